#include <heckbert/record/statistics.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace heckbert::record {

namespace {

/// Luminance of the picture mean, as each batch alone estimates it.
BatchSeries luminance_by_batch(const Record& record, const std::vector<bool>& chosen) {
  assert(chosen.size() == record.words.size());
  BatchSeries series{};
  for (std::size_t w = 0; w < chosen.size(); ++w) {
    if (!chosen[w]) continue;
    for (std::size_t b = 0; b < series.size(); ++b)
      series[b] += static_cast<double>(luminance(record.batch_means[w * kBatches + b]));
  }
  return series;
}

/// The fraction of the samples that each batch holds.
BatchSeries batch_weights(const RenderInfo& info) {
  const auto sizes = batch_sizes(info);
  BatchSeries weights{};
  for (std::size_t b = 0; b < weights.size(); ++b) weights[b] = static_cast<double>(sizes[b]) / info.samples_per_pixel;
  return weights;
}

constexpr double kNoBound = std::numeric_limits<double>::infinity();

Estimate exactly(double mean) {
  return {mean, 0, mean, mean, true};
}
Estimate unknown_spread(double mean) {
  return {mean, 0, mean, mean, false};
}

/// The interval of a sum to which few contributions may have been found. Were all of one size, their number would
/// follow Poisson's law and the interval would be Garwood's (1936); being of many sizes they count as (mean / error)^2
/// of the size error^2 / mean (Fay and Feuer 1997). The quantiles of the gamma distribution are Wilson and Hilferty's
/// (1931), with Student's, `quantile`, in place of the normal one, since the error is an estimate too. Where many were
/// found this is mean -+ quantile * error.
/// Takes: what one contribution would add, should none have been found; a bound that the true value cannot exceed.
Estimate interval(double mean, double error, double quantile, double size_if_none, double most) {
  if (mean > 0 && !(error > 0)) return exactly(mean);
  const double found = mean > 0 ? mean * mean / (error * error) : 0;
  const double size = mean > 0 ? error * error / mean : size_if_none;
  const auto gamma_quantile = [](double shape, double normal_quantile) {
    const double root = 1 - 1 / (9 * shape) + normal_quantile / (3 * std::sqrt(shape));
    return root > 0 ? shape * root * root * root : 0.0;
  };
  const double lower = found > 0 ? size * gamma_quantile(found, -quantile) : 0;
  const double upper = size * gamma_quantile(found + 1, quantile);
  return {mean, error, lower, std::min(upper, most), true};
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

BatchStatistics::BatchStatistics(const RenderInfo& info, double confidence) : weights_(batch_weights(info)) {
  for (const double weight : weights_) batches_ += weight > 0 ? 1 : 0;
  if (batches_ > 1) quantile_ = student_quantile(0.5 + confidence / 2, batches_ - 1);
}

double BatchStatistics::mean(const BatchSeries& values) const {
  double sum = 0;
  for (std::size_t b = 0; b < values.size(); ++b) sum += weights_[b] * values[b];
  return sum;
}

/// Standard error of the weighted mean of independent batches. A batch of n samples has variance s^2 / n, so the
/// weighted squares, not the plain ones, estimate s^2 without bias when batches differ in size.
double BatchStatistics::standard_error(const BatchSeries& values) const {
  const double m = mean(values);
  double squares = 0;
  for (std::size_t b = 0; b < values.size(); ++b) squares += weights_[b] * (values[b] - m) * (values[b] - m);
  return std::sqrt(squares / (batches_ - 1));
}

Estimate BatchStatistics::energy(const BatchSeries& values, double size_if_none) const {
  const double m = mean(values);
  if (batches_ < 2) return unknown_spread(m);
  return interval(m, standard_error(values), quantile_, size_if_none, kNoBound);
}

Estimate BatchStatistics::share(const BatchSeries& part, const BatchSeries& whole, double most,
                                double size_if_none) const {
  const double total = mean(whole);
  if (total <= 0) return exactly(0);
  if (part == whole) return exactly(1);
  const double ratio = mean(part) / total;
  if (batches_ < 2) return unknown_spread(ratio);
  // Delta method: the ratio errs like the mean of these residuals over the whole.
  BatchSeries residuals;
  for (std::size_t b = 0; b < residuals.size(); ++b) residuals[b] = part[b] - ratio * whole[b];
  const double error = standard_error(residuals) / total, one = size_if_none / total;
  if (ratio <= 0.5 || most > 1) return interval(ratio, error, quantile_, one, most);
  // What is left of the whole is the rarer one.
  const Estimate rest = interval(1 - ratio, error, quantile_, one, 1);
  return {ratio, error, 1 - rest.upper, 1 - rest.lower, true};
}

Estimate energy(const Record& record, const std::vector<bool>& chosen, double confidence) {
  const BatchSeries values = luminance_by_batch(record, chosen);
  return BatchStatistics(record.info, confidence)
      .energy(values, values == BatchSeries{} ? contribution_if_none(record) : 0);
}

double contribution_if_none(const Record& record) {
  const BatchSeries weights = batch_weights(record.info);
  double all = 0, once = 0;
  std::size_t found_once = 0;
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    double energy = 0;
    for (std::size_t b = 0; b < weights.size(); ++b)
      energy += weights[b] * static_cast<double>(luminance(record.batch_means[w * kBatches + b]));
    all += energy;
    if (record.counts[w] != 1) continue;
    once += energy;
    ++found_once;
  }
  const std::uint64_t count = record.tally.contributions();
  const double of_all = count > 0 ? all / static_cast<double>(count) : 0.0;
  return found_once > 0 ? std::max(once / static_cast<double>(found_once), of_all) : of_all;
}

Rgb mean_colour(const Record& record, const std::vector<bool>& chosen) {
  assert(chosen.size() == record.words.size());
  const BatchSeries weights = batch_weights(record.info);
  double red = 0, green = 0, blue = 0;
  for (std::size_t w = 0; w < chosen.size(); ++w) {
    if (!chosen[w]) continue;
    for (std::size_t b = 0; b < weights.size(); ++b) {
      const Rgb mean = record.batch_means[w * kBatches + b];
      red += weights[b] * static_cast<double>(mean.r);
      green += weights[b] * static_cast<double>(mean.g);
      blue += weights[b] * static_cast<double>(mean.b);
    }
  }
  return {static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue)};
}

