#include <heckbert/record/path_rows.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include <heckbert/record/sums.h>

namespace heckbert::record {

PathRows::WordId PathRows::word(const taxonomy::Word& word) {
  return ids_.try_emplace(word, static_cast<WordId>(ids_.size())).first->second;
}

void PathRows::add(int x, int y, WordId word, Rgb sum, std::uint32_t count) {
  if (!is_recordable(sum)) {
    (is_finite(sum) ? tally_.rejected_negative : tally_.rejected_not_finite) += count;
    return;
  }
  const auto pixel = static_cast<std::size_t>(y - window_.y0) * static_cast<std::size_t>(window_.width()) +
                     static_cast<std::size_t>(x - window_.x0);
  const Rgb light = clamped(sum);
  const RgbSum quanta(light);
  if (light != sum) tally_.clamped += count;
  if (vanishes(light, quanta)) tally_.vanished += count;
  rows_.push_back({pixel, word, count, quanta});
  // A renderer that tells every path by itself needs no more memory than one that adds them up.
  constexpr std::size_t kFewRows = 1 << 16;
  if (rows_.size() > 2 * distinct_ + kFewRows) add_up_equals();
}

void PathRows::add_up_equals() {
  std::ranges::sort(rows_, {}, [](const Row& row) { return std::tuple(row.pixel, row.word); });
  std::size_t last = 0;
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    if (rows_[last].pixel != row.pixel || rows_[last].word != row.word) {
      rows_[++last] = row;
      continue;
    }
    rows_[last].count = added_counts(rows_[last].count, row.count);
    rows_[last].sum += row.sum;
  }
  rows_.resize(std::min(last + 1, rows_.size()));
  distinct_ = rows_.size();
}

Record PathRows::record(RenderInfo info) {
  add_up_equals();
  std::vector<char> is_used(ids_.size());
  for (const Row& row : rows_) is_used[row.word] = 1;

  Tile tile;
  tile.window = window_;
  tile.tally = tally_;
  tile.tally.samples = static_cast<std::uint64_t>(info.samples_per_pixel) * window_.pixel_count();
  std::vector<std::uint32_t> rank(ids_.size());
  for (const auto& [word, id] : ids_) {
    if (is_used[id] == 0) continue;
    rank[id] = static_cast<std::uint32_t>(tile.words.size());
    tile.words.push_back(word);
  }
  for (Row& row : rows_) row.word = rank[row.word];
  std::ranges::sort(rows_, {}, [](const Row& row) { return std::tuple(row.pixel, row.word); });

  // One batch: which samples they come from is not told.
  std::vector<BatchSum> batch(tile.words.size());
  tile.samples.assign(window_.pixel_count(), static_cast<std::uint32_t>(info.samples_per_pixel));
  tile.offsets.reserve(window_.pixel_count() + 1);
  tile.entries.reserve(rows_.size());
  for (const Row& row : rows_) {
    tile.offsets.resize(row.pixel + 1, tile.entries.size());
    tile.entries.push_back({row.word, row.count, row.sum});
    batch[row.word].word = row.word;
    batch[row.word].count += row.count;
    batch[row.word].sum += row.sum;
  }
  tile.offsets.resize(window_.pixel_count() + 1, tile.entries.size());
  tile.batch_sums = std::move(batch);

  info.has_batches = false;
  info.knows_cut_off = false;
  // Words are sorted by length first.
  if (info.max_depth < 0) info.max_depth = tile.words.empty() ? 0 : static_cast<int>(tile.words.back().length());
  Assembler assembler(std::move(info));
  assembler.submit(std::move(tile));
  return assembler.finish(false);
}

}  // namespace heckbert::record
