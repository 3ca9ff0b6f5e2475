#include <heckbert/record/deep_rows.h>

#include <algorithm>

#include <heckbert/record/deep_chunk.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/parallel.h>

namespace heckbert::record::exr {

namespace {

/// Rows that are handed to OpenEXR at once: enough for all its threads, and few beside a picture.
constexpr int kBandRows = 32;

/// The base address that OpenEXR wants, from which x and y count: the one of pixel (0, 0), wherever the window starts.
template <class T>
char* base_of(T* pixels, const Window& window) {
  const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(window.y0) * window.width() + window.x0;
  return reinterpret_cast<char*>(pixels) - before * static_cast<std::ptrdiff_t>(sizeof(T));
}

Imf::Slice count_slice(unsigned* counts, const Window& window) {
  return {Imf::UINT, base_of(counts, window), sizeof(unsigned),
          sizeof(unsigned) * static_cast<std::size_t>(window.width())};
}

/// Tells OpenEXR where samples are. Costs 8 bytes per pixel and channel.
struct DeepFrame {
  DeepFrame(const Window& window, unsigned* counts, const DeepLayout& layout)
      : first_values(layout.channels.size() * window.pixel_count()) {
    const auto width = static_cast<std::size_t>(window.width());
    buffer.insertSampleCountSlice(count_slice(counts, window));
    char** first = first_values.data();
    for (const DeepChannel& channel : layout.channels) {
      buffer.insert(channel.name,
                    {channel.type, base_of(first, window), sizeof(char*), sizeof(char*) * width, layout.bytes});
      first += window.pixel_count();
    }
  }

  /// Takes: the address of the first struct of the first pixel.
  void point_at(char* samples, const std::vector<unsigned>& counts, const DeepLayout& layout) {
    char** first = first_values.data();
    for (const DeepChannel& channel : layout.channels) {
      char* next = samples == nullptr ? nullptr : samples + channel.offset;
      for (const unsigned count : counts) {
        *first++ = count == 0 ? nullptr : next;
        next += count * layout.bytes;
      }
    }
  }

  std::vector<char*> first_values;  // by channel and pixel
  Imf::DeepFrameBuffer buffer;
};

}  // namespace

void write_deep(Imf::DeepScanLineOutputPart part, const Window& window, const DeepLayout& layout, ZeroChannels zeros,
                const std::function<void(DeepBand&)>& fill) {
  float zero = 0;
  char* zero_sample = reinterpret_cast<char*>(&zero);
  DeepBand band;
  for (int y = window.y0; y < window.y1; y += kBandRows) {
    band.window = {window.x0, y, window.x1, std::min(y + kBandRows, window.y1)};
    band.counts.clear();
    band.samples.clear();
    fill(band);
    DeepFrame frame(band.window, band.counts.data(), layout);
    frame.point_at(band.samples.data(), band.counts, layout);
    for (const auto& [name, type] : zeros)
      frame.buffer.insert(name, {type, reinterpret_cast<char*>(&zero_sample), 0, 0, 0});
    part.setFrameBuffer(frame.buffer);
    part.writePixels(band.window.height());
  }
}

std::vector<std::size_t> read_offsets(Imf::DeepScanLineInputPart part) {
  const Window window = window_of(part.header().dataWindow());
  std::vector<unsigned> counts(window.pixel_count());
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(count_slice(counts.data(), window));
  part.setFrameBuffer(frame);
  part.readPixelSampleCounts(window.y0, window.y1 - 1);
  std::vector<std::size_t> offsets(counts.size() + 1);
  for (std::size_t i = 0; i < counts.size(); ++i) offsets[i + 1] = offsets[i] + counts[i];
  return offsets;
}

std::vector<std::size_t> read_deep(Imf::DeepScanLineInputPart part, const DeepLayout& layout,
                                   const std::function<char*(std::size_t)>& allocate) {
  const Window window = window_of(part.header().dataWindow());
  const auto width = static_cast<std::size_t>(window.width());
  std::vector<std::size_t> offsets = read_offsets(part);
  char* const structs = allocate(offsets.back());
  in_parallel(static_cast<std::size_t>(window.height()), [&] {
    return [&, reader = DeepRowReader(part, layout)](std::size_t row) mutable {
      const std::size_t first = offsets[row * width], last = offsets[(row + 1) * width];
      reader.read(window.y0 + static_cast<int>(row), last - first, structs + first * layout.bytes);
    };
  });
  return offsets;
}

}  // namespace heckbert::record::exr
