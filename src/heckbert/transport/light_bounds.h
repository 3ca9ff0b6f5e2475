#pragma once
// Where a light or a group of lights is, which way it shines and how much: enough to estimate what it may send to a
// place without looking at each (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting"; orientation bounds as in Pharr, Jakob and Humphreys, "Physically Based Rendering", 12.6.3).

#include <glm/vec3.hpp>

#include <heckbert/transport/emitter.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Directions within an angle of an axis.
struct Cone {
  glm::vec3 axis{0, 0, 1};  ///< unit
  float cos_angle = -1;     ///< -1: all directions
};

/// The narrowest cone, or nearly so, around two.
Cone join(const Cone& a, const Cone& b);

/// What is known of one light or of several together.
struct LightBounds {
  glm::vec3 low{0}, high{0};
  Cone normals;            ///< of the emitting surface, or the axes of spots
  float cos_emission = 0;  ///< light leaves within this angle of a normal: 0 for surfaces
  bool both_sides = false;
  double power = 0;  ///< above zero
};

LightBounds join(const LightBounds& a, const LightBounds& b);

LightBounds bounds_of(const Emitter& emitter, bool both_sides, double power);
LightBounds bounds_of(const PointLight& light);
LightBounds bounds_of(const SpotLight& light);

/// An estimate of how much arrives at a place, in any unit; 0 only where nothing can.
double importance(const LightBounds& bounds, glm::vec3 from);

/// The surface area orientation heuristic: how much of its light the group may send where it is not wanted (Conty
/// Estevez and Kulla 2018, equation 1).
double split_cost(const LightBounds& bounds);

}  // namespace heckbert::transport
