#include <heckbert/transport/filter.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heckbert::transport {

namespace {

/// Steps of the table: the piecewise linear density differs from the filter by less than 1e-4 of its height.
constexpr std::size_t kSteps = 256;

}  // namespace

double filter_value(const PixelFilter& filter, double distance) {
  const double radius = static_cast<double>(filter.radius), x = std::abs(distance) / radius;
  if (x >= 1) return 0;
  switch (filter.kind) {
    case FilterKind::Box:
      return 1;
    case FilterKind::Tent:
      return 1 - x;
    case FilterKind::Gaussian: {
      // Lowered so that it ends at zero; a standard deviation of radius / 4.
      const double edge = std::exp(-8.0);
      return (std::exp(-8 * x * x) - edge) / (1 - edge);
    }
    case FilterKind::BlackmanHarris: {
      // Harris 1978, "On the use of windows for harmonic analysis", the minimum four-term window.
      const double t = std::numbers::pi * (1 + x);
      return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
    }
  }
  return 0;
}

FilterSampler::FilterSampler(const PixelFilter& filter) : filter_(filter) {
  double sum = 0, previous = 0;
  std::vector<double> cumulative;
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double value =
        filter_value(filter, static_cast<double>(filter.radius) * (2.0 * static_cast<double>(i) / kSteps - 1));
    values_.push_back(static_cast<float>(value));
    if (i > 0) sum += (previous + value) / 2;
    cumulative.push_back(sum);
    previous = value;
  }
  for (const double c : cumulative) cumulative_.push_back(static_cast<float>(c / sum));
  integral_ = static_cast<float>(sum * 2 * static_cast<double>(filter.radius) / kSteps);
}

PixelShare FilterSampler::pixel_at(glm::vec2 place, glm::vec2 u) const {
  const AxisShare x = pixel_on_axis(place.x, u.x), y = pixel_on_axis(place.y, u.y);
  return {x.pixel, y.pixel, x.weight * y.weight};
}

FilterSampler::AxisShare FilterSampler::pixel_on_axis(float place, float u) const {
  constexpr float kFarOutside = 1e6f;
  if (!(std::abs(place) < kFarOutside)) return {};
  const float radius = filter_.radius;
  // The usual case, without doubt about where one pixel ends and the next begins.
  if (!overlaps()) return {static_cast<int>(std::floor(place)), 1};
  const int first = static_cast<int>(std::ceil(place - 0.5f - radius));
  const int last = static_cast<int>(std::floor(place - 0.5f + radius));
  const auto value = [&](int pixel) { return density(place - 0.5f - static_cast<float>(pixel)); };
  AxisShare share;
  for (int pixel = first; pixel <= last; ++pixel) share.weight += value(pixel);
  float left = u * share.weight;
  for (int pixel = first; pixel <= last; ++pixel) {
    if (!(value(pixel) > 0)) continue;
    share.pixel = pixel;
    if (left < value(pixel)) break;
    left -= value(pixel);
  }
  return share;
}

float FilterSampler::density(float distance) const {
  const float from_edge = (distance + filter_.radius) / (2 * filter_.radius) * kSteps;
  if (!(from_edge >= 0 && from_edge < kSteps)) return 0;
  if (filter_.kind == FilterKind::Box) return 1 / (2 * filter_.radius);
  const auto step = static_cast<std::size_t>(from_edge);
  const float part = from_edge - static_cast<float>(step);
  return (values_[step] + part * (values_[step + 1] - values_[step])) / integral_;
}

float FilterSampler::sample_axis(float u) const {
  if (filter_.kind == FilterKind::Box) return (2 * u - 1) * filter_.radius;
  const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
  const auto step = static_cast<std::size_t>(above - cumulative_.begin()) - 1;
  // Where in the step: the density runs linearly from a to b, so its integral is a quadratic.
  const float width = cumulative_[step + 1] - cumulative_[step];
  const float part = width > 0 ? std::clamp((u - cumulative_[step]) / width, 0.0f, 1.0f) : 0.0f;
  const float a = values_[step], b = values_[step + 1];
  const float root = a + std::sqrt(std::max(0.0f, a * a + part * (b * b - a * a)));
  const float place = root > 0 ? part * (a + b) / root : part;
  return filter_.radius * (2 * (static_cast<float>(step) + place) / kSteps - 1);
}

}  // namespace heckbert::transport
