#pragma once
// The algorithms, for help pages.

#include <string>

namespace heckbert::cli {

/// The help of a flag that takes one, and below it a line for each.
std::string with_algorithms(std::string help);

}  // namespace heckbert::cli
