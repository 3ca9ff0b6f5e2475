#include <heckbert/record/sample_map.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace heckbert::record {

namespace {

constexpr int kBlock = 8;
/// No block gets less than this share of the mean deviation: a pilot that saw nothing has not seen that there is
/// nothing.
constexpr double kLeastShare = 0.1;
constexpr double kMostRepeats = 1024;

/// Blocks of pixels over a window, row by row.
struct Blocks {
  int columns, rows;
  std::vector<double> values;

  explicit Blocks(const Window& window)
      : columns((window.width() + kBlock - 1) / kBlock),
        rows((window.height() + kBlock - 1) / kBlock),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  double& at(int column, int row) { return values[index(column, row)]; }
  double at(int column, int row) const { return values[index(column, row)]; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

/// Adds the variance of a class, relative to the square of its mean. Half the squared difference of two pilots is the
/// variance of either, without bias.
void add_variance(Blocks& blocks, const Image& first, const Image& second) {
  const Window& window = first.window;
  double mean = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i)
    mean += 0.5 * static_cast<double>(luminance(first.pixels[i]) + luminance(second.pixels[i]));
  mean /= static_cast<double>(first.pixels.size());
  if (!(mean > 0)) return;
  std::size_t pixel = 0;
  for (int y = 0; y < window.height(); ++y)
    for (int x = 0; x < window.width(); ++x, ++pixel) {
      const double difference = static_cast<double>(luminance(first.pixels[pixel]) - luminance(second.pixels[pixel]));
      blocks.at(x / kBlock, y / kBlock) += 0.5 * difference * difference / (mean * mean);
    }
}

/// The mean over each block and its neighbours.
Blocks smoothed(const Blocks& blocks) {
  Blocks out = blocks;
  for (int row = 0; row < blocks.rows; ++row)
    for (int column = 0; column < blocks.columns; ++column) {
      double sum = 0;
      int count = 0;
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, blocks.rows - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, blocks.columns - 1); ++c, ++count)
          sum += blocks.at(c, r);
      out.at(column, row) = sum / count;
    }
  return out;
}

}  // namespace

int SampleMap::at(int x, int y) const {
  assert(x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1);
  return repeats[static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
                 static_cast<std::size_t>(x - window.x0)];
}

double SampleMap::mean() const {
  return std::accumulate(repeats.begin(), repeats.end(), 0.0) / static_cast<double>(repeats.size());
}

SampleMap plan_samples(const Record& first, const Record& second, std::span<const taxonomy::Language> classes,
                       double mean_repeats) {
  const Window& window = first.info.window;
  assert(second.info.window == window && mean_repeats >= 1);
  Blocks blocks(window);
  for (const taxonomy::Language& language : classes)
    add_variance(blocks, image_of(first, members(first, language)), image_of(second, members(second, language)));
  if (classes.empty()) add_variance(blocks, beauty(first), beauty(second));
  blocks = smoothed(blocks);

  for (double& value : blocks.values) value = std::sqrt(value);
  const double mean =
      std::accumulate(blocks.values.begin(), blocks.values.end(), 0.0) / static_cast<double>(blocks.values.size());
  for (double& value : blocks.values) value = mean > 0 ? std::max(value / mean, kLeastShare) : 1.0;

  SampleMap map{.window = window};
  map.repeats.reserve(window.pixel_count());
  for (int y = 0; y < window.height(); ++y)
    for (int x = 0; x < window.width(); ++x)
      map.repeats.push_back(static_cast<std::uint16_t>(
          std::clamp(std::round(mean_repeats * blocks.at(x / kBlock, y / kBlock)), 1.0, kMostRepeats)));
  return map;
}

}  // namespace heckbert::record
