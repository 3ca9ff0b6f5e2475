#include <heckbert/transport/photon_tracer.h>

#include <heckbert/transport/photon_gathering.h>
#include <heckbert/transport/specular_walk.h>

namespace heckbert::transport {

void trace_to_photons(const World& world, Walk& walk, Ray ray) {
  const auto every_lobe = [](taxonomy::Symbol) { return true; };
  const auto in_full = [](const Photon&, glm::vec3, const Vertex::Values&) { return 1.0f; };
  walk_to_matt(world, walk, ray, [&](const Vertex& vertex, taxonomy::WordTrie::Node node, Rgb throughput, int depth) {
    gather_photons(world, walk, *world.photons, vertex, node, throughput, depth, every_lobe, in_full);
  });
}

}  // namespace heckbert::transport
