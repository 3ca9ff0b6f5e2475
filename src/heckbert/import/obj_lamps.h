#pragma once
// Which side of an OBJ lamp shines. The format does not say, and many files do not care about the order of corners. A
// lamp that shines on both sides is never dark where it should be bright; but the usual lamp hangs just below a
// ceiling, and what it sends up into the gap costs energy and noise. So a flat lamp shines one way, into the scene.

#include <heckbert/import/import.h>

namespace heckbert::import {

/// Turns the triangles of flat lamps towards the middle of the bounding box, and lets only their fronts emit; all other
/// lamps emit on both sides. Tells either as a guess. Takes: shapes that are meshes with face_materials.
void orient_lamps(transport::Scene& scene, Account& account);

}  // namespace heckbert::import
