#include <heckbert/import/radiance_image.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfTestFile.h>

// Only this file sees this copy of the reader.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#include <stb/stb_image.h>

#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
  throw ReadError("cannot read '" + path.string() + "': " + reason);
}

void require_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > kMostPixels / height) {
    refuse(path, "it has " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
  }
}

/// The channels that hold red, green and blue.
std::optional<std::array<std::string, 3>> colour_channels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  if (has("R") && has("G") && has("B")) {
    return {{"R", "G", "B"}};
  }
  if (has("Y")) {
    return {{"Y", "Y", "Y"}};
  }
  auto only = channels.begin();
  if (only == channels.end()) {
    return {};
  }
  const std::string name = only.name();
  if (++only != channels.end()) {
    return {};
  }
  return {{name, name, name}};
}

RadianceImage read_exr(const std::filesystem::path& path) {
  try {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1,
                       height = std::int64_t{box.max.y} - box.min.y + 1;
    require_size(path, width, height);
    const auto names = colour_channels(file.header().channels());
    if (!names) {
      refuse(path, "it has neither the channels R, G and B nor Y");
    }
    RadianceImage image{static_cast<int>(width), static_cast<int>(height), {}};
    const auto count = static_cast<std::size_t>(width * height);
    // One plane per colour, since one channel may fill all three.
    std::array<std::vector<float>, 3> planes;
    for (std::size_t i = 0; i < 3; ++i) {
      planes[i].resize(count);
      Imf::FrameBuffer frame;
      frame.insert((*names)[i], Imf::Slice::Make(Imf::FLOAT, planes[i].data(), box, sizeof(float),
                                                 static_cast<std::size_t>(width) * sizeof(float)));
      file.setFrameBuffer(frame);
      file.readPixels(box.min.y, box.max.y);
    }
    for (std::size_t i = 0; i < count; ++i) {
      image.pixels.emplace_back(planes[0][i], planes[1][i], planes[2][i]);
    }
    return image;
  } catch (const ReadError&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, error.what());
  }
}

RadianceImage read_hdr(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  if (stbi_info(path.c_str(), &width, &height, &channels) == 0) {
    refuse(path, "it is neither Radiance HDR nor OpenEXR");
  }
  require_size(path, width, height);
  const std::unique_ptr<float, decltype(&std::free)> data(stbi_loadf(path.c_str(), &width, &height, &channels, 3),
                                                          &std::free);
  if (data == nullptr) {
    refuse(path, stbi_failure_reason());
  }
  RadianceImage image{width, height, {}};
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < count; ++i) {
    const float* rgb = data.get() + 3 * i;
    image.pixels.emplace_back(rgb[0], rgb[1], rgb[2]);
  }
  return image;
}

}  // namespace

RadianceImage read_radiance_image(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    refuse(path, error ? error.message() : "it is no file");
  }
  RadianceImage image = Imf::isOpenExrFile(path.c_str()) ? read_exr(path) : read_hdr(path);
  const auto clean = [](float value) { return std::isfinite(value) && value > 0 ? value : 0.0f; };
  for (Rgb& pixel : image.pixels) {
    pixel = {clean(pixel.r), clean(pixel.g), clean(pixel.b)};
  }
  return image;
}

}  // namespace heckbert::import
