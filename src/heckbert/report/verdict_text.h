#pragma once
// A verification for the terminal.

#include <cstddef>
#include <string>

#include <heckbert/report/text_table.h>
#include <heckbert/report/verdict.h>

namespace heckbert::report {

/// One row for each algorithm and kind of light, the verdict in words, and below it the words that led to it, at most
/// `most` of each standing.
std::string verification_text(const Verification& verification, const TextStyle& style = {}, std::size_t most = 4);

/// "misses words it claims", "captured, but needs about 3 200 samples".
std::string sentence(const AlgorithmVerdict& verdict);

}  // namespace heckbert::report
