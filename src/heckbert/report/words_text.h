#pragma once
// Words and groups of words by energy, for the terminal and as JSON (docs/json.md).

#include <cstddef>
#include <string>
#include <vector>

#include <heckbert/report/classify.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {

/// The first `most` words as a table, then one line for the rest; 0 lists them all. Upon request with the samples that
/// each needs.
std::string words_text(const std::vector<WordEnergy>& words, const TextStyle& style = {}, std::size_t most = 0,
                       bool with_samples = false);

/// "12 words have 99 % of the energy. Entropy 3.21 bits: ..."; the classification must have a spread.
std::string spread_text(const Classification& classification);

/// The groups that classify() gave, as a table, then how the energy is spread over them; `most` as above.
std::string classification_text(const Classification& classification, const TextStyle& style = {},
                                std::size_t most = 0);

/// Schema "heckbert.classify"; the whole of it, never cut.
std::string classification_json(const Classification& classification);

}  // namespace heckbert::report
