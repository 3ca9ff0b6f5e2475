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

std::vector<Rgb> means_of(const std::vector<RgbSum>& sums, const std::vector<std::uint32_t>& samples) {
  std::vector<Rgb> means(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (samples[i] > 0) means[i] = mean_of(sums[i], samples[i]);
  return means;
}

}  // namespace

/// Reads the entries back, row by row of the window.
class RecordSpool::RowReader {
 public:
  /// The entries of one row of a tile, with their words' places.
  struct Row {
    int x0;
    std::span<const std::uint32_t> samples, counts;
    std::span<const EntrySum> entries;
  };

  /// Errors: std::logic_error when tiles overlap.
  explicit RowReader(const RecordSpool& spool)
      : spool_(spool), rank_(spool.words_->ranks()), rows_(windows_by_row(spool.windows_, spool.info_.window)) {
    assert(spool.file_ != nullptr);
    for (const Kept& tile : spool.tiles_) next_.push_back(tile.place);
  }

  /// Calls use(row) for each tile that crosses row y, from left to right. Rows come from the top downwards, each once.
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
      use(Row{window.x0, std::span(tile.samples).subspan(first, width), counts_, entries_});
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

void RecordSpool::write(const std::filesystem::path& path, bool partial) const {
  RowReader reader(*this);
  const auto append = [&](exr::DeepBand& band, int y, const RowReader::Row& row) {
    const std::size_t first = pixel_of(band.window, row.x0, y);
    const EntrySum* entry = row.entries.data();
    for (std::size_t i = 0; i < row.counts.size(); ++i) {
      band.counts[first + i] = row.counts[i];
      for (std::uint32_t e = 0; e < row.counts[i]; ++e, ++entry)
        exr::append_entry(band.samples, info_.precision,
                          {entry->word, mean_of(entry->sum, row.samples[i]), entry->count});
    }
  };
  exr::write_record_file(
      totals(partial),
      [&](exr::DeepBand& band) {
        band.counts.resize(band.window.pixel_count());
        for (int y = band.window.y0; y < band.window.y1; ++y)
          reader.read(y, [&](const RowReader::Row& row) { append(band, y, row); });
      },
      path);
}

Sums RecordSpool::sums(bool partial) const {
  Sums sums{info_, words_->tile()};
  sums.info.partial = partial;
  Tile& tile = sums.tile;
  tile.window = info_.window;
  tile.samples.resize(info_.window.pixel_count());
  tile.ambient = ambient_;
  tile.phantom = phantom_;
  tile.offsets.reserve(info_.window.pixel_count() + 1);
  tile.offsets.push_back(0);
  RowReader reader(*this);
  for (int y = info_.window.y0; y < info_.window.y1; ++y)
    reader.read(y, [&](const RowReader::Row& row) {
      std::size_t pixel = pixel_of(info_.window, row.x0, y);
      tile.offsets.resize(pixel + 1, tile.entries.size());
      tile.entries.insert(tile.entries.end(), row.entries.begin(), row.entries.end());
      for (std::size_t i = 0; i < row.counts.size(); ++i, ++pixel) {
        tile.samples[pixel] = row.samples[i];
        tile.offsets.push_back(tile.offsets.back() + row.counts[i]);
      }
    });
  tile.offsets.resize(info_.window.pixel_count() + 1, tile.entries.size());
  return sums;
}

}  // namespace heckbert::record
