#include <heckbert/report/comparison.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace heckbert::report {

double effective_count(const record::Estimate& estimate) {
  if (!(estimate.mean > 0)) return 0;
  if (!(estimate.standard_error > 0)) return std::numeric_limits<double>::infinity();
  return std::pow(estimate.mean / estimate.standard_error, 2);
}

Comparison compare(const record::Estimate& expected, int expected_batches, const record::Estimate& found,
                   int found_batches) {
  Comparison comparison{expected, found};
  const double a = std::pow(expected.standard_error, 2), b = std::pow(found.standard_error, 2);
  const double indistinct = kResolution * std::max(expected.mean, found.mean);
  const double difference = std::abs(found.mean - expected.mean);
  if (difference <= indistinct) return comparison;
  const double error = std::sqrt(a + b);
  if (!(error > 0)) {
    comparison.standard_errors = std::numeric_limits<double>::infinity();
    comparison.p_value = 0;
    return comparison;
  }
  comparison.standard_errors = (difference - indistinct) / error;
  const double degrees = (a + b) * (a + b) / (a * a / (expected_batches - 1) + b * b / (found_batches - 1));
  comparison.p_value = record::student_tails(comparison.standard_errors, static_cast<int>(std::max(degrees, 1.0)));
  return comparison;
}

record::Estimate ratio(const Comparison& comparison, double quantile) {
  const double mean = comparison.found.mean / comparison.expected.mean;
  const double error =
      std::hypot(comparison.found.standard_error, mean * comparison.expected.standard_error) / comparison.expected.mean;
  return {mean, error, std::max(mean - quantile * error, 0.0), mean + quantile * error, true};
}

double sidak(double significance, std::size_t comparisons) {
  return comparisons == 0 ? significance : -std::expm1(std::log1p(-significance) / static_cast<double>(comparisons));
}

}  // namespace heckbert::report
