#pragma once
// Text in pictures: DejaVu Sans Mono, compiled in, drawn by stb_truetype. A fixed pitch keeps expressions readable and
// makes the width of a text its number of characters.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <heckbert/report/picture.h>

namespace heckbert::report {

using Colour = std::array<std::uint8_t, 3>;

inline constexpr int kCaptionSize = 16;    ///< from the highest ascent to the lowest descent, pixels
inline constexpr int kCaptionHeight = 21;  ///< from one line to the next, pixels

/// Draws UTF-8 text with the upper left corner of the first letter at (x, y); what falls outside the picture is left
/// out. Characters that the font does not have become its empty box.
void draw_caption(Picture& picture, int x, int y, std::string_view text, Colour colour);

/// How many characters fit side by side into `width` pixels.
std::size_t caption_columns(int width);

}  // namespace heckbert::report
