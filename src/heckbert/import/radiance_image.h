#pragma once
// Pictures of linear light from files: Radiance HDR, and OpenEXR in every compression that OpenEXR knows.

#include <filesystem>
#include <vector>

#include <heckbert/record/rgb.h>

namespace heckbert::import {

struct RadianceImage {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  ///< row by row from the top; finite and not negative
};

/// The kind of file is told by its content. A grey EXR has its Y, or its only channel, in all three colours. Negative
/// and non-finite values, which compressors and renderers leave behind, become zero.
/// Errors: ReadError with the path and the reason.
RadianceImage read_radiance_image(const std::filesystem::path& path);

}  // namespace heckbert::import
