#include <heckbert/transport/spherical_rectangle.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace heckbert::transport {

SphericalRectangle::SphericalRectangle(glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v, glm::vec3 from)
    : from_(from) {
  const glm::dvec3 u(edge_u), v(edge_v), d = glm::dvec3(corner) - from_;
  const double length_u = glm::length(u), length_v = glm::length(v);
  x_ = u / length_u;
  y_ = v / length_v;
  z_ = glm::cross(x_, y_);
  x0_ = glm::dot(d, x_);
  y0_ = glm::dot(d, y_);
  z0_ = glm::dot(d, z_);
  if (z0_ > 0) {
    z_ = -z_;
    z0_ = -z0_;
  }
  x1_ = x0_ + length_u;
  y1_ = y0_ + length_v;
  // The solid angle of the rectangle from the foot of the perpendicular to (x, y), signed.
  const auto quadrant = [this](double x, double y) {
    return std::atan2(x * y, -z0_ * std::sqrt(x * x + y * y + z0_ * z0_));
  };
  solid_angle_ = z0_ < 0 ? quadrant(x1_, y1_) - quadrant(x0_, y1_) - quadrant(x1_, y0_) + quadrant(x0_, y0_) : 0.0;
}

glm::vec3 SphericalRectangle::sample(glm::vec2 u) const {
  // z components of the unit normals of the planes through the eye and the edges y = y0, y = y1 and x = x0.
  const double b0 = -y0_ / std::hypot(y0_, z0_), b1 = y1_ / std::hypot(y1_, z0_);
  const double b3 = -x0_ / std::hypot(x0_, z0_);
  // The inner angles at the two corners of x = x0; then, column by column, the x that leaves the fraction u.x of the
  // solid angle on its left.
  const double angle_1 = std::acos(std::clamp(-b1 * b3, -1.0, 1.0)),
               angle_0 = std::acos(std::clamp(-b3 * b0, -1.0, 1.0));
  const double phi = static_cast<double>(u.x) * solid_angle_ + 2 * std::numbers::pi - angle_1 - angle_0;
  const double f = (std::cos(phi) * b0 - b1) / std::sin(phi);
  const double cosine = std::clamp(std::copysign(1 / std::hypot(f, b0), f), -1.0, 1.0);
  const double x = std::clamp(-cosine * z0_ / std::sqrt(std::max(1 - cosine * cosine, 1e-30)), x0_, x1_);
  // Within the column, the sine of the elevation is uniform.
  const double d = std::hypot(x, z0_);
  const double h0 = y0_ / std::hypot(d, y0_), h1 = y1_ / std::hypot(d, y1_);
  const double h = h0 + static_cast<double>(u.y) * (h1 - h0);
  const double y = std::clamp(h * d / std::sqrt(std::max(1 - h * h, 1e-30)), y0_, y1_);
  return glm::vec3(from_ + x * x_ + y * y_ + z0_ * z_);
}

}  // namespace heckbert::transport
