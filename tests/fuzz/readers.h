#pragma once
// What all fuzz targets do: read a text, and accept exactly the errors that a reader may give.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <heckbert/taxonomy/error.h>

namespace heckbert::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Aborts when `read` throws anything but the user's errors, or an error that says nothing or points beside the text.
template <class Read>
void expect_answer(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    if (error.diagnostics().empty()) std::abort();
    for (const Diagnostic& d : error.diagnostics())
      if (d.message.empty() || (d.line != 0 && (d.column == 0 || d.length == 0))) std::abort();
  } catch (const LimitError&) {
    // A budget was exceeded, within the time that libFuzzer is told.
  }
}

}  // namespace heckbert::fuzz
