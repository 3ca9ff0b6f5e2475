#include <heckbert/transport/ambient_occlusion.h>

#include <glm/geometric.hpp>

#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;

void trace_occlusion(const World& world, Walk& walk, Ray ray) {
  Rgb weight(1.0f);
  const std::optional<Hit> hit = travel(world, walk, ray, weight, Particles::Dim).hit;
  if (!hit) return walk.sink.end_path(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
  walk.arrive(0, {hit->position, weight});
  const Vertex vertex = vertex_at(world, walk, *hit, ray.direction);
  // Directions by their cosine: a white surface's radiance is the share of them that are free.
  const glm::vec3 drawn = sample_direction(Lambert{Rgb(1.0f)}, vertex.wo, {walk.sampler.next2(), 0.0f});
  const glm::vec3 wi = vertex.local(vertex.frame.to_world(drawn));
  if (wi.z == 0) return walk.sink.end_path(PathEnd::Absorbed);  // below the surface itself
  const float reach = kOcclusionReach * glm::length(world.tracer.bounds_high() - world.tracer.bounds_low());
  const Ray probe = vertex.leave(wi, false);
  ++walk.rays;
  if (!world.tracer.is_occluded(probe.origin, probe.origin + reach * probe.direction))
    walk.sink.add_non_path(record::NonPath::Ambient, Rgb(1.0f));
  walk.sink.end_path(PathEnd::Absorbed);
}

}  // namespace heckbert::transport
