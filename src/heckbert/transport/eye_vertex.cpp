#include <heckbert/transport/eye_vertex.h>

#include <heckbert/transport/medium.h>

namespace heckbert::transport {

double EyeVertex::pdf_to_eye(const Scene& scene, glm::vec3 to_light) const {
  return static_cast<double>(surface != nullptr ? pdf_from_light(scene, *surface, index_in_front, to_light, to_eye)
                                                : phase(particle->anisotropy, glm::dot(-to_light, to_eye)));
}

Scattering scatter(const EyeVertex& at, glm::vec3 to_light) {
  Scattering result;
  if (at.surface == nullptr) {
    result.lobes = 1;
    result.pdf_to_light = phase(at.particle->anisotropy, glm::dot(-at.to_eye, to_light));
    result.f[0] = Rgb(result.pdf_to_light);
    result.letters[0] = taxonomy::Symbol::V;
    return result;
  }
  const Vertex& vertex = *at.surface;
  const glm::vec3 wi = vertex.local(to_light);
  if (wi.z == 0 || (wi.z < 0 && !vertex.transmits)) return result;
  const Vertex::Values values = vertex.values(wi);
  const std::span<const Lobe> lobes = vertex.lobes();
  result.lobes = lobes.size();
  result.pdf_to_light = values.pdf_solid_angle;
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    result.f[i] = values.f[i] * std::abs(wi.z);
    result.letters[i] = letter(lobes[i], wi.z < 0);
  }
  return result;
}

Rgb arriving_light(const World& world, Walk& walk, const EyeVertex& at, const LightSample& light, Passage& passage) {
  if (at.surface == nullptr) return arriving(world, walk.rays, walk.bodies, at.position, light, &passage);
  const Place place = at.place();
  const bool transmitted = at.surface->local(light.direction).z < 0;
  return arriving_light(world, walk, *at.surface, transmitted, place.leave(light.direction), light, &passage);
}

}  // namespace heckbert::transport
