#include <heckbert/report/coverage.h>

#include <algorithm>
#include <future>
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

/// The energy of a spelling's words, or of some of them.
struct Estimated {
  WordEnergy word;
  std::size_t name;  ///< of its spelling
};

bool has_more_energy(const Estimated& a, const Estimated& b) {
  return a.word.energy.mean > b.word.energy.mean;
}

/// Some words by energy, most first.
struct Selection {
  std::vector<Estimated> parts;           ///< of spellings that are not selected as a whole
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
  }

  std::vector<WordEnergy> all() const {
    std::vector<WordEnergy> words;
    words.reserve(all_.size());
    for (const Estimated& item : all_) words.push_back(item.word);
    return words;
  }

  Selection select(const std::vector<bool>& chosen) const {
    std::vector<std::size_t> selected(size_.size());
    for (std::size_t word = 0; word < chosen.size(); ++word)
      if (chosen[word] && energies_.part().has(word)) ++selected[spellings_.of_word[word]];
    std::vector<bool> is_split(size_.size());
    for (std::size_t name = 0; name < size_.size(); ++name)
      is_split[name] = selected[name] > 0 && selected[name] < size_[name];
    Selection selection{estimated(chosen, is_split), {}};
    std::vector<const Estimated*> whole, parts, ranked;
    for (const Estimated& item : all_)
      if (selected[item.name] == size_[item.name]) whole.push_back(&item);
    for (const Estimated& item : selection.parts) parts.push_back(&item);
    std::merge(whole.begin(), whole.end(), parts.begin(), parts.end(), std::back_inserter(ranked),
               [](const Estimated* a, const Estimated* b) {
                 return has_more_energy(*a, *b) || (!has_more_energy(*b, *a) && a->name < b->name);
               });
    selection.ranked.reserve(ranked.size());
    for (const Estimated* item : ranked) selection.ranked.push_back(&item->word);
    return selection;
  }

 private:
  /// The chosen words whose spelling is wanted.
  std::vector<Estimated> estimated(const std::vector<bool>& chosen, const std::vector<bool>& wanted) const {
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
    std::vector<Estimated> words;
    words.reserve(name_of_group.size());
    for (const GroupEnergy& sum : energies_.of_groups(group_of_word, name_of_group.size())) {
      const std::size_t name = name_of_group[words.size()];
      words.push_back({{.word = spellings_.names[name],
                        .energy = sum.energy,
                        .share = sum.share,
                        .count = sum.count,
                        .length = spellings_.lengths[name]},
                       name});
      if (sum.relative_variance) words.back().word.samples_needed = *sum.relative_variance / (error_ * error_);
    }
    std::stable_sort(words.begin(), words.end(), has_more_energy);
    return words;
  }

  const Energies& energies_;
  Spellings spellings_;
  double error_;
  std::vector<std::size_t> size_;  ///< by spelling: how many words of the part have it
  std::vector<Estimated> all_;
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

/// Columns of the window that the part has: [first, last), counted from the window's left.
struct Columns {
  std::size_t first = 0, last = 0;
};
/// Of a row; none when the part has nothing of it.
Columns columns_of(const record::Window& window, const Part& part, int y) {
  const record::Window asked = part.pixels.value_or(window);
  if (y < asked.y0 || y >= asked.y1) return {};
  return {static_cast<std::size_t>(asked.x0 - window.x0), static_cast<std::size_t>(asked.x1 - window.x0)};
}

double mean_luminance(const record::Window& window, const Part& part, const std::vector<Rgb>& pixels) {
  if (pixels.empty()) return 0;
  double sum = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    const Columns columns = columns_of(window, part, y);
    const auto first = static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width());
    for (std::size_t x = columns.first; x < columns.last; ++x) sum += static_cast<double>(luminance(pixels[first + x]));
  }
  return sum / static_cast<double>(part.pixels.value_or(window).pixel_count());
}

/// Which grammars capture a word: words of one outcome share it. Few outcomes occur, so their table stays in the cache
/// while the entries go by.
struct Outcomes {
  std::vector<std::size_t> of_word;
  std::vector<double> captured;  ///< by outcome, then grammar: 1 or 0
};

Outcomes outcomes_of(std::size_t words, const std::vector<Members>& grammars) {
  Outcomes outcomes;
  std::unordered_map<std::vector<bool>, std::size_t> known;
  std::vector<bool> outcome(grammars.size());
  for (std::size_t word = 0; word < words; ++word) {
    for (std::size_t g = 0; g < grammars.size(); ++g) outcome[g] = grammars[g].certain[word];
    const auto [place, is_new] = known.try_emplace(outcome, known.size());
    if (is_new) outcomes.captured.insert(outcomes.captured.end(), outcome.begin(), outcome.end());
    outcomes.of_word.push_back(place->second);
  }
  return outcomes;
}

