#pragma once
// What walks from the light bring to the picture: each contribution lands at whatever pixel it is seen in, not at that
// of the sample under way. One thread's splats are kept by pixel and word for the whole picture, and become a tile of
// it without samples of its own: tiles add up exactly (sums.h), so it does not matter which thread a splat came from.

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/sum.h>
#include <heckbert/taxonomy/word_trie.h>

namespace heckbert::record {

struct Tile;

class Splats {
 public:
  bool empty() const { return sums_.empty(); }
  /// `pixel` counts row by row over the window that tile() gets.
  void add(std::size_t pixel, taxonomy::WordTrie::Node word, std::size_t batch, const RgbSum& sum);
  /// All of them, which are then forgotten. The window has pixels for all.
  Tile tile(const Window& window, const taxonomy::WordTrie& words);

 private:
  struct Sum {
    RgbSum sum;
    std::uint32_t count = 0;
  };
  struct BatchSums {
    std::array<RgbSum, kBatches> sums{};
    std::array<std::uint64_t, kBatches> counts{};
  };

  std::unordered_map<std::uint64_t, Sum> sums_;  ///< by pixel (upper half) and word
  std::unordered_map<taxonomy::WordTrie::Node, BatchSums> batches_;
};

}  // namespace heckbert::record
