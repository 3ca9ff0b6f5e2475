#pragma once
// Which samples a record holds, and the batches that interval estimates come from. A render of N samples per pixel may
// be shared out: each machine takes a range of the sample numbers, everywhere in the picture, and the records of the
// ranges add up to that of the whole. Hence a sample's batch follows from its number in the whole render, never from
// what one machine took.

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace heckbert::record {

/// Number of batches that the samples of every pixel are dealt into; interval estimates come from their spread.
inline constexpr int kBatches = 32;

/// The batch of a sample: consecutive samples share one, and with fewer samples than batches each has its own.
int batch_of(int sample, int samples_per_pixel);
/// The first sample of a batch.
int first_of_batch(int batch, int samples_per_pixel);
/// How many batches are in use: min(kBatches, samples_per_pixel).
int batch_count(int samples_per_pixel);
/// How many samples of a pixel fall into each batch; they differ by one at most. Their sum is samples_per_pixel.
std::array<int, kBatches> batch_sizes(int samples_per_pixel);

/// Samples [first, last) of the `of` samples per pixel that the render with `seed` takes as a whole.
struct SampleRange {
  std::uint64_t seed = 0;
  int of = 0;
  int first = 0, last = 0;
  int count() const { return last - first; }
  auto operator<=>(const SampleRange&) const = default;
};

/// "samples 16 to 31 of 64, seed 1"
std::string to_text(const SampleRange& range);

/// Part `number`, counted from 1, of `of` that together are the whole render.
struct Part {
  int number = 1, of = 1;
};

/// The samples of a part: consecutive ones, in numbers that differ by one at most. Where `of` divides kBatches and
/// samples_per_pixel is at least that, no batch is shared by two parts. Takes: 1 <= number <= of <= samples_per_pixel.
SampleRange samples_of(const Part& part, std::uint64_t seed, int samples_per_pixel);

/// What a set of ranges, listed as united() does, lacks of the renders that it has samples of.
std::vector<SampleRange> missing_of(const std::vector<SampleRange>& ranges);

/// Both sets of ranges as one, sorted, with neighbours joined: equal sets are equal lists. Both sets are such lists.
/// Errors: std::invalid_argument naming a range that both have samples of.
std::vector<SampleRange> united(const std::vector<SampleRange>& a, const std::vector<SampleRange>& b);

}  // namespace heckbert::record
