#include <heckbert/transport/lobe_rough_dielectric.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/microfacet.h>

namespace heckbert::transport {

namespace {

float relative_index(const RoughDielectric& lobe, bool front) {
  return front ? lobe.ior : 1.0f / lobe.ior;
}

/// The facet that takes wo to wi, and the Jacobian from its normal to wi.
struct Facet {
  glm::vec3 h;
  float cos_o = 0, cos_i = 0;  ///< with h; cos_i is below zero for transmission
  float jacobian = 0;          ///< steradians of h per steradian of wi
};

std::optional<Facet> facet_between(glm::vec3 wo, glm::vec3 wi, float eta) {
  const bool reflection = wi.z > 0;
  glm::vec3 h = reflection ? wo + wi : wo + eta * wi;
  const float length2 = glm::dot(h, h);
  if (!(length2 > 0)) return std::nullopt;
  h *= (h.z < 0 ? -1.0f : 1.0f) / std::sqrt(length2);
  Facet f{.h = h, .cos_o = glm::dot(wo, h), .cos_i = glm::dot(wi, h)};
  if (f.cos_o <= 0 || (f.cos_i > 0) != reflection) return std::nullopt;
  const float spread = f.cos_i + f.cos_o / eta;
  f.jacobian = reflection ? 1.0f / (4.0f * f.cos_o) : -f.cos_i / (spread * spread);
  return f;
}

/// The share of draws that a facet reflects.
float reflection_probability(const RoughDielectric& lobe, float fresnel) {
  const float reflect = max_channel(lobe.reflection_tint) * fresnel;
  const float transmit = max_channel(lobe.transmission_tint) * (1.0f - fresnel);
  return reflect + transmit > 0 ? reflect / (reflect + transmit) : fresnel;
}

}  // namespace

Rgb evaluate_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 wi, bool front) {
  const float eta = relative_index(lobe, front);
  const std::optional<Facet> f = facet_between(wo, wi, eta);
  if (!f) return {};
  const float reflected = fresnel_dielectric(f->cos_o, eta);
  const float facets = facet_density(lobe.facets, f->h) * masking(lobe.facets, wo, wi);
  const float flux = facets * f->cos_o * f->jacobian / (wo.z * std::abs(wi.z));
  if (wi.z > 0) return lobe.reflection_tint * (reflected * flux);
  return lobe.transmission_tint * ((1.0f - reflected) * flux / (eta * eta));
}

float pdf_of_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 wi, bool front) {
  const float eta = relative_index(lobe, front);
  const std::optional<Facet> f = facet_between(wo, wi, eta);
  if (!f) return 0;
  const float reflect = reflection_probability(lobe, fresnel_dielectric(f->cos_o, eta));
  return (wi.z > 0 ? reflect : 1.0f - reflect) * pdf_facet(lobe.facets, wo, f->h) * f->jacobian;
}

glm::vec3 sample_lobe(const RoughDielectric& lobe, glm::vec3 wo, glm::vec3 u, bool front) {
  const float eta = relative_index(lobe, front);
  const glm::vec3 h = sample_facet(lobe.facets, wo, glm::vec2(u));
  const float cos_o = glm::dot(wo, h);
  if (cos_o <= 0) return glm::vec3(0);
  const float fresnel = fresnel_dielectric(cos_o, eta);
  if (u.z < reflection_probability(lobe, fresnel)) {
    const glm::vec3 wi = 2.0f * cos_o * h - wo;
    return wi.z > 0 ? wi : glm::vec3(0);
  }
  const float cos_i = std::sqrt(std::max(0.0f, 1.0f - (1.0f - cos_o * cos_o) / (eta * eta)));
  const glm::vec3 wi = glm::normalize((cos_o / eta - cos_i) * h - wo / eta);
  return wi.z < 0 ? wi : glm::vec3(0);
}

}  // namespace heckbert::transport
