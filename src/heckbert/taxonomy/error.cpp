#include <heckbert/taxonomy/error.h>

#include <algorithm>

#include <heckbert/taxonomy/utf8.h>

namespace heckbert {

namespace {

// A line may be a whole minified file; only this many characters to either side of the culprit are shown.
constexpr std::size_t kContext = 60;

std::string printable(std::string_view line, std::size_t at, const Utf8Character& c) {
  const bool control = (c.code < 0x20 && c.code != '\t') || (c.code >= 0x7F && c.code < 0xA0);
  return !c.valid || control ? "?" : std::string(line.substr(at, c.length));
}

void append_excerpt(std::string& out, const Diagnostic& d) {
  const std::size_t size = utf8_length(d.excerpt), culprit = std::min(d.column - 1, size);
  const std::size_t first = culprit > kContext ? culprit - kContext : 0, last = std::min(size, culprit + kContext);
  std::string text = first > 0 ? "  ..." : "  ";
  std::string carets(text.size(), ' ');
  for (std::size_t at = 0, number = 0; number < last; ++number) {
    const Utf8Character c = utf8_at(d.excerpt, at);
    if (number >= first) text += printable(d.excerpt, at, c);
    if (number >= first && number < culprit) carets += d.excerpt[at] == '\t' ? '\t' : ' ';
    at += c.length;
  }
  if (last < size) text += "...";
  carets.append(std::clamp<std::size_t>(d.length, 1, std::max<std::size_t>(1, last - culprit)), '^');
  out += text + "\n" + carets + "\n";
}

std::string format_all(const std::vector<Diagnostic>& diagnostics) {
  std::string all;
  for (const Diagnostic& d : diagnostics) all += format(d);
  return all;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Optimal string alignment: Levenshtein's distance with swaps of neighbouring letters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::move(last);
    last = std::move(row);
    row.assign(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0u : 1u)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string format(const Diagnostic& d) {
  std::string out = d.source;
  if (d.line > 0) out += ":" + std::to_string(d.line) + ":" + std::to_string(d.column);
  out += ": error: " + d.message;
  if (!d.pointer.empty()) out += " (at " + d.pointer + ")";
  if (!d.code.empty()) out += " [" + d.code + "]";
  out += "\n";
  if (d.line > 0 && d.column > 0) append_excerpt(out, d);
  if (!d.suggestion.empty()) out += "  " + d.suggestion + "\n";
  return out;
}

Diagnostic diagnose(std::string_view source, std::string_view text, std::size_t offset, std::size_t length,
                    std::string message, std::string suggestion) {
  offset = std::min(offset, text.size());
  const std::size_t newline_before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  const std::size_t line_begin = newline_before == std::string_view::npos ? 0 : newline_before + 1;
  std::size_t line_end = std::min(text.find('\n', offset), text.size());
  if (line_end > line_begin && text[line_end - 1] == '\r' && line_end > offset) --line_end;

  Diagnostic d;
  d.source = source;
  d.line = 1 + static_cast<std::size_t>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  d.column = 1 + utf8_length(text.substr(line_begin, offset - line_begin));
  d.length = std::max<std::size_t>(1, utf8_length(text.substr(offset, std::min(length, line_end - offset))));
  d.excerpt = text.substr(line_begin, line_end - line_begin);
  d.message = std::move(message);
  d.suggestion = std::move(suggestion);
  return d;
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(format_all(diagnostics)), diagnostics_(std::move(diagnostics)) {}

std::string nearest(std::string_view given, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, given.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // One letter replaced by another is no likeness: "x" does not mean "y".
    const std::size_t distance = edit_distance(given, candidate);
    if (distance < best_distance && distance < std::max(given.size(), candidate.size())) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace heckbert
