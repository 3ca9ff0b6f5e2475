#pragma once
// Values in texts: numbers, sizes, and one of several names, with messages that say what was expected.

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/cli/exit_code.h>
#include <heckbert/record/record.h>

namespace heckbert::cli {

/// The text is no such value. The message begins with the text in quotes; who asked for it adds where it came from.
class BadValue : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Errors: BadValue.
std::uint64_t whole_number(std::string_view text, std::uint64_t low, std::uint64_t high);
/// A finite number in (low, high). Errors: BadValue.
double number_between(std::string_view text, double low, double high);
/// A number from 0 to 1, or as per cent: "0.95", "95%". Errors: BadValue.
double share_of(std::string_view text);
/// "x0,y0,x1,y1" with x0 < x1 and y0 < y1. Errors: BadValue.
record::Window parse_window(const std::string& text);
/// "X,Y", a pixel of the window, as a window of its own. Errors: BadValue, also for one outside.
record::Window parse_pixel(const std::string& text, const record::Window& all);
/// Pixels of a picture's side, at most.
inline constexpr int kMaxSize = 16'384;
/// "a,b,c" at each separator, nothing trimmed.
std::vector<std::string> split(std::string_view text, char separator);

/// Throws BadValue that lists `names` and suggests the nearest.
[[noreturn]] void refuse_choice(std::string_view text, const std::vector<std::string>& names);

/// The names of a table of facts, in order.
template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

/// The row of a table of facts with this name. Errors: BadValue with a suggestion.
template <class Table>
const auto& choose(std::string_view text, const Table& table) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.name == text; });
  if (row == table.end()) refuse_choice(text, names_of(table));
  return *row;
}

/// What `read` gives. A BadValue becomes a UsageError that names the flag.
template <class Read>
decltype(auto) value_of_flag(std::string_view flag, Read read) {
  try {
    return read();
  } catch (const BadValue& error) {
    throw UsageError(std::string(flag) + ": " + error.what());
  }
}

/// As choose, for the value of a flag. Errors: UsageError.
template <class Table>
const auto& choose_flag(std::string_view flag, std::string_view text, const Table& table) {
  return value_of_flag(
      flag, [&]() -> const auto& { return choose(text, table); });
}

/// "keep|diffuse|specular", for help texts.
template <class Table>
std::string alternatives(const Table& table) {
  std::string all;
  for (const auto& row : table) all += (all.empty() ? "" : "|") + std::string(row.name);
  return all;
}

}  // namespace heckbert::cli
