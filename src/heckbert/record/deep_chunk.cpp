#include <heckbert/record/deep_chunk.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <libdeflate.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

#include <heckbert/record/exr.h>
#include <heckbert/record/record_header.h>

namespace heckbert::record::exr {

namespace {

static_assert(std::endian::native == std::endian::little, "values are taken as they lie in the file");

constexpr std::size_t kChunkHeader = 28;  // y and three sizes

template <class From, class To>
void scatter(const char* values, std::size_t count, char* field, std::size_t stride) {
  for (std::size_t i = 0; i < count; ++i, values += sizeof(From), field += stride) {
    From value;
    std::memcpy(&value, values, sizeof value);
    const To converted(value);
    std::memcpy(field, &converted, sizeof converted);
  }
}

std::size_t size_of(Imf::PixelType type) {
  return type == Imf::HALF ? sizeof(half) : sizeof(std::uint32_t);
}

/// How values become fields; nothing for types that do not fit.
auto scatter_for(Imf::PixelType from, Imf::PixelType to) -> decltype(&scatter<half, float>) {
  if (from == Imf::HALF && to == Imf::FLOAT) return scatter<half, float>;
  if (from != to) return nullptr;
  return from == Imf::HALF ? scatter<half, half> : scatter<std::uint32_t, std::uint32_t>;
}

/// Sums of the differences, those of the even places and then those of the odd ones put back where they belong. The odd
/// ones go on from the sum of the even ones, which is fast to find, so that both are summed at a time.
void restore(const std::vector<char>& differences, std::vector<char>& values) {
  const std::size_t odd = (differences.size() + 1) / 2, pairs = differences.size() / 2;
  const auto sum = [](unsigned char a, char b) {
    return static_cast<unsigned char>(a + static_cast<unsigned char>(b) - 128);
  };
  unsigned char even_last = 128, odd_last = 128;
  for (std::size_t i = 0; i < odd; ++i) odd_last = sum(odd_last, differences[i]);
  for (std::size_t i = 0; i < pairs; ++i) {
    even_last = sum(even_last, differences[i]);
    odd_last = sum(odd_last, differences[odd + i]);
    values[2 * i] = static_cast<char>(even_last);
    values[2 * i + 1] = static_cast<char>(odd_last);
  }
  if (odd > pairs) values[2 * pairs] = static_cast<char>(sum(even_last, differences[pairs]));
}

}  // namespace

void DeepRowReader::Free::operator()(libdeflate_decompressor* decompressor) const {
  libdeflate_free_decompressor(decompressor);
}

DeepRowReader::DeepRowReader(const Imf::DeepScanLineInputPart& part, const DeepLayout& layout)
    : part_(part),
      table_bytes_(static_cast<std::size_t>(window_of(part.header().dataWindow()).width()) * sizeof(std::uint32_t)),
      struct_bytes_(layout.bytes),
      decompressor_(libdeflate_alloc_decompressor()) {
  if (!decompressor_) throw std::bad_alloc();
  const Imf::Header& header = part_.header();
  require(header.compression() == Imf::ZIPS_COMPRESSION,
          fmt::format("the part '{}' is not packed as ZIPS, as records are", header.hasName() ? header.name() : ""));
  std::size_t found = 0;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    Channel channel{size_of(i.channel().type), nullptr, 0};
    for (const DeepChannel& wanted : layout.channels) {
      if (std::strcmp(wanted.name, i.name()) != 0) continue;
      channel.scatter = scatter_for(i.channel().type, wanted.type);
      channel.offset = wanted.offset;
      found += channel.scatter != nullptr ? 1 : 0;
    }
    sample_bytes_ += channel.bytes;
    channels_.push_back(channel);
  }
  if (found == layout.channels.size()) return;
  for (const DeepChannel& wanted : layout.channels) {
    const Imf::Channel* channel = header.channels().findChannel(wanted.name);
    require(channel != nullptr && scatter_for(channel->type, wanted.type) != nullptr,
            fmt::format("the channel '{}' is missing or of another type", wanted.name));
  }
}

void DeepRowReader::read(int y, std::size_t count, char* structs) {
  if (count == 0) return;
  const char* values = unpacked(y, count * sample_bytes_);
  for (const Channel& channel : channels_) {
    if (channel.scatter != nullptr) channel.scatter(values, count, structs + channel.offset, struct_bytes_);
    values += count * channel.bytes;
  }
}

const char* DeepRowReader::unpacked(int y, std::size_t bytes) {
  const auto check = [](bool fits) {
    require(fits, "the file is damaged: a row does not have as many samples as its pixels");
  };
  std::uint64_t size = chunk_.size();
  part_.rawPixelData(y, chunk_.data(), size);
  if (size > chunk_.size()) {
    check(size <= kChunkHeader + table_bytes_ + bytes);  // what does not pack is there as it is
    chunk_.resize(size);
    part_.rawPixelData(y, chunk_.data(), size);
  }
  std::array<std::uint64_t, 3> sizes{};  // of the table, packed, unpacked
  std::memcpy(sizes.data(), chunk_.data() + kChunkHeader - sizeof sizes, sizeof sizes);
  const auto [table, packed, unpacked] = sizes;
  check(unpacked == bytes && packed <= bytes && table <= table_bytes_ && size == kChunkHeader + table + packed);
  const char* const values = chunk_.data() + kChunkHeader + table;
  if (packed == bytes) return values;
  differences_.resize(bytes);
  values_.resize(bytes);
  require(libdeflate_zlib_decompress(decompressor_.get(), values, packed, differences_.data(), bytes, nullptr) ==
              LIBDEFLATE_SUCCESS,
          "the file is damaged: a row cannot be unpacked");
  restore(differences_, values_);
  return values_.data();
}

}  // namespace heckbert::record::exr
