#include <heckbert/report/word_groups.h>

#include <algorithm>

namespace heckbert::report {
namespace {

/// Who vouches for a word.
std::size_t witness_of(const taxonomy::Word& word, const std::vector<Witness>& witnesses) {
  const auto found = std::find_if(witnesses.begin(), witnesses.end(),
                                  [&](const Witness& witness) { return witness.language.contains(word); });
  return found == witnesses.end() ? kNobody : static_cast<std::size_t>(found - witnesses.begin());
}

void keep_brighter(BrightPixel& brightest, const BrightPixel& other) {
  if (other.luminance > brightest.luminance) brightest = other;
}

}  // namespace

GroupKey key_of(const taxonomy::Word& word, const Grouping& grouping) {
  return {word.light, grouping.spelling == Spelling::Plain ? plain(word) : fine(word), grouping.claimed.contains(word),
          witness_of(word, grouping.witnesses)};
}

void add(std::map<std::size_t, Series>& sum, const std::map<std::size_t, Series>& more) {
  for (const auto& [block, series] : more) sum[block] += series;
}

std::map<GroupKey, ComparedWords> groups_of(const Evidence& own, const Grouping& grouping) {
  std::map<GroupKey, ComparedWords> groups;
  const auto group_of = [&](const taxonomy::Word& word, const GroupKey& key) -> ComparedWords& {
    ComparedWords& group = groups[key];
    group.word = word;
    std::tie(std::ignore, group.name, group.is_claimed, group.witness) = key;
    return group;
  };
  for (const auto& [word, evidence] : own.words()) {
    ComparedWords& group = group_of(word, key_of(word, grouping));
    group.found += evidence.picture;
    add(group.found_blocks, evidence.blocks);
    keep_brighter(group.brightest_found, evidence.brightest);
  }
  for (std::size_t w = 0; w < grouping.witnesses.size(); ++w)
    for (const auto& [word, evidence] : grouping.witnesses[w].evidence->words()) {
      const GroupKey key = key_of(word, grouping);
      if (std::get<3>(key) != w) continue;
      ComparedWords& group = group_of(word, key);
      group.expected += evidence.picture;
      add(group.expected_blocks, evidence.blocks);
      keep_brighter(group.brightest_expected, evidence.brightest);
    }
  return groups;
}

}  // namespace heckbert::report
