#pragma once
// A record that is too large for memory, on its way to its file. The entries of finished tiles are kept, as sums, in
// unnamed temporary files; what stays in memory are words and batches, and four bytes per pixel. OpenEXR wants the
// words before the pixels and the pixels row by row, so the file is written when the last tile is there.
//
// Tiles may overlap, as those of walks from the light do: what they have of a pixel adds up. So that the disk holds a
// few pictures and not all that was ever splatted, overlapping tiles are added up whenever they have become more than
// what had been added up before. A sum is then written again a bounded number of times, on average, however many
// tiles come.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <heckbert/record/recorder.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::record {

class SpooledTiles;

/// Thread-safe as the Assembler is: tiles may be submitted from any thread in any order.
class RecordSpool {
 public:
  /// Overlapping tiles of fewer bytes are not added up.
  static constexpr std::uint64_t kLeastAddedUp = 256 << 20;

  /// With a rule, words that are too many are folded. The temporary files lie beside `target`, where the record will
  /// go; without, nothing but totals is kept. Errors: WriteError.
  RecordSpool(RenderInfo info, const std::optional<std::filesystem::path>& target,
              const std::optional<FoldRule>& rule = {}, std::uint64_t least_added_up = kLeastAddedUp);
  ~RecordSpool();

  /// Errors: WriteError; std::logic_error when the tile breaks its own contract.
  void submit(Tile tile);
  /// All that was submitted so far, partial where pixels have less samples than the render. The spool must outlive it,
  /// and no tile may come while it is looked at; without a target it has no entries. Where words are folded, nothing
  /// can be added to it. Memory of a pass: some rows. Errors of a pass: WriteError.
  SumsStream stream() const;
  bool is_folded() const;

 private:
  class RowReader;

  void keep(Tile& tile, const std::vector<std::uint32_t>& numbers);
  void add_up();

  RenderInfo info_;
  std::optional<std::filesystem::path> target_;
  std::uint64_t least_added_up_;
  std::mutex mutex_;
  std::unique_ptr<WordSums> words_;
  std::unique_ptr<SpooledTiles> added_up_, fresh_;  ///< entries by the numbers of their words
  bool overlap_ = false;                            ///< whether any tiles do
  std::vector<std::uint32_t> samples_;              ///< by pixel
  std::vector<RgbSum> ambient_, phantom_;           ///< as in Tile, of the whole window
};

}  // namespace heckbert::record
