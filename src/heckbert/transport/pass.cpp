#include <heckbert/transport/pass.h>

#include <cmath>

#include <heckbert/transport/instant_radiosity.h>

namespace heckbert::transport {

namespace {

/// The radius of a progressive algorithm's pass over that of its first: the error of all passes together goes to zero
/// (Knaus and Zwicker 2011, "Progressive Photon Mapping: A Probabilistic Approach").
float shrinking(int sample) {
  constexpr float kAlpha = 0.75f;
  return std::pow(static_cast<float>(sample + 1), 0.5f * (kAlpha - 1.0f));
}

}  // namespace

Pass::Pass(const World& world, const RenderSettings& settings, const SamplePlan& plan, int sample) : world_(world) {
  if (settings.algorithm == AlgorithmId::InstantRadiosity ||
      settings.algorithm == AlgorithmId::InstantRadiosityClamped) {
    lights_ = virtual_lights(world_, plan, sample);
    world_.virtual_lights = &lights_;
    return;
  }
  PhotonSettings photons{.radius = settings.method.photon_radius * world.emission.radius(),
                         .walks_per_pixel = settings.method.photons_per_pixel};
  const bool merges = settings.algorithm == AlgorithmId::ConnectionAndMerging;
  if (merges || settings.algorithm == AlgorithmId::ProgressivePhotons) photons.radius *= shrinking(sample);
  if (merges) {
    photons.walks_per_pixel = 1;
    photons.particles = Particles::Scatter;
    world_.merging =
        squared(static_cast<double>(photons.radius)) * kPi * static_cast<double>(world.window.pixel_count());
  }
  world_.photons = &photons_.emplace(world_, plan, sample, photons);
  if (settings.algorithm != AlgorithmId::FinalGathering) return;
  world_.gather_rays = settings.method.gather_rays;
  photons.caustics_only = true;
  world_.caustics = &caustics_.emplace(world_, plan, sample, photons);
}

}  // namespace heckbert::transport
