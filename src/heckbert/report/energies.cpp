#include <heckbert/report/energies.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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

/// Squares of the second differences a - 2 b + c along the rows of a picture, most of whose pixels are zero. Where the
/// light changes slowly they are noise alone: each has six times the variance of a pixel.
class Differences {
 public:
  bool is_new_in_row() const { return next_ < 0; }
  /// Pixels from left to right; those that are left out are zero.
  void add(int x, double value) {
    if (next_ < 0) next_ = x;
    pass_zeros(x);
    step(value);
  }
  void end_row(int width) {
    pass_zeros(width);
    next_ = -1;
    last_ = before_ = 0;
  }
  /// The sum of the variances of all pixels; 0 in a picture too narrow to tell.
  double variance(int width) const { return width < 3 ? 0.0 : squares_ / 6 * width / (width - 2); }

 private:
  void pass_zeros(int end) {
    while (next_ < end && (last_ != 0 || before_ != 0)) step(0);
    next_ = end;
  }
  void step(double value) {
    const double difference = before_ - 2 * last_ + value;
    if (next_ >= 2) squares_ += difference * difference;
    before_ = last_;
    last_ = value;
    ++next_;
  }

  int next_ = -1;  ///< the pixel that comes next; -1: none of this row was added
  double last_ = 0, before_ = 0;
  double squares_ = 0;
};

}  // namespace

bool Members::is_exact() const {
  return std::find(undecided.begin(), undecided.end(), true) == undecided.end();
}

Members members_of(const record::Record& record, const taxonomy::Language& language, taxonomy::GlossyRule rule) {
  Members members{record::members(record, language, rule), record::undecided(record, language, rule)};
  std::transform(members.certain.begin(), members.certain.end(), members.undecided.begin(), members.certain.begin(),
                 std::greater<>());
  return members;
}

Energies::Energies(const record::Record& record, double confidence, Part part)
    : record_(record),
      statistics_(record.info, confidence),
      contribution_if_none_(record::contribution_if_none(record)),
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
  std::vector<Differences> differences(words_.size());
  std::vector<std::uint32_t> in_row;
  std::size_t pixel = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x, ++pixel) {
      const bool is_asked = is_inside(asked, x, y);
      for (std::size_t e = record_.offsets[pixel]; e < record_.offsets[pixel + 1]; ++e) {
        const record::Entry& entry = record_.entries[e];
        OfWord& word = words_[entry.word];
        const auto light = static_cast<double>(luminance(entry.energy));
        const double scatter = light * light / entry.count;
        word.scatter_all += scatter;
        if (differences[entry.word].is_new_in_row()) in_row.push_back(entry.word);
        differences[entry.word].add(x - window.x0, light);
        if (!is_asked) continue;
        word.count += entry.count;
        word.luminance += light;
        word.scatter += scatter;
      }
    }
    for (const std::uint32_t word : in_row) differences[word].end_row(window.width());
    in_row.clear();
  }
  for (std::size_t word = 0; word < words_.size(); ++word)
    words_[word].apart_all = std::min(differences[word].variance(window.width()), words_[word].scatter_all);
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
  apart_all += other.apart_all;
  return *this;
}

GroupEnergy Energies::estimate(const Sums& sums) const {
  GroupEnergy result;
  if (part_.pixels) {
    result = estimate_region(sums);
  } else {
    result.energy = statistics_.energy(sums.batches, contribution_if_none_);
    result.share = statistics_.share(sums.batches, total_.batches, 1, contribution_if_none_);
    result.count = sums.entries.count;
  }
  if (result.energy.known && result.energy.mean > 0) {
    // The variance of one sample is that of a mean of samples times their number, which adaptive sampling makes
    // different from pixel to pixel.
    const double samples = static_cast<double>(record_.tally.samples) * static_cast<double>(pixel_count()) /
                           static_cast<double>(record_.info.window.pixel_count());
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
  // By how much less errors cancel in the region: 1 in the whole picture, most in a single pixel.
  const double exponent = all_pixels > 1 ? 1 - std::log(pixels) / std::log(all_pixels) : 0;
  const auto of_region = [&](double picture, double scatter, double scatter_all, double apart_all) {
    if (!(scatter > 0)) return 0.0;
    const double variance = std::pow(all_pixels * picture, 2);
    const double cancelled = variance > 0 ? std::max(apart_all / variance, 1.0) : 1.0;
    return std::sqrt(variance * scatter / scatter_all * std::pow(cancelled, exponent));
  };
  const bool is_known = statistics_.batches() > 1 && sums.entries.count > 0;
  const auto interval = [&](double mean, double error, double most) {
    if (!is_known) return record::Estimate{mean, 0, mean, mean, false};
    return record::Estimate{mean, error, std::max(mean - t * error, 0.0), std::min(mean + t * error, most), true};
  };
  const OfWord &group = sums.entries, &all = total_.entries;
  const double group_picture = of_picture(sums.batches);
  const double rest_picture = of_picture(difference(total_.batches, sums.batches));
  const double of_group = of_region(group_picture, group.scatter, group.scatter_all, group.apart_all);
  const double of_rest = of_region(rest_picture, all.scatter - group.scatter, all.scatter_all - group.scatter_all,
                                   all.apart_all - group.apart_all);
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

GroupEnergy Energies::of_members(const Members& members) const {
  GroupEnergy least = of_words(members.certain);
  if (members.is_exact()) return least;
  std::vector<bool> possible(members.certain.size());
  std::transform(members.certain.begin(), members.certain.end(), members.undecided.begin(), possible.begin(),
                 std::logical_or<>());
  const GroupEnergy most = of_words(possible);
  least.energy.upper = most.energy.upper;
  least.share.upper = most.share.upper;
  least.relative_variance.reset();
  return least;
}

std::vector<GroupEnergy> Energies::of_outcomes(const record::Outcomes& outcomes, std::size_t languages) const {
  std::vector<Sums> of_outcome(outcomes.members.size());
  for (std::size_t word = 0; word < words_.size(); ++word) add_word(of_outcome[outcomes.of_word[word]], word);
  std::vector<GroupEnergy> energies;
  for (std::size_t language = 0; language < languages; ++language) {
    Sums sums;
    for (std::size_t outcome = 0; outcome < of_outcome.size(); ++outcome)
      if (outcomes.members[outcome][language]) add(sums, of_outcome[outcome]);
    energies.push_back(estimate(sums));
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
