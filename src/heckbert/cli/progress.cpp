#include <heckbert/cli/progress.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace heckbert::cli {
namespace {

constexpr int kBarWidth = 30;

std::string clock(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// "42 %, 27 of 64 samples per pixel, 5.31 Mrays/s, 0:12 left". Tiles are finished one after another, so the samples
/// per pixel are those of the average pixel.
std::string figures(const transport::Progress& progress, int samples_per_pixel) {
  const double rate = progress.seconds > 0 ? static_cast<double>(progress.rays) / progress.seconds / 1e6 : 0;
  std::string text =
      fmt::format("{:3.0f} %  {:.{}f}/{} spp  {:.2f} Mrays/s", 100 * progress.fraction,
                  progress.fraction * samples_per_pixel, samples_per_pixel < 10 ? 1 : 0, samples_per_pixel, rate);
  if (progress.fraction > 0) {
    const double left = progress.seconds * (1 - progress.fraction) / progress.fraction;
    text += "  " + clock(left) + " left";
  }
  return text;
}

}  // namespace

ProgressDisplay::ProgressDisplay(ProgressStyle style, int samples_per_pixel)
    : style_(style), samples_per_pixel_(samples_per_pixel) {}

void ProgressDisplay::show(const transport::Progress& progress) {
  if (style_ == ProgressStyle::Bar) {
    const int filled = std::clamp(static_cast<int>(progress.fraction * kBarWidth), 0, kBarWidth);
    fmt::print(stderr, "\r[{:#>{}}{:.>{}}] {}\033[K", "", filled, "", kBarWidth - filled,
               figures(progress, samples_per_pixel_));
    std::fflush(stderr);
    drawn_ = true;
  } else if (style_ == ProgressStyle::Lines && static_cast<int>(progress.fraction * 10) > tenths_) {
    tenths_ = static_cast<int>(progress.fraction * 10);
    fmt::print(stderr, "{}\n", figures(progress, samples_per_pixel_));
  }
}

void ProgressDisplay::clear() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace heckbert::cli
