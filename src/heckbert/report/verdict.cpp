#include <heckbert/report/verdict.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

/// The share of the expected energy that decides how many samples an algorithm needs.
constexpr double kNearlyAll = 0.9;

/// With what the coarser stages of the trial found.
struct Group : ComparedWords {
  std::size_t length = 0;  ///< of the longest
  bool is_by_lens = false;
  std::vector<Series> coarser{};
  std::vector<std::map<std::size_t, Series>> coarser_blocks{};
};

/// Of the trial; none where it is not refined.
const std::vector<CoarserStage>& coarser_stages(const Trial& trial) {
  static const std::vector<CoarserStage> none;
  return trial.refinement ? trial.refinement->coarser : none;
}

/// For a comparison.
double enough(const Trial& trial) {
  return trial.shares_light ? kEnoughShared : kEnough;
}

/// Of what the trial claims or found.
std::vector<Group> groups_of(const Trial& trial, const std::vector<Witness>& witnesses, taxonomy::Symbol light,
                             Spelling spelling) {
  const std::vector<CoarserStage>& stages = coarser_stages(trial);
  const Grouping grouping{trial.claimed, witnesses, spelling};
  std::map<GroupKey, Group> groups;
  for (auto& [key, words] : report::groups_of(*trial.evidence, grouping)) {
    if (words.word.light != light || (!words.is_claimed && words.found.count == 0)) continue;
    Group& group = groups.emplace(key, Group{std::move(words)}).first->second;
    group.length = group.word.length();
    group.is_by_lens = trial.is_by_lens && trial.is_by_lens(group.word);
    group.coarser.resize(stages.size());
    group.coarser_blocks.resize(stages.size());
    if (!group.is_claimed) group.expected = {};
  }
  for (std::size_t i = 0; i < stages.size(); ++i)
    for (const auto& [word, evidence] : stages[i].evidence->words()) {
      if (word.light != light) continue;
      const auto group = groups.find(key_of(word, grouping));
      if (group == groups.end()) continue;
      group->second.coarser[i] += evidence.picture;
      add(group->second.coarser_blocks[i], evidence.blocks);
    }
  std::vector<Group> list;
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

/// Everything that is known of a case before the number of comparisons is.
struct Case {
  const Trial* trial = nullptr;
  taxonomy::Symbol light = taxonomy::Symbol::La;
  std::vector<WordFinding> words{};
  std::vector<const Evidence*> witnesses{};         ///< by word; null: nobody vouches for it
  std::vector<Series> expected{};                   ///< by word: what the witness has
  std::vector<std::vector<BlockFinding>> blocks{};  ///< by word: those that can be compared
  Series all_expected{}, all_found{};               ///< of the words that are compared
};

class Judge {
 public:
  Judge(const std::vector<Witness>& witnesses, const VerdictOptions& options)
      : witnesses_(witnesses), options_(options) {}

  /// Compares whatever can be compared.
  Case examine(const Trial& trial, taxonomy::Symbol light) {
    Case result{.trial = &trial, .light = light};
    std::map<std::size_t, Group> rest;  // by witness: of rare words
    std::map<std::size_t, std::size_t> rest_size;
    for (const Group& group : groups_of(trial, witnesses_, light, options_.spelling)) {
      WordFinding finding = look_at(trial, group);
      if (finding.standing == Standing::Rare || finding.standing == Standing::Untold) {
        if (group.is_claimed && group.witness != kNobody) {
          Group& sum = rest[group.witness];
          ++rest_size[group.witness];
          sum.witness = group.witness;
          sum.is_claimed = true;
          sum.length = std::max(sum.length, group.length);
          sum.expected += group.expected;
          sum.found += group.found;
          sum.coarser.resize(group.coarser.size());
          for (std::size_t i = 0; i < group.coarser.size(); ++i) sum.coarser[i] += group.coarser[i];
        }
      }
      std::vector<BlockFinding> blocks;
      if (finding.standing == Standing::Agrees) {
        result.all_expected += group.expected;
        result.all_found += group.found;
        blocks = blocks_of_group(trial, group);
      }
      finding.blocks_compared = blocks.size();
      const std::size_t compared =
          blocks.size() + (finding.standing == Standing::Agrees || finding.standing == Standing::Missing);
      comparisons_ += trial.refinement ? 2 * compared : compared;
      result.words.push_back(std::move(finding));
      result.witnesses.push_back(evidence_of_witness(group));
      result.expected.push_back(group.expected);
      result.blocks.push_back(std::move(blocks));
    }
    for (const auto& [witness, group] : rest) {
      WordFinding finding = look_at(trial, group);
      if (rest_size[witness] < 2 || finding.standing != Standing::Agrees) continue;
      finding.pooled = rest_size[witness];
      finding.word = fmt::format("{} rare words", finding.pooled);
      result.all_expected += group.expected;
      result.all_found += group.found;
      comparisons_ += trial.refinement ? 2 : 1;
      result.words.push_back(std::move(finding));
      result.witnesses.push_back(evidence_of_witness(group));
      result.expected.push_back(group.expected);
      result.blocks.emplace_back();
    }
    return result;
  }

  std::size_t comparisons() const { return comparisons_; }

  /// Call when all cases have been examined.
  AlgorithmVerdict rule(Case c) const {
    const double level = sidak(options_.significance, comparisons_);
    for (std::size_t i = 0; i < c.words.size(); ++i) {
      WordFinding& word = c.words[i];
      if (word.standing == Standing::Missing &&
          !is_surely_missing(*c.trial->evidence, known(*c.trial->evidence), *c.witnesses[i], c.expected[i], level))
        word.standing = Standing::Rare;
      if (word.standing != Standing::Agrees) continue;
      const auto stays = [&](const std::optional<Sequence>& sequence) {
        return !sequence || sequence->p_value < level;
      };
      const bool differs = word.comparison.p_value < level;
      bool stays_wrong = differs && stays(word.sequence);
      for (BlockFinding& block : c.blocks[i]) {
        if (block.comparison.p_value >= level) continue;
        ++word.blocks_that_differ;
        stays_wrong |= stays(block.sequence);
        if (!word.worst_block || block.comparison.p_value < word.worst_block->comparison.p_value)
          word.worst_block = block;
      }
      if (differs || word.blocks_that_differ > 0) word.standing = stays_wrong ? Standing::Differs : Standing::Converges;
    }
    AlgorithmVerdict verdict{
        .algorithm = c.trial->algorithm,
        .title = c.trial->title,
        .grammar = c.trial->grammar,
        .light = c.light,
        .samples_per_pixel = static_cast<int>(std::lround(c.trial->evidence->samples_per_pixel()))};
    if (c.trial->refinement) {
      verdict.refined_by = c.trial->refinement->option;
      verdict.sizes = sizes_of(*c.trial->refinement);
    }
    verdict.samples_needed = samples_for_nearly_all(c.words);
    if (const Comparison all =
            comparison_of(*c.trial->evidence, witnesses_.front().evidence, c.all_expected, c.all_found);
        all.expected.mean > 0)
      verdict.ratio = report::ratio(all, quantile(*c.trial));
    verdict.ruling = ruling_of(c.words, verdict.samples_needed);
    verdict.is_expected =
        facts(verdict.ruling).is_as_claimed || (verdict.ruling == Ruling::WrongValues && c.trial->may_be_wrong);
    verdict.shortest = shortest_of(c.words, verdict.ruling);
    std::stable_sort(c.words.begin(), c.words.end(), [](const WordFinding& a, const WordFinding& b) {
      const auto energy = [](const WordFinding& word) {
        return std::max(word.comparison.expected.mean, word.comparison.found.mean);
      };
      if (a.standing != b.standing) return a.standing < b.standing;
      return energy(a) > energy(b);
    });
    verdict.words = std::move(c.words);
    return verdict;
  }

 private:
  /// What every comparison asks of the evidence; finding it out takes a look at all words.
  struct Known {
    record::BatchStatistics statistics;
    double contribution_if_none = 0;
    /// What one event of the render brings to the mean of a word, on average over its energy: of so many that each is
    /// an event of its own, the size that gives the words their spread. Where all pixels share a virtual light, one
    /// such light is one event, and much more than one contribution.
    double event_size = 0;
  };
  const Known& known(const Evidence& evidence) const {
    const auto place = known_.find(&evidence);
    if (place != known_.end()) return place->second;
    Known known{evidence.statistics(options_.confidence), evidence.contribution_if_none()};
    double variance = 0, mean = 0;
    for (const auto& [word, of_word] : evidence.words()) {
      const record::Estimate energy = known.statistics.energy(of_word.picture.values);
      variance += energy.standard_error * energy.standard_error;
      mean += energy.mean;
    }
    if (mean > 0) known.event_size = variance / mean;
    return known_.emplace(&evidence, known).first->second;
  }
  const Evidence* evidence_of_witness(const Group& group) const {
    return group.witness == kNobody ? nullptr : witnesses_[group.witness].evidence;
  }

  double quantile(const Trial& trial) const { return known(*trial.evidence).statistics.quantile(); }

  Comparison comparison_of(const Evidence& trial, const Evidence* witness, const Series& expected,
                           const Series& found) const {
    const double size_found = found.count == 0 ? known(trial).contribution_if_none : 0;
    const record::Estimate of_found = known(trial).statistics.energy(found.values, size_found);
    if (witness == nullptr) return {{}, of_found};
    const double size_expected = expected.count == 0 ? known(*witness).contribution_if_none : 0;
    return compare(known(*witness).statistics.energy(expected.values, size_expected), witness->batches(), of_found,
                   trial.batches());
  }

  static std::vector<double> sizes_of(const Refinement& refinement) {
    std::vector<double> sizes;
    for (const CoarserStage& stage : refinement.coarser) sizes.push_back(stage.size);
    sizes.push_back(refinement.size);
    return sizes;
  }

  /// Of something that can be compared; `found` says what the coarser stages have of it. Nothing where the trial is
  /// not refined.
  std::optional<Sequence> sequence(const Trial& trial, const Evidence& witness, const Series& expected,
                                   const std::vector<const Series*>& found, const Comparison& last) const {
    if (!trial.refinement) return std::nullopt;
    std::vector<Comparison> comparisons;
    for (std::size_t i = 0; i < found.size(); ++i)
      comparisons.push_back(comparison_of(*trial.refinement->coarser[i].evidence, &witness, expected, *found[i]));
    comparisons.push_back(last);
    return sequence_of(comparisons, sizes_of(*trial.refinement), trial.refinement->order, trial.evidence->batches(),
                       quantile(trial));
  }

  /// Agrees stands for "can be compared" until the number of comparisons is known.
  WordFinding look_at(const Trial& trial, const Group& group) const {
    const Evidence* witness = evidence_of_witness(group);
    WordFinding finding{.word = group.name,
                        .length = group.length,
                        .comparison = comparison_of(*trial.evidence, witness, group.expected, group.found),
                        .expected_count = group.expected.count,
                        .found_count = group.found.count};
    if (witness != nullptr) finding.witness = witnesses_[group.witness].algorithm;
    const double enough_expected = effective_count(finding.comparison.expected);
    const double enough_found = effective_count(finding.comparison.found);
    if (group.found.count > 0) {
      finding.brightest = group.brightest_found;
      const Evidence& own = *trial.evidence;
      const double samples = static_cast<double>(own.window().pixel_count()) * own.samples_per_pixel();
      finding.samples_needed = std::max(samples / (enough_found * options_.error * options_.error), 1.0);
    } else if (group.expected.count > 0) {
      finding.brightest = group.brightest_expected;
    }
    if (group.expected.count > 0 && group.found.count > 0)
      finding.ratio = report::ratio(finding.comparison, quantile(trial));
    finding.standing = [&] {
      if (!group.is_claimed) return Standing::Unclaimed;
      if (witness == nullptr || enough_expected < kEnough) return Standing::Untold;
      if (group.found.count == 0) return group.is_by_lens ? Standing::Rare : Standing::Missing;
      return enough_found < enough(trial) ? Standing::Rare : Standing::Agrees;
    }();
    if (finding.standing == Standing::Agrees) {
      std::vector<const Series*> coarser;
      for (const Series& series : group.coarser) coarser.push_back(&series);
      finding.sequence = sequence(trial, *witness, group.expected, coarser, finding.comparison);
    }
    return finding;
  }

  std::vector<BlockFinding> blocks_of_group(const Trial& trial, const Group& group) const {
    const Evidence& witness = *witnesses_[group.witness].evidence;
    static const Series none;
    std::vector<BlockFinding> list;
    if (!witness.has_blocks() || !trial.evidence->has_blocks()) return list;
    const std::vector<record::Window> windows = blocks_of(witness.window());
    for (const auto& [block, expected] : group.expected_blocks) {
      const auto found = group.found_blocks.find(block);
      if (found == group.found_blocks.end()) continue;
      const Comparison comparison = comparison_of(*trial.evidence, &witness, expected, found->second);
      if (effective_count(comparison.expected) < kEnough || effective_count(comparison.found) < enough(trial)) continue;
      std::vector<const Series*> coarser;
      for (const auto& blocks : group.coarser_blocks) {
        const auto place = blocks.find(block);
        coarser.push_back(place == blocks.end() ? &none : &place->second);
      }
      list.push_back({windows[block], comparison, sequence(trial, witness, expected, coarser, comparison)});
    }
    return list;
  }

  /// Is there more of the word, as the witness has it, than chance could hide from the trial? One event that brings the
  /// word is supposed to be as much as one of the witness's paths would be among the trial's samples, or as what the
  /// trial's own events bring, whichever is more. Each side has half of the level.
  static bool is_surely_missing(const Evidence& trial, const Known& known, const Evidence& witness,
                                const Series& expected, double level) {
    const record::BatchStatistics of_witness = witness.statistics(1 - level / 2);
    const double path = of_witness.energy(expected.values).mean / static_cast<double>(expected.count) *
                        witness.samples_per_pixel() / trial.samples_per_pixel();
    const double size = std::max({path, known.contribution_if_none, known.event_size});
    return trial.statistics(1 - level / 2).energy({}, size).upper < of_witness.energy(expected.values).lower;
  }

  std::optional<double> samples_for_nearly_all(const std::vector<WordFinding>& words) const {
    struct Need {
      double samples, energy;
    };
    std::vector<Need> needs;
    double total = 0;
    for (const WordFinding& word : words) {
      if (word.pooled > 1 || word.standing == Standing::Unclaimed || word.witness.empty()) continue;
      const double energy = word.comparison.expected.mean;
      total += energy;
      needs.push_back({word.samples_needed.value_or(std::numeric_limits<double>::infinity()), energy});
    }
    std::sort(needs.begin(), needs.end(), [](const Need& a, const Need& b) { return a.samples < b.samples; });
    double sum = 0;
    for (const Need& need : needs)
      if ((sum += need.energy) >= kNearlyAll * total && std::isfinite(need.samples)) return need.samples;
    return std::nullopt;
  }

  Ruling ruling_of(const std::vector<WordFinding>& words, const std::optional<double>& samples_needed) const {
    const auto any = [&](Standing standing) {
      return std::any_of(words.begin(), words.end(), [&](const WordFinding& w) { return w.standing == standing; });
    };
    if (any(Standing::Unclaimed)) return Ruling::Oversteps;
    if (any(Standing::Missing)) return Ruling::Misses;
    if (any(Standing::Differs)) return Ruling::WrongValues;
    if (any(Standing::Converges)) return Ruling::Converges;
    if (words.empty()) return Ruling::Nothing;
    if (!any(Standing::Agrees) && !any(Standing::Rare)) return Ruling::Untold;
    return !samples_needed || *samples_needed > options_.budget ? Ruling::NeedsSamples : Ruling::Captures;
  }

  static std::string shortest_of(const std::vector<WordFinding>& words, Ruling ruling) {
    const auto made_it = [&](const WordFinding& word) {
      switch (ruling) {
        case Ruling::Oversteps:
          return word.standing == Standing::Unclaimed;
        case Ruling::Misses:
          return word.standing == Standing::Missing;
        case Ruling::WrongValues:
          return word.standing == Standing::Differs;
        case Ruling::Converges:
          return word.standing == Standing::Converges;
        default:
          return false;
      }
    };
    const WordFinding* shortest = nullptr;
    for (const WordFinding& word : words)
      if (made_it(word) &&
          (shortest == nullptr || std::tie(word.length, word.word) < std::tie(shortest->length, shortest->word)))
        shortest = &word;
    return shortest == nullptr ? "" : shortest->word;
  }

  const std::vector<Witness>& witnesses_;
  const VerdictOptions& options_;
  std::size_t comparisons_ = 0;
  mutable std::map<const Evidence*, Known> known_;
};

}  // namespace

Verification verify(const std::vector<Trial>& trials, const std::vector<Witness>& witnesses,
                    const std::vector<taxonomy::Symbol>& lights, const VerdictOptions& options) {
  Judge judge(witnesses, options);
  std::vector<Case> cases;
  for (const Trial& trial : trials)
    for (const taxonomy::Symbol light : lights) cases.push_back(judge.examine(trial, light));
  Verification verification{.options = options, .comparisons = judge.comparisons(), .verdicts = {}};
  for (Case& c : cases) verification.verdicts.push_back(judge.rule(std::move(c)));
  return verification;
}

}  // namespace heckbert::report
