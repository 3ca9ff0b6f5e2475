#include <heckbert/transport/pass.h>

#include <cmath>
#include <stdexcept>

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
  const float radius = settings.method.photon_radius * world.emission.radius();
  switch (settings.algorithm) {
    case AlgorithmId::PhotonMap:
      photons_.emplace(world_, plan, sample, radius);
      break;
    case AlgorithmId::ProgressivePhotons:
      photons_.emplace(world_, plan, sample, radius * shrinking(sample));
      break;
    case AlgorithmId::ConnectionAndMerging: {
      const float now = radius * shrinking(sample);
      world_.merging = squared(static_cast<double>(now)) * kPi * static_cast<double>(world.window.pixel_count());
      photons_.emplace(world_, plan, sample, now);
      break;
    }
    case AlgorithmId::InstantRadiosity:
    case AlgorithmId::InstantRadiosityClamped:
      lights_ = virtual_lights(world_, plan, sample);
      world_.virtual_lights = &lights_;
      break;
    default:
      throw std::logic_error("an algorithm by passes that has nothing to share");
  }
  if (photons_) world_.photons = &*photons_;
}

}  // namespace heckbert::transport
