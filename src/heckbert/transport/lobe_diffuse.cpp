#include <heckbert/transport/lobe_diffuse.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include <heckbert/transport/coat.h>

namespace heckbert::transport {

Rgb evaluate_lobe(const OrenNayar& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  const float a = 1.0f / (kPi + (kPi / 2.0f - 2.0f / 3.0f) * lobe.roughness);
  const float s = glm::dot(wo, wi) - wo.z * wi.z;
  const float t = s > 0 ? std::max(wo.z, wi.z) : 1.0f;
  return lobe.albedo * (a * (1.0f + lobe.roughness * s / t));
}

Rgb evaluate_lobe(const CoatedDiffuse& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  const Coat& coat = lobe.coat;
  const float passes = (1.0f - coat_albedo(coat, wo.z)) * (1.0f - coat_albedo(coat, wi.z));
  // Of diffuse light below the coat, 1 - inside gets out; radiance spreads by the squared index on its way in. For what
  // the coat does not absorb the two means are tied together by reciprocity.
  const float compression = 1.0f / (coat.ior * coat.ior);
  const float leaves = (1.0f - mean_coat_albedo(coat)) * compression;
  const float inside = 1.0f - leaves;
  const auto base = [&](float albedo) {
    return albedo * passes * compression / (kPi * (lobe.linear ? leaves : 1.0f - albedo * inside));
  };
  return lobe.tint * Rgb(base(lobe.albedo.r), base(lobe.albedo.g), base(lobe.albedo.b));
}

}  // namespace heckbert::transport
