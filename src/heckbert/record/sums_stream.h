#pragma once
// Sums of a picture that need not fit into memory: all but its entries, and these a band of rows at a time. Parts of a
// render are merged so, each from its file, and so a render that was spooled keeps its sums.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <heckbert/record/rows.h>
#include <heckbert/record/sums.h>

namespace heckbert::record {

/// What was found in some rows of a picture.
struct SumsBand {
  Window window;                      ///< as wide as the picture
  std::vector<std::uint32_t> counts;  ///< of entries, by pixel, row by row
  std::vector<EntrySum> entries;      ///< pixel by pixel, within a pixel sorted by word
};

/// Goes through the entries once. Fills counts and entries of a band whose window is set; the windows follow one
/// another from the top downwards and leave no row out. Errors: those of where the entries come from.
using SumsPass = std::function<void(SumsBand&)>;

struct SumsStream {
  RenderInfo info;
  Tile totals;                      ///< of the whole window, without offsets and entries
  std::function<SumsPass()> begin;  ///< as often as one likes; words are those of `totals`
  /// Where words stand for classes. Nothing can be added to such sums.
  std::optional<Folding> folding{};
};

/// By pixel; black where there are no samples.
std::vector<Rgb> means_of(const std::vector<RgbSum>& sums, const std::vector<std::uint32_t>& samples);

/// Those of a picture in memory, which must outlive it.
SumsStream stream_of(const Sums& sums);

/// All samples of all. Takes: at least one. Memory: their totals, and in each pass a band of each.
/// Errors: MergeError when they are not alike or have samples in common.
SumsStream merged(std::vector<SumsStream> streams);

/// The finished part of a render and the rest of it, as one. Takes: streams of the same samples. Memory: as merged().
SumsStream completed(SumsStream begun, SumsStream rest);

/// All of it in memory.
Sums collected(const SumsStream& stream);

/// The means without their pixels; and those, for which the stream must outlive the rows. Where `precision` is half,
/// the stream is gone through to count what that loses.
Record totals_of(const SumsStream& stream, Precision precision = Precision::Float);
Rows rows_of(const SumsStream& stream);

}  // namespace heckbert::record
