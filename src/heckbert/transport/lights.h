#pragma once
// All the light sources of a scene in one table, chosen by power: emitting triangles and spheres, point lights, the
// environment. A sample says where the light is, how much arrives and with what density; the density of hitting the
// same place by chance is asked separately, so that multiple importance weights can be formed (Veach 1997, 9.2).

#include <optional>
#include <vector>

#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

struct LightSample {
  taxonomy::Symbol kind = taxonomy::Symbol::La;
  glm::vec3 direction{0};  ///< unit, from the shaded point to the light
  glm::vec3 target{0};     ///< where the shadow ray ends; unused when `infinite`
  bool infinite = false;
  /// Radiance, or for a point light intensity over squared distance; before division by the density.
  Rgb radiance;
  float pdf_solid_angle = 0;  ///< with the probability of choosing this light; for a point light that probability alone
  bool is_delta = false;      ///< no ray can hit it by chance
};

class Lights {
 public:
  Lights(const Scene& scene, const Tracer& tracer);

  bool empty() const { return cumulative_.empty(); }
  /// A light and a point on it as seen from `from`; nothing when the draw sends no light there.
  std::optional<LightSample> sample(glm::vec3 from, Sampler& sampler) const;

  /// Radiance that leaves the hit surface towards the ray's origin; black for anything but an emitter's lit side.
  Rgb emitted(const Hit& hit) const;
  /// Density with which sample() would have picked the hit point from `from`, per steradian.
  float pdf_solid_angle(const Hit& hit, glm::vec3 from) const;
  /// The same for a direction that escapes to the environment.
  float pdf_environment() const;
  Rgb environment() const { return scene_.environment; }

 private:
  struct Source {
    enum class Type : std::uint8_t { Emitter, Point, Environment } type;
    std::uint32_t index;
  };
  float probability(std::size_t source) const {
    return cumulative_[source] - (source == 0 ? 0.0f : cumulative_[source - 1]);
  }
  Rgb emitted(std::uint32_t material, bool front) const;

  const Scene& scene_;
  const Tracer& tracer_;
  std::vector<Source> sources_;    ///< emitters first, in the tracer's order
  std::vector<float> cumulative_;  ///< of the choice probabilities, ends at 1
  std::optional<std::size_t> environment_source_;
};

}  // namespace heckbert::transport
