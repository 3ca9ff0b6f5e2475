#include <heckbert/import/picture_file.h>

#include <cstdio>
#include <memory>
#include <string>

// Only this file sees this copy of the reader.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <heckbert/import/radiance_image.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

transport::Image read_picture(const std::filesystem::path& path, bool srgb) {
  transport::Image image;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  int channels = 0;
  if (file != nullptr && stbi_info_from_file(file.get(), &image.width, &image.height, &channels) != 0) {
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_file(file.get(), &image.width, &image.height, &channels, STBI_rgb_alpha));
    if (pixels == nullptr) {
      throw ReadError("cannot read '" + path.string() + "': " + stbi_failure_reason());
    }
    const std::size_t count = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.bytes.assign(pixels.get(), pixels.get() + count);
    image.srgb = srgb;
    return image;
  }
  const RadianceImage radiance = read_radiance_image(path);
  image.width = radiance.width;
  image.height = radiance.height;
  image.floats.reserve(4 * radiance.pixels.size());
  for (const Rgb& p : radiance.pixels) {
    image.floats.insert(image.floats.end(), {p.r, p.g, p.b, 1.0f});
  }
  return image;
}

}  // namespace heckbert::import
