#include <heckbert/report/coverage.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <heckbert/report/energies.h>
#include <heckbert/report/numbers.h>

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

bool has_more_energy(const WordEnergy& a, const WordEnergy& b) {
  return a.energy.mean > b.energy.mean;
}

/// Some words by energy, most first.
struct Selection {
  std::vector<WordEnergy> parts;          ///< of spellings that are not selected as a whole
  std::vector<const WordEnergy*> ranked;  ///< into `parts` and into the ranking that made this
};

/// The words of a part of a record under their spellings, by energy, most first; equal energies keep the order of the
/// record. Each is estimated once, however many selections are made: most take a spelling as a whole or not at all.
class Ranking {
 public:
  Ranking(const record::Record& record, const Energies& energies, Spelling spelling, double error)
      : energies_(energies), spellings_(spell(record, spelling)), error_(error), size_(spellings_.names.size()) {
    for (std::size_t word = 0; word < record.words.size(); ++word)
      if (energies.part().has(word)) ++size_[spellings_.of_word[word]];
    all_ = estimated(std::vector<bool>(record.words.size(), true), std::vector<bool>(size_.size(), true));
    for (std::size_t name = 0; name < size_.size(); ++name) spelling_[spellings_.names[name]] = name;
    for (const WordEnergy& word : all_) spelling_of_.push_back(spelling_.at(word.word));
  }

  const std::vector<WordEnergy>& all() const { return all_; }

  Selection select(const std::vector<bool>& chosen) const {
    std::vector<std::size_t> selected(size_.size());
    for (std::size_t word = 0; word < chosen.size(); ++word)
      if (chosen[word] && energies_.part().has(word)) ++selected[spellings_.of_word[word]];
    std::vector<bool> is_split(size_.size());
    for (std::size_t name = 0; name < size_.size(); ++name)
      is_split[name] = selected[name] > 0 && selected[name] < size_[name];
    Selection selection{estimated(chosen, is_split), {}};
    std::vector<const WordEnergy*> whole, parts;
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (selected[spelling_of_[i]] == size_[spelling_of_[i]]) whole.push_back(&all_[i]);
    for (const WordEnergy& part : selection.parts) parts.push_back(&part);
    std::merge(whole.begin(), whole.end(), parts.begin(), parts.end(), std::back_inserter(selection.ranked),
               [&](const WordEnergy* a, const WordEnergy* b) {
                 if (a->energy.mean != b->energy.mean) return has_more_energy(*a, *b);
                 return spelling_.at(a->word) < spelling_.at(b->word);
               });
    return selection;
  }

 private:
  /// The chosen words whose spelling is wanted.
  std::vector<WordEnergy> estimated(const std::vector<bool>& chosen, const std::vector<bool>& wanted) const {
    std::vector<std::size_t> group_of_name(wanted.size(), kNoGroup), group_of_word(chosen.size(), kNoGroup);
    std::vector<std::size_t> name_of_group;
    for (std::size_t word = 0; word < chosen.size(); ++word) {
      const std::size_t name = spellings_.of_word[word];
      if (!chosen[word] || !wanted[name] || !energies_.part().has(word)) continue;
      if (group_of_name[name] == kNoGroup) {
        group_of_name[name] = name_of_group.size();
        name_of_group.push_back(name);
      }
      group_of_word[word] = group_of_name[name];
    }
    std::vector<WordEnergy> words;
    for (const GroupEnergy& sum : energies_.of_groups(group_of_word, name_of_group.size())) {
      const std::size_t name = name_of_group[words.size()];
      words.push_back({.word = spellings_.names[name],
                       .energy = sum.energy,
                       .share = sum.share,
                       .count = sum.count,
                       .length = spellings_.lengths[name]});
      if (sum.relative_variance) words.back().samples_needed = *sum.relative_variance / (error_ * error_);
    }
    std::stable_sort(words.begin(), words.end(), has_more_energy);
    return words;
  }