Estimate share(const Record& record, const std::vector<bool>& part, const std::vector<bool>& whole, double confidence) {
  return BatchStatistics(record.info, confidence)
      .share(luminance_by_batch(record, part), luminance_by_batch(record, whole), is_subset(part, whole) ? 1 : kNoBound,
             contribution_if_none(record));
}

Estimate cut_off(const RenderInfo& info, const Tally& tally, double confidence) {
  if (!info.knows_cut_off) return unknown_spread(0);
  if (tally.cut_off == 0) return exactly(0);
  const double n = static_cast<double>(tally.samples);
  const double mean = mean_of(tally.cut_off, n);
  if (tally.samples < 2) return unknown_spread(mean);
  const double error = std::sqrt(std::max(mean_of(tally.cut_off_squares, n) - mean * mean, 0.0) / (n - 1));
  constexpr std::uint64_t kNearlyNormal = 10000;  // a Student quantile costs a loop over its degrees of freedom
  const int degrees = static_cast<int>(std::min(tally.samples, kNearlyNormal)) - 1;
  return interval(mean, error, student_quantile(0.5 + confidence / 2, degrees), 0, kNoBound);
}

double student_quantile(double probability, int degrees) {
  assert(probability > 0 && probability < 1 && degrees >= 1);
  if (probability < 0.5) return -student_quantile(1 - probability, degrees);
  double low = 0, high = std::numbers::pi / 2;
  for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2)
    (student_central_probability(middle, degrees) < 2 * probability - 1 ? low : high) = middle;
  return std::sqrt(degrees) * std::tan(low);
}

double student_tails(double t, int degrees) {
  return std::max(1 - student_central_probability(std::atan(t / std::sqrt(degrees)), degrees), 0.0);
}

}  // namespace heckbert::record
