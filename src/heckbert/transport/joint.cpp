#include <heckbert/transport/joint.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

Joint join(const Scene& scene, const EyeVertex& here, const LightVertex& there) {
  if (!can_be_joined(there)) return {};
  const glm::vec3 edge = there.hit.position - here.position;
  const float squared_distance = glm::dot(edge, edge);
  if (!(squared_distance > 0)) return {};
  const glm::vec3 direction = edge / std::sqrt(squared_distance);
  // Made where it will be: what is read by the line soon after it was written by the float waits (docs/performance.md).
  return {direction, squared_distance, scatter(here, direction), scatter(scene, there, -direction)};
}

Passage passage_along(const World& world, Walk& walk, const EyeVertex& here, const LightVertex& there,
                      const Joint& joint) {
  const Place begin = here.place();
  return passage_between(world, walk.rays, begin.bodies(world.scene, walk.bodies, joint.direction),
                         begin.leave(joint.direction), there.place().leave(-joint.direction));
}

void add_joint(const World& world, Walk& walk, const EyeVertex& here, const LightWalk& light, std::size_t number,
               const Joint& joint, Rgb carried) {
  const Labels::Id label_here = here.place().label(world.labels);
  const Labels::Id label_there = light.vertices[number].place().label(world.labels);
  const record::Technique technique{static_cast<std::uint16_t>(number + 2)};
  for (std::size_t i = 0; i < joint.here.lobes; ++i) {
    if (is_black(joint.here.f[i])) continue;
    const taxonomy::WordTrie::Node scattered = walk.step(here.node, joint.here.letters[i], label_here);
    for (std::size_t j = 0; j < joint.there.lobes; ++j) {
      if (is_black(joint.there.f[j])) continue;
      const taxonomy::WordTrie::Node joined = walk.step(scattered, joint.there.letters[j], label_there);
      walk.find({spell(world, walk, joined, light, number), carried * joint.here.f[i] * joint.there.f[j], technique});
    }
  }
}

}  // namespace heckbert::transport
