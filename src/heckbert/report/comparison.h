#pragma once
// Do two independent renders say the same of one energy? Student's test on the means of their batches, in the form for
// unequal variances (Welch 1947, "The generalization of 'Student's' problem when several different population variances
// are involved").
//
// The test supposes that means are nearly normal, which those of a few bright contributions are not. So an energy is
// compared only where it counts as at least kEnough contributions of one size: (mean / standard error)^2, the number
// that intervals of rare words go by (docs/decisions/2026-11-27-intervals.md).

#include <heckbert/record/statistics.h>
#include <heckbert/report/evidence.h>

namespace heckbert::report {

inline constexpr double kEnough = 16;
/// The same where all pixels share photons or virtual lights: what one of them brings ranges over decades with how near
/// it lies to what is seen, so that sixteen of them are still far from normal.
inline constexpr double kEnoughShared = 64;

/// Relative difference below which two energies are not told apart: by some 1e-4 even agreeing batches can be wrong,
/// where an edge cuts a stratum of the samples or a ray clears a surface.
inline constexpr double kResolution = 5e-4;

struct Comparison {
  record::Estimate expected, found;
  double standard_errors = 0;  ///< of the difference, by how many of them it differs from none
  double p_value = 1;          ///< of a difference so large by chance, two-sided, for this comparison alone
};

/// (mean / standard error)^2; infinite where all batches agree, 0 where nothing was found.
double effective_count(const record::Estimate& estimate);

/// Takes: estimates of series with at least two batches.
Comparison compare(const record::Estimate& expected, int expected_batches, const record::Estimate& found,
                   int found_batches);

/// found / expected, by the errors of both. Takes: an expected mean above 0.
record::Estimate ratio(const Comparison& comparison, double quantile);

/// The significance of each of so many independent comparisons, for that of all together (Sidak 1967).
double sidak(double significance, std::size_t comparisons);

}  // namespace heckbert::report
