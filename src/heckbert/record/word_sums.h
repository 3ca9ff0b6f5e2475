#pragma once
// What tiles say of the whole picture: its words, their counts and their sums by batch. Tiles come in any order; words
// are numbered as they come, and sorted at the end. Private to the layer.

#include <cstdint>
#include <map>
#include <vector>

#include <heckbert/record/recorder.h>

namespace heckbert::record {

class WordSums {
 public:
  /// Adds the tile's batches and tally; gives the number of each of its words.
  std::vector<std::uint32_t> add(const Tile& tile);
  /// A record with all but its pixels. Sorts words, drops none.
  Record totals(const RenderInfo& info) const;
  /// A tile with all but its pixels.
  Tile tile() const;
  /// By number of a word: its place among the sorted ones.
  std::vector<std::uint32_t> ranks() const;

 private:
  std::map<taxonomy::Word, std::uint32_t> numbers_;
  std::vector<std::vector<BatchSum>> batches_;  ///< by number, sorted by batch
  Tally tally_;
};

/// Throws std::logic_error unless the tile lies inside the window and its lists fit one another.
void check_tile(const Tile& tile, const Window& window);

/// By row of the window: the places in `windows` of those that cross it, from left to right.
/// Errors: std::logic_error when two overlap.
std::vector<std::vector<std::size_t>> windows_by_row(const std::vector<Window>& windows, const Window& window);

}  // namespace heckbert::record
