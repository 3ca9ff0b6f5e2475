#pragma once
// Bidirectional path tracing (Lafortune and Willems 1993; Veach and Guibas 1994; Veach 1997, chapter 10): for every
// sample one walk from the eye and one from a light, and every vertex of the one joined to every vertex of the other. A
// path of n scatterings is so found by up to n + 3 techniques (s, t), each weighted by the power heuristic over all of
// them (light_walk.h). Techniques with one vertex of the eye, or none, find paths for any pixel and are splatted
// (light_to_eye.h). With photons it is vertex connection and merging (vertex_merging.h).

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Where world.photons are, their vertices are merged with too.
void trace_bidirectionally(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
