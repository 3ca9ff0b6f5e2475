#pragma once
// Light as it leaves: where walks from the light begin. A light is chosen by power, a place on it by area and a
// direction by the cosine; a point shines into its sphere or cone; light from infinitely far away has a direction first
// and then a place on a disc that covers the scene (Veach 1997, 8.2; Pharr, Jakob and Humphreys, 16.1).
//
// Weights of bidirectional path tracing need the same densities for paths that were found otherwise, so every path's
// beginning is described in one way, whatever made it: see Departure.

#include <optional>

#include <heckbert/transport/discrete_distribution.h>
#include <heckbert/transport/lights.h>

namespace heckbert::transport {

/// The first edge of a path as a walk from the light would have drawn it.
struct Departure {
  float pdf = 0;  ///< per area and steradian; of a light without extent or direction, what is left of the two
  float pdf_place =
      0;             ///< of the place alone, per area; infinitely far away: of the direction; of a delta light: chance
  float cosine = 1;  ///< of an area light, between the direction and its normal
};

/// The start of a walk.
struct Emitted {
  taxonomy::Symbol kind = taxonomy::Symbol::La;
  LightSource source{};
  Ray ray{};
  glm::vec3 normal{0};  ///< of an area light, on the side it shines from
  float error = 0;      ///< as Hit::error
  Rgb radiance{};       ///< or, of lights that have none, intensity on the axis or irradiance
  Rgb throughput{};     ///< L cos / p
  Departure departure{};
  bool infinite = false, is_delta = false;
};

class Emission {
 public:
  /// Keeps references. `eye` is covered by the disc of light from far away.
  Emission(const Scene& scene, const Tracer& tracer, const Lights& lights, glm::vec3 eye, float eye_radius);

  bool empty() const { return choice_.empty(); }
  /// Of a ball around the scene and the eye.
  float radius() const { return radius_; }
  /// Nothing when the draw sends no light, or there is none.
  std::optional<Emitted> sample(Sampler& sampler) const;
  /// What sample() would have made of the edge that leaves an area light's `place` along `direction`.
  Departure departure(const Hit& place, glm::vec3 direction) const;
  /// The same for light from the sky that travels along `direction`.
  Departure departure_from_sky(glm::vec3 direction) const;
  /// The same for what next-event estimation drew.
  Departure departure(const LightSample& light) const;
  /// What the place where the walk began sends another way: radiance times cosine, or intensity. Of finite lights.
  Rgb towards(const Emitted& start, glm::vec3 direction) const;

 private:
  std::optional<Emitted> from_emitter(std::uint32_t index, float chance, Sampler& sampler) const;
  std::optional<Emitted> from_point(const LightSource& source, float chance, Sampler& sampler) const;
  std::optional<Emitted> from_far(const LightSource& source, float chance, Sampler& sampler) const;
  Departure from_area(std::uint32_t emitter, float cosine) const;
  float chance_of(LightSource source) const;

  const Scene& scene_;
  const Tracer& tracer_;
  const Lights& lights_;
  DiscreteDistribution choice_;  ///< over Lights::powers()
  glm::vec3 center_{0};          ///< of a ball around all there is
  float radius_ = 0;
};

}  // namespace heckbert::transport
