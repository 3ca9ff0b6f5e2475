#pragma once
// tinyobjloader reads numbers that are none as zero and indices that lead nowhere as they stand. This check of the text
// before it finds them, with their places.

#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>

namespace heckbert::import {

/// Every vertex, normal and face line that is malformed: too few or infinite numbers, faces with less than three
/// corners, indices of nothing. At most 100 diagnostics.
std::vector<Diagnostic> check_obj_text(std::string_view text, std::string_view source);

}  // namespace heckbert::import
