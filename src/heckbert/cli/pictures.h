#pragma once
// Pictures for people: PNG files.

#include <string>

#include <heckbert/record/record.h>
#include <heckbert/report/picture.h>

namespace heckbert::cli {

/// The bytes of a PNG.
std::string png_of(const report::Picture& picture);
std::string png_of(const record::Image& image, float exposure);

}  // namespace heckbert::cli
