#pragma once
// Pixel filters, drawn by importance: every ray of a pixel goes through a point drawn with the filter's own density, so
// that all its contributions stay in the pixel with weight one (Ernst, Stamminger and Greiner 2006, "Filter Importance
// Sampling"). Samples of neighbouring pixels stay independent, and a record needs no splatting.

#include <array>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::transport {

struct FilterFacts {
  FilterKind kind;
  std::string_view name;  ///< as on the command line and in scene files
  float radius;           ///< unless the scene says otherwise
};

/// Every filter; the command line, the scene format and the tests read this table.
inline constexpr std::array<FilterFacts, 4> kFilters{{
    {FilterKind::Box, "box", 0.5f},
    {FilterKind::Tent, "tent", 1.0f},
    {FilterKind::Gaussian, "gaussian", 2.0f},
    {FilterKind::BlackmanHarris, "blackman-harris", 1.5f},
}};

/// The filter along one axis at a distance from the pixel's centre; 1 in the middle, not normalised.
double filter_value(const PixelFilter& filter, double distance);

class FilterSampler {
 public:
  explicit FilterSampler(const PixelFilter& filter);
  /// A point of the picture relative to the pixel's centre, in pixels.
  glm::vec2 sample(glm::vec2 u) const { return {sample_axis(u.x), sample_axis(u.y)}; }

 private:
  float sample_axis(float u) const;

  PixelFilter filter_;
  std::vector<float> values_;      ///< at equal steps from -radius to radius
  std::vector<float> cumulative_;  ///< of the piecewise linear density through them, from 0 to 1
};

}  // namespace heckbert::transport
