#pragma once
// Paths of another renderer, as a stream that any language can print: a few lines about the render, then a row per
// pixel and word, in any order: pixel, word, colour, number of paths. As text, or as binary with the same header.
// docs/path-stream.md is the reference. A renderer in the same process feeds a PathSink instead (path_sink.h) and gets
// intervals too; a stream tells only sums, so that how much they scatter is unknown.

#include <array>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include <heckbert/record/record.h>

namespace heckbert::record {

/// A word of the header and what follows it; the reader, the documentation and the tests go through this table.
struct PathStreamKey {
  std::string_view name, value;
  bool is_required;
  std::string_view meaning;
};

inline constexpr std::array<PathStreamKey, 9> kPathStreamKeys{{
    {"size", "WIDTH HEIGHT", true, "of the picture, in pixels"},
    {"samples", "N", true, "per pixel: what the colours will be divided by"},
    {"crop", "X0 Y0 X1 Y1", false, "the pixels that were rendered, X1 and Y1 excluded; default: all"},
    {"light", "La|Lp|Ld|Le", false, "what `L` means in a word that says no more; default: La"},
    {"eye", "Ep|El", false, "what `E` means in a word that says no more; default: Ep"},
    {"depth", "N", false, "most scatterings of a path; default: those of the longest word"},
    {"seed", "N", false, "of the random numbers; default: 0"},
    {"scene", "TEXT", false, "its name, for people; the rest of the line; default: another renderer's"},
    {"algorithm", "TEXT", false, "how it was rendered, for people; the rest of the line; default: imported"},
}};

/// The first line of a stream, before its encoding.
inline constexpr std::string_view kPathStreamMagic = "heckbert-paths 1";

/// Reads a stream to its end. `source` names it in errors. Memory: 64 bytes per pair of pixel and word.
/// Errors: InputError with all errors of the header, or of the first lines of text that have any; ReadError with the
/// offset of the byte where a binary stream is torn or wrong.
Record read_path_stream(std::istream& stream, const std::string& source);

}  // namespace heckbert::record
