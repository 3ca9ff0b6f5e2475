#pragma once
// Text in pictures, drawn with the built-in letters of stb_easy_font: no font file is needed. ASCII only; each
// character outside of it is drawn as '?'.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <heckbert/report/picture.h>

namespace heckbert::report {

using Colour = std::array<std::uint8_t, 3>;

/// Every stroke is two pixels wide.
inline constexpr int kCaptionScale = 2;
inline constexpr int kCaptionHeight = 12 * kCaptionScale;  ///< from one line to the next, pixels

/// Draws with the upper left corner of the first letter at (x, y); what falls outside the picture is left out.
void draw_caption(Picture& picture, int x, int y, std::string_view text, Colour colour);
/// Width in pixels.
int caption_width(std::string_view text);
/// The text, or as much of it as fits into `width` pixels with "..." at the end.
std::string fitted_caption(std::string_view text, int width);

}  // namespace heckbert::report
