#pragma once
// Light gathered from photons (Jensen 1996; Hachisuka and Jensen 2009, "Stochastic Progressive Photon Mapping"): a walk
// from the eye goes on at mirrors and glass, and at every surface that is not specular takes the photons near it for
// light that arrives there. Lamps and their mirror images are found by running into them. Of a light that is a point
// this finds every word with a surface that is not specular, a caustic in a mirror (LSDSE) too.
//
// The disc of photons stands for a point, which blurs: right words, values that converge with the radius. With a radius
// that shrinks from sample to sample the error goes to zero (Knaus and Zwicker 2011); with a fixed one it stays.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Takes world.photons.
void trace_to_photons(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
