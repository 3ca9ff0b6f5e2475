#pragma once
// A camera for a scene that brings none.

#include <heckbert/transport/scene.h>

namespace heckbert::import {

/// Looks level along the z axis at the bounding box of the shapes, from the end that is less walled in (+z when equal),
/// just far enough back for a square picture to hold the near face. Cost: one pass over the triangles.
transport::Camera frame(const std::vector<transport::Shape>& shapes);

}  // namespace heckbert::import
