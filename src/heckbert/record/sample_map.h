#pragma once
// Where to spend samples. A map says how often each pixel's samples are repeated; it is planned from two pilot renders
// that are thrown away, so that it knows nothing of the samples it asks for: every pixel is a mean over a number of
// samples that was fixed beforehand, and the picture, every class of it and every interval stay unbiased. (Maps made
// from the samples themselves are not: Kirk and Arvo 1991, "Unbiased sampling techniques for image synthesis".)

#include <cstdint>
#include <span>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::record {

struct SampleMap {
  Window window;
  std::vector<std::uint16_t> repeats{};  ///< by pixel, row by row; at least 1

  int at(int x, int y) const;
  /// Over all pixels.
  double mean() const;
};

/// Repeats in proportion to the standard deviation of the classes, each relative to its own mean over the picture, so
/// that a faint class counts as much as a bright one; by blocks of pixels, smoothed.
/// Takes: two pilots of the same picture with different seeds; without classes, the beauty. `mean_repeats`, at least 1,
/// is what the map adds up to on average, nearly.
SampleMap plan_samples(const Record& first, const Record& second, std::span<const taxonomy::Language> classes,
                       double mean_repeats);

}  // namespace heckbert::record
