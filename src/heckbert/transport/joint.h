#pragma once
// A vertex of a walk from the eye joined to one of a walk from the light: what either sends along the line between
// them, before anybody looks whether something is in between.

#include <heckbert/transport/eye_vertex.h>

namespace heckbert::transport {

struct Joint {
  glm::vec3 direction{0};  ///< unit, from the eye's vertex to the light's
  float squared_distance = 0;
  Scattering here{}, there{};  ///< of the eye's vertex, and of the light's

  bool is_black() const { return here.is_black() || there.is_black(); }
};

/// Black when no light goes that way.
Joint join(const Scene& scene, const EyeVertex& here, const LightVertex& there);

/// What is in between, from the eye's vertex, where the walk stands, to the light's. Counts its rays.
Passage passage_along(const World& world, Walk& walk, const EyeVertex& here, const LightVertex& there,
                      const Joint& joint);

/// Finds a path for each pair of lobes. `number` counts the light's vertices; `carried` is all but what the two
/// vertices do.
void add_joint(const World& world, Walk& walk, const EyeVertex& here, const LightWalk& light, std::size_t number,
               const Joint& joint, Rgb carried);

}  // namespace heckbert::transport
