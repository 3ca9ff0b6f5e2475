#include <heckbert/report/coverage.h>

#include <algorithm>
#include <unordered_map>

#include <heckbert/report/energies.h>

namespace heckbert::report {
namespace {

/// The words of a record by their spelling: which print alike.
struct Spellings {
  std::vector<std::string> names;
  std::vector<std::size_t> lengths;  ///< by name
  std::vector<std::size_t> of_word;  ///< index into names, by word of the record
};

Spellings spell(const record::Record& record, Spelling spelling) {
  Spellings result;
  result.of_word.reserve(record.words.size());
  std::unordered_map<std::string, std::size_t> known;
  for (const taxonomy::Word& word : record.words) {
    const auto [found, is_new] =
        known.try_emplace(spelling == Spelling::Plain ? plain(word) : fine(word), result.names.size());
    if (is_new) {
      result.names.push_back(found->first);
      result.lengths.push_back(word.length());
    }
    result.of_word.push_back(found->second);
  }
  return result;
}

/// The chosen words under their spellings, by energy, most first. Equal energies keep the order of the record.
std::vector<WordEnergy> ranked(const Energies& energies, const Spellings& spellings, const std::vector<bool>& chosen) {
  std::vector<std::size_t> group_of_name(spellings.names.size(), kNoGroup);
  std::vector<std::size_t> group_of_word(chosen.size(), kNoGroup);
  std::vector<std::size_t> name_of_group;
  for (std::size_t word = 0; word < chosen.size(); ++word) {
    if (!chosen[word]) continue;
    const std::size_t name = spellings.of_word[word];
    if (group_of_name[name] == kNoGroup) {
      group_of_name[name] = name_of_group.size();
      name_of_group.push_back(name);
    }
    group_of_word[word] = group_of_name[name];
  }
  std::vector<WordEnergy> words;
  for (const GroupEnergy& sum : energies.of_groups(group_of_word, name_of_group.size())) {
    const std::size_t name = name_of_group[words.size()];
    words.push_back({.word = spellings.names[name],
                     .energy = sum.energy,
                     .share = sum.share,
                     .count = sum.count,
                     .length = spellings.lengths[name]});
  }
  std::stable_sort(words.begin(), words.end(),
                   [](const WordEnergy& a, const WordEnergy& b) { return a.energy.mean > b.energy.mean; });
  return words;
}

/// The first `count` of them that carry any energy.
std::vector<WordEnergy> top(std::vector<WordEnergy> words, std::size_t count) {
  const auto dark = std::find_if(words.begin(), words.end(), [](const WordEnergy& w) { return w.energy.mean <= 0; });
  words.resize(std::min(count, static_cast<std::size_t>(dark - words.begin())));
  return words;
}

double mean_luminance(const std::vector<Rgb>& pixels) {
  double sum = 0;
  for (const Rgb pixel : pixels) sum += static_cast<double>(luminance(pixel));
  return pixels.empty() ? 0 : sum / static_cast<double>(pixels.size());
}

}  // namespace

std::vector<WordEnergy> words_by_energy(const record::Record& record, const std::vector<bool>& chosen,
                                        Spelling spelling, double confidence) {
  return ranked(Energies(record, confidence), spell(record, spelling), chosen);
}

Coverage coverage(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                  const CoverageOptions& options) {
  const Energies energies(record, options.confidence);
  const Spellings spellings = spell(record, options.spelling);
  const std::vector<bool> all(record.words.size(), true);

  Coverage result;
  result.info = record.info;
  result.tally = record.tally;
  result.glossy_rule = options.glossy_rule;
  result.confidence = options.confidence;
  result.total = energies.of_words(all).energy;
  result.ambient = mean_luminance(record.ambient);
  result.phantom = mean_luminance(record.phantom);
  result.words = ranked(energies, spellings, all);
  for (const taxonomy::Grammar& grammar : grammars) {
    if (!taxonomy::has_language(grammar)) {
      result.left_out.push_back({grammar.name, grammar.title, taxonomy::why_no_language(grammar)});
      continue;
    }
    const std::vector<bool> captured = members(record, grammar.language, options.glossy_rule);
    std::vector<bool> missed = captured;
    missed.flip();
    const GroupEnergy sum = energies.of_words(captured);
    result.grammars.push_back({.name = grammar.name,
                               .title = grammar.title,
                               .expression = grammar.expression,
                               .expression_delta = grammar.expression_delta,
                               .source = grammar.source,
                               .biases = grammar.biases,
                               .variances = grammar.variances,
                               .preconditions = grammar.preconditions,
                               .captured = captured,
                               .captured_energy = sum.energy,
                               .share = sum.share,
                               .top_captured = top(ranked(energies, spellings, captured), options.top),
                               .top_missed = top(ranked(energies, spellings, missed), options.top)});
  }
  return result;
}

bool has_two_expressions(const GrammarCoverage& grammar) {
  return !grammar.expression_delta.empty() && grammar.expression_delta != grammar.expression;
}

double missed_share(const Coverage& coverage, const GrammarCoverage& grammar) {
  return coverage.total.mean > 0 ? 1 - grammar.share.mean : 0;
}

}  // namespace heckbert::report
