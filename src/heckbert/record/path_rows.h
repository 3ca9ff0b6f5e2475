#pragma once
// Sums of paths by pixel and word, in whatever order they come. Private to the layer.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <heckbert/record/recorder.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::record {

class PathRows {
 public:
  using WordId = std::uint32_t;

  explicit PathRows(const Window& window) : window_(window) {}

  /// The number of a word, the same for equal words.
  WordId word(const taxonomy::Word& word);
  /// `sum` over `count` paths of a pixel of the window. What is no light is counted as rejected, never added.
  /// Errors: std::overflow_error when a pixel has more paths of one word than an Entry can count.
  void add(int x, int y, WordId word, Rgb sum, std::uint32_t count);
  /// Call once, at the end. A max_depth below zero becomes that of the longest word. Cost: O(rows log rows).
  Record record(RenderInfo info);

 private:
  struct Row {
    std::size_t pixel = 0;
    WordId word = 0;
    std::uint32_t count = 0;
    RgbSum sum;
  };

  void add_up_equals();

  Window window_;
  Tally tally_;
  std::map<taxonomy::Word, WordId> ids_;
  std::vector<Row> rows_;
  std::size_t distinct_ = 0;  ///< rows when their equals were last added up
};

}  // namespace heckbert::record
