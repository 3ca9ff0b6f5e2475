#include <heckbert/report/caption.h>

#include <algorithm>
#include <cmath>
#include <vector>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include <heckbert/taxonomy/utf8.h>

namespace heckbert::report {

extern const unsigned char caption_font[];  // a font file, compiled in

namespace {

struct Font {
  stbtt_fontinfo info{};
  float scale = 0;    ///< font units to pixels
  float advance = 0;  ///< from one letter to the next, pixels
  int baseline = 0;   ///< below the upper edge, pixels

  Font() {
    stbtt_InitFont(&info, caption_font, 0);
    scale = stbtt_ScaleForPixelHeight(&info, kCaptionSize);
    int ascent = 0, descent = 0, gap = 0, width = 0, bearing = 0;
    stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
    stbtt_GetCodepointHMetrics(&info, 'L', &width, &bearing);
    baseline = static_cast<int>(std::lround(scale * static_cast<float>(ascent)));
    advance = scale * static_cast<float>(width);
  }
};

const Font& font() {
  static const Font loaded;
  return loaded;
}

/// Mixes the colour into one pixel, if it is one of the picture's.
void blend(Picture& picture, int x, int y, Colour colour, int coverage) {
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
  for (std::ptrdiff_t channel = 0; channel < 3; ++channel) {
    auto& byte = picture.rgb[static_cast<std::size_t>(3 * (std::ptrdiff_t{y} * picture.width + x) + channel)];
    const int ink = colour[static_cast<std::size_t>(channel)];
    byte = static_cast<std::uint8_t>((byte * (255 - coverage) + ink * coverage) / 255);
  }
}

}  // namespace

void draw_caption(Picture& picture, int x, int y, std::string_view text, Colour colour) {
  std::vector<unsigned char> letter;
  float pen = static_cast<float>(x);
  for (std::size_t at = 0; at < text.size(); pen += font().advance) {
    const Utf8Character character = utf8_at(text, at);
    at += character.length;
    const int glyph = stbtt_FindGlyphIndex(&font().info, static_cast<int>(character.code));
    const float left = std::floor(pen), shift = pen - left;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font().info, glyph, font().scale, font().scale, shift, 0, &x0, &y0, &x1, &y1);
    const int width = x1 - x0, height = y1 - y0;
    letter.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    stbtt_MakeGlyphBitmapSubpixel(&font().info, letter.data(), width, height, width, font().scale, font().scale, shift,
                                  0, glyph);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        blend(
            picture, static_cast<int>(left) + x0 + column, y + font().baseline + y0 + row, colour,
            letter[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)]);
  }
}

std::size_t caption_columns(int width) {
  return static_cast<std::size_t>(std::max(0.0f, static_cast<float>(width) / font().advance));
}

}  // namespace heckbert::report
