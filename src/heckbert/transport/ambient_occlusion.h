#pragma once
// Ambient occlusion: how much of an even sky a surface would see, if what is far away were not there (Zhukov, Iones and
// Kronin 1998, "An Ambient Light Illumination Model"). It is LeDE of another scene: the same shapes, white and diffuse,
// under a sky of radiance one, with rays of limited length. None of that is light of this scene, so it goes to the
// ambient buffer and no word is found.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Length of the rays as a share of the diagonal of the scene's bounding box.
inline constexpr float kOcclusionReach = 0.25f;

void trace_occlusion(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
