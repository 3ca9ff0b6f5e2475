#include <heckbert/transport/medium.h>

#include <cmath>

#include <glm/geometric.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

namespace {

/// No extinction times an infinite distance is no extinction.
float transmittance(float extinction, float distance) {
  return extinction > 0 ? std::exp(-extinction * distance) : 1.0f;
}

float mean(Rgb c) {
  return (c.r + c.g + c.b) / 3.0f;
}

}  // namespace

Rgb transmittance(const Medium& medium, float distance) {
  const Rgb e = extinction(medium);
  return {transmittance(e.r, distance), transmittance(e.g, distance), transmittance(e.b, distance)};
}

Stretch stretch(const Medium& medium, float distance) {
  Stretch way{.transmittance = transmittance(medium, distance)};
  if (is_black(medium.scattering)) return way;
  way.chance = mean(way.transmittance);
  if (way.chance > 0) way.rate = mean(way.transmittance * extinction(medium)) / way.chance;
  return way;
}

Flight fly(const Medium& medium, float farthest, Sampler& sampler) {
  if (is_black(medium.scattering)) return {farthest, false, transmittance(medium, farthest)};
  const Rgb e = extinction(medium);
  const glm::vec2 u = sampler.next2();
  const float chosen = u.x < 1.0f / 3.0f ? e.r : u.x < 2.0f / 3.0f ? e.g : e.b;
  const float distance = chosen > 0 ? -std::log1p(-u.y) / chosen : farthest;
  if (!(distance < farthest)) {
    const Rgb passed = transmittance(medium, farthest);
    return {farthest, false, mean(passed) > 0 ? passed / mean(passed) : Rgb{}};
  }
  const Rgb passed = transmittance(medium, distance);
  return {distance, true, passed * medium.scattering / mean(passed * e)};
}

float phase(float g, float cosine) {
  const float d = 1.0f + g * g - 2.0f * g * cosine;
  return (1.0f - g * g) / (4.0f * kPi * d * std::sqrt(d));
}

glm::vec3 sample_phase(float g, glm::vec3 direction, glm::vec2 u) {
  constexpr float kNearlyIsotropic = 3e-4f;
  float cosine = 1.0f - 2.0f * u.x;
  if (std::abs(g) > kNearlyIsotropic) {
    const float root = (1.0f - g * g) / (1.0f + g * cosine);
    cosine = std::clamp((1.0f + g * g - root * root) / (2.0f * g), -1.0f, 1.0f);
  }
  const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  const float phi = 2.0f * kPi * u.y;
  return Frame::around(direction).to_world({sine * std::cos(phi), sine * std::sin(phi), cosine});
}

}  // namespace heckbert::transport
