#include <heckbert/report/caption.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <stb/stb_easy_font.h>

namespace heckbert::report {
namespace {

/// One '?' for every character, not byte, that the font does not have.
std::string printable(std::string_view utf8) {
  std::string ascii;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0) == 0x80;
    if (!continues) ascii += byte >= 32 && byte < 127 ? c : '?';
  }
  return ascii;
}

/// A corner of a quad as stb_easy_font writes it.
struct Vertex {
  float x, y, z;
  std::array<unsigned char, 4> colour;
};

void fill(Picture& picture, int x0, int y0, int x1, int y1, Colour colour) {
  for (int y = std::max(y0, 0); y < std::min(y1, picture.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x1, picture.width); ++x)
      std::copy(colour.begin(), colour.end(), picture.rgb.begin() + 3 * (std::ptrdiff_t{y} * picture.width + x));
}

}  // namespace

void draw_caption(Picture& picture, int x, int y, std::string_view text, Colour colour) {
  constexpr std::size_t kBytesPerLetter = 1024;  // no letter has more than 16 strokes of four corners
  std::string ascii = printable(text);
  std::vector<Vertex> corners((ascii.size() + 1) * kBytesPerLetter / sizeof(Vertex));
  const int quads = stb_easy_font_print(0, 0, ascii.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(Vertex)));
  const auto pixel = [](float unit) { return static_cast<int>(std::lround(unit * kCaptionScale)); };
  for (std::size_t quad = 0; quad < static_cast<std::size_t>(quads); ++quad) {
    const Vertex &low = corners[4 * quad], &high = corners[4 * quad + 2];
    fill(picture, x + pixel(low.x), y + pixel(low.y), x + pixel(high.x), y + pixel(high.y), colour);
  }
}

int caption_width(std::string_view text) {
  std::string ascii = printable(text);
  return kCaptionScale * stb_easy_font_width(ascii.data());
}

std::string fitted_caption(std::string_view text, int width) {
  std::string ascii = printable(text);
  if (caption_width(ascii) <= width) return ascii;
  while (!ascii.empty() && caption_width(ascii + "...") > width) ascii.pop_back();
  return ascii + "...";
}

}  // namespace heckbert::report
