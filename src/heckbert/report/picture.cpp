#include <heckbert/report/picture.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <png.h>

namespace heckbert::report {
namespace {

constexpr double kMiddleGrey = 0.18;

std::uint8_t srgb_byte(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

}  // namespace

float auto_exposure(const record::Image& image) {
  double log_sum = 0;
  std::size_t lit = 0;
  for (const Rgb& pixel : image.pixels) {
    const float y = luminance(pixel);
    if (y <= 0) continue;
    log_sum += std::log(static_cast<double>(y));
    ++lit;
  }
  if (lit == 0) return 1;
  return static_cast<float>(kMiddleGrey / std::exp(log_sum / static_cast<double>(lit)));
}

Picture to_srgb(const record::Image& image, float exposure) {
  Picture picture{image.window.width(), image.window.height(), {}};
  picture.rgb.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (const float channel : {pixel.r, pixel.g, pixel.b}) picture.rgb.push_back(srgb_byte(exposure * channel));
  return picture;
}

record::Image shrunk(const record::Image& image, int max_width) {
  const int width = image.window.width(), height = image.window.height();
  const int k = (width + max_width - 1) / max_width;
  if (k <= 1) return image;
  record::Image small{{0, 0, (width + k - 1) / k, (height + k - 1) / k}, {}};
  for (int by = 0; by < height; by += k)
    for (int bx = 0; bx < width; bx += k) {
      const int x1 = std::min(bx + k, width), y1 = std::min(by + k, height);
      Rgb sum;
      for (int y = by; y < y1; ++y)
        for (int x = bx; x < x1; ++x) sum += image.at(image.window.x0 + x, image.window.y0 + y);
      small.pixels.push_back(sum / static_cast<float>((x1 - bx) * (y1 - by)));
    }
  return small;
}

std::vector<std::byte> encode_png(const Picture& picture) {
  if (picture.rgb.empty()) throw std::invalid_argument("a picture without pixels cannot be a PNG");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("libpng: ") + image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace heckbert::report
