#include <heckbert/record/record_spool.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <utility>

#include <heckbert/record/file.h>
#include <heckbert/record/paths_part.h>
#include <heckbert/record/spool_file.h>
#include <heckbert/record/word_sums.h>

namespace heckbert::record {

namespace {

std::size_t pixel_of(const Window& window, int x, int y) {
  return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(x - window.x0);
}

/// Puts the tile's pixels where they are in the window.
template <class T>
void paste(const std::vector<T>& from, const Window& tile, const Window& window, std::vector<T>& to) {
  if (from.empty()) return;
  to.resize(window.pixel_count());
  const auto width = static_cast<std::size_t>(tile.width());
  for (int y = tile.y0; y < tile.y1; ++y)
    std::copy_n(&from[pixel_of(tile, tile.x0, y)], width, &to[pixel_of(window, tile.x0, y)]);
}

}  // namespace

/// Reads the entries back, row by row of the window.
class RecordSpool::RowReader {
 public:
  /// Errors: std::logic_error when tiles overlap.
  explicit RowReader(const RecordSpool& spool)
      : spool_(spool), rank_(spool.words_->ranks()), rows_(windows_by_row(spool.windows_, spool.info_.window)) {
    assert(spool.file_ != nullptr);
    for (const Kept& tile : spool.tiles_) next_.push_back(tile.place);
  }

  /// Calls use(x0, counts, entries) for each tile that crosses row y, from left to right, words by their places. Rows
  /// come from the top downwards, each once.
  template <class F>
  void read(int y, F use) {
    for (const std::size_t t : rows_[static_cast<std::size_t>(y - spool_.info_.window.y0)]) {
      const Window& window = spool_.windows_[t];
      const Kept& tile = spool_.tiles_[t];
      const std::size_t first = pixel_of(window, window.x0, y), width = static_cast<std::size_t>(window.width());
      const auto counts = std::span(tile.counts).subspan(first, width);
      entries_.resize(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
      const std::span<char> bytes(reinterpret_cast<char*>(entries_.data()), entries_.size() * sizeof(EntrySum));
      spool_.file_->read(next_[t], bytes);
      next_[t] += bytes.size();
      for (EntrySum& entry : entries_) entry.word = rank_[entry.word];
      counts_.assign(counts.begin(), counts.end());
      if (spool_.is_folded()) add_up_classes();
      use(window.x0, counts_, entries_);
    }
  }

 private:
  /// Several words of a pixel may have become one class.
  void add_up_classes() {
    std::vector<EntrySum> sums;
    const EntrySum* next = entries_.data();
    for (std::uint32_t& count : counts_) {
      const std::size_t first = sums.size();
      sums.insert(sums.end(), next, next + count);
      next += count;
      add_up_equals(sums, first);
      count = static_cast<std::uint32_t>(sums.size() - first);
    }
    entries_ = std::move(sums);
  }

  const RecordSpool& spool_;
  std::vector<std::uint32_t> rank_;
  std::vector<std::vector<std::size_t>> rows_;
  std::vector<std::uint64_t> next_;  // by tile: the place of the row that comes next
  std::vector<EntrySum> entries_;    // of the current row
  std::vector<std::uint32_t> counts_;
};

RecordSpool::RecordSpool(RenderInfo info, const std::optional<std::filesystem::path>& target,
                         const std::optional<FoldRule>& rule)
    : info_(std::move(info)),
      words_(std::make_unique<WordSums>(rule)),
      file_(target ? std::make_unique<SpoolFile>(*target) : nullptr) {}
RecordSpool::~RecordSpool() = default;

void RecordSpool::submit(const Tile& tile) {
  check_tile(tile, info_.window);
  const std::lock_guard lock(mutex_);
  const std::vector<std::uint32_t> numbers = words_->add(tile);
  if (!tile.ambient.empty() || !tile.phantom.empty()) paste(tile.samples, tile.window, info_.window, samples_);
  paste(tile.ambient, tile.window, info_.window, ambient_);
  paste(tile.phantom, tile.window, info_.window, phantom_);
  if (!file_) return;
  std::vector<EntrySum> entries = tile.entries;
  for (EntrySum& entry : entries) entry.word = numbers[entry.word];
  Kept kept{.samples = tile.samples, .counts = {}};
  kept.counts.reserve(tile.window.pixel_count());
  for (std::size_t pixel = 0; pixel < tile.window.pixel_count(); ++pixel) {
    kept.counts.push_back(static_cast<std::uint32_t>(tile.offsets[pixel + 1] - tile.offsets[pixel]));
    if (info_.precision == Precision::Half)
      for (std::size_t e = tile.offsets[pixel]; e < tile.offsets[pixel + 1]; ++e)
        exr::count_rounding(rounding_, mean_of(entries[e].sum, tile.samples[pixel]));
  }
  kept.place = file_->append({reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(EntrySum)});
  windows_.push_back(tile.window);
  tiles_.push_back(std::move(kept));
}

Record RecordSpool::totals(bool partial) const {
  Record record = words_->totals(info_);
  record.info.partial = partial;
  record.tally += rounding_;
  record.ambient = means_of(ambient_, samples_);
  record.phantom = means_of(phantom_, samples_);
  return record;
}

bool RecordSpool::is_folded() const {
  return words_->is_folded();
}

SumsStream RecordSpool::stream(bool partial) const {
  SumsStream stream{info_, is_folded() ? Tile{} : words_->tile(), [this] {
                      auto reader = std::make_shared<RowReader>(*this);
                      return [reader](SumsBand& band) { read_band(*reader, band); };
                    }};
  stream.info.partial = partial;
  Tile& totals = stream.totals;
  totals.window = info_.window;
  totals.ambient = ambient_;
  totals.phantom = phantom_;
  totals.samples.resize(info_.window.pixel_count());
  for (std::size_t t = 0; t < tiles_.size(); ++t) paste(tiles_[t].samples, windows_[t], info_.window, totals.samples);
  return stream;
}

void RecordSpool::read_band(RowReader& reader, SumsBand& band) {
  band.counts.assign(band.window.pixel_count(), 0);
  band.entries.clear();
  for (int y = band.window.y0; y < band.window.y1; ++y)
    reader.read(y, [&](int x0, std::span<const std::uint32_t> counts, std::span<const EntrySum> entries) {
      const std::size_t first = pixel_of(band.window, x0, y);
      std::copy(counts.begin(), counts.end(), band.counts.begin() + static_cast<std::ptrdiff_t>(first));
      band.entries.insert(band.entries.end(), entries.begin(), entries.end());
    });
}

void RecordSpool::write(const std::filesystem::path& path, bool partial) const {
  const SumsStream sums = stream(partial);
  exr::write_record_file(totals(partial), exr::means_of_bands(sums, info_.precision), nullptr, path);
}

}  // namespace heckbert::record
