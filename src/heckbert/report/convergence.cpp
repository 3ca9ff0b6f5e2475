#include <heckbert/report/convergence.h>

#include <algorithm>
#include <cmath>

namespace heckbert::report {
namespace {

double error_of(const Comparison& comparison) {
  return comparison.found.mean - comparison.expected.mean;
}

double spread_of(const Comparison& comparison) {
  return std::hypot(comparison.found.standard_error, comparison.expected.standard_error);
}

/// As Sequence::p_value, against one earlier stage, of whose error `factor` may be left. The witness is the same for
/// both, so its own error counts by the difference of what it does to them.
double p_value_against(const Comparison& earlier, const Comparison& last, double factor, int batches) {
  const double before = error_of(earlier), left = error_of(last);
  const double indistinct = kResolution * std::max(last.expected.mean, last.found.mean);
  const double excess = std::abs(left) - factor * std::abs(before) - indistinct;
  if (excess <= 0) return 1;
  const double of_witness = (before * left > 0 ? 1 - factor : 1 + factor) * last.expected.standard_error;
  const double spread = std::sqrt(std::pow(last.found.standard_error, 2) +
                                  std::pow(factor * earlier.found.standard_error, 2) + of_witness * of_witness);
  if (!(spread > 0)) return 0;
  return record::student_tails(excess / spread, batches - 1) / 2;
}

std::optional<record::Estimate> measured_order(const Comparison& first, const Comparison& last, double refined,
                                               double quantile) {
  const double before = std::abs(error_of(first)), left = std::abs(error_of(last));
  if (before <= 3 * spread_of(first) || left <= 3 * spread_of(last)) return std::nullopt;
  const double order = std::log(before / left) / std::log(refined);
  const double error = std::hypot(spread_of(first) / before, spread_of(last) / left) / std::log(refined);
  return record::Estimate{order, error, order - quantile * error, order + quantile * error, true};
}

}  // namespace

Sequence sequence_of(const std::vector<Comparison>& comparisons, const std::vector<double>& sizes, double order,
                     int batches, double quantile) {
  Sequence sequence;
  for (const Comparison& comparison : comparisons) sequence.ratios.push_back(ratio(comparison, quantile));
  const Comparison& last = comparisons.back();
  sequence.order = measured_order(comparisons.front(), last, sizes.front() / sizes.back(), quantile);
  // An error may pass through none on its way, so the stage that lets expect most decides.
  sequence.p_value = 0;
  for (std::size_t i = 0; i + 1 < comparisons.size(); ++i)
    sequence.p_value = std::max(
        sequence.p_value, p_value_against(comparisons[i], last, std::pow(sizes.back() / sizes[i], order), batches));
  return sequence;
}

}  // namespace heckbert::report
