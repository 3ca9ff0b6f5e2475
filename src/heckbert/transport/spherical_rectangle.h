#pragma once
// A rectangle as seen from a point, drawn uniformly by solid angle (Urena, Fajardo and King 2013, "An Area-Preserving
// Parametrization for Spherical Rectangles"). In double precision: the angles nearly cancel.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace heckbert::transport {

class SphericalRectangle {
 public:
  /// The edges are perpendicular to each other.
  SphericalRectangle(glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v, glm::vec3 from);

  /// In steradian; 0 from within the rectangle's plane.
  double solid_angle() const { return solid_angle_; }
  /// A point of the rectangle. Ask only where the solid angle is above zero.
  glm::vec3 sample(glm::vec2 u) const;

 private:
  glm::dvec3 from_, x_, y_, z_;  ///< the frame has z away from the rectangle
  double x0_, x1_, y0_, y1_, z0_;
  double solid_angle_;
};

}  // namespace heckbert::transport