  const Energies& energies_;
  Spellings spellings_;
  double error_;
  std::vector<std::size_t> size_;  ///< by spelling: how many words of the part have it
  std::vector<WordEnergy> all_;
  std::vector<std::size_t> spelling_of_;  ///< by place in all_
  std::unordered_map<std::string, std::size_t> spelling_;
};

/// The first `count` that carry any energy.
std::vector<WordEnergy> top(const Selection& selection, std::size_t count) {
  std::vector<WordEnergy> words;
  for (const WordEnergy* word : selection.ranked) {
    if (words.size() == count || word->energy.mean <= 0) break;
    words.push_back(*word);
  }
  return words;
}

double practical_share(const Selection& selection, double budget) {
  double share = 0;
  for (const WordEnergy* word : selection.ranked)
    if (is_practical(*word, budget)) share += word->share.mean;
  return share;
}

/// Calls f(index of the pixel, x, y) for the pixels that the part has.
template <class F>
void for_each_pixel(const record::Record& record, const Part& part, F f) {
  const record::Window& all = record.info.window;
  const record::Window asked = part.pixels.value_or(all);
  for (int y = asked.y0; y < asked.y1; ++y)
    for (int x = asked.x0; x < asked.x1; ++x)
      f(static_cast<std::size_t>(y - all.y0) * static_cast<std::size_t>(all.width()) +
            static_cast<std::size_t>(x - all.x0),
        x, y);
}

double mean_luminance(const record::Record& record, const Part& part, const std::vector<Rgb>& pixels) {
  if (pixels.empty()) return 0;
  double sum = 0;
  std::size_t count = 0;
  for_each_pixel(record, part, [&](std::size_t pixel, int, int) {
    sum += static_cast<double>(luminance(pixels[pixel]));
    ++count;
  });
  return sum / static_cast<double>(count);
}

/// Which grammars capture a word: words of one outcome share it. Few outcomes occur, so their table stays in the cache
/// while the entries go by.
struct Outcomes {
  std::vector<std::size_t> of_word;
  std::vector<double> captured;  ///< by outcome, then grammar: 1 or 0
};

Outcomes outcomes_of(std::size_t words, const std::vector<GrammarCoverage>& grammars) {
  Outcomes outcomes;
  std::unordered_map<std::vector<bool>, std::size_t> known;
  std::vector<bool> outcome(grammars.size());
  for (std::size_t word = 0; word < words; ++word) {
    for (std::size_t g = 0; g < grammars.size(); ++g) outcome[g] = grammars[g].captured[word];
    const auto [place, is_new] = known.try_emplace(outcome, known.size());
    if (is_new) outcomes.captured.insert(outcomes.captured.end(), outcome.begin(), outcome.end());
    outcomes.of_word.push_back(place->second);
  }
  return outcomes;
}

/// One pass over the entries for all grammars.
void find_worst_pixels(const record::Record& record, Coverage& coverage) {
  const std::size_t grammars = coverage.grammars.size();
  if (grammars == 0) return;
  const Outcomes outcomes = outcomes_of(record.words.size(), coverage.grammars);
  std::vector<double> captured(grammars), brightness(grammars);
  for_each_pixel(record, coverage.part, [&](std::size_t pixel, int x, int y) {
    double total = 0;
    std::fill(captured.begin(), captured.end(), 0.0);
    for (std::size_t e = record.offsets[pixel]; e < record.offsets[pixel + 1]; ++e) {
      const record::Entry& entry = record.entries[e];
      if (!coverage.part.has(entry.word)) continue;
      const auto light = static_cast<double>(luminance(entry.energy));
      total += light;
      const double* of_word = &outcomes.captured[outcomes.of_word[entry.word] * grammars];
      for (std::size_t g = 0; g < grammars; ++g) captured[g] += of_word[g] * light;
    }
    if (!(total > 0)) return;
    for (std::size_t g = 0; g < grammars; ++g) {
      const double share = captured[g] / total;
      std::optional<WorstPixel>& worst = coverage.grammars[g].worst_pixel;
      if (worst && (share > worst->share || (share == worst->share && total <= brightness[g]))) continue;
      worst = {x, y, share};
      brightness[g] = total;
    }
  });
}

}  // namespace

