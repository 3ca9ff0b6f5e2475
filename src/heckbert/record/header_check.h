#pragma once
// Headers of OpenEXR files before OpenEXR reads them. Private to the layer.

#include <cstdint>
#include <istream>

namespace heckbert::record::exr {

/// Every attribute says how many bytes its value has, and values hold further sizes. OpenEXR allocates what they say
/// before it reads, and for most types does not compare them, so that a few damaged bytes can ask for gigabytes. This
/// reads over all attributes of all headers, from the beginning of the file, and checks that their sizes fit the file,
/// their types and one another. Errors: std::runtime_error with the reason.
/// Source: "OpenEXR File Layout", openexr.com.
void check_headers(std::istream& in, std::uint64_t file_bytes);

}  // namespace heckbert::record::exr
