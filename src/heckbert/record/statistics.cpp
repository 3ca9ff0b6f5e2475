#include <heckbert/record/statistics.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace heckbert::record {

namespace {

using Series = std::vector<double>;  // one value per batch in use

/// The numbers of the batches that have samples.
std::vector<std::size_t> batches_of(const Record& record) {
  const auto sizes = batch_sizes(record.info);
  std::vector<std::size_t> batches;
  for (std::size_t b = 0; b < kBatches; ++b)
    if (sizes[b] > 0) batches.push_back(b);
  return batches;
}

/// Luminance of the picture mean, as each batch alone estimates it.
Series luminance_by_batch(const Record& record, const std::vector<bool>& chosen) {
  assert(chosen.size() == record.words.size());
  const std::vector<std::size_t> batches = batches_of(record);
  Series series(batches.size());
  for (std::size_t w = 0; w < chosen.size(); ++w) {
    if (!chosen[w]) continue;
    for (std::size_t b = 0; b < series.size(); ++b)
      series[b] += static_cast<double>(luminance(record.batch_means[w * kBatches + batches[b]]));
  }
  return series;
}

/// The fraction of the samples that each batch holds.
Series batch_weights(const Record& record) {
  const auto sizes = batch_sizes(record.info);
  Series weights;
  for (const std::size_t b : batches_of(record))
    weights.push_back(static_cast<double>(sizes[b]) / record.info.samples_per_pixel);
  return weights;
}

double weighted_mean(const Series& values, const Series& weights) {
  double sum = 0;
  for (std::size_t b = 0; b < values.size(); ++b) sum += weights[b] * values[b];
  return sum;
}

/// Standard error of the weighted mean of independent batches. A batch of n samples has variance s^2 / n, so the
/// weighted squares, not the plain ones, estimate s^2 without bias when batches differ in size.
double standard_error(const Series& values, const Series& weights) {
  const double mean = weighted_mean(values, weights);
  double squares = 0;
  for (std::size_t b = 0; b < values.size(); ++b) squares += weights[b] * (values[b] - mean) * (values[b] - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

Estimate exactly(double mean) {
  return {mean, 0, mean, mean, true};
}
Estimate unknown_spread(double mean) {
  return {mean, 0, mean, mean, false};
}

/// `most` is a bound that the true value cannot exceed; none is below zero.
Estimate with_interval(double mean, double error, std::size_t batches, double confidence, double most) {
  const double half = student_quantile(0.5 + confidence / 2, static_cast<int>(batches) - 1) * error;
  return {mean, error, std::max(mean - half, 0.0), std::min(mean + half, most), true};
}

bool is_subset(const std::vector<bool>& part, const std::vector<bool>& whole) {
  for (std::size_t w = 0; w < part.size(); ++w)
    if (part[w] && !whole[w]) return false;
  return true;
}

/// P(|T| <= t) with t = sqrt(degrees) tan(angle); finite series for whole degrees of freedom.
/// Source: Abramowitz and Stegun, 26.7.3 and 26.7.4.
double student_central_probability(double angle, int degrees) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1, sum = degrees == 1 ? 0 : term;
  for (int k = odd ? 3 : 2; k <= degrees - 2; k += 2) {
    term *= cosine * cosine * (k - 1) / k;
    sum += term;
  }
  return odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

}  // namespace

Estimate energy(const Record& record, const std::vector<bool>& chosen, double confidence) {
  const Series values = luminance_by_batch(record, chosen), weights = batch_weights(record);
  const double mean = weighted_mean(values, weights);
  if (values.size() < 2) return unknown_spread(mean);
  return with_interval(mean, standard_error(values, weights), values.size(), confidence,
                       std::numeric_limits<double>::infinity());
}

Rgb mean_colour(const Record& record, const std::vector<bool>& chosen) {
  assert(chosen.size() == record.words.size());
  const std::vector<std::size_t> batches = batches_of(record);
  const Series weights = batch_weights(record);
  double red = 0, green = 0, blue = 0;
  for (std::size_t w = 0; w < chosen.size(); ++w) {
    if (!chosen[w]) continue;
    for (std::size_t b = 0; b < weights.size(); ++b) {
      const Rgb mean = record.batch_means[w * kBatches + batches[b]];
      red += weights[b] * static_cast<double>(mean.r);
      green += weights[b] * static_cast<double>(mean.g);
      blue += weights[b] * static_cast<double>(mean.b);
    }
  }
  return {static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue)};
}

Estimate share(const Record& record, const std::vector<bool>& part, const std::vector<bool>& whole, double confidence) {
  const Series parts = luminance_by_batch(record, part), wholes = luminance_by_batch(record, whole);
  const Series weights = batch_weights(record);
  const double total = weighted_mean(wholes, weights);
  if (total <= 0 || part == std::vector<bool>(part.size())) return exactly(0);
  if (part == whole) return exactly(1);
  const double ratio = weighted_mean(parts, weights) / total;
  if (parts.size() < 2) return unknown_spread(ratio);
  // Delta method: the ratio errs like the mean of these residuals over the whole.
  Series residuals(parts.size());
  for (std::size_t b = 0; b < residuals.size(); ++b) residuals[b] = parts[b] - ratio * wholes[b];
  const double most = is_subset(part, whole) ? 1 : std::numeric_limits<double>::infinity();
  return with_interval(ratio, standard_error(residuals, weights) / total, parts.size(), confidence, most);
}

Estimate cut_off(const Tally& tally, double confidence) {
  if (tally.cut_off == 0) return exactly(0);
  const double n = static_cast<double>(tally.samples);
  const double mean = mean_of(tally.cut_off, n);
  if (tally.samples < 2) return unknown_spread(mean);
  const double error = std::sqrt(std::max(mean_of(tally.cut_off_squares, n) - mean * mean, 0.0) / (n - 1));
  constexpr std::uint64_t kNearlyNormal = 10000;  // a Student quantile costs a loop over its degrees of freedom
  return with_interval(mean, error, std::min(tally.samples, kNearlyNormal), confidence,
                       std::numeric_limits<double>::infinity());
}

double student_quantile(double probability, int degrees) {
  assert(probability > 0 && probability < 1 && degrees >= 1);
  if (probability < 0.5) return -student_quantile(1 - probability, degrees);
  double low = 0, high = std::numbers::pi / 2;
  for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2)
    (student_central_probability(middle, degrees) < 2 * probability - 1 ? low : high) = middle;
  return std::sqrt(degrees) * std::tan(low);
}

}  // namespace heckbert::record
