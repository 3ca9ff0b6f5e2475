#pragma once
// Records that are added up: the parts of a render that several machines share, renders of one scene with different
// seeds, and what an interrupted render had done. They meet as sums, before anything is divided or rounded, and sums
// are whole numbers (sum.h): any order and any grouping of additions gives the same record, bit for bit, and the parts
// of a render give the record of the whole.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/recorder.h>

namespace heckbert::record {

/// A record whose sums are still sums.
struct Sums {
  RenderInfo info;
  Tile tile;  ///< of the whole window
  bool operator==(const Sums&) const = default;
};

/// Records that do not belong together. The message names what differs, and both values.
class MergeError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MergeError unless both are of the same scene, picture, depth, algorithm, sampler, filter and version.
void check_alike(const RenderInfo& a, const RenderInfo& b);

/// The samples of both, as united() lists them. Errors: MergeError when they have some in common.
std::vector<SampleRange> samples_of_both(const RenderInfo& a, const RenderInfo& b);

/// The tiles of a window as one; what several of them have of a pixel is added up. Cost: O(entries).
/// Errors: std::overflow_error, see added_counts().
Tile added(const Window& window, std::vector<Tile> tiles);

/// What all samples of both are of, but for whether that is partial. Errors: MergeError when they are not alike or have
/// samples in common.
RenderInfo info_of_both(const RenderInfo& a, const RenderInfo& b);
/// The sum of tiles of one window, without offsets and entries, which `tiles` need not have. `places` gets, for each
/// tile and each of its words, the place among all words.
Tile added_totals(const Window& window, const std::vector<Tile>& tiles,
                  std::vector<std::vector<std::uint32_t>>& places);
/// Whether a pixel has less samples than the render.
bool is_partial(const RenderInfo& info, const Tile& tile);

/// All samples of both. Errors: as info_of_both().
Sums merged(Sums a, Sums b);

/// "" or why the samples of both may be the same ones although their ranges say nothing of it.
std::string doubt_of(const RenderInfo& a, const RenderInfo& b);

/// The means. Cost: O(entries).
Record record_of(Sums sums);

/// Sorts the entries from `first` on by word and adds up those of the same word.
void add_up_equals(std::vector<EntrySum>& entries, std::size_t first);

/// a + b. Errors: std::overflow_error when an Entry cannot count that far.
std::uint32_t added_counts(std::uint32_t a, std::uint32_t b);

}  // namespace heckbert::record
