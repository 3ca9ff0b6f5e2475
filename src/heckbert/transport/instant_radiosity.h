#pragma once
// Instant radiosity (Keller 1997): a few walks from the light, the same for every pixel, whose vertices are virtual
// lights. A walk from the eye goes on at mirrors and glass; the first surface that is not specular is lit by the lights
// and by all virtual lights. Each sample number has virtual lights of its own.
//
// A virtual light that is near makes a bright spot, so programs bound what one may send. That takes light out of
// corners: right words, too dark.

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

/// Walks from the light that all pixels share, for one sample number.
std::deque<LightWalk> virtual_lights(const World& world, const SamplePlan& plan, int sample);

/// Takes world.virtual_lights. Virtual lights nearer than `least_distance` send as if they were that far away; 0: none.
void trace_to_virtual_lights(const World& world, Walk& walk, Ray ray, float least_distance);

}  // namespace heckbert::transport