std::vector<WordEnergy> words_by_energy(const record::Record& record, const std::vector<bool>& chosen,
                                        Spelling spelling, double confidence, Part part) {
  const Energies energies(record, confidence, std::move(part));
  const Ranking ranking(record, energies, spelling, CoverageOptions{}.error);
  std::vector<WordEnergy> words;
  for (const WordEnergy* word : ranking.select(chosen).ranked) words.push_back(*word);
  std::erase_if(words, [](const WordEnergy& word) { return word.count == 0; });
  return words;
}

bool is_practical(const WordEnergy& word, double budget) {
  return word.samples_needed && *word.samples_needed <= budget;
}

Coverage coverage(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                  const CoverageOptions& options) {
  const Energies energies(record, options.confidence, options.part);
  const Ranking ranking(record, energies, options.spelling, options.error);
  const std::vector<bool> all(record.words.size(), true);

  Coverage result;
  result.info = record.info;
  result.tally = record.tally;
  result.glossy_rule = options.glossy_rule;
  result.confidence = options.confidence;
  result.error = options.error;
  result.budget = options.budget;
  result.part = options.part;
  result.total = energies.of_words(all).energy;
  result.ambient = mean_luminance(record, options.part, record.ambient);
  result.phantom = mean_luminance(record, options.part, record.phantom);
  result.words = ranking.all();
  for (const taxonomy::Grammar& grammar : grammars) {
    if (!taxonomy::has_language(grammar)) {
      result.left_out.push_back({grammar.name, grammar.title, taxonomy::why_no_language(grammar)});
      continue;
    }
    const std::vector<bool> undecided = record::undecided(record, grammar.language, options.glossy_rule);
    std::vector<bool> captured = members(record, grammar.language, options.glossy_rule);
    std::transform(captured.begin(), captured.end(), undecided.begin(), captured.begin(), std::greater<>());
    std::vector<bool> missed = captured;
    missed.flip();
    const GroupEnergy sum = energies.between(captured, undecided);
    const Selection captured_words = ranking.select(captured);
    result.grammars.push_back({.name = grammar.name,
                               .title = grammar.title,
                               .expression = grammar.expression,
                               .expression_delta = grammar.expression_delta,
                               .source = grammar.source,
                               .biases = grammar.biases,
                               .variances = grammar.variances,
                               .preconditions = grammar.preconditions,
                               .captured = captured,
                               .is_exact = std::find(undecided.begin(), undecided.end(), true) == undecided.end(),
                               .captured_energy = sum.energy,
                               .share = sum.share,
                               .practical_share = practical_share(captured_words, options.budget),
                               .top_captured = top(captured_words, options.top),
                               .top_missed = top(ranking.select(missed), options.top)});
  }
  find_worst_pixels(record, result);
  return result;
}

std::string practical_rule(const Coverage& coverage) {
  return fmt::format(
      "Practical: words of which a pixel comes within {} in at most {} samples of the algorithm that made this record "
      "({}), on average over the pixels.",
      level(coverage.error), grouped(static_cast<std::uint64_t>(coverage.budget)), coverage.info.algorithm);
}

bool has_two_expressions(const GrammarCoverage& grammar) {
  return !grammar.expression_delta.empty() && grammar.expression_delta != grammar.expression;
}

bool is_biased(const GrammarCoverage& grammar) {
  return !grammar.biases.empty();
}

double missed_share(const Coverage& coverage, const GrammarCoverage& grammar) {
  return coverage.total.mean > 0 ? 1 - grammar.share.mean : 0;
}

}  // namespace heckbert::report
