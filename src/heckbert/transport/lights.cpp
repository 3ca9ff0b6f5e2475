#include <heckbert/transport/lights.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

// A sphere seen from outside is sampled by the cone it subtends; 1 - cos of that cone, without cancellation.
float one_minus_cos_cone(const Emitter& sphere, float distance2) {
  const float sin2 = sphere.radius * sphere.radius / distance2;
  return sin2 / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sin2)));
}

bool is_outside(const Emitter& sphere, float distance2) {
  const float clear = sphere.radius + sphere.error;
  return distance2 > clear * clear;
}

/// Density by area turned into density by solid angle; 0 edge on.
float per_solid_angle(float pdf_area, float distance2, float cos_light) {
  return cos_light > 0 ? pdf_area * distance2 / cos_light : 0.0f;
}

glm::vec3 triangle_normal(const Emitter& e) {
  return glm::normalize(glm::cross(e.p1 - e.p0, e.p2 - e.p0));
}

}  // namespace

Lights::Lights(const Scene& scene, const Tracer& tracer) : scene_(scene), tracer_(tracer) {
  std::vector<double> power;
  const auto& emitters = tracer.emitters();
  for (std::uint32_t i = 0; i < emitters.size(); ++i) {
    const Material& material = scene.materials[emitters[i].material];
    const double sides = material.emission_sides == Sides::Both ? 2 : 1;
    sources_.push_back({Source::Type::Emitter, i});
    power.push_back(sides * kPi * emitters[i].area * max_channel(material.emission));
  }
  for (std::uint32_t i = 0; i < scene.point_lights.size(); ++i) {
    if (is_black(scene.point_lights[i].intensity)) continue;
    sources_.push_back({Source::Type::Point, i});
    power.push_back(4.0 * kPi * max_channel(scene.point_lights[i].intensity));
  }
  if (!is_black(scene.environment)) {
    const float radius = 0.5f * glm::length(tracer.bounds_high() - tracer.bounds_low());
    environment_source_ = sources_.size();
    sources_.push_back({Source::Type::Environment, 0});
    const double sky = double{kPi} * kPi * radius * radius * max_channel(scene.environment);
    // A wide floor must not starve the lamps that stand on it: the sky is never chosen more often than all of them.
    const double lamps = std::accumulate(power.begin(), power.end(), 0.0);
    power.push_back(lamps > 0 ? std::min(sky, lamps) : 1.0);
  }
  const double total = std::accumulate(power.begin(), power.end(), 0.0);
  double sum = 0;
  for (const double p : power) cumulative_.push_back(static_cast<float>((sum += p) / total));
  if (!cumulative_.empty()) cumulative_.back() = 1.0f;
}

Rgb Lights::emitted(std::uint32_t material, bool front) const {
  const Material& m = scene_.materials[material];
  return front || m.emission_sides == Sides::Both ? m.emission : Rgb{};
}

Rgb Lights::emitted(const Hit& hit) const {
  return hit.emitter == kNoEmitter ? Rgb{} : emitted(hit.material, hit.front);
}

float Lights::pdf_environment() const {
  return environment_source_ ? probability(*environment_source_) / (4.0f * kPi) : 0.0f;
}

float Lights::pdf_solid_angle(const Hit& hit, glm::vec3 from) const {
  const Emitter& e = tracer_.emitters()[hit.emitter];
  const float choice = probability(hit.emitter);
  if (e.is_sphere) {
    const glm::vec3 to_center = e.center - from;
    const float distance2 = glm::dot(to_center, to_center);
    if (is_outside(e, distance2)) return choice / (2.0f * kPi * one_minus_cos_cone(e, distance2));
  }
  const glm::vec3 d = hit.position - from;
  const float distance2 = glm::dot(d, d);
  return per_solid_angle(choice / e.area, distance2,
                         std::abs(glm::dot(d, hit.normal_geometric)) / std::sqrt(distance2));
}

