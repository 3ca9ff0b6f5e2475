#include <heckbert/taxonomy/dialect_text.h>

#include <utility>

namespace heckbert::taxonomy {

void DialectText::report(ErrorCode code, std::size_t offset, std::size_t length, Values values,
                         std::string suggestion) {
  source.report(code, offset, length, values, std::move(suggestion));
  tree.is_repairable = false;
}

void DialectText::report(ErrorCode code, std::size_t offset, std::size_t length, Values values, const Edit& edit,
                         std::string suggestion) {
  if (suggestion.empty()) suggestion = edit.replacement.empty() ? "delete it" : did_you_mean(edit.replacement);
  source.report(code, offset, length, values, std::move(suggestion));
  tree.edits.push_back(edit);
}

void DialectText::warn(ErrorCode code, std::size_t offset, std::size_t length) {
  if (tree.warnings.size() < ExpressionSource::kMostErrors)
    tree.warnings.push_back(diagnose(code, source.name, source.document, offset, length));
}

void DialectText::trim() {
  if (dialect.blanks == Blanks::Refused) return;
  while (!at_end() && is_blank(peek())) ++at;
  while (!at_end() && is_blank(source.document[end - 1])) --end;
}

void DialectText::skip_blanks() {
  while (!at_end() && is_blank(peek())) {
    if (dialect.blanks != Blanks::Ignored) report(ErrorCode::BlankRefused, at, 1, {title()}, Edit{at, 1, ""});
    ++at;
  }
}

}  // namespace heckbert::taxonomy
