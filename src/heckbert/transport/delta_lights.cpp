#include <heckbert/transport/delta_lights.h>

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace heckbert::transport {

std::optional<DeltaSample> sample_delta(const PointLight& light, glm::vec3 from) {
  const glm::vec3 d = light.position - from;
  const float distance2 = glm::dot(d, d);
  if (!(distance2 > 0)) return std::nullopt;
  return DeltaSample{d / std::sqrt(distance2), light.intensity / distance2};
}

std::optional<DeltaSample> sample_delta(const SpotLight& light, glm::vec3 from) {
  std::optional<DeltaSample> s = sample_delta(PointLight{light.position, light.intensity}, from);
  if (!s) return std::nullopt;
  const float falloff = spot_falloff(light, -glm::dot(s->direction, glm::normalize(light.direction)));
  if (!(falloff > 0)) return std::nullopt;
  s->irradiance *= falloff;
  return s;
}

DeltaSample sample_delta(const DistantLight& light) {
  return {-glm::normalize(light.direction), light.irradiance};
}

float spot_falloff(const SpotLight& light, float cos_angle) {
  const float cutoff = glm::radians(light.cutoff_degrees), start = glm::radians(light.falloff_degrees);
  const float angle = std::acos(glm::clamp(cos_angle, -1.0f, 1.0f));
  if (angle <= start) return 1;
  return angle < cutoff ? (cutoff - angle) / (cutoff - start) : 0.0f;
}

double power(const PointLight& light) {
  return 4 * std::numbers::pi * max_channel(light.intensity);
}

double power(const SpotLight& light) {
  // The falloff integrated over the sphere of directions.
  const double cutoff = glm::radians(static_cast<double>(light.cutoff_degrees));
  const double start = glm::radians(static_cast<double>(light.falloff_degrees));
  const double edge = cutoff > start ? (std::sin(cutoff) - std::sin(start)) / (cutoff - start) : std::cos(cutoff);
  return 2 * std::numbers::pi * (1 - edge) * max_channel(light.intensity);
}

double power(const DistantLight& light, double scene_radius) {
  return std::numbers::pi * scene_radius * scene_radius * max_channel(light.irradiance);
}

}  // namespace heckbert::transport
