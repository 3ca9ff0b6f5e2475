#include <heckbert/record/samples.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include <fmt/format.h>

namespace heckbert::record {

namespace {

/// The least whole number that is not below a / b.
std::int64_t divided_up(std::int64_t a, std::int64_t b) {
  return (a + b - 1) / b;
}

bool is_same_render(const SampleRange& a, const SampleRange& b) {
  return a.seed == b.seed && a.of == b.of;
}

}  // namespace

int batch_count(int samples_per_pixel) {
  return std::min(kBatches, samples_per_pixel);
}

int batch_of(int sample, int samples_per_pixel) {
  assert(sample >= 0 && sample < samples_per_pixel);
  return static_cast<int>(static_cast<std::int64_t>(sample) * batch_count(samples_per_pixel) / samples_per_pixel);
}

int first_of_batch(int batch, int samples_per_pixel) {
  // The first sample s with floor(s * batches / samples) == batch.
  return static_cast<int>(
      divided_up(static_cast<std::int64_t>(batch) * samples_per_pixel, batch_count(samples_per_pixel)));
}

std::array<int, kBatches> batch_sizes(int samples_per_pixel) {
  std::array<int, kBatches> sizes{};
  for (int b = 0; b < batch_count(samples_per_pixel); ++b)
    sizes[static_cast<std::size_t>(b)] =
        first_of_batch(b + 1, samples_per_pixel) - first_of_batch(b, samples_per_pixel);
  return sizes;
}

std::string to_text(const SampleRange& range) {
  return fmt::format("samples {} to {} of {}, seed {}", range.first, range.last - 1, range.of, range.seed);
}

SampleRange samples_of(const Part& part, std::uint64_t seed, int samples_per_pixel) {
  assert(1 <= part.number && part.number <= part.of && part.of <= samples_per_pixel);
  // Rounded as first_of_batch is, so that parts end where batches do.
  const auto first_of = [&](std::int64_t number) {
    return static_cast<int>(divided_up((number - 1) * samples_per_pixel, part.of));
  };
  return {seed, samples_per_pixel, first_of(part.number), first_of(std::int64_t{part.number} + 1)};
}

std::vector<SampleRange> united(const std::vector<SampleRange>& a, const std::vector<SampleRange>& b) {
  std::vector<SampleRange> sorted;
  std::ranges::merge(a, b, std::back_inserter(sorted));
  std::vector<SampleRange> joined;
  for (const SampleRange& range : sorted) {
    if (joined.empty() || !is_same_render(joined.back(), range) || joined.back().last < range.first) {
      joined.push_back(range);
    } else if (joined.back().last == range.first) {
      joined.back().last = range.last;
    } else {
      const SampleRange both{range.seed, range.of, range.first, std::min(joined.back().last, range.last)};
      throw std::invalid_argument(to_text(both));
    }
  }
  return joined;
}

std::vector<SampleRange> missing_of(const std::vector<SampleRange>& ranges) {
  std::vector<SampleRange> missing;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const SampleRange& range = ranges[i];
    const bool is_first = i == 0 || !is_same_render(ranges[i - 1], range);
    const bool is_last = i + 1 == ranges.size() || !is_same_render(range, ranges[i + 1]);
    if (is_first && range.first > 0) missing.push_back({range.seed, range.of, 0, range.first});
    const int next = is_last ? range.of : ranges[i + 1].first;
    if (range.last < next) missing.push_back({range.seed, range.of, range.last, next});
  }
  return missing;
}

}  // namespace heckbert::record
