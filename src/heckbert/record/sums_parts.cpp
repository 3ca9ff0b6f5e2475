#include <heckbert/record/sums_parts.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <heckbert/record/exr.h>
#include <heckbert/record/record_header.h>

namespace heckbert::record::exr {

namespace {

constexpr const char* kSumsPart = "sums";
constexpr const char* kSamplesPart = "samples";
constexpr const char* kBatchesPart = "batches";

struct NonPathPart {
  const char* name;
  std::vector<RgbSum> Tile::*buffer;
};
constexpr std::array<NonPathPart, 2> kNonPathParts{
    {{"ambient sums", &Tile::ambient}, {"phantom sums", &Tile::phantom}}};

/// Four bytes of a struct, as a channel.
struct Channel {
  std::string name;
  std::size_t offset;
};

/// The channels of an RgbSum that lies at `offset`.
std::vector<Channel> sum_channels(std::size_t offset) {
  static_assert(sizeof(Quanta) == 16 && offsetof(RgbSum, g) == 16 && offsetof(RgbSum, b) == 32);
  std::vector<Channel> channels;
  for (const char colour : {'R', 'G', 'B'})
    for (int word = 0; word < 4; ++word, offset += 4) channels.push_back({fmt::format("{}{}", colour, word), offset});
  return channels;
}

std::vector<Channel> batch_channels() {
  std::vector<Channel> channels = sum_channels(offsetof(BatchSum, sum));
  channels.push_back({"count0", offsetof(BatchSum, count)});
  channels.push_back({"count1", offsetof(BatchSum, count) + 4});
  return channels;
}

Window batches_window(std::size_t words) {
  return {0, 0, kBatches, std::max(1, static_cast<int>(words))};
}

Imf::Header header_of(const RenderInfo& info, const char* name, const std::string& type, const Window& window,
                      const std::vector<Channel>& channels) {
  Imf::Header header(box_of({0, 0, info.width, info.height}), box_of(window));
  header.setName(name);
  header.setType(type);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const Channel& channel : channels) header.channels().insert(channel.name, Imf::Channel(Imf::UINT));
  return header;
}

/// Values of a struct by pixel of a window, row by row, as a flat image.
template <class T>
Imf::FrameBuffer frame_of(const T* pixels, const Window& window, const std::vector<Channel>& channels) {
  Imf::FrameBuffer frame;
  for (const Channel& channel : channels)
    frame.insert(channel.name, Imf::Slice::Make(Imf::UINT, reinterpret_cast<const char*>(pixels) + channel.offset,
                                                box_of(window), sizeof(T)));
  return frame;
}

template <class T>
void write_flat(Imf::MultiPartOutputFile& file, int part, const std::vector<T>& pixels, const Window& window,
                const std::vector<Channel>& channels) {
  Imf::OutputPart output(file, part);
  output.setFrameBuffer(frame_of(pixels.data(), window, channels));
  output.writePixels(window.height());
}

std::optional<int> find_part(const Imf::MultiPartInputFile& file, const std::string& name) {
  for (int part = 0; part < file.parts(); ++part)
    if (file.header(part).hasName() && file.header(part).name() == name) return part;
  return {};
}

Imf::InputPart flat_part(Imf::MultiPartInputFile& file, const char* name, const Window& window) {
  const auto part = find_part(file, name);
  require(part.has_value(), fmt::format("the part '{}' is missing", name));
  require(window_of(file.header(*part).dataWindow()) == window,
          fmt::format("the part '{}' has another data window", name));
  return {file, *part};
}

template <class T>
std::vector<T> read_flat(Imf::MultiPartInputFile& file, const char* name, const Window& window,
                         const std::vector<Channel>& channels) {
  Imf::InputPart input = flat_part(file, name, window);
  std::vector<T> pixels(window.pixel_count());
  input.setFrameBuffer(frame_of(pixels.data(), window, channels));
  input.readPixels(window.y0, window.y1 - 1);
  return pixels;
}

constexpr auto kEntrySumChannels = [] {
  constexpr std::array<const char*, 12> kNames{"R0", "R1", "R2", "R3", "G0", "G1", "G2", "G3", "B0", "B1", "B2", "B3"};
  std::array<DeepChannel, kNames.size()> channels{};
  for (std::size_t i = 0; i < kNames.size(); ++i) channels[i] = {kNames[i], Imf::UINT, offsetof(EntrySum, sum) + 4 * i};
  return channels;
}();

/// Words whose batches are laid out at a time.
constexpr int kWordsAtOnce = 1024;

void write_batches(Imf::MultiPartOutputFile& file, int part, const Tile& tile) {
  Imf::OutputPart output(file, part);
  const Window all = batches_window(tile.words.size());
  auto next = tile.batch_sums.begin();
  for (int y = 0; y < all.y1; y += kWordsAtOnce) {
    const Window rows{0, y, kBatches, std::min(y + kWordsAtOnce, all.y1)};
    std::vector<BatchSum> batches(rows.pixel_count());
    for (; next != tile.batch_sums.end() && next->word < static_cast<std::uint32_t>(rows.y1); ++next)
      batches[(next->word - static_cast<std::size_t>(y)) * kBatches + next->batch] = *next;
    output.setFrameBuffer(frame_of(batches.data(), rows, batch_channels()));
    output.writePixels(rows.height());
  }
}

void read_batches(Imf::MultiPartInputFile& file, Tile& tile) {
  const Window all = batches_window(tile.words.size());
  Imf::InputPart input = flat_part(file, kBatchesPart, all);
  for (int y = 0; y < all.y1; y += kWordsAtOnce) {
    const Window rows{0, y, kBatches, std::min(y + kWordsAtOnce, all.y1)};
    std::vector<BatchSum> batches(rows.pixel_count());
    input.setFrameBuffer(frame_of(batches.data(), rows, batch_channels()));
    input.readPixels(rows.y0, rows.y1 - 1);
    for (std::size_t i = 0; i < batches.size(); ++i)
      if (const BatchSum& batch = batches[i]; batch.count > 0)
        tile.batch_sums.push_back({static_cast<std::uint32_t>(static_cast<std::size_t>(y) + i / kBatches),
                                   static_cast<std::uint32_t>(i % kBatches), batch.count, batch.sum});
  }
}

}  // namespace

