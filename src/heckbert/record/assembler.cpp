#include <algorithm>
#include <utility>

#include <heckbert/record/recorder.h>
#include <heckbert/record/word_sums.h>

namespace heckbert::record {

namespace {

/// Mean light that no path carries, of one row of a tile.
void copy_row(const std::vector<RgbSum>& from, std::vector<Rgb>& to, const Tile& tile, std::size_t first,
              std::size_t to_first) {
  if (from.empty()) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(tile.window.width()); ++i)
    to[to_first + i] = mean_of(from[first + i], tile.samples[first + i]);
}

/// Appends one row of a tile to the record, which has all pixels before it.
void append_row(Record& record, const Tile& tile, int y, const std::vector<std::uint32_t>& rank) {
  const auto width = static_cast<std::size_t>(tile.window.width());
  const std::size_t from = static_cast<std::size_t>(y - tile.window.y0) * width;
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
  std::vector<Window> windows;
  windows.reserve(tiles.size());
  for (const Tile& tile : tiles) windows.push_back(tile.window);
  const auto rows = windows_by_row(windows, window);
  const auto pad_to = [&](int x, int y) {
    const std::size_t pixel = static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
                              static_cast<std::size_t>(x - window.x0);
    record.offsets.resize(pixel + 1, record.entries.size());
  };
  record.offsets.reserve(window.pixel_count() + 1);
  record.offsets.push_back(0);
  for (int y = window.y0; y < window.y1; ++y) {
    for (const std::size_t i : rows[static_cast<std::size_t>(y - window.y0)]) {
      Tile& tile = tiles[i];
      pad_to(tile.window.x0, y);
      append_row(record, tile, y, rank);
      if (y == tile.window.y1 - 1) tile.entries = {};
    }
    pad_to(window.x1, y);
  }
}

}  // namespace

Assembler::Assembler(RenderInfo info) : info_(std::move(info)), words_(std::make_unique<WordSums>()) {}
Assembler::~Assembler() = default;

void Assembler::submit(Tile tile) {
  check_tile(tile, info_.window);
  const std::lock_guard lock(mutex_);
  const std::vector<std::uint32_t> numbers = words_->add(tile);
  for (EntrySum& entry : tile.entries) entry.word = numbers[entry.word];
  tile.words = {};
  tile.batch_sums = {};
  tiles_.push_back(std::move(tile));
}

Record Assembler::finish(bool partial) {
  Record record = means_of_words(info_, words_->tile());
  record.info.partial = partial;
  std::size_t entry_count = 0;
  for (const Tile& tile : tiles_) {
    entry_count += tile.entries.size();
    if (!tile.ambient.empty()) record.ambient.resize(info_.window.pixel_count());
    if (!tile.phantom.empty()) record.phantom.resize(info_.window.pixel_count());
  }
  record.entries.reserve(entry_count);
  lay_out(record, tiles_, words_->ranks());
  return record;
}

}  // namespace heckbert::record
