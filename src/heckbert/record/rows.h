#pragma once
// The pixels of a record, a row at a time: of one in memory, or of a file that is read while its rows are looked at
// (file.h) and never held as a whole. What is asked of pixels is written once, for either.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::record {

struct PixelRow {
  int y = 0;
  std::size_t first_pixel = 0;           ///< index in the window, row by row, of the leftmost one
  std::span<const std::size_t> offsets;  ///< one more than there are pixels; from offsets[0] as the first entry
  std::span<const Entry> entries;        ///< of the whole row

  std::size_t pixel_count() const { return offsets.size() - 1; }
  std::span<const Entry> pixel(std::size_t i) const {
    return entries.subspan(offsets[i] - offsets[0], offsets[i + 1] - offsets[i]);
  }
};

/// Called once for each row, in any order and by several threads at a time: what it finds belongs in a place of the
/// row's own.
using RowVisitor = std::function<void(const PixelRow&)>;
/// Shows all rows of a record. What a visitor or the reading throws is thrown on, once all threads have ended.
using Rows = std::function<void(const RowVisitor&)>;

/// The row of number `row` from the top, as yet without entries. Takes: offsets as in Record, which must outlive it.
PixelRow pixel_row(const Window& window, std::span<const std::size_t> offsets, std::size_t row);

/// Those of a record in memory, which must outlive them.
Rows rows_of(const Record& record);

/// Images of many sets of words, which may overlap, in one pass: at every pixel the sum of the chosen words in the
/// order of the word list. `totals` has the words and the window and needs no pixels. O(entries).
std::vector<Image> images_of(const Record& totals, const Rows& rows, const std::vector<std::vector<bool>>& sets);

}  // namespace heckbert::record
