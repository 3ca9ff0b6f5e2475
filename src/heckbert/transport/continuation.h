#pragma once
// How a walk goes on from a surface: the direction is drawn from the mixture of the lobes without a Dirac, or one Dirac
// is followed; then the walk continues as one lobe (path_tracer.h says why). And from a particle: by its phase
// function. Every walk that follows one way at a time uses this, from whichever end it comes; it is in a header so that
// it is compiled into each of their loops.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <heckbert/transport/medium.h>
#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Walks of fewer scatterings than this are not ended by roulette, unless by survives_from().
inline constexpr int kRouletteStart = 4;
inline constexpr float kHighestSurvival = 0.95f;

/// How a path goes on from a vertex; unless it says more, not at all.
struct Continuation {
  Ray ray{};
  taxonomy::Symbol event = taxonomy::Symbol::Dr;
  Rgb factor;                 ///< f cos / p of the chosen lobe, every choice divided out; black: absorbed
  float pdf_solid_angle = 0;  ///< of the mixture; 0 after a delta lobe
  float radiance_scale = 1;   ///< the compression of radiance in `factor`, which roulette must not see
  bool transmitted = false;   ///< through the surface
};

/// An index, and what the draw leaves over: again uniform in [0, 1).
struct Drawn {
  std::size_t index = 0;
  float u = 0;
};

/// The index drawn from weights that add up to `total`.
template <class Weights>
Drawn draw(const Weights& weights, std::size_t count, float total, float u) {
  constexpr float kBelowOne = 0x1.fffffep-1f;
  float left = u * total;
  Drawn drawn;
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] <= 0) continue;
    drawn = {i, std::min(left / weights[i], kBelowOne)};
    if (left < weights[i]) break;
    left -= weights[i];
  }
  return drawn;
}

/// The lobe to follow; nothing where the surface is black. Draws no number where there is nothing to choose.
inline std::optional<Drawn> draw_lobe(const Vertex& vertex, Sampler& sampler) {
  if (!(vertex.total_weight > 0)) return std::nullopt;
  return draw(vertex.selection, vertex.lobes().size(), 1.0f, vertex.has_choice ? sampler.next() : 0.0f);
}

/// Does the walk go on? Then it makes up for those that do not.
inline bool survives(Sampler& sampler, Rgb& throughput, float energy) {
  const float survival = std::min(kHighestSurvival, energy);
  if (sampler.next() >= survival) return false;
  throughput *= 1.0f / survival;
  return true;
}

/// Roulette for a walk that was scattered so often, by the energy it has left: radiance without its compression.
inline bool survives(Sampler& sampler, Rgb& throughput, float radiance_scale, int scatterings) {
  return scatterings < kRouletteStart || survives(sampler, throughput, max_channel(throughput) / radiance_scale);
}

/// Roulette that begins sooner, where a path is found by many walks: from `start` scatterings on by what the last one
/// alone left of the energy, and from kRouletteStart on by all that is left. Takes: a start of at most that.
inline bool survives_from(int start, Sampler& sampler, Rgb& throughput, float radiance_scale, float left_by_last,
                          int scatterings) {
  if (scatterings < start) return true;
  if (scatterings < kRouletteStart) return left_by_last >= 1 || survives(sampler, throughput, left_by_last);
  return survives(sampler, throughput, radiance_scale, scatterings);
}

inline Continuation follow_delta(const Vertex& vertex, Drawn lobe) {
  const DeltaBranches branches = delta_branches(vertex.lobes()[lobe.index], vertex.wo, vertex.hit.front);
  const float reflect = max_channel(branches.reflected.weight);
  // The choice goes by energy, not by radiance, which changes with the medium.
  const float transmit =
      branches.transmitted ? max_channel(branches.transmitted->weight) / branches.transmitted->radiance_scale : 0.0f;
  if (!(reflect + transmit > 0)) return {};
  const float p_reflect = reflect / (reflect + transmit);
  const bool transmitted = lobe.u >= p_reflect;
  const DeltaBranch& branch = transmitted ? *branches.transmitted : branches.reflected;
  const float probability = vertex.selection[lobe.index] * (transmitted ? 1.0f - p_reflect : p_reflect);
  return {.ray = vertex.leave(branch.wi, transmitted),
          .event = branch.event,
          .factor = branch.weight / probability,
          .radiance_scale = branch.radiance_scale,
          .transmitted = transmitted};
}

