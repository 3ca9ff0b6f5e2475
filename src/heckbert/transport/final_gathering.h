#pragma once
// Photon mapping with final gathering (Jensen 1996, "Global Illumination using Photon Maps"; Jensen 2001, "Realistic
// Image Synthesis Using Photon Mapping", chapter 9). A walk from the eye goes on at mirrors, glass and glossy lobes.
// What light does at a diffuse surface x falls into three parts that share no word and leave none out, by the way it
// came to x:
//
//   straight from the light     shadow rays                                                              L D (G|S)* E
//   by mirrors and gloss alone  the caustic map, looked at directly: few photons, close together    L (G|S)+ D (G|S)* E
//   by some diffuse surface     rays from x, to the next diffuse surface beyond mirrors and gloss,
//                               and the global map there: its blur is far away          L .* D (G|S)* D (G|S)* E
//
// Without any diffuse surface, the walk runs into the light, L (G|S)* E, or at a glossy lobe asks for it too, weighted
// lobe by lobe as in distribution ray tracing.
//
// Both maps blur: right words, values that converge with the radius.

#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

/// Takes world.photons, the global map, and world.caustics.
void trace_with_final_gathering(const World& world, Walk& walk, Ray ray);

}  // namespace heckbert::transport
