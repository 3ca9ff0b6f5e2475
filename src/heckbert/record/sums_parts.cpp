#include <heckbert/record/sums_parts.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <heckbert/record/exr.h>

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

template <class T>
std::vector<T> read_flat(Imf::MultiPartInputFile& file, const char* name, const Window& window,
                         const std::vector<Channel>& channels) {
  const auto part = find_part(file, name);
  if (!part) throw std::runtime_error(fmt::format("the part '{}' is missing", name));
  if (window_of(file.header(*part).dataWindow()) != window)
    throw std::runtime_error(fmt::format("the part '{}' has another data window", name));
  std::vector<T> pixels(window.pixel_count());
  Imf::InputPart input(file, *part);
  input.setFrameBuffer(frame_of(pixels.data(), window, channels));
  input.readPixels(window.y0, window.y1 - 1);
  return pixels;
}

/// Lets OpenEXR write from and read into the sums of entries in place, as EntryFrame of record_file.cpp does for means.
struct SumsFrame {
  SumsFrame(const EntrySum* entries, const std::vector<std::size_t>& offsets, const Window& window)
      : counts(window.pixel_count()) {
    const auto width = static_cast<std::size_t>(window.width());
    const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(window.y0) * window.width() + window.x0;
    const auto base = [&](auto& values) {
      return reinterpret_cast<char*>(values.data()) - before * static_cast<std::ptrdiff_t>(sizeof(values[0]));
    };
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = static_cast<unsigned>(offsets[i + 1] - offsets[i]);
    buffer.insertSampleCountSlice({Imf::UINT, base(counts), sizeof(unsigned), sizeof(unsigned) * width});
    for (const Channel& channel : sum_channels(offsetof(EntrySum, sum))) {
      std::vector<const char*>& first = first_values.emplace_back(window.pixel_count());
      for (std::size_t i = 0; i < counts.size(); ++i)
        first[i] = counts[i] == 0 ? nullptr : reinterpret_cast<const char*>(entries + offsets[i]) + channel.offset;
      buffer.insert(channel.name, {Imf::UINT, base(first), sizeof(char*), sizeof(char*) * width, sizeof(EntrySum)});
    }
  }

  std::vector<unsigned> counts;  // by pixel
  std::vector<std::vector<const char*>> first_values;
  Imf::DeepFrameBuffer buffer;
};

void read_entry_sums(Imf::MultiPartInputFile& file, Tile& tile) {
  Imf::DeepScanLineInputPart input(file, *find_part(file, kSumsPart));
  if (window_of(input.header().dataWindow()) != tile.window)
    throw std::runtime_error(fmt::format("the part '{}' has another data window", kSumsPart));
  SumsFrame frame(tile.entries.data(), tile.offsets, tile.window);
  const std::vector<unsigned> wanted = frame.counts;
  input.setFrameBuffer(frame.buffer);
  input.readPixelSampleCounts(tile.window.y0, tile.window.y1 - 1);
  if (frame.counts != wanted)
    throw std::runtime_error(fmt::format("the part '{}' has other words than the part 'paths'", kSumsPart));
  input.readPixels(tile.window.y0, tile.window.y1 - 1);
}

/// Throws unless the means of the file are those of its sums: a cheap way to see that the two belong together.
void check_means(const Sums& sums, const Record& record) {
  if (record_of(sums) != record) throw std::runtime_error("the sums are not those of the means");
}

}  // namespace

std::vector<Imf::Header> sums_headers(const Sums& sums) {
  const auto flat = [&](const char* name, const Window& window, const std::vector<Channel>& channels) {
    return header_of(sums.info, name, Imf::SCANLINEIMAGE, window, channels);
  };
  std::vector<Imf::Header> headers{
      header_of(sums.info, kSumsPart, Imf::DEEPSCANLINE, sums.info.window, sum_channels(0)),
      flat(kSamplesPart, sums.info.window, {{"samples", 0}}),
      flat(kBatchesPart, batches_window(sums.tile.words.size()), batch_channels())};
  for (const NonPathPart& part : kNonPathParts)
    if (!(sums.tile.*part.buffer).empty()) headers.push_back(flat(part.name, sums.info.window, sum_channels(0)));
  return headers;
}

void write_sums_parts(Imf::MultiPartOutputFile& file, int first, const Sums& sums) {
  const Tile& tile = sums.tile;
  const Window& window = sums.info.window;
  SumsFrame frame(tile.entries.data(), tile.offsets, window);
  Imf::DeepScanLineOutputPart output(file, first);
  output.setFrameBuffer(frame.buffer);
  output.writePixels(window.height());

  write_flat(file, first + 1, tile.samples, window, {{"samples", 0}});
  const Window rows = batches_window(tile.words.size());
  std::vector<BatchSum> batches(rows.pixel_count());
  for (const BatchSum& sum : tile.batch_sums) batches[std::size_t{sum.word} * kBatches + sum.batch] = sum;
  write_flat(file, first + 2, batches, rows, batch_channels());
  int part = first + 3;
  for (const NonPathPart& non_path : kNonPathParts)
    if (const auto& pixels = tile.*non_path.buffer; !pixels.empty())
      write_flat(file, part++, pixels, window, sum_channels(0));
}

bool has_sums(const Imf::MultiPartInputFile& file) {
  return find_part(file, kSumsPart).has_value();
}

Sums read_sums_parts(Imf::MultiPartInputFile& file, const Record& record) {
  const Window& window = record.info.window;
  Sums sums{record.info, {}};
  Tile& tile = sums.tile;
  tile.window = window;
  tile.words = record.words;
  tile.offsets = record.offsets;
  tile.tally = record.tally;
  tile.entries.reserve(record.entries.size());
  for (const Entry& entry : record.entries) tile.entries.push_back({entry.word, entry.count, {}});
  read_entry_sums(file, tile);
  tile.samples = read_flat<std::uint32_t>(file, kSamplesPart, window, {{"samples", 0}});
  const Window rows = batches_window(tile.words.size());
  const auto batches = read_flat<BatchSum>(file, kBatchesPart, rows, batch_channels());
  for (std::uint32_t w = 0; w < tile.words.size(); ++w)
    for (std::uint32_t b = 0; b < kBatches; ++b)
      if (const BatchSum& batch = batches[std::size_t{w} * kBatches + b]; batch.count > 0)
        tile.batch_sums.push_back({w, b, batch.count, batch.sum});
  for (const NonPathPart& part : kNonPathParts)
    if (find_part(file, part.name)) tile.*part.buffer = read_flat<RgbSum>(file, part.name, window, sum_channels(0));
  check_means(sums, record);
  return sums;
}

}  // namespace heckbert::record::exr
