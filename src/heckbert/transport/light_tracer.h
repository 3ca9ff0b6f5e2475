#pragma once
// Light tracing (Dutre, Lafortune and Willems 1993): walks from the lights, each of whose vertices is joined to the
// eye. A pinhole sees what is not specular and nothing else; a lens can be met by chance, and then sees everything. See
// light_walk.h and light_to_eye.h.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

void trace_from_light(const World& world, Walk& walk);

}  // namespace heckbert::transport
