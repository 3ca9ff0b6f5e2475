#include <heckbert/transport/spherical_triangle.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace heckbert::transport {

namespace {

/// The part of v that is perpendicular to the unit vector n, made unit.
glm::dvec3 perpendicular(glm::dvec3 v, glm::dvec3 n) {
  const glm::dvec3 rest = v - glm::dot(v, n) * n;
  const double length = glm::length(rest);
  return length > 0 ? rest / length : glm::dvec3(0);
}

}  // namespace

SphericalTriangle::SphericalTriangle(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 normal, glm::vec3 from)
    : from_(from),
      normal_(normal),
      plane_(glm::dot(glm::dvec3(p0) - from_, normal_)),
      a_(glm::normalize(glm::dvec3(p0) - from_)),
      b_(glm::normalize(glm::dvec3(p1) - from_)),
      c_(glm::normalize(glm::dvec3(p2) - from_)) {
  // Van Oosterom and Strackee 1983: no differences of angles.
  const double volume = std::abs(glm::dot(a_, glm::cross(b_, c_)));
  solid_angle_ = 2 * std::atan2(volume, 1 + glm::dot(a_, b_) + glm::dot(b_, c_) + glm::dot(c_, a_));
}

glm::vec3 SphericalTriangle::sample(glm::vec2 u) const {
  // The angle at a, between the planes of its two sides.
  const double cos_alpha = std::clamp(glm::dot(perpendicular(b_, a_), perpendicular(c_, a_)), -1.0, 1.0);
  const double alpha = std::acos(cos_alpha), sin_alpha = std::sin(alpha), cos_c = glm::dot(a_, b_);
  // The corner c' on the side from a to c that leaves the fraction u.x of the area on the side of b.
  const double angle = static_cast<double>(u.x) * solid_angle_ - alpha;
  const double s = std::sin(angle), t = std::cos(angle);
  const double p = t - cos_alpha, q = s + sin_alpha * cos_c;
  const double cos_side =
      std::clamp(((q * t - p * s) * cos_alpha - q) / ((q * s + p * t) * sin_alpha), glm::dot(a_, c_), 1.0);
  const glm::dvec3 corner = cos_side * a_ + std::sqrt(std::max(0.0, 1 - cos_side * cos_side)) * perpendicular(c_, a_);
  // A point on the arc from b to c'.
  const double z = 1 - static_cast<double>(u.y) * (1 - glm::dot(corner, b_));
  const glm::dvec3 direction = z * b_ + std::sqrt(std::max(0.0, 1 - z * z)) * perpendicular(corner, b_);
  return glm::vec3(from_ + plane_ / glm::dot(direction, normal_) * direction);
}

}  // namespace heckbert::transport
