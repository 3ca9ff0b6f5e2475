#pragma once
// From contributions to a record. Each tracing thread has a TileRecorder, the sink of one tile at a time; finished
// tiles go to the Assembler, which adds them up in the order of their numbers whatever order they finish in, so that
// the same seed gives the same bytes for any number of threads (design decision 7).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/record/record.h>
#include <heckbert/record/sample_map.h>

namespace heckbert::record {

/// Sums of one word, batch by batch: r, g, b.
using BatchSums = std::array<double, std::size_t{3} * kBatches>;

/// What one tile leaves: its pixels' entries and its words' batch sums, words by index into a list of its own.
struct Tile {
  Window window;
  std::vector<taxonomy::Word> words;  ///< sorted, distinct
  std::vector<std::size_t> offsets;   ///< as in Record, for the tile's own window
  std::vector<Entry> entries;         ///< energy is the mean over the samples taken; within a pixel sorted by word
  std::vector<BatchSums> batch_sums;  ///< by word: sums over the tile's pixels and each batch's samples
  std::vector<Rgb> ambient, phantom;  ///< empty when never added
  Tally tally;
};

/// Reused for tile after tile. Each add() costs two small sums at a place found by the trie node: no hashing, and no
/// allocation once the words of the scene have been seen.
class TileRecorder final : public PathSink {
 public:
  /// With a map, each sample number of a pixel comes as often as the map says; all of them count the same.
  explicit TileRecorder(const RenderInfo& info, const SampleMap* sample_map = nullptr);
  void begin_tile(const Window& window);
  /// Call after the last sample of the tile. Pixels without samples have no entries.
  Tile end_tile();

  void begin_sample(int x, int y, int sample) override;
  void add(const Contribution& contribution) override;
  void add(std::span<const Contribution> contributions) override;
  void add_non_path(NonPath buffer, Rgb value) override;
  void end_path(PathEnd end) override;
  void add_cut_off(Rgb value) override;

 private:
  static constexpr std::uint32_t kNoWord = std::numeric_limits<std::uint32_t>::max();

  /// What the current pixel has from one word, and the number of that word in the current tile.
  struct Slot {
    double r = 0, g = 0, b = 0;
    std::uint32_t count = 0;
    std::uint32_t tile_word = kNoWord;
  };
  /// The current tile's entries of one pixel: [first, last) of entries_.
  struct Range {
    std::uint32_t first = 0, last = 0;
  };

  bool accept(Rgb value);
  void enlist(taxonomy::WordTrie::Node node, Slot& slot);
  void finish_pixel();

  int samples_per_pixel_ = 0;
  const SampleMap* sample_map_ = nullptr;
  double mean_repeats_ = 1;
  Tile tile_;                                          ///< window, tally and non-path light of the current tile
  std::vector<Slot> slots_;                            ///< by trie node
  std::vector<taxonomy::WordTrie::Node> pixel_nodes_;  ///< words of the current pixel
  std::vector<taxonomy::WordTrie::Node> tile_nodes_;   ///< words of the current tile, in the order they were met
  std::vector<BatchSums> batch_sums_;                  ///< by number in the current tile
  std::vector<Entry> entries_;                         ///< in the order of the tracer's pixels, words by tile number
  std::vector<Range> pixels_;                          ///< row by row over the tile
  std::size_t pixel_ = 0;                              ///< index of the current pixel in the tile
  int x_ = 0, y_ = 0;
  int pixel_samples_ = 0;    ///< 0: no pixel begun
  std::size_t batch_ = 0;    ///< of the current sample, as an offset into BatchSums
  double batch_weight_ = 1;  ///< of the current pixel's samples in their batches: one over their repeats
};

/// Thread-safe: tiles may be submitted from any thread in any order.
class Assembler {
 public:
  explicit Assembler(RenderInfo info);
  /// `number` counts the tiles from 0 in a fixed order. Windows of different tiles do not overlap.
  /// Errors: std::logic_error when the number was submitted before or the tile breaks its own contract.
  void submit(std::size_t number, Tile tile);
  /// The record of all submitted tiles; numbers never submitted leave their pixels empty, and `partial` says so in the
  /// record's info. Sorts words, drops none. Call once, after all submits. Cost: O(entries).
  Record finish(bool partial);

 private:
  void merge(Tile tile);

  RenderInfo info_;
  std::mutex mutex_;
  std::map<std::size_t, Tile> waiting_;          ///< tiles that came before one of a lower number
  std::size_t next_ = 0;                         ///< number of the next tile to merge
  std::vector<Tile> merged_;                     ///< without words and batch sums; entries by number in ids_
  std::map<taxonomy::Word, std::uint32_t> ids_;  ///< numbered in the order of merging
  std::vector<BatchSums> batch_sums_;            ///< by number in ids_
};

}  // namespace heckbert::record
