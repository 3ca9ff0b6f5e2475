#include <heckbert/report/energies.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace heckbert::report {
namespace {

record::BatchSeries difference(const record::BatchSeries& a, const record::BatchSeries& b) {
  record::BatchSeries result;
  for (std::size_t batch = 0; batch < result.size(); ++batch) result[batch] = a[batch] - b[batch];
  return result;
}

bool is_inside(const record::Window& window, int x, int y) {
  return x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1;
}

}  // namespace

Energies::Energies(const record::Record& record, double confidence, Part part)
    : record_(record),
      statistics_(record.info, confidence),
      mean_contribution_(record::mean_contribution(record)),
      part_(std::move(part)),
      words_(record.words.size()) {
  if (part_.pixels)
    look_at_pixels(*part_.pixels);
  else
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word].count = record.counts[word];
  for (std::size_t word = 0; word < record.words.size(); ++word) add_word(total_, word);
}

void Energies::look_at_pixels(const record::Window& asked) {
  const record::Window& window = record_.info.window;
  std::size_t pixel = 0;
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x, ++pixel) {
      const bool is_asked = is_inside(asked, x, y);
      for (std::size_t e = record_.offsets[pixel]; e < record_.offsets[pixel + 1]; ++e) {
        const record::Entry& entry = record_.entries[e];
        OfWord& word = words_[entry.word];
        const auto light = static_cast<double>(luminance(entry.energy));
        const double scatter = light * light / entry.count;
        word.scatter_all += scatter;
        if (!is_asked) continue;
        word.count += entry.count;
        word.luminance += light;
        word.scatter += scatter;
      }
    }
}

void Energies::add_word(Sums& sums, std::size_t word, double weight) const {
  if (!part_.has(word)) return;
  for (std::size_t batch = 0; batch < record::kBatches; ++batch)
    sums.batches[batch] +=
        weight * static_cast<double>(luminance(record_.batch_means[word * record::kBatches + batch]));
  sums.entries += words_[word];
}

void Energies::add(Sums& sums, const Sums& more) {
  for (std::size_t batch = 0; batch < record::kBatches; ++batch) sums.batches[batch] += more.batches[batch];
  sums.entries += more.entries;
}

Energies::OfWord& Energies::OfWord::operator+=(const OfWord& other) {
  count += other.count;
  luminance += other.luminance;
  scatter += other.scatter;
  scatter_all += other.scatter_all;
  return *this;
}

GroupEnergy Energies::estimate(const Sums& sums) const {
  GroupEnergy result;
  if (part_.pixels) {
    result = estimate_region(sums);
  } else {
    result.energy = statistics_.energy(sums.batches, mean_contribution_);
    result.share = statistics_.share(sums.batches, total_.batches, 1, mean_contribution_);
    result.count = sums.entries.count;
  }
  if (result.energy.known && result.energy.mean > 0) {
    // The variance of one sample is that of a mean of samples times their number.
    const double samples = static_cast<double>(pixel_count()) * record_.info.samples_per_pixel;
    result.relative_variance = std::pow(result.energy.standard_error / result.energy.mean, 2) * samples;
  }
  return result;
}

GroupEnergy Energies::estimate_region(const Sums& sums) const {
  const auto all_pixels = static_cast<double>(record_.info.window.pixel_count());
  const auto pixels = static_cast<double>(pixel_count());
  const double t = statistics_.quantile();
  // Standard errors: of the picture's mean, and of the sum over the region's pixels.
  const auto of_picture = [&](const record::BatchSeries& batches) {
    return statistics_.energy(batches).standard_error;
  };
  const auto of_region = [&](double picture, double scatter, double scatter_all) {
    return scatter > 0 ? all_pixels * picture * std::sqrt(scatter / scatter_all) : 0.0;
  };
  const bool is_known = statistics_.batches() > 1 && sums.entries.count > 0;
  const auto interval = [&](double mean, double error, double most) {
    if (!is_known) return record::Estimate{mean, 0, mean, mean, false};
    return record::Estimate{mean, error, std::max(mean - t * error, 0.0), std::min(mean + t * error, most), true};
  };
  const OfWord &group = sums.entries, &all = total_.entries;
  const double group_picture = of_picture(sums.batches);
  const double rest_picture = of_picture(difference(total_.batches, sums.batches));
  const double of_group = of_region(group_picture, group.scatter, group.scatter_all);
  const double of_rest = of_region(rest_picture, all.scatter - group.scatter, all.scatter_all - group.scatter_all);
  GroupEnergy result;
  result.energy = interval(group.luminance / pixels, of_group / pixels, std::numeric_limits<double>::infinity());
  if (all.luminance > 0) {
    // The correlation of the group with the rest is the picture's, from the variance of their sum.
    const double product = group_picture * rest_picture;
    const double covariance =
        0.5 * (std::pow(of_picture(total_.batches), 2) - std::pow(group_picture, 2) - std::pow(rest_picture, 2));
    const double correlation = product > 0 ? std::clamp(covariance / product, -1.0, 1.0) : 0.0;
    const double share = group.luminance / all.luminance;
    const double a = (1 - share) * of_group, b = share * of_rest;
    result.share =
        interval(share, std::sqrt(std::max(a * a + b * b - 2 * correlation * a * b, 0.0)) / all.luminance, 1);
  }
  result.count = group.count;
  return result;
}

std::vector<GroupEnergy> Energies::of_groups(const std::vector<std::size_t>& group_of, std::size_t groups) const {
  std::vector<Sums> sums(groups);
  for (std::size_t word = 0; word < group_of.size(); ++word)
    if (group_of[word] != kNoGroup) add_word(sums[group_of[word]], word);
  std::vector<GroupEnergy> energies;
  energies.reserve(groups);
  for (const Sums& group : sums) energies.push_back(estimate(group));
  return energies;
}

GroupEnergy Energies::of_words(const std::vector<bool>& chosen) const {
  Sums sums;
  for (std::size_t word = 0; word < chosen.size(); ++word)
    if (chosen[word]) add_word(sums, word);
  return estimate(sums);
}

std::vector<GroupEnergy> Energies::of_sets(const std::vector<std::vector<bool>>& sets) const {
  std::unordered_map<std::vector<bool>, Sums> outcomes;  // by the sets that have a word
  std::vector<bool> outcome(sets.size());
  for (std::size_t word = 0; word < words_.size(); ++word) {
    for (std::size_t set = 0; set < sets.size(); ++set) outcome[set] = sets[set][word];
    add_word(outcomes[outcome], word);
  }
  std::vector<GroupEnergy> energies;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    Sums sum;
    for (const auto& [members, sums] : outcomes)
      if (members[set]) add(sum, sums);
    energies.push_back(estimate(sum));
  }
  return energies;
}

record::Estimate Energies::mean_over_energy(const std::vector<double>& value_of_word) const {
  Sums weighted;
  double entries = 0;
  for (std::size_t word = 0; word < value_of_word.size(); ++word) {
    add_word(weighted, word, value_of_word[word]);
    if (part_.has(word)) entries += value_of_word[word] * words_[word].luminance;
  }
  if (!part_.pixels)
    return statistics_.share(weighted.batches, total_.batches, std::numeric_limits<double>::infinity());
  const double mean = total_.entries.luminance > 0 ? entries / total_.entries.luminance : 0;
  return {mean, 0, mean, mean, false};
}

}  // namespace heckbert::report
