#include <algorithm>
#include <stdexcept>
#include <utility>

#include <heckbert/record/recorder.h>

namespace heckbert::record {

namespace {

void require(bool holds, const char* claim) {
  if (!holds) throw std::logic_error(claim);
}

/// Adds to the sums of one word, sorted by batch.
void add_to(std::vector<BatchSum>& sums, const BatchSum& more) {
  const auto place = std::lower_bound(sums.begin(), sums.end(), more.batch,
                                      [](const BatchSum& sum, std::uint32_t batch) { return sum.batch < batch; });
  if (place == sums.end() || place->batch != more.batch) {
    sums.insert(place, more);
  } else {
    place->count += more.count;
    place->sum += more.sum;
  }
}

bool is_inside(const Window& inner, const Window& outer) {
  return outer.x0 <= inner.x0 && inner.x0 < inner.x1 && inner.x1 <= outer.x1 &&  //
         outer.y0 <= inner.y0 && inner.y0 < inner.y1 && inner.y1 <= outer.y1;
}

std::size_t row_of(const Window& window, int y) {
  return static_cast<std::size_t>(y - window.y0);
}

/// The tiles that cross each row of the window, from left to right.
std::vector<std::vector<Tile*>> tiles_by_row(std::vector<Tile>& tiles, const Window& window) {
  std::sort(tiles.begin(), tiles.end(), [](const Tile& a, const Tile& b) { return a.window.x0 < b.window.x0; });
  std::vector<std::vector<Tile*>> rows(static_cast<std::size_t>(window.height()));
  for (Tile& tile : tiles)
    for (int y = tile.window.y0; y < tile.window.y1; ++y) rows[row_of(window, y)].push_back(&tile);
  return rows;
}

/// Mean light that no path carries, of one row of a tile.
void copy_row(const std::vector<RgbSum>& from, std::vector<Rgb>& to, const Tile& tile, std::size_t first,
              std::size_t to_first) {
  if (from.empty()) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(tile.window.width()); ++i)
    if (const std::uint32_t samples = tile.samples[first + i]; samples > 0)
      to[to_first + i] = mean_of(from[first + i], samples);
}

/// Appends one row of a tile to the record, which has all pixels before it.
void append_row(Record& record, const Tile& tile, int y, const std::vector<std::uint32_t>& rank) {
  const auto width = static_cast<std::size_t>(tile.window.width());
  const std::size_t from = row_of(tile.window, y) * width;
  const std::size_t to = record.offsets.size() - 1;
  copy_row(tile.ambient, record.ambient, tile, from, to);
  copy_row(tile.phantom, record.phantom, tile, from, to);
  for (std::size_t pixel = from; pixel < from + width; ++pixel) {
    for (std::size_t e = tile.offsets[pixel]; e < tile.offsets[pixel + 1]; ++e) {
      const EntrySum& entry = tile.entries[e];
      record.entries.push_back({rank[entry.word], mean_of(entry.sum, tile.samples[pixel]), entry.count});
    }
    record.offsets.push_back(record.entries.size());
  }
}

/// Lays the pixels of all tiles out row by row; `rank` gives the place of each word that the tiles number. A tile's
/// entries are freed with its last row, so that the peak is one copy of all entries and a band of tiles.
void lay_out(Record& record, std::vector<Tile>& tiles, const std::vector<std::uint32_t>& rank) {
  const Window& window = record.info.window;
  const auto rows = tiles_by_row(tiles, window);
  const auto pad_to = [&](int x, int y) {
    const std::size_t pixel =
        row_of(window, y) * static_cast<std::size_t>(window.width()) + static_cast<std::size_t>(x - window.x0);
    require(record.offsets.size() <= pixel + 1, "tiles do not overlap");
    record.offsets.resize(pixel + 1, record.entries.size());
  };
  record.offsets.reserve(window.pixel_count() + 1);
  record.offsets.push_back(0);
  for (int y = window.y0; y < window.y1; ++y) {
    for (Tile* tile : rows[row_of(window, y)]) {
      pad_to(tile->window.x0, y);
      append_row(record, *tile, y, rank);
      if (y == tile->window.y1 - 1) tile->entries = {};
    }
    pad_to(window.x1, y);
  }
}

/// The estimates of the picture mean that the batches give.
std::vector<Rgb> means_of(const std::vector<BatchSum>& sums, const RenderInfo& info) {
  const auto sizes = batch_sizes(info);
  std::vector<Rgb> means(kBatches);
  for (const BatchSum& sum : sums)
    means[sum.batch] = mean_of(sum.sum, sizes[sum.batch] * static_cast<double>(info.window.pixel_count()));
  return means;
}

}  // namespace

Assembler::Assembler(RenderInfo info) : info_(std::move(info)) {}

void Assembler::submit(Tile tile) {
  require(is_inside(tile.window, info_.window), "a tile lies inside the picture's window");
  require(tile.offsets.size() == tile.window.pixel_count() + 1 && tile.offsets.back() == tile.entries.size() &&
              tile.samples.size() == tile.window.pixel_count(),
          "a tile's lists fit its window");
  require(std::is_sorted(tile.words.begin(), tile.words.end()), "a tile's words are sorted");

  const std::lock_guard lock(mutex_);
  std::vector<std::uint32_t> id(tile.words.size());
  for (std::size_t w = 0; w < id.size(); ++w)
    id[w] = ids_.try_emplace(std::move(tile.words[w]), static_cast<std::uint32_t>(ids_.size())).first->second;
  batch_sums_.resize(ids_.size());
  for (const BatchSum& sum : tile.batch_sums) add_to(batch_sums_[id[sum.word]], sum);
  for (EntrySum& entry : tile.entries) entry.word = id[entry.word];
  tile.words = {};
  tile.batch_sums = {};
  tiles_.push_back(std::move(tile));
}

Record Assembler::finish(bool partial) {
  Record record;
  record.info = info_;
  record.info.partial = partial;

  std::vector<std::uint32_t> rank(ids_.size());
  for (const auto& [word, id] : ids_) {
    rank[id] = static_cast<std::uint32_t>(record.words.size());
    record.words.push_back(word);
    const std::vector<Rgb> means = means_of(batch_sums_[id], info_);
    record.batch_means.insert(record.batch_means.end(), means.begin(), means.end());
  }

  std::size_t entry_count = 0;
  for (const Tile& tile : tiles_) {
    record.tally += tile.tally;
    entry_count += tile.entries.size();
    if (!tile.ambient.empty()) record.ambient.resize(info_.window.pixel_count());
    if (!tile.phantom.empty()) record.phantom.resize(info_.window.pixel_count());
  }
  record.entries.reserve(entry_count);
  lay_out(record, tiles_, rank);
  return record;
}

}  // namespace heckbert::record
