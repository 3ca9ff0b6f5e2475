#include <heckbert/report/text_table.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace heckbert::report {
namespace {

constexpr std::string_view kGap = "  ";
constexpr std::size_t kLongestBar = 24, kShortestBar = 6;
constexpr std::size_t kNarrowestFlexible = 8;

std::string escape_code(std::string_view code, std::string_view text, const TextStyle& style) {
  return style.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

std::string aligned(std::string_view text, std::size_t width, Align align) {
  return align == Align::Left ? fmt::format("{:<{}}", text, width) : fmt::format("{:>{}}", text, width);
}

/// Blocks down to an eighth of a column, so that small differences show.
std::string bar(double fraction, std::size_t width) {
  constexpr std::array<std::string_view, 8> kEighths{"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  const auto eighths =
      static_cast<std::size_t>(std::lround(std::clamp(fraction, 0.0, 1.0) * 8.0 * static_cast<double>(width)));
  std::string blocks;
  for (std::size_t i = 0; i < eighths / 8; ++i) blocks += "█";
  return blocks + std::string(kEighths[eighths % 8]);
}

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::size_t display_width(std::string_view utf8) {
  // fmt pads by display width; the padding it adds to a field wider than the text tells that width.
  const std::size_t field = utf8.size() + 1;
  return field - (fmt::formatted_size("{:<{}}", utf8, field) - utf8.size());
}

std::string cut(std::string_view utf8, std::size_t width) {
  if (display_width(utf8) <= width) return std::string(utf8);
  constexpr std::string_view kDots = "...";
  if (width <= kDots.size()) return std::string(kDots.substr(0, width));
  return fmt::format("{:.{}}{}", utf8, width - kDots.size(), kDots);
}

std::string wrap(std::string_view utf8, std::size_t width, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string text, line;
  while (!utf8.empty()) {
    const std::size_t end = std::min(utf8.find(' '), utf8.size());
    const std::string_view piece = utf8.substr(0, end);
    utf8.remove_prefix(std::min(end + 1, utf8.size()));
    if (piece.empty()) continue;
    if (!line.empty() && indent + display_width(line) + 1 + display_width(piece) > width) {
      text += margin + line + '\n';
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += piece;
  }
  if (!line.empty()) text += margin + line + '\n';
  return text;
}

std::string bold(std::string_view text, const TextStyle& style) {
  return escape_code("1", text, style);
}
std::string dim(std::string_view text, const TextStyle& style) {
  return escape_code("2", text, style);
}

std::string text_table(const std::vector<TextColumn>& columns, const std::vector<TextRow>& rows,
                       const TextStyle& style) {
  std::vector<std::size_t> widths;
  std::size_t fixed = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::size_t width = display_width(columns[c].title);
    for (const TextRow& row : rows) width = std::max(width, display_width(row.cells[c]));
    widths.push_back(width);
    if (c > 0) fixed += kGap.size() + width;
  }
  if (fixed + widths[0] > style.width)
    widths[0] = std::max(kNarrowestFlexible, style.width - std::min(style.width, fixed));
  const std::size_t table_width = fixed + widths[0];
  const std::size_t room = style.width - std::min(style.width, table_width + kGap.size());
  const bool bars = room >= kShortestBar;

  const auto line_of = [&](const auto& cell) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) line += kGap;
      line += aligned(c == 0 ? cut(cell(c), widths[c]) : cell(c), widths[c], columns[c].align);
    }
    return line;
  };
  std::string text =
      bold(without_trailing_blanks(line_of([&](std::size_t c) { return columns[c].title; })), style) + '\n';
  for (const TextRow& row : rows) {
    std::string line = line_of([&](std::size_t c) { return row.cells[c]; });
    if (bars && row.bar) line += std::string(kGap) + bar(*row.bar, std::min(room, kLongestBar));
    text += without_trailing_blanks(std::move(line)) + '\n';
    for (const std::string& note : row.notes) text += dim("  " + cut(note, style.width - 2), style) + '\n';
  }
  return text;
}

}  // namespace heckbert::report
