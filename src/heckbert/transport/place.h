#pragma once
// Where a path turns: at a surface, or at a particle of a medium. What joining walks has to know of either is the same
// but for a few things, which are here.

#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Of a direction with the geometric normal, on whichever side.
inline float cosine(const Hit& hit, glm::vec3 direction) {
  return std::abs(glm::dot(hit.normal_geometric, direction));
}

struct Place {
  const Hit* surface = nullptr;      ///< null: a particle
  const Medium* particle = nullptr;  ///< of this medium
  glm::vec3 position{0};

  /// What a density per area, or per volume, has to do with one per steradian, beside the squared distance: the cosine,
  /// or the rate of particles along an edge (Passage).
  float facing(glm::vec3 direction, float rate) const {
    return surface != nullptr ? cosine(*surface, direction) : rate;
  }
  /// Where a ray that leaves in this direction begins.
  glm::vec3 leave(glm::vec3 direction) const {
    return surface != nullptr ? transport::leave(*surface, is_in_front(direction)) : position;
  }
  /// The bodies that such a ray is in; those of the side from which the walk came are `bodies`.
  Bodies bodies(const Scene& scene, Bodies bodies, glm::vec3 direction) const {
    if (surface != nullptr && is_in_front(direction) != surface->front)
      bodies.cross(scene, surface->material, surface->front);
    return bodies;
  }
  Labels::Id label(const Labels& labels) const {
    return surface != nullptr ? labels.surface(*surface) : labels.particle(*particle);
  }

 private:
  bool is_in_front(glm::vec3 direction) const { return glm::dot(direction, surface->normal_geometric) > 0; }
};

}  // namespace heckbert::transport
