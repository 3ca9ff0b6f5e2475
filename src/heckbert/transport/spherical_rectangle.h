#pragma once
// A rectangle as seen from a point, drawn uniformly by solid angle, with the parametrization of Urena, Fajardo and King
// (2013, "An Area-Preserving Parametrization for Spherical Rectangles"). Their angles are kept as complex numbers, so
// that one arc tangent and one sine are left of ten; all in double precision, because the angles nearly cancel.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace heckbert::transport {

/// What is the same from everywhere.
struct Rectangle {
  glm::dvec3 corner{0};
  glm::dvec3 u{0}, v{0}, normal{0};  ///< unit, perpendicular to each other
  double length_u = 0, length_v = 0;

  Rectangle() = default;
  /// The edges are perpendicular to each other.
  Rectangle(glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v);
};

class SphericalRectangle {
 public:
  /// Keeps a reference.
  SphericalRectangle(const Rectangle& rectangle, glm::vec3 from);

  /// In steradian; 0 from within the rectangle's plane.
  double solid_angle() const { return solid_angle_; }
  /// A point of the rectangle. Ask only where the solid angle is above zero.
  glm::vec3 sample(glm::vec2 u) const;

 private:
  const Rectangle& rectangle_;
  double x0_, x1_, y0_, y1_, z_;  ///< of the rectangle, seen from `from`; z from the plane, not negative
  glm::dvec2 left_{0};            ///< as the angle of a complex number: see the constructor
  double solid_angle_ = 0;
};

}  // namespace heckbert::transport
