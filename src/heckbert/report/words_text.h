#pragma once
// Words and groups of words by energy, for the terminal and as JSON (docs/json.md).

#include <cstddef>
#include <string>
#include <vector>

#include <heckbert/report/classify.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {

/// The first `most` words as a table, then one line for the rest; 0 lists them all.
std::string words_text(const std::vector<WordEnergy>& words, const TextStyle& style = {}, std::size_t most = 0);

/// The groups that classify() gave, as a table; `most` as above.
std::string groups_text(const std::vector<WordGroup>& groups, GroupBy by, const TextStyle& style = {},
                        std::size_t most = 0);

/// Schema "heckbert.classify"; the whole of it, never cut.
std::string groups_json(const std::vector<WordGroup>& groups, GroupBy by, const record::RenderInfo& info,
                        const record::Tally& tally, const ClassifyOptions& options);

}  // namespace heckbert::report
