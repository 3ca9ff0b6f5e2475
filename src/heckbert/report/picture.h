#pragma once
// Pictures to look at: light to 8-bit sRGB under an exposure, and PNG. Nothing but a factor and a clamp stands between
// light and pixel, so pictures of parts that are shown at one exposure add up to the picture of the whole as far as
// nothing clips.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::report {

/// 8-bit sRGB, rows from the top, three bytes per pixel.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The factor that brings the log-average luminance of the lit pixels to middle grey, 0.18; 1 when nothing is lit.
/// Pixels without light are left out, so a dark background does not brighten the rest. One exposure, taken from the
/// whole picture, serves every part of it. Source: Reinhard et al., "Photographic Tone Reproduction", 2002, eq. 1-2.
float auto_exposure(const record::Image& image);

/// Times the exposure, clamped to [0, 1], with the sRGB curve (IEC 61966-2-1).
Picture to_srgb(const record::Image& image, float exposure);

/// Mean over blocks of k x k pixels, k the smallest that brings the width to `max_width` or less; blocks at the right
/// and lower edge may be smaller. The same image when it is narrow enough.
record::Image shrunk(const record::Image& image, int max_width);

/// The bytes of a PNG file. Errors: std::invalid_argument when the picture has no pixels.
std::vector<std::byte> encode_png(const Picture& picture);

}  // namespace heckbert::report
