#include <heckbert/transport/lobe.h>

#include <cmath>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

glm::vec3 mirrored(glm::vec3 wo) {
  return {-wo.x, -wo.y, wo.z};
}

// GGX after Walter et al. 2007; height-correlated Smith masking and visible normals after Heitz 2014 and 2018.
float ggx_density(glm::vec3 h, float alpha) {
  const float a2 = alpha * alpha;
  const float d = h.x * h.x + h.y * h.y + a2 * h.z * h.z;  // not from the cosine alone, which is near one and cancels
  return a2 / (kPi * d * d);
}

float smith_lambda(glm::vec3 w, float alpha) {
  const float cos2 = w.z * w.z;
  const float tan2 = std::max(0.0f, 1.0f - cos2) / cos2;
  return 0.5f * (std::sqrt(1.0f + alpha * alpha * tan2) - 1.0f);
}

Rgb schlick(Rgb f0, float cos_i) {
  const float m = std::clamp(1.0f - cos_i, 0.0f, 1.0f);
  const float m5 = m * m * m * m * m;
  return f0 + (Rgb(1.0f) - f0) * m5;
}

glm::vec3 visible_normal(glm::vec3 wo, float alpha, glm::vec2 u) {
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * wo.x, alpha * wo.y, wo.z));
  const float length2 = stretched.x * stretched.x + stretched.y * stretched.y;
  const glm::vec3 t1 =
      length2 > 0 ? glm::vec3(-stretched.y, stretched.x, 0.0f) / std::sqrt(length2) : glm::vec3(1, 0, 0);
  const glm::vec3 t2 = glm::cross(stretched, t1);
  glm::vec2 p = uniform_disk(u);
  const float blend = 0.5f * (1.0f + stretched.z);
  p.y = (1.0f - blend) * std::sqrt(std::max(0.0f, 1.0f - p.x * p.x)) + blend * p.y;
  const glm::vec3 n = p.x * t1 + p.y * t2 + std::sqrt(std::max(0.0f, 1.0f - p.x * p.x - p.y * p.y)) * stretched;
  return glm::normalize(glm::vec3(alpha * n.x, alpha * n.y, std::max(1e-6f, n.z)));
}

/// The n-th power of the cosine about the mirror direction; nothing beyond a right angle, for n = 0 too.
float phong_power(const Phong& l, glm::vec3 wo, glm::vec3 wi) {
  const float cosine = glm::dot(mirrored(wo), wi);
  return cosine > 0 ? std::pow(std::min(cosine, 1.0f), l.exponent) : 0.0f;
}

}  // namespace

bool is_delta(const Lobe& lobe) {
  return std::holds_alternative<Mirror>(lobe) || std::holds_alternative<Dielectric>(lobe);
}

Symbol letter(const Lobe& lobe) {
  return std::holds_alternative<Lambert>(lobe) ? Symbol::Dr : Symbol::Gr;
}

Rgb evaluate(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi) {
  if (wo.z <= 0 || wi.z <= 0) return {};
  return std::visit(
      Overload{
          [](const Lambert& l) { return l.albedo * (1.0f / kPi); },
          [&](const Ggx& l) {
            const glm::vec3 h = glm::normalize(wo + wi);
            const float masking = 1.0f / (1.0f + smith_lambda(wo, l.alpha) + smith_lambda(wi, l.alpha));
            return schlick(l.f0, glm::dot(wi, h)) * (ggx_density(h, l.alpha) * masking / (4.0f * wo.z * wi.z));
          },
          [&](const Phong& l) { return l.reflectance * ((l.exponent + 2.0f) / (2.0f * kPi) * phong_power(l, wo, wi)); },
          [](const auto&) { return Rgb{}; },
      },
      lobe);
}

float pdf_solid_angle(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi) {
  if (wo.z <= 0 || wi.z <= 0) return 0;
  return std::visit(Overload{
                        [&](const Lambert&) { return wi.z / kPi; },
                        [&](const Ggx& l) {
                          const glm::vec3 h = glm::normalize(wo + wi);
                          return ggx_density(h, l.alpha) / ((1.0f + smith_lambda(wo, l.alpha)) * 4.0f * wo.z);
                        },
                        [&](const Phong& l) { return (l.exponent + 1.0f) / (2.0f * kPi) * phong_power(l, wo, wi); },
                        [](const auto&) { return 0.0f; },
                    },
                    lobe);
}

std::optional<glm::vec3> sample_direction(const Lobe& lobe, glm::vec3 wo, glm::vec2 u) {
  const std::optional<glm::vec3> wi = std::visit(
      Overload{
          [&](const Lambert&) { return std::optional(cosine_hemisphere(u)); },
          [&](const Ggx& l) {
            const glm::vec3 h = visible_normal(wo, l.alpha, u);
            return std::optional(2.0f * glm::dot(wo, h) * h - wo);
          },
          [&](const Phong& l) {
            const float cos_lobe = std::pow(u.x, 1.0f / (l.exponent + 1.0f));
            const float sin_lobe = std::sqrt(std::max(0.0f, 1.0f - cos_lobe * cos_lobe));
            const float phi = 2.0f * kPi * u.y;
            return std::optional(
                Frame::around(mirrored(wo)).to_world({sin_lobe * std::cos(phi), sin_lobe * std::sin(phi), cos_lobe}));
          },
          [](const auto&) { return std::optional<glm::vec3>(); },
      },
      lobe);
  if (!wi || wi->z <= 0) return std::nullopt;
  return wi;
}

float selection_weight(const Lobe& lobe, glm::vec3 wo) {
  return std::visit(Overload{
                        [](const Lambert& l) { return max_channel(l.albedo); },
                        [](const Mirror& l) { return max_channel(l.reflectance); },
                        [](const Dielectric& l) {
                          return std::max(max_channel(l.reflection_tint), max_channel(l.transmission_tint));
                        },
                        [&](const Ggx& l) { return max_channel(schlick(l.f0, wo.z)); },
                        [](const Phong& l) { return max_channel(l.reflectance); },
                    },
                    lobe);
}

float fresnel_dielectric(float cos_incident, float eta) {
  const float cos_i = std::clamp(cos_incident, 0.0f, 1.0f);
  const float sin2_t = (1.0f - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1.0f) return 1.0f;
  const float cos_t = std::sqrt(1.0f - sin2_t);
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

DeltaBranches delta_branches(const Lobe& lobe, glm::vec3 wo, bool entering) {
  DeltaBranches branches;
  branches.reflected.event = Symbol::Sr;
  branches.reflected.wi = mirrored(wo);
  if (const auto* mirror = std::get_if<Mirror>(&lobe)) {
    branches.reflected.weight = mirror->reflectance;
  } else if (const auto* glass = std::get_if<Dielectric>(&lobe)) {
    const float eta = entering ? glass->ior : 1.0f / glass->ior;
    const float reflectance = fresnel_dielectric(wo.z, eta);
    branches.reflected.weight = glass->reflection_tint * reflectance;
    if (reflectance < 1.0f) {
      const float cos_t = std::sqrt(std::max(0.0f, 1.0f - (1.0f - wo.z * wo.z) / (eta * eta)));
      const glm::vec3 wi(-wo.x / eta, -wo.y / eta, -cos_t);
      const float compression = 1.0f / (eta * eta);
      branches.transmitted = DeltaBranch{Symbol::St, glm::normalize(wi),
                                         glass->transmission_tint * ((1.0f - reflectance) * compression), compression};
    }
  }
  return branches;
}

}  // namespace heckbert::transport
