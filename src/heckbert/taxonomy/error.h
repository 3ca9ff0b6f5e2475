#pragma once
// Errors that the caller can act on. User's text that is wrong throws InputError, which carries every diagnostic found
// in that text, each with its place and a caret under the culprit; a file that cannot be read or written throws
// IoError; a budget that is exceeded throws LimitError naming the culprit. The command line turns them into exit codes.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace heckbert {

/// One thing wrong with one place of a text.
struct Diagnostic {
  std::string source;      ///< file name, or what the text is ("expression", "argument of --lpe")
  std::size_t line = 0;    ///< from 1; 0 when the place is the whole source
  std::size_t column = 0;  ///< from 1, in characters of UTF-8 text
  std::size_t length = 1;  ///< how many characters the carets cover
  std::string excerpt;     ///< the line of text itself, without its newline
  std::string message;     ///< what is wrong, and what was expected
  std::string suggestion;  ///< a phrase printed as it stands, "did you mean 'Sr'?"; empty when there is none
  std::string pointer;     ///< JSON pointer of the culprit; empty outside JSON
  std::string code;        ///< stable name of this error, "HB101"; empty where errors have none
};

/// "file:line:column: error: message [code]", the excerpt, the carets, the suggestion; several lines, each
/// newline-terminated.
std::string format(const Diagnostic& diagnostic);

/// A diagnostic for the characters [offset, offset+length) of `text` (byte offsets; columns count characters).
Diagnostic diagnose(std::string_view source, std::string_view text, std::size_t offset, std::size_t length,
                    std::string message, std::string suggestion = {});

/// The user's text is wrong. what() is all diagnostics formatted.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  explicit InputError(Diagnostic diagnostic) : InputError(std::vector{std::move(diagnostic)}) {}
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A file cannot be opened, read or understood as the kind of file it should be (exit 3).
class ReadError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file cannot be written (exit 5).
class WriteError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A budget was exceeded; the message names the culprit, the limit and how to raise it (exit 4).
class LimitError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The candidate nearest to `given` by edit distance (a swap of neighbours counts one, case counts nothing), or empty
/// when none is near enough to be meant: more than a third of the letters would have to change.
std::string nearest(std::string_view given, const std::vector<std::string>& candidates);

}  // namespace heckbert
