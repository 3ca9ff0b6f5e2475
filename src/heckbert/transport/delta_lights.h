#pragma once
// Lights that no ray can hit by chance: a point, a spot, a distant light. Each sends light to a place from one
// direction.

#include <optional>

#include <glm/vec3.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

struct DeltaSample {
  glm::vec3 direction{0};  ///< unit, from the lit place to the light
  Rgb irradiance;          ///< on a surface there that faces the light
};

/// Nothing at the light's own position, and outside a spot's cone.
std::optional<DeltaSample> sample_delta(const PointLight& light, glm::vec3 from);
std::optional<DeltaSample> sample_delta(const SpotLight& light, glm::vec3 from);
DeltaSample sample_delta(const DistantLight& light);

/// Intensity, as a share of that on the axis, at an angle with this cosine.
float spot_falloff(const SpotLight& light, float cos_angle);

/// Power in W, of the strongest channel. A distant light's goes by the radius of the scene that it crosses.
double power(const PointLight& light);
double power(const SpotLight& light);
double power(const DistantLight& light, double scene_radius);

}  // namespace heckbert::transport
