#include <heckbert/record/paths_part.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <array>
#include <functional>

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

/// Throws unless the entries of some pixels keep the promises of Record.
struct EntryCheck {
  const Record& record;
  std::vector<std::uint64_t> counts;  ///< by word, of contributions in the entries that were checked

  void operator()(std::size_t band) {
    const std::size_t first = band * kBandPixels;
    const std::size_t last = std::min(first + kBandPixels, record.offsets.size() - 1);
    for (std::size_t pixel = first; pixel < last; ++pixel)
      for (std::size_t e = record.offsets[pixel]; e < record.offsets[pixel + 1]; ++e) {
        const Entry& entry = record.entries[e];
        if (entry.word >= counts.size()) throw std::runtime_error("a pixel has an id that the id manifest lacks");
        if (e > record.offsets[pixel] && record.entries[e - 1].word >= entry.word)
          throw std::runtime_error("a pixel's ids are not ascending");
        if (!is_recordable(entry.energy))
          throw std::runtime_error("a pixel has an energy that is negative or not finite");
        if (entry.count == 0) throw std::runtime_error("a pixel has a word without contributions");
        counts[entry.word] += entry.count;
      }
  }

  static constexpr std::size_t kBandPixels = 4096;
};

void check_entries(const Record& record) {
  const std::size_t bands = (record.offsets.size() + EntryCheck::kBandPixels - 2) / EntryCheck::kBandPixels;
  std::vector<std::uint64_t> counts(record.words.size());
  for (const EntryCheck& check : in_parallel(bands, [&] {
         return EntryCheck{record, std::vector<std::uint64_t>(counts.size())};
       }))
    std::transform(counts.begin(), counts.end(), check.counts.begin(), counts.begin(), std::plus<>());
  require(std::find(counts.begin(), counts.end(), 0u) == counts.end(), "the id manifest has a word that no pixel has");
  require(counts == record.counts, "the counts of the words are not those of their pixels");
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

void count_rounding(Tally& tally, Rgb energy) {
  tally.half_clamped += max_channel(energy) > kMostHalf ? 1 : 0;
  const bool vanishes = half_of(energy.r) == 0 && half_of(energy.g) == 0 && half_of(energy.b) == 0;
  tally.half_vanished += vanishes && !is_black(energy) ? 1 : 0;
}

void read_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record) {
  const auto allocate = [&](std::size_t total) {
    require(can_unpack_to(total * sizeof(HalfEntry), file_bytes),
            "the file is damaged: it promises more samples than it can hold");
    record.entries.resize(total);
    return reinterpret_cast<char*>(record.entries.data());
  };
  const auto counts = read_deep(Imf::DeepScanLineInputPart(file, 0), paths_layout(Precision::Float), allocate);
  record.offsets.reserve(counts.size() + 1);
  record.offsets.push_back(0);
  for (const unsigned count : counts) record.offsets.push_back(record.offsets.back() + count);
  check_entries(record);
}

}  // namespace heckbert::record::exr
