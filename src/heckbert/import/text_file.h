#pragma once
// A whole file as a string.

#include <filesystem>
#include <string>

namespace heckbert::import {

/// Errors: ReadError with the path and the reason of the system.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace heckbert::import
