#include <heckbert/transport/vertex_merging.h>

#include <heckbert/transport/photon_gathering.h>

namespace heckbert::transport {

void merge(const World& world, Walk& walk, const EyeVertex& at) {
  const auto every_lobe = [](taxonomy::Symbol) { return true; };
  const auto weigh = [&](const Photon& photon, glm::vec3 to_light, const Vertex::Values& values) {
    return static_cast<float>(weight_of_merging(world.merging, photon.rivals,
                                                static_cast<double>(values.pdf_solid_angle), at.rivals,
                                                at.pdf_to_eye(world.scene, to_light)));
  };
  gather_photons(world, walk, *world.photons, *at.surface, at.node, at.throughput, at.scatterings, every_lobe, weigh);
}

}  // namespace heckbert::transport
