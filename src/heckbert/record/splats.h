#pragma once
// What walks from the light bring to the picture: each contribution lands at whatever pixel it is seen in, not at that
// of the sample under way. One thread's splats are kept as they come, and become a tile of the picture without samples
// of its own: tiles add up exactly (sums.h), so it does not matter which thread a splat came from, nor how many tiles
// they were made into. Kept so, a splat takes 20 bytes; in a table by pixel and word it would take more than a hundred,
// and few are for the same place as another before memory has to be freed.

#include <cstddef>
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
  /// Memory that the splats take, nearly.
  std::size_t bytes() const;
  /// `pixel` counts row by row over the window that tile() gets. Takes: light as RgbSum takes it.
  void add(std::size_t pixel, taxonomy::WordTrie::Node word, std::size_t batch, Rgb light);
  /// What takes time before tile(), for callers that let others wait during that. Takes: that no add() comes between.
  void sort(const taxonomy::WordTrie& words);
  /// All of them, which are then forgotten. Takes: that they are sorted, and a window that has pixels for all.
  Tile tile(const Window& window);

 private:
  struct Splat {
    std::uint32_t pixel, word;  ///< a node, once sorted the place in words_
    Rgb light;
  };
  struct Found {
    RgbSum sum;
    std::uint64_t count = 0;
  };

  std::vector<Splat> splats_;
  std::unordered_map<std::uint64_t, Found> batches_;                    ///< by word, a node, and batch
  std::vector<taxonomy::Word> words_;                                   ///< of sorted splats
  std::unordered_map<taxonomy::WordTrie::Node, std::uint32_t> places_;  ///< in words_
};

}  // namespace heckbert::record
