#include <heckbert/transport/joint.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

std::optional<Joint> join(const Scene& scene, const EyeVertex& here, const LightVertex& there) {
  if (!can_be_joined(there)) return std::nullopt;
  Joint joint;
  const glm::vec3 edge = there.hit.position - here.position;
  joint.squared_distance = glm::dot(edge, edge);
  if (!(joint.squared_distance > 0)) return std::nullopt;
  joint.direction = edge / std::sqrt(joint.squared_distance);
  joint.here = scatter(here, joint.direction);
  if (joint.here.is_black()) return std::nullopt;
  joint.there = scatter(scene, there, -joint.direction);
  if (joint.there.is_black()) return std::nullopt;
  return joint;
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
