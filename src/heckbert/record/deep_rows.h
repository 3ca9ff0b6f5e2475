#pragma once
// Deep scan-line images from and to arrays of structs, written a band of rows at a time. OpenEXR asks for the address
// of each pixel's first value in each channel; the samples of a pixel lie one after the other. Private to the layer: it
// shows OpenEXR's types.

#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfHeader.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::record::exr {

/// A channel of a deep image as a field of a struct.
struct DeepChannel {
  const char* name;
  Imf::PixelType type;
  std::size_t offset;
};

struct DeepLayout {
  std::span<const DeepChannel> channels;
  std::size_t bytes;  ///< of the struct
};

/// Channels that are zero everywhere.
using ZeroChannels = std::span<const std::pair<const char*, Imf::PixelType>>;

/// Some rows of a deep image.
struct DeepBand {
  Window window;
  std::vector<unsigned> counts;  ///< of samples, by pixel, row by row
  std::vector<char> samples;     ///< structs, pixel by pixel
};

/// Writes all rows of `window`; `fill` gets bands with their window set and nothing else, from the top downwards.
void write_deep(Imf::DeepScanLineOutputPart part, const Window& window, const DeepLayout& layout, ZeroChannels zeros,
                const std::function<void(DeepBand&)>& fill);

/// Pixel i, row by row, has the samples [offsets[i], offsets[i+1]). Errors: std::runtime_error with the reason.
std::vector<std::size_t> read_offsets(Imf::DeepScanLineInputPart part);

/// Reads all pixels of the part's data window into structs, pixel by pixel; halves become floats where the layout says
/// so. `allocate` is told how many structs there are and gives the place for them, or throws. Gives the offsets.
/// Errors: std::runtime_error with the reason.
std::vector<std::size_t> read_deep(Imf::DeepScanLineInputPart part, const DeepLayout& layout,
                                   const std::function<char*(std::size_t)>& allocate);

}  // namespace heckbert::record::exr
