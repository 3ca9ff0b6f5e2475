#include <heckbert/transport/lobe_glossy.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lobe_specular.h>
#include <heckbert/transport/microfacet.h>

namespace heckbert::transport {

Rgb evaluate_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  const glm::vec3 h = glm::normalize(wo + wi);
  const float facets = facet_density(lobe.facets, h) * masking(lobe.facets, wo, wi) / (4.0f * wo.z * wi.z);
  return lobe.tint * fresnel(lobe.fresnel, glm::dot(wi, h)) * facets;
}

float pdf_of_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  const glm::vec3 h = glm::normalize(wo + wi);
  return pdf_facet(lobe.facets, wo, h) / (4.0f * glm::dot(wo, h));
}

glm::vec3 sample_lobe(const MicrofacetReflection& lobe, glm::vec3 wo, glm::vec3 u, bool) {
  const glm::vec3 h = sample_facet(lobe.facets, wo, glm::vec2(u));
  return 2.0f * glm::dot(wo, h) * h - wo;
}

namespace {

/// The n-th power of the cosine about the mirror direction; nothing beyond a right angle, for n = 0 too.
float phong_power(const Phong& lobe, glm::vec3 wo, glm::vec3 wi) {
  const float cosine = glm::dot(mirrored(wo), wi);
  return cosine > 0 ? std::pow(std::min(cosine, 1.0f), lobe.exponent) : 0.0f;
}

}  // namespace

Rgb evaluate_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  return lobe.reflectance * ((lobe.exponent + 2.0f) / (2.0f * kPi) * phong_power(lobe, wo, wi));
}

float pdf_of_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 wi, bool) {
  return (lobe.exponent + 1.0f) / (2.0f * kPi) * phong_power(lobe, wo, wi);
}

glm::vec3 sample_lobe(const Phong& lobe, glm::vec3 wo, glm::vec3 u, bool) {
  const float cos_lobe = std::pow(u.x, 1.0f / (lobe.exponent + 1.0f));
  const float sin_lobe = std::sqrt(std::max(0.0f, 1.0f - cos_lobe * cos_lobe));
  const float phi = 2.0f * kPi * u.y;
  return Frame::around(mirrored(wo)).to_world({sin_lobe * std::cos(phi), sin_lobe * std::sin(phi), cos_lobe});
}

}  // namespace heckbert::transport
