#include <heckbert/transport/lobe_specular.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/fresnel.h>

namespace heckbert::transport {

using taxonomy::Symbol;

DeltaBranches branches_of(const Mirror& lobe, glm::vec3 wo) {
  return {.reflected = {Symbol::Sr, mirrored(wo), lobe.tint * fresnel(lobe.fresnel, wo.z), 1}, .transmitted = {}};
}

DeltaBranches branches_of(const Dielectric& lobe, glm::vec3 wo, bool front) {
  const float eta = front ? lobe.ior : 1.0f / lobe.ior;
  const float reflectance = fresnel_dielectric(wo.z, eta);
  DeltaBranches out{.reflected = {Symbol::Sr, mirrored(wo), lobe.reflection_tint * reflectance, 1}, .transmitted = {}};
  if (reflectance < 1.0f) {
    const float cos_t = std::sqrt(std::max(0.0f, 1.0f - (1.0f - wo.z * wo.z) / (eta * eta)));
    const glm::vec3 wi(-wo.x / eta, -wo.y / eta, -cos_t);
    const float compression = 1.0f / (eta * eta);
    out.transmitted = DeltaBranch{Symbol::St, glm::normalize(wi),
                                  lobe.transmission_tint * ((1.0f - reflectance) * compression), compression};
  }
  return out;
}

DeltaBranches branches_of(const ThinDielectric& lobe, glm::vec3 wo) {
  const float face = fresnel_dielectric(wo.z, lobe.ior);
  const float reflectance = 2.0f * face / (1.0f + face);
  return {.reflected = {Symbol::Sr, mirrored(wo), lobe.reflection_tint * reflectance, 1},
          .transmitted = DeltaBranch{Symbol::St, -wo, lobe.transmission_tint * (1.0f - reflectance), 1}};
}

}  // namespace heckbert::transport
