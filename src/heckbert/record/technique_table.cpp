#include <heckbert/record/technique_table.h>

#include <algorithm>
#include <iterator>

namespace heckbert::record {

namespace {

bool is_before(const TechniqueSum& a, const TechniqueSum& b) {
  return a.word != b.word ? a.word < b.word : a.technique < b.technique;
}

}  // namespace

TechniqueRecorder::TechniqueRecorder(const RenderInfo& info)
    : window_(info.window), samples_of_the_whole_(samples_of(info).front().of) {}

void TechniqueRecorder::begin_sample(int /*x*/, int /*y*/, int sample) {
  batch_ = static_cast<std::size_t>(batch_of(sample, samples_of_the_whole_));
}

void TechniqueRecorder::add(const Contribution& contribution) {
  if (!is_recordable(contribution.value) || is_black(contribution.value)) return;
  Found& found = found_[{contribution.word, contribution.technique}];
  ++found.count;
  found.by_batch[batch_] += RgbSum(clamped(contribution.value));
}

void TechniqueRecorder::splat(int x, int y, const Contribution& contribution) {
  if (x >= window_.x0 && x < window_.x1 && y >= window_.y0 && y < window_.y1) add(contribution);
}

TechniqueTable TechniqueRecorder::table() {
  TechniqueTable table;
  table.reserve(found_.size());
  for (const auto& [key, found] : found_)
    table.push_back({words().word(key.first), key.second, found.count, found.by_batch});
  std::sort(table.begin(), table.end(), is_before);
  return table;
}

TechniqueTable added(const TechniqueTable& a, const TechniqueTable& b) {
  TechniqueTable sum;
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum), is_before);
  std::size_t last = 0;
  for (std::size_t i = 1; i < sum.size(); ++i) {
    if (sum[i].word != sum[last].word || sum[i].technique != sum[last].technique) {
      sum[++last] = sum[i];
      continue;
    }
    sum[last].count += sum[i].count;
    for (std::size_t batch = 0; batch < kBatches; ++batch) sum[last].by_batch[batch] += sum[i].by_batch[batch];
  }
  if (!sum.empty()) sum.resize(last + 1);
  return sum;
}

Estimate energy_of(const TechniqueSum& sum, const RenderInfo& info, double confidence) {
  const auto sizes = batch_sizes(info);
  const auto pixels = static_cast<double>(info.window.pixel_count());
  BatchSeries values{};
  for (std::size_t batch = 0; batch < kBatches; ++batch)
    if (sizes[batch] > 0)
      values[batch] = static_cast<double>(luminance(mean_of(sum.by_batch[batch], sizes[batch] * pixels)));
  return BatchStatistics(info, confidence).energy(values);
}

}  // namespace heckbert::record
