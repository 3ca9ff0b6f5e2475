#include <heckbert/transport/microfacet.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

namespace {

bool is_ggx(const Microfacets& f) {
  return f.distribution == Microfacets::Distribution::Ggx;
}

/// Not from the cosine alone, which is near one for the facets of a smooth surface and cancels.
float squared_slope(const Microfacets& f, glm::vec3 h) {
  const float x = h.x / f.alpha_x, y = h.y / f.alpha_y;
  return x * x + y * y;
}

glm::vec3 sample_visible_ggx(const Microfacets& f, glm::vec3 wo, glm::vec2 u) {
  const glm::vec3 stretched = glm::normalize(glm::vec3(f.alpha_x * wo.x, f.alpha_y * wo.y, wo.z));
  const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
  const glm::vec3 t1 =
      length2 > 0 ? glm::vec3(-stretched.y, stretched.x, 0.0f) / std::sqrt(length2) : glm::vec3(1, 0, 0);
  const glm::vec3 t2 = glm::cross(stretched, t1);
  glm::vec2 p = uniform_disk(u);
  const float blend = 0.5f * (1.0f + stretched.z);
  p.y = (1.0f - blend) * std::sqrt(std::max(0.0f, 1.0f - p.x * p.x)) + blend * p.y;
  const glm::vec3 n = p.x * t1 + p.y * t2 + std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y)) * stretched;
  return glm::normalize(glm::vec3(f.alpha_x * n.x, f.alpha_y * n.y, std::max(1e-6f, n.z)));
}

glm::vec3 sample_beckmann(const Microfacets& f, glm::vec2 u) {
  const float slope = std::sqrt(-std::log(1.0f - u.x));
  const float phi = 2.0f * kPi * u.y;
  return glm::normalize(glm::vec3(f.alpha_x * slope * std::cos(phi), f.alpha_y * slope * std::sin(phi), 1.0f));
}

}  // namespace

float facet_density(const Microfacets& f, glm::vec3 h) {
  const float slope2 = squared_slope(f, h), cos2 = h.z * h.z;
  const float area = kPi * f.alpha_x * f.alpha_y;
  if (is_ggx(f)) {
    const float d = slope2 + cos2;
    return 1.0f / (area * d * d);
  }
  return cos2 > 0 ? std::exp(-slope2 / cos2) / (area * cos2 * cos2) : 0.0f;
}

float smith_lambda(const Microfacets& f, glm::vec3 w) {
  const float x = f.alpha_x * w.x, y = f.alpha_y * w.y;
  const float alpha2_tan2 = (x * x + y * y) / (w.z * w.z);
  if (is_ggx(f)) return 0.5f * (std::sqrt(1.0f + alpha2_tan2) - 1.0f);
  const float a = 1.0f / std::sqrt(alpha2_tan2);
  if (a > 4.0f) return 0.0f;  // below 1e-9
  return std::max(0.0f, 0.5f * (std::exp(-a * a) / (a * std::sqrt(kPi)) - std::erfc(a)));
}

float masking(const Microfacets& f, glm::vec3 wo, glm::vec3 wi) {
  const float hidden_o = smith_lambda(f, wo), hidden_i = smith_lambda(f, wi);
  return wo.z * wi.z > 0 ? 1.0f / (1.0f + hidden_o + hidden_i) : 1.0f / ((1.0f + hidden_o) * (1.0f + hidden_i));
}

glm::vec3 sample_facet(const Microfacets& f, glm::vec3 wo, glm::vec2 u) {
  return is_ggx(f) ? sample_visible_ggx(f, wo, u) : sample_beckmann(f, u);
}

float pdf_facet(const Microfacets& f, glm::vec3 wo, glm::vec3 h) {
  if (!is_ggx(f)) return facet_density(f, h) * h.z;
  return facet_density(f, h) * std::max(0.0f, glm::dot(wo, h)) / ((1.0f + smith_lambda(f, wo)) * wo.z);
}

}  // namespace heckbert::transport
