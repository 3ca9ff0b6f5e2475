#pragma once
// A Cryptomatte of path classes, so that a compositor picks a class of paths by clicking on the picture: per pixel the
// classes by the share of the pixel's energy that they carry, most first, each as a pair of an id and that share. An id
// is a hash of the class's name, and a manifest in the header gives the names back. Source: Friedman and Jones, "Fully
// automatic ID mattes with support for motion blur and transparency" (2015), and the specification that came of it,
// version 1.2.0 (github.com/Psyop/Cryptomatte).

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/file.h>
#include <heckbert/record/record.h>
#include <heckbert/record/rows.h>

namespace heckbert::report {

/// A partition of a record's words, or of some of them, into named classes.
struct PathClasses {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::string> names;    ///< distinct
  std::vector<std::size_t> of_word;  ///< by word of the record: its class, or kNone
};

/// Every word is a class, by its plain letters.
PathClasses classes_by_word(const record::Record& record);
/// A word belongs to the first set that has it; sets are by word of the record.
PathClasses classes_by_set(std::vector<std::string> names, const std::vector<std::vector<bool>>& sets);

/// Ranks of a pixel, two in each layer; what comes after is left out.
inline constexpr std::size_t kCryptomatteRanks = 8;

/// Layers "<name>00", "<name>01" ... and the metadata, for write_layers(). The share of words without a class has no
/// id. Energy is luminance. Takes: the picture's window, and its pixels as `rows` shows them. Cost: O(entries).
record::Attachment cryptomatte(const record::Window& window, const record::Rows& rows, const PathClasses& classes,
                               std::string_view name = "PathClass");

/// MurmurHash3_32 with seed 0 (A. Appleby, public domain).
std::uint32_t murmur3(std::string_view text);
/// The hash of a name as the id of the specification: its bits made those of a finite, normal float.
float cryptomatte_id(std::string_view name);

}  // namespace heckbert::report