/// A direction drawn from the lobes without a Dirac, local; its z is 0 when the draw comes to nothing.
inline glm::vec3 draw_direction(const Vertex& vertex, Drawn lobe, Sampler& sampler) {
  const glm::vec3 local =
      sample_direction(vertex.lobes()[lobe.index], vertex.wo, {sampler.next2(), lobe.u}, vertex.hit.front);
  return local.z == 0 ? local : vertex.usable(local);
}

/// The one lobe that a walk goes on as, and its share of what all of them send along the direction.
struct ChosenLobe {
  std::size_t index = 0;
  float share = 0;  ///< 0: none of them sends anything
};

inline ChosenLobe choose_lobe(std::span<const Rgb> f, Sampler& sampler) {
  if (f.size() == 1) return {0, is_black(f[0]) ? 0.0f : 1.0f};
  std::array<float, kMaxLobes> weight{};
  float total = 0;
  for (std::size_t i = 0; i < f.size(); ++i) total += weight[i] = max_channel(f[i]);
  if (!(total > 0)) return {};
  const std::size_t lobe = f.size() > 1 ? draw(weight, f.size(), total, sampler.next()).index : 0;
  return {lobe, weight[lobe] / total};
}

inline Continuation follow_non_delta(const Vertex& vertex, Drawn sampled, Sampler& sampler) {
  const glm::vec3 wi = draw_direction(vertex, sampled, sampler);
  if (wi.z == 0) return {};
  const Vertex::Values values = vertex.values(wi);
  if (!(values.pdf_solid_angle > 0)) return {};
  const std::span<const Lobe> lobes = vertex.lobes();
  const ChosenLobe lobe = choose_lobe(values.of_lobes(), sampler);
  if (!(lobe.share > 0)) return {};
  const bool transmitted = wi.z < 0;
  return {.ray = vertex.leave(wi, transmitted),
          .event = letter(lobes[lobe.index], transmitted),
          .factor = values.f[lobe.index] * (std::abs(wi.z) / (values.pdf_solid_angle * lobe.share)),
          .pdf_solid_angle = values.pdf_solid_angle,
          .radiance_scale = transmitted ? radiance_compression(lobes[lobe.index], vertex.hit.front) : 1.0f,
          .transmitted = transmitted};
}

/// One way on by one lobe that has no Dirac, as if it were alone.
inline Continuation follow_alone(const Vertex& vertex, const Lobe& lobe, Sampler& sampler) {
  const glm::vec2 u = sampler.next2();
  const glm::vec3 drawn =
      sample_direction(lobe, vertex.wo, {u, is_branching(lobe) ? sampler.next() : 0.0f}, vertex.hit.front);
  if (drawn.z == 0) return {};
  const glm::vec3 wi = vertex.usable(drawn);
  if (wi.z == 0) return {};
  const LobeValue value = value_and_pdf(lobe, vertex.wo, wi, vertex.hit.front);
  if (!(value.pdf_solid_angle > 0)) return {};
  const bool transmitted = wi.z < 0;
  return {.ray = vertex.leave(wi, transmitted),
          .event = letter(lobe, transmitted),
          .factor = value.f * (std::abs(wi.z) / value.pdf_solid_angle),
          .pdf_solid_angle = value.pdf_solid_angle,
          .radiance_scale = transmitted ? radiance_compression(lobe, vertex.hit.front) : 1.0f,
          .transmitted = transmitted};
}

/// From a particle, where the ray ended.
inline Continuation follow_particle(const Medium& medium, const Ray& arrived, Sampler& sampler) {
  const glm::vec3 direction = sample_phase(medium.anisotropy, arrived.direction, sampler.next2());
  return {.ray = {arrived.origin, direction},
          .event = taxonomy::Symbol::V,
          .factor = Rgb(1.0f),
          .pdf_solid_angle = phase(medium.anisotropy, glm::dot(arrived.direction, direction))};
}

/// One way on from the vertex.
inline Continuation follow(const Vertex& vertex, Sampler& sampler) {
  const std::optional<Drawn> lobe = draw_lobe(vertex, sampler);
  if (!lobe) return {};
  return is_delta(vertex.lobes()[lobe->index]) ? follow_delta(vertex, *lobe) : follow_non_delta(vertex, *lobe, sampler);
}

}  // namespace heckbert::transport
