#pragma once
// A walk from the eye that goes on at mirrors and glass alone, for algorithms that find the rest of the light at the
// first surface that is not specular. Lamps and their mirror images, LS*E, are found by running into them.

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/running_into_lights.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

/// Calls shade(vertex, node, throughput, scatterings before it) at each vertex that has a lobe without a Dirac; `node`
/// is the word so far, without what happens there. At a surface of both kinds of lobes the walk goes on by chance.
/// Past the depth limit a share of walks goes on to find out what it cuts off. Without `follows_mirrors` it ends at the
/// first surface. Media dim the light and do not scatter it.
template <class Shade>
void walk_to_matt(const World& world, Walk& walk, Ray ray, Shade shade, bool follows_mirrors = true) {
  using record::PathEnd;
  taxonomy::WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
  Rgb throughput(1.0f);
  float radiance_scale = 1;
  std::optional<PastTheLimit> past_the_limit;
  const auto end = [&](PathEnd how) {
    if (!past_the_limit) walk.sink.end_path(how);
  };
  for (int depth = 0;; ++depth) {
    const std::optional<Hit> hit = travel(world, walk, ray, throughput, Particles::Dim).hit;
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    walk.arrive(depth, {hit ? hit->position : ray.direction, throughput, !hit});
    if (!hit) {
      run_into_sky(world, walk, node, ray.direction, throughput);
      return end(world.lights.has_environment() ? PathEnd::Escaped : PathEnd::EscapedUnlit);
    }
    run_into_lamp(world, walk, node, *hit, throughput);
    if (depth == world.max_depth) {
      end(PathEnd::DepthLimit);
      if (walk.sampler.next() >= PastTheLimit::kShare) return;
      past_the_limit.emplace(walk);
    }
    const Vertex vertex = vertex_at(world, walk, *hit, ray.direction);
    if (vertex.has_non_delta) shade(vertex, node, throughput, depth);
    const std::optional<Drawn> lobe = follows_mirrors ? draw_lobe(vertex, walk.sampler) : std::nullopt;
    if (!lobe || !is_delta(vertex.lobes()[lobe->index])) return end(PathEnd::Absorbed);
    const Continuation next = follow_delta(vertex, *lobe);
    throughput *= next.factor;
    radiance_scale *= next.radiance_scale;
    if (is_black(throughput)) return end(PathEnd::Absorbed);
    if (!survives(walk.sampler, throughput, radiance_scale, depth + 1)) return end(PathEnd::Roulette);
    node = walk.step(node, next.event, world.labels.surface(*hit));
    if (next.transmitted && world.has_bodies) walk.bodies.cross(world.scene, hit->material, hit->front);
    ray = next.ray;
  }
}

}  // namespace heckbert::transport
