#include <heckbert/record/folding.h>

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/expression.h>

namespace heckbert::record {

taxonomy::Language longer_than(int longest) {
  return taxonomy::compile(fmt::format("L .{{{},}} E", longest + 1));
}

// The languages are fused into one automaton, of which every outcome is a set of languages that have some word in
// common and in no other. A class is the words of one outcome of the declared ones: where those meet outcomes with and
// without the language that is asked for, the class is undecided.
std::vector<bool> undecided(const Record& record, const taxonomy::Language& language, taxonomy::GlossyRule rule) {
  std::vector<bool> result(record.words.size());
  if (!record.folding) return result;
  const Folding& folding = *record.folding;
  const taxonomy::Language asked = taxonomy::apply(rule, language);
  if (std::ranges::find(folding.exact, asked) != folding.exact.end()) return result;
  std::vector<taxonomy::Language> languages = folding.exact;
  const std::size_t asked_at = languages.size(), folded_at = asked_at + 1;
  languages.push_back(asked);
  languages.push_back(longer_than(folding.longest));
  const taxonomy::Classifier classifier(languages);
  if (classifier.group_count() > 1) {  // too many states to be told
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(folding.first), result.end(), true);
    return result;
  }
  std::map<taxonomy::Membership, std::array<bool, 2>> met;  // by declared languages: words without and within
  for (std::size_t outcome = 0; outcome < classifier.outcome_count(0); ++outcome) {
    const auto bits = classifier.members(outcome, 0);
    const auto has = [&](std::size_t i) { return (bits[i / 64] >> i % 64 & 1) != 0; };
    if (!has(folded_at)) continue;
    taxonomy::Membership declared(asked_at);
    for (std::size_t i = 0; i < asked_at; ++i) declared[i] = has(i);
    met[declared][has(asked_at) ? 1 : 0] = true;
  }
  for (std::size_t word = folding.first; word < result.size(); ++word) {
    taxonomy::Membership declared = classifier.classify(record.words[word]);
    declared.resize(asked_at);
    const auto& [without, within] = met[declared];
    result[word] = without && within;
  }
  return result;
}

}  // namespace heckbert::record
