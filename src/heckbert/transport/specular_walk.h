#pragma once
// A walk from the eye that goes on at mirrors and glass alone, for algorithms that find the rest of the light at the
// first surface that is not specular. Lamps and their mirror images, LS*E, are found by running into them.

#include <heckbert/transport/continuation.h>

namespace heckbert::transport {

/// Calls shade(vertex, node, throughput, scatterings before it) at each vertex that has a lobe without a Dirac; `node`
/// is the word so far, without what happens there. At a surface of both kinds of lobes the walk goes on by chance.
/// Takes a scene without bodies.
template <class Shade>
void walk_to_matt(const World& world, Walk& walk, Ray ray, Shade shade) {
  using record::PathEnd;
  using taxonomy::Symbol;
  taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb throughput(1.0f);
  float radiance_scale = 1;
  for (int depth = 0;; ++depth) {
    ++walk.rays;
    const std::optional<Hit> hit = world.tracer.intersect(ray);
    if (!hit) {
      const Rgb sky = world.lights.environment(ray.direction);
      if (!is_black(sky))
        add_hit(walk, node, Symbol::Le, world.labels.light({LightSource::Type::Environment, 0}), throughput * sky);
      return walk.sink.end_path(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    if (const Rgb emitted = world.lights.emitted(*hit); !is_black(emitted))
      add_hit(walk, node, Symbol::La, world.labels.light({LightSource::Type::Emitter, hit->emitter}),
              throughput * emitted);
    if (depth == world.max_depth) return walk.sink.end_path(PathEnd::DepthLimit);
    const Vertex vertex(world.scene, *hit, ray.direction);
    if (vertex.has_non_delta) shade(vertex, node, throughput, depth);
    if (!(vertex.total_weight > 0)) return walk.sink.end_path(PathEnd::Absorbed);
    const float u = vertex.has_choice ? walk.sampler.next() : 0.0f;
    const Drawn lobe = draw(vertex.selection, vertex.lobes().size(), 1.0f, u);
    if (!is_delta(vertex.lobes()[lobe.index])) return walk.sink.end_path(PathEnd::Absorbed);
    const Continuation next = follow_delta(vertex, lobe);
    throughput *= next.factor;
    radiance_scale *= next.radiance_scale;
    if (is_black(throughput)) return walk.sink.end_path(PathEnd::Absorbed);
    if (depth + 1 >= kRouletteStart) {
      const float survival = std::min(kHighestSurvival, max_channel(throughput) / radiance_scale);
      if (walk.sampler.next() >= survival) return walk.sink.end_path(PathEnd::Roulette);
      throughput *= 1.0f / survival;
    }
    node = walk.step(node, next.event, world.labels.surface(*hit));
    ray = next.ray;
  }
}

}  // namespace heckbert::transport
