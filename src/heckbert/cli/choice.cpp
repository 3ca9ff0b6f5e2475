#include <heckbert/cli/choice.h>

#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {

std::uint64_t whole_number(std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high)
    throw BadValue(fmt::format("'{}' is not a whole number from {} to {}", text, low, high));
  return value;
}

double number_between(std::string_view text, double low, double high) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > low && value < high))
    throw BadValue(fmt::format("'{}' is not a number between {} and {}", text, low, high));
  return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

void refuse_choice(std::string_view text, const std::vector<std::string>& names) {
  const std::string near = nearest(text, names);
  throw BadValue(fmt::format("'{}' is none of {}{}", text, fmt::join(names, ", "),
                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

}  // namespace heckbert::cli
