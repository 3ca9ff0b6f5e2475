#pragma once
// The energy of a record sorted into groups of words: by spelling, by number of scatterings, by named class, or by
// algorithm. Spellings and lengths are partitions; classes and algorithms may overlap, so their shares need not add up
// to one.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/coverage.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::report {

enum class GroupBy : std::uint8_t { Word, FineWord, Length, Class, Algorithm };

struct GroupByFacts {
  GroupBy by;
  std::string_view name;   ///< as on the command line
  std::string_view title;  ///< heading of the column of groups
};

inline constexpr std::array<GroupByFacts, 5> kGroupings{{
    {GroupBy::Word, "word", "Word"},
    {GroupBy::FineWord, "fine-word", "Word"},
    {GroupBy::Length, "length", "Scatterings"},
    {GroupBy::Class, "class", "Class"},
    {GroupBy::Algorithm, "algorithm", "Algorithm"},
}};

struct WordGroup {
  std::string name;        ///< spelling, number of scatterings, or name of the grammar
  std::string expression;  ///< of a class or algorithm; else empty
  record::Estimate energy;
  record::Estimate share;
  std::uint64_t count = 0;  ///< contributions
  std::size_t words = 0;    ///< distinct words of the record in the group
};

struct ClassifyOptions {
  taxonomy::GlossyRule glossy_rule = taxonomy::GlossyRule::Keep;
  double confidence = 0.95;
};

/// Groups of the record's words. Words by energy, most first; lengths ascending; classes and algorithms in the order of
/// the library, those without energy too.
std::vector<WordGroup> classify(const record::Record& record, GroupBy by, const taxonomy::GrammarLibrary& library,
                                const ClassifyOptions& options = {});

}  // namespace heckbert::report
