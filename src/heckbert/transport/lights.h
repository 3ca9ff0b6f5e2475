#pragma once
// All the light sources of a scene in one table: the pieces of area lights, point, spot and distant lights, the
// environment. One is chosen by power, or through a tree where there are many. A sample says where the light is, how
// much arrives and with what density; the density of hitting the same place by chance is asked separately, so that
// multiple importance weights can be formed (Veach 1997, 9.2).

#include <optional>
#include <vector>

#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/discrete_distribution.h>
#include <heckbert/transport/environment.h>
#include <heckbert/transport/light_tree.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

/// One light of a scene: a piece of an area light by its number among the tracer's emitters, another light by its place
/// in the scene's list of its type.
struct LightSource {
  enum class Type : std::uint8_t { Emitter, Point, Spot, Distant, Environment } type = Type::Emitter;
  std::uint32_t index = 0;
};
inline constexpr std::size_t kLightSourceTypes = 5;

struct LightSample {
  taxonomy::Symbol kind = taxonomy::Symbol::La;
  glm::vec3 direction{0};  ///< unit, from the shaded point to the light
  glm::vec3 target{0};     ///< where the shadow ray ends; unused when `infinite`
  bool infinite = false;
  /// Radiance, or the irradiance that a delta light gives a surface facing it; before division by the density.
  Rgb radiance;
  /// With the probability of choosing this light; for a delta light that probability alone. 0: the draw sends no light
  /// to the point, and the rest says nothing.
  float pdf_solid_angle = 0;
  bool is_delta = false;  ///< no ray can hit it by chance
  /// A light whose surface has holes or a texture: the shadow ray must meet this very emitter, not just reach `target`,
  /// and what it emits there takes the place of `radiance`.
  std::uint32_t to_be_met = kNoEmitter;
  LightSource source{};
};

class Lights {
 public:
  Lights(const Scene& scene, const Tracer& tracer);

  bool empty() const { return groups_.empty(); }
  /// A light and a point on it as seen from `from`.
  LightSample sample(glm::vec3 from, Sampler& sampler) const;

  /// Radiance that leaves the hit surface towards the ray's origin; black for anything but an emitter's lit side.
  Rgb emitted(const Hit& hit) const;
  /// Density with which sample() would have picked the hit point from `from`, per steradian.
  float pdf_solid_angle(const Hit& hit, glm::vec3 from) const;
  /// Radiance that comes from infinitely far away in a direction, and the same density for it.
  Rgb environment(glm::vec3 direction) const { return environment_.radiance(direction); }
  float pdf_environment(glm::vec3 direction) const;
  bool has_environment() const { return !environment_.is_black(); }
  const Environment& sky() const { return environment_; }

  /// Every light that gives light, and the power of its strongest channel in W.
  struct Power {
    LightSource source{};
    double watts = 0;
  };
  const std::vector<Power>& powers() const { return powers_; }
  /// The chance that sample() chooses this light; that of an emitter is part of pdf_solid_angle().
  float probability(LightSource source, glm::vec3 from) const;

 private:
  /// Without its texture.
  Rgb emitted(std::uint32_t material, bool front) const;
  struct Choice {
    LightSource source{};
    float probability = 0;  ///< 0: no light
  };
  Choice choose(glm::vec3 from, double u) const;
  LightSample sample_source(const Choice& choice, glm::vec3 from, glm::vec2 u) const;

  const Scene& scene_;
  const Tracer& tracer_;
  Environment environment_;
  std::vector<LightSource> near_;       ///< those with a place; emitters first, in the tracer's order
  std::vector<LightSource> far_;        ///< those infinitely far away; the environment last
  std::optional<LightTree> near_tree_;  ///< over near_, when there are many
  DiscreteDistribution near_choice_;    ///< by power otherwise
  DiscreteDistribution groups_;         ///< all of near_, then each of far_
  std::optional<LightSource> only_;     ///< where there is nothing to choose
  std::vector<Power> powers_;           ///< of near_, then of far_
};

}  // namespace heckbert::transport
