#include <heckbert/cli/collector.h>

#include <utility>

namespace heckbert::cli {

Collector::Collector(record::Sums begun, std::optional<double> seconds, Write write)
    : sums_(std::move(begun)), write_(std::move(write)) {
  if (seconds) interval_ = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
}

void Collector::take(record::Tile tile) {
  pixels_waiting_ += tile.window.pixel_count();
  tiles_.push_back(std::move(tile));
  // Tiles that overlap take more memory apart than together.
  constexpr std::size_t kMostPictures = 8;
  if (pixels_waiting_ > kMostPictures * sums_.info.window.pixel_count()) add_up();
  if (!interval_ || Clock::now() - last_ < *interval_) return;
  add_up();
  write_(sums_);
  last_ = Clock::now();  // from the end of writing, so that writing never takes all the time
}

record::Sums Collector::finish() {
  add_up();
  return std::move(sums_);
}

void Collector::add_up() {
  sums_ = record::completed(std::move(sums_), std::move(tiles_));
  tiles_.clear();
  pixels_waiting_ = 0;
}

}  // namespace heckbert::cli
