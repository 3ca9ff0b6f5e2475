#include <heckbert/transport/instant_radiosity.h>

#include <cmath>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/joint.h>
#include <heckbert/transport/specular_walk.h>

namespace heckbert::transport {

namespace {

/// Walks for each sample number.
constexpr int kWalks = 8;

}  // namespace

std::deque<LightWalk> virtual_lights(const World& world, const SamplePlan& plan, int sample) {
  std::deque<LightWalk> walks;
  std::uint64_t rays = 0;
  for (int walk = 0; walk < kWalks; ++walk) {
    Sampler sampler = Sampler(plan, walk, 0, sample).split();
    walks.push_back(walk_from_light(world, rays, sampler, Particles::Dim));
  }
  return walks;
}

void trace_to_virtual_lights(const World& world, Walk& walk, Ray ray, float least_distance) {
  const float least_square = least_distance * least_distance;
  walk_to_matt(world, walk, ray, [&](const Vertex& vertex, taxonomy::WordTrie::Node node, Rgb throughput, int depth) {
    gather_direct_light(world, walk, vertex, node, throughput, {});
    const EyeVertex at{.surface = &vertex, .position = vertex.hit.position, .throughput = throughput, .node = node};
    for (const LightWalk& light : *world.virtual_lights)
      for (std::size_t i = 0; i < light.vertices.size() && depth + static_cast<int>(i) + 2 <= world.max_depth; ++i) {
        const Joint joint = join(world.scene, at, light.vertices[i]);
        if (joint.is_black()) continue;
        const Rgb passed = passage_along(world, walk, at, light.vertices[i], joint).transmittance;
        if (is_black(passed)) continue;
        const float spread = std::max(joint.squared_distance, least_square) * static_cast<float>(kWalks);
        add_joint(world, walk, at, light, i, joint, throughput * light.vertices[i].throughput * passed / spread);
      }
  });
}

}  // namespace heckbert::transport
