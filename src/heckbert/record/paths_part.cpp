#include <heckbert/record/paths_part.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>

#include <heckbert/record/exr.h>
#include <heckbert/record/parallel.h>
#include <heckbert/record/record_header.h>

namespace heckbert::record::exr {

namespace {

struct HalfEntry {
  std::uint32_t word, count;
  half r, g, b;
};

constexpr std::array<DeepChannel, 5> kFloatChannels{{
    {"id", Imf::UINT, offsetof(Entry, word)},
    {"R", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, r)},
    {"G", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, g)},
    {"B", Imf::FLOAT, offsetof(Entry, energy) + offsetof(Rgb, b)},
    {"count", Imf::UINT, offsetof(Entry, count)},
}};
constexpr std::array<DeepChannel, 5> kHalfChannels{{
    {"id", Imf::UINT, offsetof(HalfEntry, word)},
    {"R", Imf::HALF, offsetof(HalfEntry, r)},
    {"G", Imf::HALF, offsetof(HalfEntry, g)},
    {"B", Imf::HALF, offsetof(HalfEntry, b)},
    {"count", Imf::UINT, offsetof(HalfEntry, count)},
}};

constexpr float kMostHalf = 65504;

half half_of(float energy) {
  return half(std::min(energy, kMostHalf));
}

/// Calls what `make` makes for each thread with a reader and the number of a row, for all rows from the top.
template <class Make>
void for_each_row(const Imf::DeepScanLineInputPart& part, const Record& record, Make make) {
  struct Worker {
    PathRowReader reader;
    decltype(make()) read_row;
    void operator()(std::size_t row) { read_row(reader, row); }
  };
  std::vector<std::uint64_t> counts(record.words.size());
  for (const Worker& worker : in_parallel(static_cast<std::size_t>(record.info.window.height()), [&] {
         return Worker{PathRowReader(part, counts.size()), make()};
       }))
    std::ranges::transform(counts, worker.reader.counts(), counts.begin(), std::plus<>());
  check_counts(counts, record);
}

}  // namespace

DeepLayout paths_layout(Precision precision) {
  if (precision == Precision::Half) return {kHalfChannels, sizeof(HalfEntry)};
  return {kFloatChannels, sizeof(Entry)};
}

void append_entry(std::vector<char>& structs, Precision precision, const Entry& entry) {
  const auto append = [&](const auto& value) {
    const char* bytes = reinterpret_cast<const char*>(&value);
    structs.insert(structs.end(), bytes, bytes + sizeof value);
  };
  if (precision == Precision::Float) return append(entry);
  const Rgb energy = entry.energy;
  append(HalfEntry{entry.word, entry.count, half_of(energy.r), half_of(energy.g), half_of(energy.b)});
}

std::function<void(DeepBand&)> means_of_bands(const SumsStream& sums, Precision precision) {
  return [&sums, precision, pass = sums.begin(), rows = SumsBand()](DeepBand& band) mutable {
    rows.window = band.window;
    pass(rows);
    const Window& window = sums.info.window;
    const std::uint32_t* samples =
        &sums.totals
             .samples[static_cast<std::size_t>(band.window.y0 - window.y0) * static_cast<std::size_t>(window.width())];
    const EntrySum* entry = rows.entries.data();
    for (const std::uint32_t count : rows.counts) {
      band.counts.push_back(count);
      for (std::uint32_t e = 0; e < count; ++e, ++entry)
        append_entry(band.samples, precision, {entry->word, mean_of(entry->sum, *samples), entry->count});
      ++samples;
    }
  };
}

void count_rounding(Tally& tally, Rgb energy) {
  tally.half_clamped += max_channel(energy) > kMostHalf ? 1 : 0;
  const bool vanishes = half_of(energy.r) == 0 && half_of(energy.g) == 0 && half_of(energy.b) == 0;
  tally.half_vanished += vanishes && !is_black(energy) ? 1 : 0;
}

PathRowReader::PathRowReader(const Imf::DeepScanLineInputPart& part, std::size_t words)
    : reader_(part, paths_layout(Precision::Float)), counts_(words) {}

void PathRowReader::read(int y, std::span<const std::size_t> offsets, std::span<Entry> entries) {
  reader_.read(y, entries.size(), reinterpret_cast<char*>(entries.data()));
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
    check(entries.subspan(offsets[i] - offsets.front(), offsets[i + 1] - offsets[i]));
}

void PathRowReader::check(std::span<const Entry> pixel) {
  for (std::size_t e = 0; e < pixel.size(); ++e) {
    const Entry& entry = pixel[e];
    if (entry.word >= counts_.size()) throw std::runtime_error("a pixel has an id that the id manifest lacks");
    if (e > 0 && pixel[e - 1].word >= entry.word) throw std::runtime_error("a pixel's ids are not ascending");
    if (!is_recordable(entry.energy)) throw std::runtime_error("a pixel has an energy that is negative or not finite");
    if (entry.count == 0) throw std::runtime_error("a pixel has a word without contributions");
    counts_[entry.word] += entry.count;
  }
}

void check_counts(const std::vector<std::uint64_t>& counts, const Record& totals) {
  require(std::ranges::find(counts, 0u) == counts.end(), "the id manifest has a word that no pixel has");
  require(counts == totals.counts, "the counts of the words are not those of their pixels");
}

std::vector<std::size_t> read_path_offsets(const Imf::DeepScanLineInputPart& part, std::uint64_t file_bytes) {
  std::vector<std::size_t> offsets = read_offsets(part);
  require(can_unpack_to(offsets.back() * sizeof(HalfEntry), file_bytes),
          "the file is damaged: it promises more samples than it can hold");
  return offsets;
}

void read_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record) {
  const Imf::DeepScanLineInputPart part(file, 0);
  record.offsets = read_path_offsets(part, file_bytes);
  record.entries.resize(record.offsets.back());
  for_each_row(part, record, [&] {
    return [&](PathRowReader& reader, std::size_t row) {
      const PixelRow pixels = pixel_row(record.info.window, record.offsets, row);
      const std::size_t first = pixels.offsets.front(), last = pixels.offsets.back();
      reader.read(pixels.y, pixels.offsets, std::span(record.entries).subspan(first, last - first));
    };
  });
}

void visit_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, const Record& record,
                 const RowVisitor& visit) {
  const Imf::DeepScanLineInputPart part(file, 0);
  const std::vector<std::size_t> offsets = read_path_offsets(part, file_bytes);
  for_each_row(part, record, [&] {
    return [&, entries = std::vector<Entry>()](PathRowReader& reader, std::size_t row) mutable {
      PixelRow pixels = pixel_row(record.info.window, offsets, row);
      entries.resize(pixels.offsets.back() - pixels.offsets.front());
      reader.read(pixels.y, pixels.offsets, entries);
      pixels.entries = entries;
      visit(pixels);
    };
  });
}

}  // namespace heckbert::record::exr
