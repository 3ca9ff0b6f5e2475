#pragma once
// Coverage for a terminal.

#include <cstddef>
#include <string>

#include <heckbert/report/coverage.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {

/// A heading with scene, algorithm, samples, seed, version and the rule for G; warnings; then per grammar its title,
/// share with interval, captured energy, expressions and the words it misses most; then the scene's first `words` words
/// by energy.
std::string coverage_text(const Coverage& coverage, const TextStyle& style = {}, std::size_t words = 12);

}  // namespace heckbert::report
