#pragma once
// The pieces that area lights are made of, and how a point on one is drawn as seen from elsewhere: by solid angle where
// a closed form exists and pays, by area otherwise. Drawing and asking for the density make the same choice, which
// depends on the piece and the place it is seen from alone, so that multiple importance weights are exact.

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/spherical_rectangle.h>

namespace heckbert::transport {

/// One piece of an area light, in world space. Two neighbouring triangles that make a rectangle are one piece.
struct Emitter {
  enum class Form : std::uint8_t { Triangle, Rectangle, Disk, Sphere } form = Form::Triangle;
  glm::vec3 origin{0};             ///< a corner, or the centre of a disk or sphere
  glm::vec3 edge_u{0}, edge_v{0};  ///< from the corner, of a triangle or rectangle
  glm::vec3 normal{0};             ///< unit, on the front; none for a sphere
  float radius = 0;                ///< of a disk or sphere
  glm::vec3 center{0};             ///< of all forms
  float extent = 0;                ///< no point of the piece is farther from `center`
  float area = 0;
  float error = 0;  ///< as Hit::error, for a shadow ray that ends here
  std::uint32_t material = 0;
  std::uint32_t shape = 0;  ///< as Hit::shape
  Rectangle rectangle{};    ///< the same once more, for drawing by solid angle
};

/// Counter-clockwise seen from the front.
using Corners = std::array<glm::vec3, 3>;

Emitter triangle_emitter(const Corners& corners);
/// Nothing unless the two triangles share the diagonal of a rectangle and face the same side.
std::optional<Emitter> rectangle_emitter(const Corners& first, const Corners& second);
Emitter disk_emitter(glm::vec3 center, glm::vec3 normal, float radius);
Emitter sphere_emitter(glm::vec3 center, float radius);

struct SurfaceSample {
  glm::vec3 position{0};
  glm::vec3 normal{0};  ///< unit, on the front
  /// Per steradian as seen from where it was asked; 0: the piece is seen edge on, and the rest says nothing.
  float pdf_solid_angle = 0;
};

/// A point of the piece, all parts of its area alike; pdf_solid_angle says nothing.
SurfaceSample sample_area(const Emitter& emitter, glm::vec2 u);

/// A point of the piece as seen from `from`.
SurfaceSample sample_surface(const Emitter& emitter, glm::vec3 from, glm::vec2 u);

/// The density with which sample_surface draws this point; 0 where it gives nothing.
float pdf_solid_angle(const Emitter& emitter, glm::vec3 from, glm::vec3 position, glm::vec3 normal);

}  // namespace heckbert::transport
