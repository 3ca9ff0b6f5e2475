#pragma once
// The text of an expression and the errors found in it so far. The expression may be a part of a larger document (a
// value in a grammar file): errors are placed in the document.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/error_codes.h>

namespace heckbert::taxonomy {

struct ExpressionSource {
  std::string_view name;      ///< of the document, for errors
  std::string_view document;  ///< offsets count from its beginning
  std::size_t begin = 0;      ///< the expression is [begin, end)
  std::size_t end = 0;
  std::vector<Diagnostic> errors;

  /// A text that is garbage has an error in every character, and each error shows the text.
  static constexpr std::size_t kMostErrors = 100;

  void report(ErrorCode code, std::size_t offset, std::size_t length,
              std::initializer_list<std::string_view> values = {}, std::string suggestion = {}) {
    if (errors.size() > kMostErrors) return;
    if (errors.size() == kMostErrors)
      errors.push_back(
          heckbert::diagnose(name, document, offset, length, "too many errors; what follows here is not listed"));
    else
      errors.push_back(diagnose(code, name, document, offset, length, values, std::move(suggestion)));
  }
  std::string text(std::size_t offset, std::size_t length) const {
    return std::string(document.substr(offset, length));
  }
};

}  // namespace heckbert::taxonomy
