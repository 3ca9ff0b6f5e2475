#pragma once
// Lobes that spread light over the whole hemisphere: letters Dr and Dt. All are sampled by the cosine, in the
// hemisphere that they scatter into. Directions as in lobe.h, on the right sides.

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

inline Rgb evaluate_lobe(const Lambert& lobe, glm::vec3, glm::vec3, bool) {
  return lobe.albedo * (1.0f / kPi);
}

/// Fujii's improved qualitative model (https://mimosa-pudica.net/improved-oren-nayar.html): with s the part of the
/// cosine between wo and wi that azimuth adds, (A + B s / t) where the original divides by max(tan), so that there is
/// no dark rim. The albedo is albedo * A (pi + roughness G(theta)), which rises to `albedo` at grazing angles.
Rgb evaluate_lobe(const OrenNayar& lobe, glm::vec3 wo, glm::vec3 wi, bool);

inline Rgb evaluate_lobe(const DiffuseTransmission& lobe, glm::vec3, glm::vec3, bool) {
  return lobe.transmittance * (1.0f / kPi);
}

/// What passes the coat on the way in and out, with the geometric series of reflections between base and coat
/// (Kelemen and Szirmay-Kalos 2001; for a smooth coat the same as Mitsuba's `plastic`).
Rgb evaluate_lobe(const CoatedDiffuse& lobe, glm::vec3 wo, glm::vec3 wi, bool);

template <class DiffuseLobe>
float pdf_of_lobe(const DiffuseLobe&, glm::vec3, glm::vec3 wi, bool) {
  return std::abs(wi.z) / kPi;
}

inline glm::vec3 sample_lobe(const Lambert&, glm::vec3, glm::vec3 u, bool) {
  return cosine_hemisphere(glm::vec2(u));
}
inline glm::vec3 sample_lobe(const OrenNayar&, glm::vec3, glm::vec3 u, bool) {
  return cosine_hemisphere(glm::vec2(u));
}
inline glm::vec3 sample_lobe(const CoatedDiffuse&, glm::vec3, glm::vec3 u, bool) {
  return cosine_hemisphere(glm::vec2(u));
}
inline glm::vec3 sample_lobe(const DiffuseTransmission&, glm::vec3, glm::vec3 u, bool) {
  const glm::vec3 w = cosine_hemisphere(glm::vec2(u));
  return {w.x, w.y, -w.z};
}

}  // namespace heckbert::transport
