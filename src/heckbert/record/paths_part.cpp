#include <heckbert/record/paths_part.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <array>

#include <heckbert/record/exr.h>
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

void check_channels(const Imf::Header& header) {
  for (const DeepChannel& channel : kFloatChannels) {
    const Imf::Channel* found = header.channels().findChannel(channel.name);
    require(
        found != nullptr && (found->type == channel.type || (channel.type == Imf::FLOAT && found->type == Imf::HALF)),
        fmt::format("the channel '{}' is missing or of another type", channel.name));
  }
}

/// Throws unless the entries keep the promises of Record.
void check_entries(const Record& record) {
  std::vector<std::uint64_t> counts(record.words.size());
  for (std::size_t i = 0; i + 1 < record.offsets.size(); ++i) {
    for (std::size_t e = record.offsets[i]; e < record.offsets[i + 1]; ++e) {
      const Entry& entry = record.entries[e];
      if (entry.word >= counts.size()) throw std::runtime_error("a pixel has an id that the id manifest lacks");
      if (e > record.offsets[i] && record.entries[e - 1].word >= entry.word)
        throw std::runtime_error("a pixel's ids are not ascending");
      if (!is_recordable(entry.energy))
        throw std::runtime_error("a pixel has an energy that is negative or not finite");
      if (entry.count == 0) throw std::runtime_error("a pixel has a word without contributions");
      counts[entry.word] += entry.count;
    }
  }
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
  check_channels(file.header(0));
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
