#pragma once
// The text of a dialect's expression while it is read: where reading is, and what has been found so far. An error that
// has an obvious remedy carries it as an edit.

#include <initializer_list>
#include <string>
#include <string_view>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/dialect_parser.h>

namespace heckbert::taxonomy {

struct DialectText {
  ExpressionSource& source;
  const DialectFacts& dialect;
  std::size_t at = source.begin;  ///< offsets in the document
  std::size_t end = source.end;
  DialectTree tree = {};

  using Values = std::initializer_list<std::string_view>;

  bool at_end() const { return at >= end; }
  /// '\0' behind the end.
  char peek(std::size_t ahead = 0) const { return at + ahead < end ? source.document[at + ahead] : '\0'; }
  std::string title() const { return std::string(dialect.title); }

  void report(ErrorCode code, std::size_t offset, std::size_t length, Values values = {}, std::string suggestion = {});
  /// An error that the edit would mend; without a suggestion, that is the suggestion.
  void report(ErrorCode code, std::size_t offset, std::size_t length, Values values, const Edit& edit,
              std::string suggestion = {});
  void warn(ErrorCode code, std::size_t offset, std::size_t length);

  /// Blanks around the whole, where the dialect has them.
  void trim();
  /// Goes on behind blanks, and reports them where the dialect has none.
  void skip_blanks();
};

}  // namespace heckbert::taxonomy
