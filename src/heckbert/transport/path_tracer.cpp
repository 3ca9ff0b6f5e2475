#include <heckbert/transport/path_tracer.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/medium.h>
#include <heckbert/transport/running_into_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::PathEnd;
using taxonomy::Symbol;

namespace {

/// Next-event estimation at a particle where the ray ends.
void gather_light_at_particle(const World& world, Walk& walk, const Ray& ray, const Medium& medium,
                              taxonomy::WordTrie::Node node, Rgb throughput, PathTechniques techniques) {
  const LightSample light = world.lights.sample(ray.origin, walk.sampler);
  if (!(light.pdf_solid_angle > 0)) return;
  const float value = phase(medium.anisotropy, glm::dot(ray.direction, light.direction));
  const Rgb incident = arriving(world, walk.rays, walk.bodies, ray.origin, light);
  if (is_black(incident)) return;
  const bool has_rival = techniques.hits && !light.is_delta;
  const float weight = (has_rival ? power_heuristic(light.pdf_solid_angle, value) : 1.0f) * value;
  const taxonomy::WordTrie::Node scattered = walk.step(node, Symbol::V, world.labels.particle(medium));
  walk.find({walk.step(scattered, light.kind, world.labels.light(light.source)),
             throughput * incident * (weight / light.pdf_solid_angle), record::Technique::NextEvent},
            light);
}

/// What happens at a particle where the ray ends: light is gathered, and the path goes on. The ray is a copy for the
/// reason that travel() gives.
Continuation scatter_at_particle(const World& world, Walk& walk, Ray ray, taxonomy::WordTrie::Node node, Rgb throughput,
                                 PathTechniques techniques) {
  const Medium& medium = *walk.bodies.medium(world.scene);
  if (techniques.next_event) gather_light_at_particle(world, walk, ray, medium, node, throughput, techniques);
  return follow_particle(medium, ray, walk.sampler);
}

/// The same at a surface.
Continuation scatter_at_surface(const World& world, Walk& walk, const Hit& hit, glm::vec3 direction,
                                taxonomy::WordTrie::Node node, Rgb throughput, PathTechniques techniques) {
  const Vertex vertex = vertex_at(world, walk, hit, direction);
  if (vertex.has_non_delta && techniques.next_event)
    gather_direct_light(world, walk, vertex, node, throughput, {.multiple_importance = techniques.hits});
  return follow(vertex, walk.sampler);
}

}  // namespace

void trace_path(const World& world, Walk& walk, Ray ray, PathTechniques techniques) {
  taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb throughput(1.0f);
  float radiance_scale = 1;
  Approach approach;
  std::optional<PastTheLimit> past_the_limit;
  const auto end = [&](PathEnd how) {
    if (!past_the_limit) walk.sink.end_path(how);
  };

  for (int depth = 0;; ++depth) {
    const auto [hit, scattered] = travel(world, walk, ray, throughput);
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    if (!hit && !scattered) {
      walk.arrive(depth, {ray.direction, throughput, true});
      if (techniques.hits) run_into_sky(world, walk, node, ray.direction, throughput, approach);
      return end(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    walk.arrive(depth, {hit ? hit->position : ray.origin, throughput});
    if (hit && techniques.hits) run_into_lamp(world, walk, node, *hit, throughput, approach);
    if (depth == world.max_depth) {
      end(PathEnd::DepthLimit);
      if (walk.sampler.next() >= PastTheLimit::kShare) return;
      past_the_limit.emplace(walk);
    }

    const Continuation next = scattered
                                  ? scatter_at_particle(world, walk, ray, node, throughput, techniques)
                                  : scatter_at_surface(world, walk, *hit, ray.direction, node, throughput, techniques);
    throughput *= next.factor;
    radiance_scale *= next.radiance_scale;
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    if (!survives(walk.sampler, throughput, radiance_scale, depth + 1)) return end(PathEnd::Roulette);
    const Labels::Id label =
        scattered ? world.labels.particle(*walk.bodies.medium(world.scene)) : world.labels.surface(*hit);
    node = walk.step(node, next.event, label);
    approach = {techniques.next_event ? next.pdf_solid_angle : 0.0f, scattered ? ray.origin : hit->position};
    if (next.transmitted && world.has_bodies) walk.bodies.cross(world.scene, hit->material, hit->front);
    ray = next.ray;
  }
}

}  // namespace heckbert::transport
