#include <heckbert/transport/fresnel.h>

#include <algorithm>
#include <cmath>

#include <heckbert/transport/overload.h>

namespace heckbert::transport {

float fresnel_dielectric(float cos_incident, float eta) {
  const float cos_i = std::clamp(cos_incident, 0.0f, 1.0f);
  const float sin2_t = (1.0f - cos_i * cos_i) / (eta * eta);
  if (sin2_t >= 1.0f) return 1.0f;
  const float cos_t = std::sqrt(1.0f - sin2_t);
  const float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// With a^2 + b^2 and a from the square root of the complex refracted cosine (Born and Wolf; Lagarde 2013, "Memo on
// Fresnel equations").
float fresnel_conductor(float cos_incident, float eta, float k) {
  const float cos_i = std::clamp(cos_incident, 0.0f, 1.0f);
  const float cos2 = cos_i * cos_i, sin2 = 1.0f - cos2;
  const float t0 = eta * eta - k * k - sin2;
  const float a2_plus_b2 = std::sqrt(t0 * t0 + 4.0f * eta * eta * k * k);
  const float a = std::sqrt(std::max(0.0f, 0.5f * (a2_plus_b2 + t0)));
  const float t1 = a2_plus_b2 + cos2, t2 = 2.0f * a * cos_i;
  const float perpendicular = (t1 - t2) / (t1 + t2);
  const float t3 = cos2 * a2_plus_b2 + sin2 * sin2, t4 = t2 * sin2;
  const float parallel = perpendicular * (t3 - t4) / (t3 + t4);
  return 0.5f * (parallel + perpendicular);
}

Rgb fresnel(const Fresnel& kind, float cos_incident) {
  return std::visit(Overload{
                        [](const Rgb& constant) { return constant; },
                        [&](const SchlickFresnel& f) {
                          const float m = std::clamp(1.0f - cos_incident, 0.0f, 1.0f);
                          const float m5 = m * m * m * m * m;
                          return f.f0 + (Rgb(1.0f) - f.f0) * m5;
                        },
                        [&](const ConductorFresnel& f) {
                          return Rgb(fresnel_conductor(cos_incident, f.eta.r, f.k.r),
                                     fresnel_conductor(cos_incident, f.eta.g, f.k.g),
                                     fresnel_conductor(cos_incident, f.eta.b, f.k.b));
                        },
                        [&](const DielectricFresnel& f) { return Rgb(fresnel_dielectric(cos_incident, f.ior)); },
                    },
                    kind);
}

float mean_fresnel_dielectric(float eta) {
  const double n = static_cast<double>(eta);
  if (n - 1 < 1e-3) return 0.0f;  // the terms of the closed form cancel there
  const double n2 = n * n, n4 = n2 * n2;
  const double plus = n + 1, square = n2 + 1, fourth = n4 - 1;
  return static_cast<float>(0.5 + (n - 1) * (3 * n + 1) / (6 * plus * plus) +
                            n2 * (n2 - 1) * (n2 - 1) / (square * square * square) * std::log((n - 1) / plus) -
                            2 * n * n2 * (n2 + 2 * n - 1) / (square * fourth) +
                            8 * n4 * (n4 + 1) / (square * fourth * fourth) * std::log(n));
}

}  // namespace heckbert::transport
