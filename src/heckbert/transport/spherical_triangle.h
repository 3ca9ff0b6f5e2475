#pragma once
// A triangle as seen from a point, drawn uniformly by solid angle (Arvo 1995, "Stratified Sampling of Spherical
// Triangles"). In double precision: the angles nearly cancel.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace heckbert::transport {

class SphericalTriangle {
 public:
  /// `normal` is the triangle's, unit, on either side.
  SphericalTriangle(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2, glm::vec3 normal, glm::vec3 from);

  /// In steradian; 0 from within the triangle's plane.
  double solid_angle() const { return solid_angle_; }
  /// A point of the triangle. Ask only where the solid angle is above zero.
  glm::vec3 sample(glm::vec2 u) const;

 private:
  glm::dvec3 from_, normal_;
  double plane_;          ///< distance of the plane along the normal, seen from `from`
  glm::dvec3 a_, b_, c_;  ///< unit, towards the corners
  double solid_angle_;
};

}  // namespace heckbert::transport
