#pragma once
// The scenes that speed is measured on: lambertian triangles under one square lamp, which a bare loop can trace too.

#include <heckbert/transport/scene.h>

namespace heckbert::bench {

/// The Cornell box with its lamp hung below an uncut ceiling: 32 triangles.
transport::Scene boxes();

/// The Cornell box with a dented ball of 512 x 512 cells instead of its blocks: half a million triangles where every
/// bounce off the ball is incoherent.
transport::Scene ball();

}  // namespace heckbert::bench
