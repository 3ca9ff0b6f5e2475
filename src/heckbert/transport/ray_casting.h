#pragma once
// Ray casting: one ray from the eye to the nearest surface, and from there one to a light to see whether the surface is
// in shadow (Appel 1968, "Some Techniques for Shading Machine Renderings of Solids"). It finds L(D|G)?E: lamps that are
// looked at, and surfaces that a lamp lights directly. Mirrors and glass stay black.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

void cast_ray(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
