#include <heckbert/taxonomy/label.h>

#include <heckbert/taxonomy/letter.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

// Control characters would tear a line of text apart; a label has blanks instead.
char printable(char c) {
  return static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
}

}  // namespace

std::optional<QuotedLabel> read_label(std::string_view text, std::size_t at) {
  const char quote = text[at];
  QuotedLabel read;
  for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == quote) {
      read.length = i + 1 - at;
      return read;
    }
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == quote || text[i + 1] == '\\')) ++i;
    read.label += printable(text[i]);
  }
  return std::nullopt;
}

std::string write_label(std::string_view label) {
  std::string text = "'";
  for (const char c : label) {
    if (c == '\'' || c == '\\') text += '\\';
    text += printable(c);
  }
  return text + '\'';
}

std::string name(const Letter& letter) {
  return letter.label.empty() ? name(letter.symbol) : name(letter.symbol) + write_label(letter.label);
}

}  // namespace heckbert::taxonomy
