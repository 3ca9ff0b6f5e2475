#pragma once
// How walks from the light reach the picture: their vertices are joined to a point of the eye (t = 1), and a lens may
// be met by chance (t = 0). Each finds paths for whatever pixel they are seen in, which is splatted.

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

/// Which other techniques the weights reckon with.
enum class Rivalry : std::uint8_t {
  LightOnly,  ///< those of this file alone: light tracing
  All         ///< walks from the eye too, one per pixel for each walk from the light
};

/// Joins every vertex of the walk to the eye, and takes in what came through the lens. The light itself is joined to
/// the eye too, except that a pinhole sees no lamp in light tracing, nor a light that is a point (or a direction) in
/// any.
void splat(const World& world, Walk& walk, const LightWalk& light, Sampler& sampler, Rivalry rivalry);

}  // namespace heckbert::transport
