#include <heckbert/transport/ray_casting.h>

#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;

void cast_ray(const World& world, Walk& walk, Ray ray) {
  const taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb weight(1.0f);
  const std::optional<Hit> hit = travel(world, walk, ray, weight, Particles::Dim).hit;
  const auto emits = [&](Symbol kind, LightSource light, Rgb radiance) {
    if (!is_black(radiance)) add_hit(walk, node, kind, world.labels.light(light), weight * radiance);
  };
  if (!hit) {
    walk.arrive(0, {ray.direction, weight, true});
    emits(Symbol::Le, {LightSource::Type::Environment, 0}, world.lights.environment(ray.direction));
    return walk.sink.end_path(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
  }
  walk.arrive(0, {hit->position, weight});
  emits(Symbol::La, {LightSource::Type::Emitter, hit->emitter}, world.lights.emitted(*hit));
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
