#include <heckbert/report/classify.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include <heckbert/report/energies.h>
#include <heckbert/taxonomy/letter.h>

namespace heckbert::report {
namespace {

using taxonomy::Word;

constexpr std::string_view kNoLabel = "(no label)";

std::size_t letters(const Word& word, char letter) {
  return static_cast<std::size_t>(std::count_if(word.events.begin(), word.events.end(), [letter](taxonomy::Symbol s) {
    return taxonomy::facts(s).letter == letter;
  }));
}

/// The number of letters that a grouping counts; nothing for the other groupings.
std::optional<std::size_t> number_of(GroupBy by, const Word& word) {
  switch (by) {
    case GroupBy::Length:
      return word.length();
    case GroupBy::Diffuse:
      return letters(word, 'D');
    case GroupBy::Glossy:
      return letters(word, 'G');
    case GroupBy::Specular:
      return letters(word, 'S');
    default:
      return {};
  }
}

bool counts_letters(GroupBy by) {
  return number_of(by, Word{}).has_value();
}

std::string label_or_none(std::string_view label) {
  return std::string(label.empty() ? kNoLabel : label);
}

/// The name of the group that a word is in.
std::string name_of(GroupBy by, const Word& word) {
  switch (by) {
    case GroupBy::FineWord:
      return fine(word);
    case GroupBy::Light:
      return taxonomy::name(taxonomy::Letter{word.light, std::string(word.label(0))});
    case GroupBy::Seen:
      return word.events.empty() ? "(a light)" : label_or_none(word.label(word.length()));
    default:
      return plain(word);
  }
}

std::set<std::string> labels_of(const Word& word) {
  std::set<std::string> labels;
  for (std::size_t place = 1; place <= word.length(); ++place) labels.insert(label_or_none(word.label(place)));
  return labels;
}

WordGroup group_of(const std::string& name, const GroupEnergy& sum, std::size_t words) {
  return {.name = name, .expression = {}, .energy = sum.energy, .share = sum.share, .count = sum.count, .words = words};
}

/// The numbers that a grouping counts, by word; kNoGroup outside of the part.
std::vector<std::size_t> numbers(const record::Record& record, const Part& part, GroupBy by) {
  std::vector<std::size_t> number(record.words.size(), kNoGroup);
  for (std::size_t w = 0; w < number.size(); ++w)
    if (part.has(w)) number[w] = *number_of(by, record.words[w]);
  return number;
}

Spectrum spectrum_of(const record::Record& record, const Energies& energies, const GroupByFacts& grouping) {
  const std::vector<std::size_t> number = numbers(record, energies.part(), grouping.by);
  std::size_t size = 0;
  for (const std::size_t n : number)
    if (n != kNoGroup) size = std::max(size, n + 1);
  Spectrum spectrum{grouping.name, {}};
  for (const GroupEnergy& sum : energies.of_groups(number, size)) spectrum.shares.push_back(sum.share);
  return spectrum;
}

/// Groups of words by key, and the group of each word.
struct Partition {
  std::vector<WordGroup> groups;
  std::vector<std::size_t> group_of;
};

/// In the order of the keys. `key_of(word number)` is asked for words of the part alone.
template <class KeyOf>
Partition by_key(const record::Record& record, const Energies& energies, KeyOf key_of) {
  std::map<decltype(key_of(std::size_t{})), std::vector<std::size_t>> words_of;
  for (std::size_t w = 0; w < record.words.size(); ++w)
    if (energies.part().has(w)) words_of[key_of(w)].push_back(w);
  Partition result{{}, std::vector<std::size_t>(record.words.size(), kNoGroup)};
  std::size_t next = 0;
  for (const auto& [key, words] : words_of) {
    for (const std::size_t w : words) result.group_of[w] = next;
    ++next;
  }
  const std::vector<GroupEnergy> sums = energies.of_groups(result.group_of, words_of.size());
  for (const auto& [key, words] : words_of)
    result.groups.push_back(group_of(fmt::format("{}", key), sums[result.groups.size()], words.size()));
  return result;
}

void sort_by_energy(std::vector<WordGroup>& groups) {
  std::stable_sort(groups.begin(), groups.end(),
                   [](const WordGroup& a, const WordGroup& b) { return a.energy.mean > b.energy.mean; });
}

std::vector<WordGroup> by_label(const record::Record& record, const Energies& energies) {
  std::map<std::string, std::vector<bool>> words_of;
  for (std::size_t w = 0; w < record.words.size(); ++w)
    if (energies.part().has(w))
      for (const std::string& name : labels_of(record.words[w])) {
        std::vector<bool>& words = words_of[name];
        words.resize(record.words.size());
        words[w] = true;
      }
  std::vector<WordGroup> groups;
  for (const auto& [name, words] : words_of)
    groups.push_back(group_of(name, energies.of_words(words),
                              static_cast<std::size_t>(std::count(words.begin(), words.end(), true))));
  sort_by_energy(groups);
  return groups;
}

std::vector<WordGroup> by_grammar(const record::Record& record, const Energies& energies,
                                  const taxonomy::GrammarLibrary& library, taxonomy::GrammarKind kind,
                                  taxonomy::GlossyRule rule) {
  std::vector<WordGroup> groups;
  for (const taxonomy::Grammar& grammar : library.grammars) {
    if (grammar.kind != kind) continue;
    const Members members = members_of(record, grammar.language, rule);
    std::size_t words = 0;
    for (std::size_t w = 0; w < members.certain.size(); ++w)
      words += members.certain[w] && energies.part().has(w) ? 1 : 0;
    groups.push_back(group_of(grammar.name, energies.of_members(members), words));
    groups.back().expression = grammar.expression;
  }
  return groups;
}

/// Entropy is the mean of -log2 of a group's share over the energy. Its error to first order is that of this mean with
/// the shares held fast. `group_of` is by word.
std::optional<Spread> spread_of(const Energies& energies, const std::vector<WordGroup>& groups,
                                const std::vector<std::size_t>& group_of, double reach) {
  std::vector<double> shares;
  for (const WordGroup& group : groups)
    if (group.share.mean > 0) shares.push_back(group.share.mean);
  if (shares.empty()) return {};
  std::vector<double> surprise(group_of.size());
  for (std::size_t w = 0; w < surprise.size(); ++w)
    if (group_of[w] != kNoGroup && groups[group_of[w]].share.mean > 0)
      surprise[w] = std::max(-std::log2(groups[group_of[w]].share.mean), 0.0);
  Spread spread;
  spread.entropy = energies.mean_over_energy(surprise);
  spread.effective_groups = std::exp2(spread.entropy.mean);
  spread.reach = reach;
  std::sort(shares.begin(), shares.end(), std::greater<>());
  double reached = 0;
  while (spread.groups_to_reach < shares.size() && reached < reach) reached += shares[spread.groups_to_reach++];
  return spread;
}

}  // namespace

Classification classify(const record::Record& record, GroupBy by, const taxonomy::GrammarLibrary& library,
                        const ClassifyOptions& options) {
  const Energies energies(record, options.confidence, options.part);
  Classification result{.info = record.info,
                        .tally = record.tally,
                        .by = by,
                        .glossy_rule = options.glossy_rule,
                        .confidence = options.confidence,
                        .part = options.part,
                        .groups = {},
                        .spread = {},
                        .spectra = {}};
  for (const GroupByFacts& grouping : kGroupings)
    if (counts_letters(grouping.by)) result.spectra.push_back(spectrum_of(record, energies, grouping));
  if (by == GroupBy::Class) {
    result.groups = by_grammar(record, energies, library, taxonomy::GrammarKind::Class, options.glossy_rule);
  } else if (by == GroupBy::Algorithm) {
    result.groups = by_grammar(record, energies, library, taxonomy::GrammarKind::Algorithm, options.glossy_rule);
  } else if (by == GroupBy::Label) {
    result.groups = by_label(record, energies);
  } else {
    Partition partition = counts_letters(by)
                              ? by_key(record, energies, [&](std::size_t w) { return *number_of(by, record.words[w]); })
                              : by_key(record, energies, [&](std::size_t w) { return name_of(by, record.words[w]); });
    result.spread = spread_of(energies, partition.groups, partition.group_of, options.reach);
    result.groups = std::move(partition.groups);
    if (!counts_letters(by)) sort_by_energy(result.groups);
  }
  return result;
}

std::vector<WordGroup> fewest_to_reach(const Classification& classification) {
  if (!classification.spread) return {};
  std::vector<WordGroup> groups = classification.groups;
  sort_by_energy(groups);
  groups.resize(classification.spread->groups_to_reach);
  return groups;
}

}  // namespace heckbert::report
