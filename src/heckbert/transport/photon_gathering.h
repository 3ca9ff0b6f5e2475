#pragma once
// The photons near a vertex of a walk from the eye, taken for light that arrives there: the estimate of density that
// all algorithms with photons share (Jensen 1996, "Global Illumination using Photon Maps"), over a disc of a radius
// that is given.

#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/photon_map.h>

namespace heckbert::transport {

/// Photons whose surface is turned farther than this away from the place belong to another wall.
inline constexpr float kSameSurface = 0.7f;

/// The direction from which a photon came, as the place sees it: turned with the normal from the one to the other, or
/// on a curved wall some of the light that grazes it would come from below the horizon of the place and be lost.
inline glm::vec3 to_light_of(const Photon& photon, glm::vec3 normal) {
  if (photon.normal == normal) return photon.to_light;
  const glm::vec3 sum = photon.normal + normal;
  return photon.to_light - glm::dot(sum, photon.to_light) / (1 + glm::dot(photon.normal, normal)) * sum +
         2 * glm::dot(photon.normal, photon.to_light) * normal;
}

/// Finds a path for each photon near the vertex and each lobe with `scatters(its letter)`. `node` is the word up to but
/// without the vertex; `weigh(photon, to_light, values)` is what the path counts, `values` being those of the vertex
/// for light that comes from there.
template <class Scatters, class Weigh>
void gather_photons(const World& world, Walk& walk, const PhotonMap& map, const Vertex& vertex,
                    taxonomy::WordTrie::Node node, Rgb throughput, int scatterings, Scatters scatters, Weigh weigh) {
  thread_local std::vector<const Photon*> found;
  map.find(vertex.hit.position, found);
  const float disc = kPi * map.radius() * map.radius();
  const std::span<const Lobe> lobes = vertex.lobes();
  const Labels::Id label = world.labels.surface(vertex.hit);
  for (const Photon* photon : found) {
    if (scatterings + photon->vertices > world.max_depth) continue;
    if (glm::dot(photon->normal, vertex.hit.normal_geometric) < kSameSurface) continue;
    const glm::vec3 to_light = to_light_of(*photon, vertex.hit.normal_geometric);
    const glm::vec3 wi = vertex.local(to_light);
    const float cosine = std::abs(glm::dot(vertex.hit.normal_geometric, to_light));
    if (wi.z == 0 || !(cosine > 0)) continue;
    const Vertex::Values values = vertex.values(wi);
    const Rgb arriving =
        throughput * photon->power *
        (std::abs(wi.z) / cosine / (disc * static_cast<float>(map.walks())) * weigh(*photon, to_light, values));
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      const taxonomy::Symbol event = letter(lobes[i], wi.z < 0);
      if (is_black(values.f[i]) || !scatters(event)) continue;
      const taxonomy::WordTrie::Node scattered = walk.step(node, event, label);
      // The vertex is the last of both walks: the light, the photon's surfaces.
      const record::Technique technique{static_cast<std::uint16_t>(photon->vertices + 1), true};
      walk.find({map.spell(walk, scattered, *photon), arriving * values.f[i], technique});
    }
  }
}

}  // namespace heckbert::transport
