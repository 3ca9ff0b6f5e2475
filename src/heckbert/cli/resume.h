#pragma once
// Going on with a render that was interrupted.

#include <string>
#include <vector>

#include <heckbert/record/sums_stream.h>

namespace heckbert::cli {

/// What a file has of the render that `wanted` describes. All of it has been read once: that it is damaged is found
/// before work is done on top of it. Errors: ReadError when it cannot be read, or naming what of the render differs.
record::SumsStream resumed(const std::string& name, const record::RenderInfo& wanted);

/// By pixel: whether it has its samples already.
std::vector<bool> pixels_done(const record::SumsStream& begun);

}  // namespace heckbert::cli
