#include <heckbert/transport/ray_casting.h>

#include <heckbert/transport/running_into_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;

void cast_ray(const World& world, Walk& walk, Ray ray) {
  const taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb weight(1.0f);
  const std::optional<Hit> hit = travel(world, walk, ray, weight, Particles::Dim).hit;
  if (!hit) {
    walk.arrive(0, {ray.direction, weight, true});
    run_into_sky(world, walk, node, ray.direction, weight);
    return walk.sink.end_path(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
  }
  walk.arrive(0, {hit->position, weight});
  run_into_lamp(world, walk, node, *hit, weight);
  const Vertex vertex = vertex_at(world, walk, *hit, ray.direction);
  if (world.max_depth > 0) {
    gather_direct_light(world, walk, vertex, node, weight, {});
    return walk.sink.end_path(PathEnd::Absorbed);
  }
  walk.sink.end_path(PathEnd::DepthLimit);
  if (walk.sampler.next() >= PastTheLimit::kShare) return;
  const PastTheLimit unrecorded(walk);
  gather_direct_light(world, walk, vertex, node, weight, {});
}

}  // namespace heckbert::transport
