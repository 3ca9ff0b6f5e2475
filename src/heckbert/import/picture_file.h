#pragma once
// Pictures from files as textures: PNG, JPEG, BMP and TGA as bytes; Radiance HDR and OpenEXR as floats.

#include <filesystem>

#include <heckbert/transport/scene.h>

namespace heckbert::import {

/// The kind of file is told by its content. `srgb` says whether the colours of bytes follow the sRGB curve; floats are
/// linear. A picture without opacity is opaque.
/// Errors: ReadError with the path and the reason.
transport::Image read_picture(const std::filesystem::path& path, bool srgb);

}  // namespace heckbert::import
