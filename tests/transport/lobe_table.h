#pragma once
// The lobes that the laws of lobe_test.cpp are checked on: one of each kind at least, and what is special about it.

#include <cmath>
#include <numbers>
#include <vector>

#include <heckbert/transport/lobe.h>
#include <heckbert/transport/material.h>

namespace heckbert::transport {

struct NamedLobe {
  const char* name;
  Lobe lobe;
  bool front = true;  ///< seen from the front
};

inline const std::vector<NamedLobe>& lobe_table() {
  using enum Microfacets::Distribution;
  const ConductorFresnel copper = *find_metal("Cu");
  static const std::vector<NamedLobe> table{
      {"lambert", Lambert{Rgb(0.7f)}},
      {"oren-nayar", OrenNayar{Rgb(0.9f), 0.8f}},
      {"diffuse transmission", DiffuseTransmission{Rgb(0.6f)}},
      {"base of smooth plastic", CoatedDiffuse{.albedo = Rgb(0.8f)}},
      {"base of rough plastic", CoatedDiffuse{.albedo = Rgb(0.8f), .coat = {1.8f, 0.3f}, .linear = false}},
      {"ggx rough", ggx(Rgb(0.9f), 0.6f)},
      {"ggx smooth", ggx(Rgb(0.9f), 0.1f)},
      {"ggx brushed", MicrofacetReflection{Rgb(0.9f), {0.5f, 0.1f}}},
      {"copper", MicrofacetReflection{copper, {0.3f, 0.3f}}},
      {"rough coat", MicrofacetReflection{DielectricFresnel{1.5f}, {0.2f, 0.2f}}},
      {"beckmann rough", MicrofacetReflection{Rgb(0.9f), {0.5f, 0.5f, Beckmann}}},
      {"beckmann brushed", MicrofacetReflection{copper, {0.1f, 0.3f, Beckmann}}},
      {"rough glass", RoughDielectric{.ior = 1.5f, .facets = {0.3f, 0.3f}}},
      {"rough glass from inside", RoughDielectric{.ior = 1.5f, .facets = {0.3f, 0.3f}}, false},
      {"brushed glass", RoughDielectric{.ior = 1.8f, .facets = {0.4f, 0.15f, Beckmann}}},
      {"phong 0", Phong{Rgb(0.8f), 0}},
      {"phong 5", Phong{Rgb(0.8f), 5}},
      {"phong 80", Phong{Rgb(0.8f), 80}}};
  return table;
}

/// Cosines between wo and the normal at which the laws are checked; with an azimuth that is on no axis.
inline constexpr double kCosines[] = {0.95, 0.5, 0.15};
inline constexpr double kAzimuth = 0.4;

inline glm::vec3 direction(double cos_theta, double phi) {
  const double sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

/// Integral over the sphere (`whole`) or its upper half, by the midpoint rule in both angles, `rows` from pole to
/// equator.
template <class F>
double over_directions(F f, bool whole, int rows, int columns) {
  double sum = 0;
  const double step = std::numbers::pi / (2 * rows);
  for (int i = 0; i < (whole ? 2 * rows : rows); ++i) {
    const double theta = (i + 0.5) * step;
    for (int j = 0; j < columns; ++j)
      sum += static_cast<double>(f(direction(std::cos(theta), 2 * std::numbers::pi * (j + 0.5) / columns))) *
             std::sin(theta);
  }
  return sum * step * 2 * std::numbers::pi / columns;
}

/// Share of the light arriving from wo that is scattered anywhere: the compression of radiance is not energy.
inline double energy_albedo(const Lobe& lobe, glm::vec3 wo, bool front = true, int rows = 512, int columns = 1024) {
  const auto energy = [&](glm::vec3 wi) {
    const float compression = wi.z < 0 ? radiance_compression(lobe, front) : 1.0f;
    return evaluate(lobe, wo, wi, front).r * std::abs(wi.z) / compression;
  };
  return over_directions(energy, transmits(lobe), rows, columns);
}

}  // namespace heckbert::transport
