#include <heckbert/record/record_spool.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <utility>

#include <heckbert/record/spooled_tiles.h>
#include <heckbert/record/word_sums.h>

namespace heckbert::record {

namespace {

std::size_t pixel_of(const Window& window, int x, int y) {
  return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(x - window.x0);
}

/// Adds the tile's pixels to where they are in the window.
template <class T>
void add_pixels(const std::vector<T>& from, const Window& tile, const Window& window, std::vector<T>& to) {
  if (from.empty()) return;
  to.resize(window.pixel_count());
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) to[pixel_of(window, x, y)] += from[pixel_of(tile, x, y)];
}

std::unique_ptr<SpooledTiles> spooled_tiles(const std::optional<std::filesystem::path>& target, const Window& window) {
  return target ? std::make_unique<SpooledTiles>(window, *target) : nullptr;
}

}  // namespace

/// Reads entries back, row by row of the window; words by their places among the sorted ones.
class RecordSpool::RowReader {
 public:
  explicit RowReader(const RecordSpool& spool) : spool_(spool), rank_(spool.words_->ranks()) {}

  /// Appends row y.
  void append(int y, std::vector<std::uint32_t>& counts, std::vector<EntrySum>& entries) {
    std::vector<Source> sources;
    for (const SpooledTiles* tiles : {spool_.added_up_.get(), spool_.fresh_.get()})
      if (tiles != nullptr)
        for (SpooledTiles::Piece& piece : tiles->pieces(y)) sources.push_back({tiles, std::move(piece)});

    // All entries of a pixel side by side, whichever tile they are from; then those of the same word as one.
    const Window& window = spool_.info_.window;
    std::vector<std::size_t> next(static_cast<std::size_t>(window.width()) + 1);
    std::vector<int> sources_of(next.size());
    for (const auto& [tiles, piece] : sources) {
      auto column = static_cast<std::size_t>(piece.x0 - window.x0);
      for (const std::uint32_t count : piece.counts) {
        if (count > 0) ++sources_of[column];
        next[++column] += count;
      }
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    const std::vector<std::size_t> ends(next.begin() + 1, next.end());
    row_.resize(next.back());
    for (const auto& [tiles, piece] : sources) {
      tiles->read(piece, piece_entries_);
      auto column = static_cast<std::size_t>(piece.x0 - window.x0);
      const EntrySum* entry = piece_entries_.data();
      for (const std::uint32_t count : piece.counts) {
        for (std::uint32_t e = 0; e < count; ++e, ++entry) {
          EntrySum& place = row_[next[column]++];
          place = *entry;
          place.word = rank_[entry->word];
        }
        ++column;
      }
    }
    const EntrySum* from = row_.data();
    for (std::size_t column = 0; column < ends.size(); ++column) {
      const std::size_t first = entries.size();
      const EntrySum* const to = row_.data() + ends[column];
      entries.insert(entries.end(), from, to);
      from = to;
      if (sources_of[column] > 1 || spool_.is_folded()) add_up_equals(entries, first);
      counts.push_back(static_cast<std::uint32_t>(entries.size() - first));
    }
  }

 private:
  struct Source {
    const SpooledTiles* tiles;
    SpooledTiles::Piece piece;
  };

  const RecordSpool& spool_;
  std::vector<std::uint32_t> rank_;
  std::vector<EntrySum> piece_entries_, row_;
};

RecordSpool::RecordSpool(RenderInfo info, const std::optional<std::filesystem::path>& target,
                         const std::optional<FoldRule>& rule, std::uint64_t least_added_up)
    : info_(std::move(info)),
      target_(target),
      least_added_up_(least_added_up),
      words_(std::make_unique<WordSums>(rule)),
      fresh_(spooled_tiles(target, info_.window)),
      samples_(info_.window.pixel_count()) {}
RecordSpool::~RecordSpool() = default;

void RecordSpool::submit(Tile tile) {
  check_tile(tile, info_.window);
  const std::lock_guard lock(mutex_);
  const std::vector<std::uint32_t> numbers = words_->add(tile);
  if (fresh_) keep(tile, numbers);
  add_pixels(tile.samples, tile.window, info_.window, samples_);
  add_pixels(tile.ambient, tile.window, info_.window, ambient_);
  add_pixels(tile.phantom, tile.window, info_.window, phantom_);
}

void RecordSpool::keep(Tile& tile, const std::vector<std::uint32_t>& numbers) {
  for (EntrySum& entry : tile.entries) entry.word = numbers[entry.word];
  std::vector<std::uint32_t> counts;
  counts.reserve(tile.window.pixel_count());
  for (int y = tile.window.y0; y < tile.window.y1; ++y)
    for (int x = tile.window.x0; x < tile.window.x1; ++x) {
      const std::size_t pixel = counts.size();
      counts.push_back(static_cast<std::uint32_t>(tile.offsets[pixel + 1] - tile.offsets[pixel]));
      // A pixel has all its samples in one tile, unless tiles overlap.
      const bool was_seen = samples_[pixel_of(info_.window, x, y)] > 0;
      overlap_ = overlap_ || (counts.back() > 0 && (was_seen || tile.samples[pixel] == 0));
    }
  fresh_->append(tile.window, counts, tile.entries);
  if (overlap_ && fresh_->bytes() > std::max(least_added_up_, added_up_ ? added_up_->bytes() : 0)) add_up();
}

void RecordSpool::add_up() {
  auto sum = std::make_unique<SpooledTiles>(info_.window, *target_);
  const std::vector<std::uint32_t> numbers = words_->numbers();
  RowReader reader(*this);
  std::vector<std::uint32_t> counts;
  std::vector<EntrySum> entries;
  for (int y = info_.window.y0; y < info_.window.y1; ++y) {
    counts.clear();
    entries.clear();
    reader.append(y, counts, entries);
    for (EntrySum& entry : entries) entry.word = numbers[entry.word];
    sum->append({info_.window.x0, y, info_.window.x1, y + 1}, counts, entries);
  }
  added_up_ = std::move(sum);
  fresh_ = spooled_tiles(target_, info_.window);
}

bool RecordSpool::is_folded() const {
  return words_->is_folded();
}

SumsStream RecordSpool::stream() const {
  SumsStream stream{.info = info_, .totals = words_->tile(), .begin = {}, .folding = words_->folding()};
  Tile& totals = stream.totals;
  totals.window = info_.window;
  totals.samples = samples_;
  totals.ambient = ambient_;
  totals.phantom = phantom_;
  stream.info.partial = is_partial(info_, totals);
  stream.begin = [this] {
    assert(fresh_ != nullptr);
    return [reader = RowReader(*this)](SumsBand& band) mutable {
      band.counts.clear();
      band.entries.clear();
      for (int y = band.window.y0; y < band.window.y1; ++y) reader.append(y, band.counts, band.entries);
    };
  };
  return stream;
}

}  // namespace heckbert::record
