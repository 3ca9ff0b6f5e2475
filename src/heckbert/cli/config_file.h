#pragma once
// The config file: one setting per line, name = value, the names being those of the long flags; # begins a comment.
// This is the flat part of TOML. CLI11 has a reader of its own, but it knows no line numbers.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {

/// One setting of the file with its places, for errors found later.
struct ConfigEntry {
  std::string name, value;
  std::size_t name_offset = 0;   ///< in bytes from the start of the file's text
  std::size_t value_offset = 0;  ///< of the value without its quotes
};

/// Errors: InputError with all lines that are no settings, unknown names (with suggestions) and names given twice.
std::vector<ConfigEntry> parse_config(std::string_view text, std::string_view source,
                                      const std::vector<std::string>& known_names);

}  // namespace heckbert::cli
