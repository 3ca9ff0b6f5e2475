#include <heckbert/report/diagnosis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace heckbert::report {
namespace {

using Groups = std::map<GroupKey, ComparedWords>;

/// Of the words that somebody knows.
Groups known_groups(const Suspect& suspect, const std::vector<Witness>& witnesses) {
  Groups groups = groups_of(*suspect.evidence, {suspect.claimed, witnesses});
  std::erase_if(groups, [](const auto& group) { return group.second.expected.count == 0; });
  return groups;
}

/// What the suspect's techniques brought of all words that print alike.
std::vector<StrategyUse> uses_of(const Suspect& suspect, const taxonomy::Word& word,
                                 const std::vector<MeasuredTechnique>& measured) {
  std::vector<StrategyUse> uses;
  for (const taxonomy::Strategy& strategy : taxonomy::strategies(word)) {
    StrategyUse use{strategy, suspect.has(word, strategy)};
    for (const MeasuredTechnique& technique : measured) {
      if (technique.merged || technique.light_vertices != strategy.light_vertices ||
          technique.word.light != word.light || plain(technique.word) != plain(word))
        continue;
      if (!use.measured) use.measured = {.word = word, .light_vertices = strategy.light_vertices};
      use.measured->count += technique.count;
      use.measured->mean += technique.mean;
      use.measured->standard_error = std::hypot(use.measured->standard_error, technique.standard_error);
    }
    uses.push_back(std::move(use));
  }
  return uses;
}

void rank(std::vector<Candidate>& candidates, const Groups& groups, double total,
          const taxonomy::Language& words_of_scene) {
  for (Candidate& candidate : candidates) {
    candidate.claimed = candidate.claimed & words_of_scene;
    double captured = 0;
    for (const auto& [key, group] : groups)
      if (candidate.claimed.contains(group.word))
        for (const double value : group.expected.values) captured += value / record::kBatches;
    candidate.share = total > 0 ? captured / total : 0;
  }
  for (Candidate& candidate : candidates)
    candidate.is_minimal =
        candidate.share >= kSufficient && std::none_of(candidates.begin(), candidates.end(), [&](const auto& other) {
          return other.share >= kSufficient && other.claimed != candidate.claimed &&
                 (other.claimed - candidate.claimed).is_empty();
        });
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    return a.seconds.value_or(kNever) < b.seconds.value_or(kNever);
  });
}

}  // namespace

Diagnosis diagnose(const Suspect& suspect, const std::vector<Witness>& witnesses, std::vector<Candidate> candidates,
                   const std::vector<MeasuredTechnique>& measured, const taxonomy::Language& words_of_scene,
                   const VerdictOptions& options) {
  const Groups groups = known_groups(suspect, witnesses);
  Diagnosis diagnosis{.algorithm = suspect.algorithm,
                      .title = suspect.title,
                      .options = options,
                      .causes = {},
                      .candidates = {},
                      .has_measured = !measured.empty()};
  const auto energy = [&](const ComparedWords& group) {
    return witnesses[group.witness].evidence->statistics(options.confidence).energy(group.expected.values);
  };
  for (const auto& [key, group] : groups) diagnosis.total += energy(group).mean;
  rank(candidates, groups, diagnosis.total, words_of_scene);

  for (const auto& [key, group] : groups) {
    Cause cause{.word = group.name,
                .length = group.word.length(),
                .light = group.word.light,
                .is_claimed = group.is_claimed,
                .energy = energy(group),
                .witness = witnesses[group.witness].algorithm,
                .brightest = group.brightest_expected,
                .found_count = group.found.count,
                .strategies = {},
                .finders = {}};
    cause.share = cause.energy.mean / diagnosis.total;
    if (group.found.count > 0) {
      const Evidence& own = *suspect.evidence;
      const double samples = static_cast<double>(own.window().pixel_count()) * own.samples_per_pixel();
      const double count = effective_count(own.statistics(options.confidence).energy(group.found.values));
      cause.samples_needed = std::max(samples / (count * options.error * options.error), 1.0);
    }
    if (cause.is_claimed && cause.samples_needed && *cause.samples_needed <= options.budget) continue;
    (cause.is_claimed ? diagnosis.rare : diagnosis.unreachable) += cause.share;
    cause.strategies = uses_of(suspect, group.word, measured);
    for (const Candidate& candidate : candidates)
      if (candidate.algorithm != suspect.algorithm && candidate.claimed.contains(group.word))
        cause.finders.push_back(candidate.algorithm);
    diagnosis.causes.push_back(std::move(cause));
  }
  std::stable_sort(diagnosis.causes.begin(), diagnosis.causes.end(), [](const Cause& a, const Cause& b) {
    if (a.is_claimed != b.is_claimed) return b.is_claimed;
    return a.energy.mean > b.energy.mean;
  });
  diagnosis.candidates = std::move(candidates);
  return diagnosis;
}

std::optional<double> samples_for_picture(const NoisyImage& image, double samples_per_pixel, double error) {
  double squares = 0, light = 0;
  for (std::size_t p = 0; p < image.standard_error.size(); ++p) {
    squares += image.standard_error[p] * image.standard_error[p];
    light += static_cast<double>(luminance(image.mean.pixels[p]));
  }
  if (!(light > 0)) return std::nullopt;
  const auto pixels = static_cast<double>(image.standard_error.size());
  const double relative = std::sqrt(squares / pixels) / (light / pixels);
  return samples_per_pixel * (relative / error) * (relative / error);
}

}  // namespace heckbert::report
