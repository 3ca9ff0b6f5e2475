#pragma once
// What a dielectric coat reflects before anything can reach what is below it: the directional albedo of its Mirror or
// MicrofacetReflection lobe with DielectricFresnel. CoatedDiffuse gives to its base what this leaves over (Kelemen and
// Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model").
//
// A smooth coat is exact. For a rough one the albedo is tabulated over angle, width and index when it is first asked
// for (some tenths of a second) and interpolated linearly; the error is below 0.004.

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Share of the light from a direction at this cosine that the coat reflects.
float coat_albedo(const Coat& coat, float cosine);

/// Its average over directions weighted by their cosine.
float mean_coat_albedo(const Coat& coat);

}  // namespace heckbert::transport