DeepLayout entry_sums_layout() {
  return {kEntrySumChannels, sizeof(EntrySum)};
}

std::vector<Imf::Header> sums_headers(const SumsStream& sums) {
  const Window& window = sums.info.window;
  const auto flat = [&](const char* name, const Window& of, const std::vector<Channel>& channels) {
    return header_of(sums.info, name, Imf::SCANLINEIMAGE, of, channels);
  };
  std::vector<Imf::Header> headers{header_of(sums.info, kSumsPart, Imf::DEEPSCANLINE, window, sum_channels(0)),
                                   flat(kSamplesPart, window, {{"samples", 0}}),
                                   flat(kBatchesPart, batches_window(sums.totals.words.size()), batch_channels())};
  for (const NonPathPart& part : kNonPathParts)
    if (!(sums.totals.*part.buffer).empty()) headers.push_back(flat(part.name, window, sum_channels(0)));
  return headers;
}

void write_sums_parts(Imf::MultiPartOutputFile& file, int first, const SumsStream& sums) {
  const Tile& totals = sums.totals;
  const Window& window = sums.info.window;
  write_deep(Imf::DeepScanLineOutputPart(file, first), window, entry_sums_layout(), {},
             [pass = sums.begin(), rows = SumsBand()](DeepBand& band) mutable {
               rows.window = band.window;
               pass(rows);
               band.counts.assign(rows.counts.begin(), rows.counts.end());
               const char* bytes = reinterpret_cast<const char*>(rows.entries.data());
               band.samples.assign(bytes, bytes + rows.entries.size() * sizeof(EntrySum));
             });
  write_flat(file, first + 1, totals.samples, window, {{"samples", 0}});
  write_batches(file, first + 2, totals);
  int part = first + 3;
  for (const NonPathPart& non_path : kNonPathParts)
    if (const auto& pixels = totals.*non_path.buffer; !pixels.empty())
      write_flat(file, part++, pixels, window, sum_channels(0));
}

Imf::DeepScanLineInputPart sums_part(Imf::MultiPartInputFile& file) {
  const auto part = find_part(file, kSumsPart);
  require(part.has_value(),
          "this record has means and no sums, so nothing can be added to it exactly; expected one of 'heckbert "
          "render --exact', --part or --checkpoint, or an interrupted one");
  require(window_of(file.header(*part).dataWindow()) == window_of(file.header(0).dataWindow()),
          fmt::format("the part '{}' has another data window", kSumsPart));
  return {file, *part};
}

Tile read_sums_totals(Imf::MultiPartInputFile& file, const Record& totals) {
  const Window& window = totals.info.window;
  Tile tile;
  tile.window = window;
  tile.words = totals.words;
  tile.tally = totals.tally;
  tile.samples = read_flat<std::uint32_t>(file, kSamplesPart, window, {{"samples", 0}});
  read_batches(file, tile);
  for (const NonPathPart& part : kNonPathParts)
    if (find_part(file, part.name)) tile.*part.buffer = read_flat<RgbSum>(file, part.name, window, sum_channels(0));
  return tile;
}

}  // namespace heckbert::record::exr
