#pragma once
// Going on with a render that was interrupted.

#include <string>
#include <vector>

#include <heckbert/record/sums.h>

namespace heckbert::cli {

/// What a file has of the render that `wanted` describes. Errors: ReadError when it cannot be read, or naming what of
/// the render differs.
record::Sums resumed(const std::string& name, const record::RenderInfo& wanted);

/// By pixel: whether it has its samples already.
std::vector<bool> pixels_done(const record::Sums& begun);

}  // namespace heckbert::cli
