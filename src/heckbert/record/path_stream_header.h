#pragma once
// The lines of text that a path stream begins with. Private to the layer.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/symbol.h>

namespace heckbert::record {

/// A stream line by line, and what is wrong with the lines.
class StreamLines {
 public:
  StreamLines(std::istream& stream, std::string source) : stream_(stream), source_(std::move(source)) {}

  /// Reads the next line that is neither empty nor a comment; false at the end.
  bool next();
  const std::string& text() const { return text_; }  ///< without its newline
  std::uint64_t bytes() const { return bytes_; }     ///< read so far

  /// Notes an error about [offset, offset + length) of the line; throws InputError when there are many.
  void refuse(std::size_t offset, std::size_t length, std::string message, std::string suggestion = {});
  /// Notes an error that has a place within the line, at `offset` of which its text begins.
  void refuse(std::size_t offset, const InputError& error);
  /// Throws InputError if there are errors.
  void check() const;

 private:
  void note(Diagnostic diagnostic);

  std::istream& stream_;
  std::string source_, text_;
  std::size_t number_ = 0;
  std::uint64_t bytes_ = 0;
  std::vector<Diagnostic> errors_;
};

/// A piece of a line between blanks; blanks within the quotes of a label separate nothing.
struct StreamField {
  std::string_view text;
  std::size_t offset = 0;
};
std::vector<StreamField> fields_of(std::string_view line);

enum class PathStreamEncoding : std::uint8_t { Text, Binary };

struct PathStreamHeader {
  PathStreamEncoding encoding = PathStreamEncoding::Text;
  RenderInfo info;                                ///< max_depth below zero: not told
  taxonomy::Symbol light = taxonomy::Symbol::La;  ///< of words that say no more than L
  taxonomy::Symbol eye = taxonomy::Symbol::Ep;    ///< of words that say no more than E
};

/// Reads the lines up to and with "paths". Errors: InputError with all that is wrong with them.
PathStreamHeader read_path_stream_header(StreamLines& lines);

}  // namespace heckbert::record
