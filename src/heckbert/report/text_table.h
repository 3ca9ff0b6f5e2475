#pragma once
// Tables for a terminal: columns aligned by what the eye sees (UTF-8, wide letters count two), one flexible column that
// gives way when the terminal is narrow, notes under a row, and a bar at the end where there is room for one.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heckbert::report {

struct TextStyle {
  std::size_t width = 80;  ///< columns of the terminal
  bool colour = false;     ///< ANSI escapes: bold titles, dim notes
};

enum class Align : unsigned char { Left, Right };

struct TextColumn {
  std::string title;
  Align align = Align::Left;
};

struct TextRow {
  std::vector<std::string> cells;    ///< one per column
  std::vector<std::string> notes{};  ///< lines under the row, indented; cut at the width
  std::optional<double> bar{};       ///< 0 .. 1
};

/// The first column is the flexible one: it is cut with "..." when the table would be too wide. Every line ends in
/// '\n'.
std::string text_table(const std::vector<TextColumn>& columns, const std::vector<TextRow>& rows,
                       const TextStyle& style);

/// Columns that the text takes on a terminal.
std::size_t display_width(std::string_view utf8);
/// The text itself, or its beginning and "..." when it is wider than `width`.
std::string cut(std::string_view utf8, std::size_t width);
/// The text broken at blanks into lines no wider than `width`, each with the indent; longer pieces stay whole.
std::string wrap(std::string_view utf8, std::size_t width, std::size_t indent = 0);

std::string bold(std::string_view text, const TextStyle& style);
std::string dim(std::string_view text, const TextStyle& style);

}  // namespace heckbert::report
