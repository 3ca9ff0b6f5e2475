#include <heckbert/report/classify.h>

#include <algorithm>
#include <map>

#include <heckbert/report/energies.h>

namespace heckbert::report {
namespace {

WordGroup group_of(const std::string& name, const GroupEnergy& sum, std::size_t words) {
  return {.name = name, .expression = {}, .energy = sum.energy, .share = sum.share, .count = sum.count, .words = words};
}

/// One group per distinct key of the words, in the order of the keys.
template <typename Key, typename Spell>
std::vector<WordGroup> by_key(const record::Record& record, const Energies& energies, const Key& key,
                              const Spell& spell) {
  std::map<decltype(key(record.words[0])), std::vector<std::size_t>> words_of;
  for (std::size_t w = 0; w < record.words.size(); ++w) words_of[key(record.words[w])].push_back(w);

  std::vector<std::size_t> group(record.words.size());
  std::size_t next = 0;
  for (const auto& [name, words] : words_of) {
    for (const std::size_t w : words) group[w] = next;
    ++next;
  }
  const std::vector<GroupEnergy> sums = energies.of_groups(group, words_of.size());
  std::vector<WordGroup> groups;
  groups.reserve(words_of.size());
  for (const auto& [name, words] : words_of) groups.push_back(group_of(spell(name), sums[groups.size()], words.size()));
  return groups;
}

std::vector<WordGroup> by_spelling(const record::Record& record, const Energies& energies,
                                   std::string (*spelling)(const taxonomy::Word&)) {
  auto groups = by_key(record, energies, spelling, [](const std::string& name) { return name; });
  std::stable_sort(groups.begin(), groups.end(),
                   [](const WordGroup& a, const WordGroup& b) { return a.energy.mean > b.energy.mean; });
  return groups;
}

std::vector<WordGroup> by_grammar(const record::Record& record, const Energies& energies,
                                  const taxonomy::GrammarLibrary& library, taxonomy::GrammarKind kind,
                                  taxonomy::GlossyRule rule) {
  std::vector<WordGroup> groups;
  for (const taxonomy::Grammar& grammar : library.grammars) {
    if (grammar.kind != kind) continue;
    const std::vector<bool> chosen = members(record, grammar.language, rule);
    groups.push_back(group_of(grammar.name, energies.of_words(chosen),
                              static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true))));
    groups.back().expression = grammar.expression;
  }
  return groups;
}

}  // namespace

std::vector<WordGroup> classify(const record::Record& record, GroupBy by, const taxonomy::GrammarLibrary& library,
                                const ClassifyOptions& options) {
  const Energies energies(record, options.confidence);
  switch (by) {
    case GroupBy::Word:
      return by_spelling(record, energies, taxonomy::plain);
    case GroupBy::FineWord:
      return by_spelling(record, energies, taxonomy::fine);
    case GroupBy::Length:
      return by_key(
          record, energies, [](const taxonomy::Word& word) { return word.length(); },
          [](std::size_t length) { return std::to_string(length); });
    case GroupBy::Class:
      return by_grammar(record, energies, library, taxonomy::GrammarKind::Class, options.glossy_rule);
    case GroupBy::Algorithm:
      return by_grammar(record, energies, library, taxonomy::GrammarKind::Algorithm, options.glossy_rule);
  }
  return {};
}

}  // namespace heckbert::report
