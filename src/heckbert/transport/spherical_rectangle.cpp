#include <heckbert/transport/spherical_rectangle.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace heckbert::transport {

namespace {

// Complex numbers stand for their angles.

glm::dvec2 sum_of_angles(glm::dvec2 a, glm::dvec2 b) {
  return {a.x * b.x - a.y * b.y, a.y * b.x + a.x * b.y};
}

glm::dvec2 difference_of_angles(glm::dvec2 a, glm::dvec2 b) {
  return {a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y};
}

}  // namespace

Rectangle::Rectangle(glm::vec3 at, glm::vec3 edge_u, glm::vec3 edge_v)
    : corner(at), length_u(glm::length(glm::dvec3(edge_u))), length_v(glm::length(glm::dvec3(edge_v))) {
  u = glm::dvec3(edge_u) / length_u;
  v = glm::dvec3(edge_v) / length_v;
  normal = glm::cross(u, v);
}

SphericalRectangle::SphericalRectangle(const Rectangle& rectangle, glm::vec3 from) : rectangle_(rectangle) {
  const glm::dvec3 d = rectangle.corner - glm::dvec3(from);
  x0_ = glm::dot(d, rectangle.u);
  x1_ = x0_ + rectangle.length_u;
  y0_ = glm::dot(d, rectangle.v);
  y1_ = y0_ + rectangle.length_v;
  z_ = std::abs(glm::dot(d, rectangle.normal));
  if (!(z_ > 0)) return;
  // The solid angle from the foot of the perpendicular to (x, y), signed; of the columns up to x0 and up to x1; and of
  // what lies between.
  const auto quadrant = [this](double x, double y) {
    return glm::dvec2(z_ * std::sqrt(x * x + y * y + z_ * z_), x * y);
  };
  left_ = difference_of_angles(quadrant(x0_, y1_), quadrant(x0_, y0_));
  const glm::dvec2 right = difference_of_angles(quadrant(x1_, y1_), quadrant(x1_, y0_));
  const glm::dvec2 between = difference_of_angles(right, left_);
  solid_angle_ = std::atan2(between.y, between.x);
  // More than half a turn is seen from above the rectangle alone; elsewhere, less than nothing is rounding.
  const bool is_above = x0_ < 0 && x1_ > 0 && y0_ < 0 && y1_ > 0;
  if (solid_angle_ < 0) solid_angle_ = is_above ? solid_angle_ + 2 * std::numbers::pi : 0.0;
}

glm::vec3 SphericalRectangle::sample(glm::vec2 u) const {
  // Sines and cosines of the elevations of the edges y0 and y1 above the foot.
  const double z2 = z_ * z_, edge0 = std::sqrt(y0_ * y0_ + z2), edge1 = std::sqrt(y1_ * y1_ + z2);
  const double inverse = 1 / (edge0 * edge1), sines = y0_ * y1_ * inverse, cosines = z2 * inverse;
  // The column up to x has the solid angle asin(m sin1) - asin(m sin0), where m = x / sqrt(x^2 + z^2). It shall have
  // the fraction u.x more than the column up to x0; the law of cosines gives m, and m gives x.
  const double more = static_cast<double>(u.x) * solid_angle_;
  const glm::dvec2 column = sum_of_angles(left_ * (inverse / (x0_ * x0_ + z2)), {std::cos(more), std::sin(more)});
  const double off = column.x - sines;
  const double x = std::clamp(z_ * column.y / std::sqrt(std::max(off * off - cosines * cosines, 1e-300)), x0_, x1_);
  // Within the column, the sine of the elevation is uniform.
  const double d2 = x * x + z2;
  const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
  const double h = h0 + static_cast<double>(u.y) * (h1 - h0);
  const double y = std::clamp(h * std::sqrt(d2 / std::max(1 - h * h, 1e-300)), y0_, y1_);
  return glm::vec3(rectangle_.corner + (x - x0_) * rectangle_.u + (y - y0_) * rectangle_.v);
}

}  // namespace heckbert::transport
