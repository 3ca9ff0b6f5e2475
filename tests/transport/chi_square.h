#pragma once
// Pearson's chi-square test of counts against what was expected of them.

#include <cmath>
#include <cstddef>
#include <vector>

namespace heckbert::transport {

/// How many standard deviations the statistic lies above its mean, by the normal approximation of chi-square (good from
/// some thirty cells on). Cells that expect fewer than five are pooled.
inline double chi_square_excess(const std::vector<double>& expected, const std::vector<double>& seen) {
  double statistic = 0, pool_expected = 0, pool_seen = 0;
  int cells = 0;
  const auto count = [&](double e, double s) {
    statistic += (s - e) * (s - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] >= 5) {
      count(expected[i], seen[i]);
    } else {
      pool_expected += expected[i];
      pool_seen += seen[i];
    }
  }
  if (pool_expected >= 5)
    count(pool_expected, pool_seen);
  else if (pool_seen > 5 + 10 * pool_expected)
    return INFINITY;  // draws where none should be
  const double degrees = cells - 1;
  return degrees > 0 ? (statistic - degrees) / std::sqrt(2 * degrees) : 0.0;
}

}  // namespace heckbert::transport
