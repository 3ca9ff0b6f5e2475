#pragma once
// Reads a PNG back with libpng, the other half of the tests of what we write.

#include <cstddef>
#include <vector>

#include <heckbert/report/picture.h>

namespace heckbert::report::test {

/// Errors: std::runtime_error when the bytes are no PNG.
Picture decode_png(const std::vector<std::byte>& bytes);

}  // namespace heckbert::report::test
