#pragma once
// How much of unpolarised light an ideal surface reflects. Indices are relative: that of the far side over the near
// one's; cosines are those of the angle of incidence, from 0 to 1.

#include <heckbert/record/rgb.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

/// Fresnel's equations between two dielectrics; 1 beyond the critical angle.
float fresnel_dielectric(float cos_incident, float eta);

/// Fresnel's equations for one channel of a metal of complex index eta + i k.
float fresnel_conductor(float cos_incident, float eta, float k);

Rgb fresnel(const Fresnel& kind, float cos_incident);

/// The average of fresnel_dielectric over directions weighted by their cosine: what a diffuse sky sees reflected.
/// Closed form for eta >= 1 (Duntley 1942, as in Egan and Hilgeman 1979).
float mean_fresnel_dielectric(float eta);

}  // namespace heckbert::transport
