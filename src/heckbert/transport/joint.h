#pragma once
// A vertex of a walk from the eye joined to one of a walk from the light: what either sends along the line between
// them, before anybody looks whether something is in between.

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

struct Joint {
  glm::vec3 direction{0};  ///< unit, from the eye's vertex to the light's
  float squared_distance = 0;
  glm::vec3 wi{0};      ///< the same in the eye's vertex's frame
  Vertex::Values here;  ///< of the eye's vertex
  Scattering there;     ///< of the light's vertex
  float cos_there = 0;  ///< with its geometric normal
};

/// Nothing when no light goes that way.
std::optional<Joint> join(const Scene& scene, const Vertex& here, const LightVertex& there);

/// Is something in between? Counts its ray.
bool is_blocked(const World& world, Walk& walk, const Vertex& here, const LightVertex& there, const Joint& joint);

/// Finds a path for each pair of lobes. `node` is the word up to but without the eye's vertex; `number` counts the
/// light's vertices; `carried` is all but what the two vertices do.
void add_joint(const World& world, Walk& walk, const Vertex& here, taxonomy::WordTrie::Node node,
               const LightWalk& light, std::size_t number, const Joint& joint, Rgb carried);

}  // namespace heckbert::transport
