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

double share_of(std::string_view text) {
  const bool is_percent = text.ends_with('%');
  const std::string_view digits = is_percent ? text.substr(0, text.size() - 1) : text;
  double value = -1;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (is_percent) value /= 100;
  if (error != std::errc{} || end != digits.data() + digits.size() || !(value >= 0 && value <= 1))
    throw BadValue(fmt::format("'{}' is no share; expected a number from 0 to 1, or per cent such as 95%", text));
  return value;
}

record::Window parse_window(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 4) throw BadValue(fmt::format("'{}' is no window; expected X0,Y0,X1,Y1 in pixels", text));
  const auto place = [](const std::string& part) { return static_cast<int>(whole_number(part, 0, kMaxSize)); };
  const record::Window window{place(parts[0]), place(parts[1]), place(parts[2]), place(parts[3])};
  if (window.x1 <= window.x0 || window.y1 <= window.y0)
    throw BadValue(fmt::format("'{}' is an empty window; X1 must exceed X0 and Y1 must exceed Y0", text));
  return window;
}

record::Window parse_pixel(const std::string& text, const record::Window& all) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2) throw BadValue(fmt::format("'{}' is no pixel; expected X,Y", text));
  const auto place = [](const std::string& part, int low, int high) {
    return static_cast<int>(whole_number(part, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high - 1)));
  };
  const int x = place(parts[0], all.x0, all.x1), y = place(parts[1], all.y0, all.y1);
  return {x, y, x + 1, y + 1};
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
