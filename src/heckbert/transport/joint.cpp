#include <heckbert/transport/joint.h>

#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

std::optional<Joint> join(const Scene& scene, const Vertex& here, const LightVertex& there) {
  if (!can_be_joined(there)) return std::nullopt;
  Joint joint;
  const glm::vec3 edge = there.hit.position - here.hit.position;
  joint.squared_distance = glm::dot(edge, edge);
  if (!(joint.squared_distance > 0)) return std::nullopt;
  joint.direction = edge / std::sqrt(joint.squared_distance);
  joint.wi = here.local(joint.direction);
  if (joint.wi.z == 0 || (joint.wi.z < 0 && !here.transmits)) return std::nullopt;
  joint.here = here.values(joint.wi);
  if (std::ranges::all_of(joint.here.f, [](Rgb f) { return is_black(f); })) return std::nullopt;
  joint.there = scatter(scene, there, -joint.direction);
  if (joint.there.is_black()) return std::nullopt;
  joint.cos_there = std::abs(glm::dot(there.hit.normal_geometric, joint.direction));
  return joint;
}

bool is_blocked(const World& world, Walk& walk, const Vertex& here, const LightVertex& there, const Joint& joint) {
  const bool to_front = glm::dot(joint.direction, here.hit.normal_geometric) > 0;
  const bool from_front = glm::dot(joint.direction, there.hit.normal_geometric) < 0;
  ++walk.rays;
  return world.tracer.is_occluded(leave(here.hit, to_front), leave(there.hit, from_front));
}

void add_joint(const World& world, Walk& walk, const Vertex& here, taxonomy::WordTrie::Node node,
               const LightWalk& light, std::size_t number, const Joint& joint, Rgb carried) {
  const Hit& there = light.vertices[number].hit;
  const std::span<const Lobe> lobes = here.lobes();
  const record::Technique technique{static_cast<std::uint16_t>(number + 2)};
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    if (is_black(joint.here.f[i])) continue;
    const taxonomy::WordTrie::Node scattered =
        walk.step(node, letter(lobes[i], joint.wi.z < 0), world.labels.surface(here.hit));
    for (std::size_t j = 0; j < joint.there.lobes; ++j) {
      if (is_black(joint.there.f[j])) continue;
      const taxonomy::WordTrie::Node joined = walk.step(scattered, joint.there.letters[j], world.labels.surface(there));
      walk.find({spell(world, walk, joined, light, number), carried * joint.here.f[i] * joint.there.f[j], technique});
    }
  }
}

}  // namespace heckbert::transport
