#pragma once
// A record that is too large for memory, on its way to its file. The entries of finished tiles are kept, as sums, in an
// unnamed temporary file; what stays in memory are words and batches, and eight bytes per pixel. OpenEXR wants the
// words before the pixels and the pixels row by row, so the file is written when the last tile is there.

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <heckbert/record/recorder.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::record {

class SpoolFile;

/// Thread-safe as the Assembler is: tiles may be submitted from any thread in any order.
class RecordSpool {
 public:
  /// With a rule, words that are too many are folded. The temporary file lies beside `target`, where the record will
  /// go; without, nothing but totals is kept. The record will have the precision that `info` says. Errors: WriteError.
  RecordSpool(RenderInfo info, const std::optional<std::filesystem::path>& target,
              const std::optional<FoldRule>& rule = {});
  ~RecordSpool();

  /// Windows of different tiles do not overlap. Errors: WriteError; std::logic_error when the tile breaks its own
  /// contract.
  void submit(const Tile& tile);

  // Call these after all submits.

  /// The record without offsets and entries.
  Record totals(bool partial) const;
  /// Writes what write_record() would write of the same tiles. Takes: a target was given. Memory: some rows. Errors:
  /// WriteError; std::logic_error when tiles overlap.
  void write(const std::filesystem::path& path, bool partial) const;
  bool is_folded() const;
  /// All of it, to be merged or resumed; the spool must outlive it. Takes: a target was given. Where words are folded,
  /// the totals have neither words nor batches, and nothing can be added. Errors of a pass: as write().
  SumsStream stream(bool partial) const;

 private:
  struct Kept {
    std::vector<std::uint32_t> samples;  ///< by pixel
    std::vector<std::uint32_t> counts;   ///< of words, by pixel
    std::uint64_t place = 0;             ///< of its entries in the temporary file
  };
  class RowReader;

  static void read_band(RowReader& reader, SumsBand& band);

  RenderInfo info_;
  std::mutex mutex_;
  std::unique_ptr<WordSums> words_;
  std::unique_ptr<SpoolFile> file_;
  std::vector<Window> windows_;  ///< of the tiles
  std::vector<Kept> tiles_;
  Tally rounding_;                         ///< what half precision cannot hold
  std::vector<std::uint32_t> samples_;     ///< by pixel, where there is non-path light
  std::vector<RgbSum> ambient_, phantom_;  ///< as in Tile, of the whole window
};

}  // namespace heckbert::record
