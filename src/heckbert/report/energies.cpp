#include <heckbert/report/energies.h>

namespace heckbert::report {
namespace {

Rgb to_rgb(const std::array<double, 3>& sum) {
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

void add(std::array<double, 3>& sum, Rgb value) {
  sum[0] += value.r;
  sum[1] += value.g;
  sum[2] += value.b;
}

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

Energies::Energies(const record::Record& record, double confidence)
    : record_(record), confidence_(confidence), counts_(record.words.size()) {
  for (const record::Entry& entry : record.entries) counts_[entry.word] += entry.count;
  for (std::size_t word = 0; word < record.words.size(); ++word) add_word(total_, word);
}

void Energies::add_word(Sums& sums, std::size_t word) const {
  for (std::size_t batch = 0; batch < record::kBatches; ++batch)
    add(sums.batches[batch], record_.batch_means[word * record::kBatches + batch]);
  sums.count += counts_[word];
}

GroupEnergy Energies::estimate(const Sums& sums) const {
  // The statistics read the batches and the number of samples, nothing else. Which two words stand for the group and
  // the rest does not matter, only that they are two.
  record::Record two;
  two.info = record_.info;
  two.words = {taxonomy::Word{}, taxonomy::Word{.events = {taxonomy::Symbol::Dr}}};
  two.batch_means.reserve(sums.batches.size() * 2);
  for (const auto& batch : sums.batches) two.batch_means.push_back(to_rgb(batch));
  for (std::size_t i = 0; i < record::kBatches; ++i)
    two.batch_means.push_back(to_rgb(difference(total_.batches[i], sums.batches[i])));
  const std::vector<bool> group{true, false}, whole{true, true};
  return {record::energy(two, group, confidence_), record::share(two, group, whole, confidence_), sums.count};
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

}  // namespace heckbert::report