std::optional<LightSample> Lights::sample(glm::vec3 from, Sampler& sampler) const {
  const float pick = sampler.next();
  const glm::vec2 u = sampler.next2();
  if (cumulative_.empty()) return std::nullopt;
  const auto chosen = static_cast<std::size_t>(std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, pick) -
                                               cumulative_.begin());
  const Source source = sources_[chosen];
  const float choice = probability(chosen);
  LightSample s;

  if (source.type == Source::Type::Environment) {
    s.kind = Symbol::Le;
    s.infinite = true;
    s.direction = uniform_sphere(u);
    s.radiance = scene_.environment;
    s.pdf_solid_angle = choice / (4.0f * kPi);
    return s;
  }

  if (source.type == Source::Type::Point) {
    const PointLight& light = scene_.point_lights[source.index];
    const glm::vec3 d = light.position - from;
    const float distance2 = glm::dot(d, d);
    if (!(distance2 > 0)) return std::nullopt;
    s.kind = Symbol::Lp;
    s.direction = d / std::sqrt(distance2);
    s.target = light.position;
    s.radiance = light.intensity / distance2;
    s.pdf_solid_angle = choice;
    s.is_delta = true;
    return s;
  }

  const Emitter& e = tracer_.emitters()[source.index];
  s.kind = Symbol::La;
  glm::vec3 position, normal;
  bool by_cone = false;
  if (!e.is_sphere) {
    const glm::vec2 b = uniform_triangle(u);
    position = (1.0f - b.x - b.y) * e.p0 + b.x * e.p1 + b.y * e.p2;
    normal = triangle_normal(e);
  } else {
    const glm::vec3 to_center = e.center - from;
    const float distance2 = glm::dot(to_center, to_center);
    by_cone = is_outside(e, distance2);
    if (by_cone) {
      // A direction in the cone, then the nearer of its two intersections with the sphere (Shirley, Wang, Zimmerman
      // 1996), written as a point on the sphere so that the shadow ray ends exactly there. Its angle at the centre
      // follows from the law of sines, which stays exact for a sphere as small and far as a star.
      const float distance = std::sqrt(distance2);
      const float one_minus_cos = u.x * one_minus_cos_cone(e, distance2);
      const float sin2_theta = one_minus_cos * (2.0f - one_minus_cos);
      const float in_radii = distance / e.radius;
      const float cos_alpha = std::min(
          1.0f, sin2_theta * in_radii +
                    (1.0f - one_minus_cos) * std::sqrt(std::max(0.0f, 1.0f - sin2_theta * in_radii * in_radii)));
      const float sin_alpha = std::sqrt(std::max(0.0f, 1.0f - cos_alpha * cos_alpha));
      const float phi = 2.0f * kPi * u.y;
      normal = Frame::around(-to_center / distance)
                   .to_world({sin_alpha * std::cos(phi), sin_alpha * std::sin(phi), cos_alpha});
      s.pdf_solid_angle = choice / (2.0f * kPi * one_minus_cos_cone(e, distance2));
    } else {
      normal = uniform_sphere(u);
    }
    position = e.center + e.radius * normal;
  }

  const glm::vec3 d = position - from;
  const float distance2 = glm::dot(d, d);
  if (!(distance2 > 0)) return std::nullopt;
  s.direction = d / std::sqrt(distance2);
  const float cos_light = -glm::dot(s.direction, normal);
  const bool front = cos_light > 0;
  s.radiance = emitted(e.material, front);
  if (is_black(s.radiance)) return std::nullopt;
  if (!by_cone) s.pdf_solid_angle = per_solid_angle(choice / e.area, distance2, std::abs(cos_light));
  if (!(s.pdf_solid_angle > 0)) return std::nullopt;
  s.target = position + (front ? e.error : -e.error) * normal;
  return s;
}

}  // namespace heckbert::transport
