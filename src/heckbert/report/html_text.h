#pragma once
// What goes into an HTML page: text made harmless and bytes made text.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace heckbert::report {

/// Text for element content and for quoted attributes.
std::string escaped(std::string_view text);

/// RFC 4648, with padding.
std::string base64(std::span<const std::byte> bytes);

}  // namespace heckbert::report
