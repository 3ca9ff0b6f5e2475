#pragma once
// What a homogeneous medium does to light: transmittance (Beer and Lambert), free distances, and the phase function of
// Henyey and Greenstein (1941). Directions are those in which light or the walk travels; the cosine of an angle of
// scattering is one for straight on.

#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

inline Rgb extinction(const Medium& medium) {
  return medium.absorption + medium.scattering;
}

/// exp(-extinction * distance) by channel; the distance may be infinite.
Rgb transmittance(const Medium& medium, float distance);

/// A way through a medium, as free flights see it.
struct Stretch {
  Rgb transmittance{1.0f};
  float chance = 1;  ///< of a flight to get that far; where nothing scatters, all do
  float rate = 0;    ///< with which a flight that got that far ends at a particle there, per length
};
Stretch stretch(const Medium& medium, float distance);

/// A free flight: how far, whether it ended at a particle, and the transmittance and scattering coefficient met on the
/// way over the density of what was drawn.
struct Flight {
  float distance = 0;
  bool scattered = false;
  Rgb weight{1.0f};
};
/// Distances are drawn by the extinction of one channel chosen at random, and weighed by the mean density of all three
/// (single-sample balance heuristic), so coloured media stay unbiased. Without scattering nothing is drawn. stretch()
/// has the densities.
Flight fly(const Medium& medium, float farthest, Sampler& sampler);

/// Henyey and Greenstein's phase function, per steradian; it integrates to one over the sphere.
float phase(float anisotropy, float cosine);
/// A direction drawn by phase().
glm::vec3 sample_phase(float anisotropy, glm::vec3 direction, glm::vec2 u);

}  // namespace heckbert::transport
