#pragma once
// A surface or a particle that a walk from the eye came to, as those who join it to walks from the light see it.

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

struct EyeVertex {
  const Vertex* surface = nullptr;   ///< null: a particle
  const Medium* particle = nullptr;  ///< of this medium
  glm::vec3 position{0};
  float index_in_front = 1;  ///< of refraction, of a surface
  glm::vec3 to_eye{0};       ///< unit, towards the vertex before
  Rgb throughput{};
  Rivals rivals{};
  taxonomy::WordTrie::Node node = 0;  ///< the word so far, without what happens here
  int scatterings = 0;                ///< before this one

  Place place() const { return {surface != nullptr ? &surface->hit : nullptr, particle, position}; }
  /// With which a walk that comes from `to_light` would leave this vertex for the one before; per steradian.
  double pdf_to_eye(const Scene& scene, glm::vec3 to_light) const;
};

/// The vertex in light that comes from there; black also where its surface has no lobe without a Dirac.
Scattering scatter(const EyeVertex& vertex, glm::vec3 to_light);

/// A light sample's radiance as it arrives at the vertex of the walk; black when something is in between. The passage
/// begins at the vertex.
Rgb arriving_light(const World& world, Walk& walk, const EyeVertex& vertex, const LightSample& light, Passage& passage);

}  // namespace heckbert::transport
