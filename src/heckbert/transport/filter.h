#pragma once
// Pixel filters, drawn by importance: every ray of a pixel goes through a point drawn with the filter's own density, so
// that all its contributions stay in the pixel with weight one (Ernst, Stamminger and Greiner 2006, "Filter Importance
// Sampling"). Samples of neighbouring pixels stay independent. A walk from the light is splatted: it goes to one of the
// pixels whose filters reach the point where it arrives, drawn by their values there.

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

/// A pixel to which a point of the picture belongs.
struct PixelShare {
  int x = 0, y = 0;
  float weight = 0;  ///< the filter's, over the chance that this pixel was drawn; 0: no pixel's filter reaches there
};

class FilterSampler {
 public:
  explicit FilterSampler(const PixelFilter& filter);
  /// A point of the picture relative to the pixel's centre, in pixels.
  glm::vec2 sample(glm::vec2 u) const { return {sample_axis(u.x), sample_axis(u.y)}; }
  /// The other way round: one of the pixels whose filters reach the point `place`, drawn by their values there.
  /// In pixels from the upper left corner; pixel (0, 0) has its centre at (0.5, 0.5).
  PixelShare pixel_at(glm::vec2 place, glm::vec2 u) const;
  /// Does `u` make a difference to pixel_at()? Not where every point of the picture is of one pixel.
  bool overlaps() const { return filter_.kind != FilterKind::Box || filter_.radius != 0.5f; }

 private:
  float sample_axis(float u) const;
  /// Per pixel, at a distance from the centre; the density of sample_axis.
  float density(float distance) const;
  struct AxisShare {
    int pixel = 0;
    float weight = 0;
  };
  AxisShare pixel_on_axis(float place, float u) const;

  PixelFilter filter_;
  std::vector<float> values_;      ///< at equal steps from -radius to radius
  std::vector<float> cumulative_;  ///< of the piecewise linear density through them, from 0 to 1
  float integral_ = 1;             ///< of the piecewise linear function, over pixels
};

}  // namespace heckbert::transport
