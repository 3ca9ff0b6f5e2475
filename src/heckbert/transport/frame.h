#pragma once
// Orthonormal frames and the classical warps from the unit square. Local directions have the normal along z.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace heckbert::transport {

inline constexpr float kPi = std::numbers::pi_v<float>;

struct Frame {
  glm::vec3 s, t, n;

  /// Any frame around a unit normal (Duff et al. 2017, "Building an Orthonormal Basis, Revisited"). A call would return
  /// it through memory, which costs more than making it (docs/performance.md).
  [[gnu::always_inline]] static Frame around(glm::vec3 n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }
  /// The frame around a unit normal whose s lies as near to `tangent` as it can; any frame when that is nowhere.
  static Frame along(glm::vec3 n, glm::vec3 tangent) {
    const glm::vec3 s = tangent - glm::dot(tangent, n) * n;
    const float length2 = glm::dot(s, s);
    if (!(length2 > 0)) return around(n);
    const glm::vec3 unit = s / std::sqrt(length2);
    return {unit, glm::cross(n, unit), n};
  }
  glm::vec3 to_local(glm::vec3 world) const { return {glm::dot(world, s), glm::dot(world, t), glm::dot(world, n)}; }
  glm::vec3 to_world(glm::vec3 local) const { return local.x * s + local.y * t + local.z * n; }
};

inline glm::vec3 uniform_sphere(glm::vec2 u) {
  const float z = 1.0f - 2.0f * u.x;
  const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const float phi = 2.0f * kPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

inline glm::vec2 uniform_disk(glm::vec2 u) {
  const float r = std::sqrt(u.x);
  const float phi = 2.0f * kPi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// Density cos / pi per steradian.
inline glm::vec3 cosine_hemisphere(glm::vec2 u) {
  const glm::vec2 d = uniform_disk(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1.0f - u.x))};
}

/// Barycentric coordinates (of the second and third vertex), uniform over a triangle.
inline glm::vec2 uniform_triangle(glm::vec2 u) {
  const float root = std::sqrt(u.x);
  return {root * (1.0f - u.y), root * u.y};
}

}  // namespace heckbert::transport
