#pragma once
// Words that are spoken of as one: of one kind of light, printed alike, claimed alike by the algorithm that is looked
// at, and vouched for by the same witness; with what both sides have of them.

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <heckbert/report/coverage.h>
#include <heckbert/report/evidence.h>
#include <heckbert/taxonomy/language.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::report {

/// Renders that are believed, for the words of a language.
struct Witness {
  std::string algorithm;
  const Evidence* evidence = nullptr;
  taxonomy::Language language;
};

/// In place of a witness's number.
inline constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// What makes words alike. Refers to both.
struct Grouping {
  const taxonomy::Language& claimed;
  const std::vector<Witness>& witnesses;  ///< in the order in which they are believed
  Spelling spelling = Spelling::Plain;
};

/// Kind of light, spelling, claimed or not, number of the witness.
using GroupKey = std::tuple<taxonomy::Symbol, std::string, bool, std::size_t>;
GroupKey key_of(const taxonomy::Word& word, const Grouping& grouping);

/// Such words together.
struct ComparedWords {
  taxonomy::Word word;  ///< one of them
  std::string name;     ///< as all of them print
  bool is_claimed = false;
  std::size_t witness = kNobody;
  Series expected, found;  ///< by the witness; by the algorithm itself
  std::map<std::size_t, Series> expected_blocks, found_blocks;
  BrightPixel brightest_expected{}, brightest_found{};
};

/// Of all words that the algorithm found or a witness vouches for.
std::map<GroupKey, ComparedWords> groups_of(const Evidence& own, const Grouping& grouping);

/// Block by block.
void add(std::map<std::size_t, Series>& sum, const std::map<std::size_t, Series>& more);

}  // namespace heckbert::report
