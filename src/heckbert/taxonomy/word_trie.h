#pragma once
// While tracing, a word is one integer: a node of this trie. The tracer starts at the node of its eye, takes one step
// per event and one last step when the path reaches a light; equal words end at equal nodes. The trie grows as paths
// are found and has no bound on the length of a word (design decision 3). It stores the walk from the eye; word()
// turns it round.
//
// Not thread-safe: each tracing thread owns one.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <heckbert/taxonomy/word.h>

namespace heckbert::taxonomy {

class WordTrie {
 public:
  using Node = std::uint32_t;

  WordTrie();

  Node eye(Symbol eye_kind) const;  ///< the empty path at this eye
  /// The node one letter further from the eye: an event goes on, a light finishes the word. O(1), may allocate.
  Node step(Node node, Symbol letter) {
    const std::uint32_t child = nodes_[node].child[index(letter)];
    return child != 0 ? child : grow(node, letter);
  }
  Word word(Node finished) const;                     ///< the word that ended here, light -> eye
  std::size_t size() const { return nodes_.size(); }  ///< nodes are 0 .. size()-1

 private:
  struct NodeData {
    std::uint32_t parent = 0;
    Symbol letter = Symbol::Ep;
    std::array<std::uint32_t, kSymbolCount - 2> child{};  ///< by light or event; 0: none yet (node 0 is a root)
  };
  Node grow(Node node, Symbol letter);
  std::vector<NodeData> nodes_;
};

}  // namespace heckbert::taxonomy
