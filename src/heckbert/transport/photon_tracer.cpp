#include <heckbert/transport/photon_tracer.h>

#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/photon_map.h>
#include <heckbert/transport/specular_walk.h>

namespace heckbert::transport {

using record::Technique;
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
  walk_to_matt(world, walk, ray, [&](const Vertex& vertex, WordTrie::Node node, Rgb throughput, int depth) {
    merge(world, walk, vertex, node, throughput, depth);
  });
}

}  // namespace heckbert::transport
