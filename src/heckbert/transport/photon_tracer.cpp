#include <heckbert/transport/photon_tracer.h>

#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/continuation.h>
#include <heckbert/transport/photon_map.h>

namespace heckbert::transport {

using record::PathEnd;
using record::Technique;
using taxonomy::Symbol;
using taxonomy::WordTrie;

namespace {

/// Photons whose surface is turned farther than this away from the place belong to another wall.
constexpr float kSameSurface = 0.7f;

/// Photons near the vertex, as light that arrives there.
void merge(const World& world, Walk& walk, const Vertex& vertex, WordTrie::Node node, Rgb throughput, int scatterings) {
  thread_local std::vector<const Photon*> found;
  const PhotonMap& map = *world.photons;
  map.find(vertex.hit.position, found);
  const float disc = kPi * map.radius() * map.radius();
  const std::span<const Lobe> lobes = vertex.lobes();
  const Labels::Id label = world.labels.surface(vertex.hit);
  for (const Photon* photon : found) {
    if (scatterings + photon->vertices > world.max_depth) continue;
    if (glm::dot(photon->normal, vertex.hit.normal_geometric) < kSameSurface) continue;
    const glm::vec3 wi = vertex.local(photon->to_light);
    const float cosine = std::abs(glm::dot(vertex.hit.normal_geometric, photon->to_light));
    if (wi.z == 0 || !(cosine > 0)) continue;
    const Vertex::Values values = vertex.values(wi);
    const Rgb arriving = throughput * photon->power * (std::abs(wi.z) / cosine * world.pixel_share / disc);
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      if (is_black(values.f[i])) continue;
      const WordTrie::Node scattered = walk.step(node, letter(lobes[i], wi.z < 0), label);
      // The vertex is the last of both walks: the light, the photon's surfaces.
      const Technique technique{static_cast<std::uint16_t>(photon->vertices + 1), true};
      walk.find({map.spell(walk, scattered, *photon), arriving * values.f[i], technique});
    }
  }
}

}  // namespace

void trace_to_photons(const World& world, Walk& walk, Ray ray) {
  WordTrie::Node node = walk.sink.words().eye(world.eye.kind());
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
    if (vertex.has_non_delta) merge(world, walk, vertex, node, throughput, depth);
    if (!(vertex.total_weight > 0)) return walk.sink.end_path(PathEnd::Absorbed);
    const float u = vertex.has_choice ? walk.sampler.next() : 0.0f;
    const Drawn lobe = draw(vertex.selection, vertex.lobes().size(), 1.0f, u);
    // What the other lobes send is in the photons.
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