/// The worst pixel of a grammar so far, and all that it has.
struct Worst {
  std::optional<WorstPixel> pixel{};
  double brightness = 0;

  void compare(const Worst& other) {
    if (!other.pixel) return;
    if (pixel &&
        (other.pixel->share > pixel->share || (other.pixel->share == pixel->share && other.brightness <= brightness)))
      return;
    *this = other;
  }
};

/// By grammar. One pass over the entries for all of them.
std::vector<Worst> worst_pixels(const record::Record& record, const record::Rows& rows,
                                const std::vector<Members>& captured_by, const Part& part) {
  const std::size_t grammars = captured_by.size();
  if (grammars == 0) return {};
  const Outcomes outcomes = outcomes_of(record.words.size(), captured_by);
  const record::Window& window = record.info.window;
  std::vector<std::vector<Worst>> by_row(static_cast<std::size_t>(window.height()));
  rows([&](const record::PixelRow& row) {
    std::vector<double> captured(grammars);
    std::vector<Worst> worst(grammars);
    const Columns columns = columns_of(window, part, row.y);
    for (std::size_t x = columns.first; x < columns.last; ++x) {
      double total = 0;
      std::fill(captured.begin(), captured.end(), 0.0);
      for (const record::Entry& entry : row.pixel(x)) {
        if (!part.has(entry.word)) continue;
        const auto light = static_cast<double>(luminance(entry.energy));
        total += light;
        const double* of_word = &outcomes.captured[outcomes.of_word[entry.word] * grammars];
        for (std::size_t g = 0; g < grammars; ++g) captured[g] += of_word[g] * light;
      }
      if (!(total > 0)) continue;
      const int column = window.x0 + static_cast<int>(x);
      for (std::size_t g = 0; g < grammars; ++g) worst[g].compare({{{column, row.y, captured[g] / total}}, total});
    }
    by_row[static_cast<std::size_t>(row.y - window.y0)] = std::move(worst);
  });
  std::vector<Worst> worst(grammars);
  for (const std::vector<Worst>& of_row : by_row)
    for (std::size_t g = 0; g < grammars; ++g) worst[g].compare(of_row[g]);
  return worst;
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
  return coverage(record, record::rows_of(record), grammars, options);
}

Coverage coverage(const record::Record& record, const record::Rows& rows,
                  const std::vector<taxonomy::Grammar>& grammars, const CoverageOptions& options) {
  Coverage result;
  std::vector<const taxonomy::Grammar*> covered;
  std::vector<Members> captured;
  for (const taxonomy::Grammar& grammar : grammars) {
    if (!taxonomy::has_language(grammar)) {
      result.left_out.push_back({grammar.name, grammar.title, taxonomy::why_no_language(grammar)});
      continue;
    }
    covered.push_back(&grammar);
    captured.push_back(members_of(record, grammar.language, options.glossy_rule));
  }
  // Reading the pixels is most of the work, and nothing else needs them.
  std::future<std::vector<Worst>> worst =
      std::async(std::launch::async, [&] { return worst_pixels(record, rows, captured, options.part); });

  const Energies energies(record, options.confidence, options.part);
  const Ranking ranking(record, energies, options.spelling, options.error);
  result.info = record.info;
  result.tally = record.tally;
  result.glossy_rule = options.glossy_rule;
  result.confidence = options.confidence;
  result.error = options.error;
  result.budget = options.budget;
  result.part = options.part;
  result.total = energies.of_words(std::vector<bool>(record.words.size(), true)).energy;
  result.ambient = mean_luminance(record.info.window, options.part, record.ambient);
  result.phantom = mean_luminance(record.info.window, options.part, record.phantom);
  result.words = ranking.all();
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const taxonomy::Grammar& grammar = *covered[i];
    std::vector<bool> missed = captured[i].certain;
    missed.flip();
    const GroupEnergy sum = energies.of_members(captured[i]);
    const Selection captured_words = ranking.select(captured[i].certain);
    result.grammars.push_back({.name = grammar.name,
                               .title = grammar.title,
                               .expression = grammar.expression,
                               .expression_delta = grammar.expression_delta,
                               .source = grammar.source,
                               .biases = grammar.biases,
                               .variances = grammar.variances,
                               .preconditions = grammar.preconditions,
                               .captured = captured[i].certain,
                               .is_exact = captured[i].is_exact(),
                               .captured_energy = sum.energy,
                               .share = sum.share,
                               .practical_share = practical_share(captured_words, options.budget),
                               .top_captured = top(captured_words, options.top),
                               .top_missed = top(ranking.select(missed), options.top)});
  }
  const std::vector<Worst> found = worst.get();
  for (std::size_t i = 0; i < found.size(); ++i) result.grammars[i].worst_pixel = found[i].pixel;
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
