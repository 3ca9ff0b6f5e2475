#pragma once
// From contributions to a record. Each tracing thread has a TileRecorder, the sink of one tile at a time; finished
// tiles go to the Assembler, in any order. Sums are whole numbers (sum.h), so the same seed gives the same bytes for
// any number of threads (design decision 7) and the parts of a picture add up to the whole.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/record/record.h>
#include <heckbert/record/sample_map.h>
#include <heckbert/record/splats.h>

namespace heckbert::record {

/// What was found of one word at one pixel.
struct EntrySum {
  std::uint32_t word = 0;   ///< index into Tile::words
  std::uint32_t count = 0;  ///< contributions
  RgbSum sum;               ///< over the pixel's samples
  bool operator==(const EntrySum&) const = default;
};

/// What was found of one word in one batch.
struct BatchSum {
  std::uint32_t word = 0;   ///< index into Tile::words
  std::uint32_t batch = 0;  ///< below kBatches
  std::uint64_t count = 0;  ///< contributions
  RgbSum sum;               ///< over the tile's pixels and the batch's samples
  bool operator==(const BatchSum&) const = default;
};

/// A rectangle of a record as sums, before anything is divided or rounded: tiles of the same pixels add up. This is the
/// form in which parts of a render meet; a whole picture can be one tile.
struct Tile {
  Window window;
  std::vector<taxonomy::Word> words;     ///< sorted, distinct
  std::vector<std::uint32_t> samples;    ///< taken, by pixel of the window, row by row
  std::vector<std::size_t> offsets;      ///< as in Record, for the tile's own window
  std::vector<EntrySum> entries;         ///< within a pixel sorted by word
  std::vector<BatchSum> batch_sums;      ///< sorted by word, then batch; those without contributions are left out
  std::vector<RgbSum> ambient, phantom;  ///< non-path light by pixel; empty when never added
  Tally tally;
  bool operator==(const Tile&) const = default;
};

/// Reused for tile after tile. Each add() costs two small sums at a place found by the trie node: no hashing, and no
/// allocation once the words of the scene have been seen.
class TileRecorder final : public PathSink {
 public:
  /// `info` is of one render or of a part of one. With a map, each sample number of a pixel comes as often as the map
  /// says; all of them count the same.
  explicit TileRecorder(const RenderInfo& info, const SampleMap* sample_map = nullptr);
  void begin_tile(const Window& window);
  /// Call after the last sample of the tile. Pixels without samples have no entries.
  Tile end_tile();
  /// All splats since the last time, as a tile of the picture's window that has no samples. First they are sorted,
  /// which others need not wait for.
  void sort_splats();
  Tile end_splats();
  /// Memory that they take, nearly.
  std::size_t splat_bytes() const { return splats_.bytes(); }

  void begin_sample(int x, int y, int sample) override;
  void add(const Contribution& contribution) override;
  void add(std::span<const Contribution> contributions) override;
  /// Pixels outside of the picture's window get nothing. Takes no sample map.
  void splat(int x, int y, const Contribution& contribution) override;
  void add_non_path(NonPath buffer, Rgb value) override;
  void end_path(PathEnd end) override;
  void add_cut_off(Rgb value) override;

 private:
  static constexpr std::uint32_t kNoWord = std::numeric_limits<std::uint32_t>::max();

  /// What the current pixel has from one word, and the number of that word in the current tile.
  struct Slot {
    RgbSum sum;
    std::uint32_t count = 0;
    std::uint32_t tile_word = kNoWord;
  };
  /// The current tile's entries of one pixel: [first, last) of entries_.
  struct Range {
    std::uint32_t first = 0, last = 0;
  };

  /// What of one word has been found in one batch of the current tile.
  struct Found {
    RgbSum sum;
    std::uint64_t count = 0;
  };

  bool accept(Rgb value);
  /// `value` as it is added; counts what that loses.
  RgbSum sum_of(Rgb& value);
  void enlist(taxonomy::WordTrie::Node node, Slot& slot);
  void finish_pixel();

  Window window_;                 ///< of the picture
  int samples_of_the_whole_ = 0;  ///< per pixel, of which this recorder may get a part
  const SampleMap* sample_map_ = nullptr;
  float mean_repeats_ = 1;
  Tile tile_;                                          ///< window, tally and non-path light of the current tile
  std::vector<Slot> slots_;                            ///< by trie node
  std::vector<taxonomy::WordTrie::Node> pixel_nodes_;  ///< words of the current pixel
  std::vector<taxonomy::WordTrie::Node> tile_nodes_;   ///< words of the current tile, in the order they were met
  std::vector<std::array<Found, kBatches>> batches_;   ///< by number in the current tile
  std::vector<EntrySum> entries_;                      ///< in the order of the tracer's pixels, words by tile number
  std::vector<Range> pixels_;                          ///< row by row over the tile
  std::size_t pixel_ = 0;                              ///< index of the current pixel in the tile
  int x_ = 0, y_ = 0;
  int pixel_samples_ = 0;   ///< 0: no pixel begun
  std::size_t batch_ = 0;   ///< of the current sample
  float batch_weight_ = 1;  ///< of the current pixel's samples in their batches: one over their repeats
  Splats splats_;           ///< of all tiles since end_splats()
};

class WordSums;

/// Thread-safe: tiles may be submitted from any thread in any order.
class Assembler {
 public:
  explicit Assembler(RenderInfo info);
  ~Assembler();
  /// Windows of different tiles do not overlap. Errors: std::logic_error when the tile breaks its own contract.
  void submit(Tile tile);
  /// The record of all submitted tiles; pixels of none stay empty, and `partial` says so in the record's info. Sorts
  /// words, drops none. Call once, after all submits. Cost: O(entries). Errors: std::logic_error when tiles overlap.
  Record finish(bool partial);

 private:
  RenderInfo info_;
  std::mutex mutex_;
  std::vector<Tile> tiles_;  ///< without words and batch sums; entries by number in words_
  std::unique_ptr<WordSums> words_;
};

}  // namespace heckbert::record
