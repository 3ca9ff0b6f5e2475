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
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <heckbert/taxonomy/word.h>

namespace heckbert::taxonomy {

class WordTrie {
 public:
  using Node = std::uint32_t;
  using LabelId = std::uint32_t;
  static constexpr LabelId kNoLabel = 0;

  WordTrie();

  Node eye(Symbol eye_kind) const;  ///< the empty path at this eye
  /// The node one letter further from the eye: an event goes on, a light finishes the word. O(1), may allocate.
  Node step(Node node, Symbol letter) {
    const std::uint32_t child = nodes_[node].child[index(letter)];
    return child != 0 ? child : grow(node, letter);
  }
  /// The same for a letter with a label; a renderer asks for the labels of its objects once, beforehand.
  Node step(Node node, Symbol letter, LabelId label) {
    return label == kNoLabel ? step(node, letter) : step_labelled(node, letter, label);
  }
  /// The number of a label, the same for the same name; kNoLabel for the empty one. O(log labels), may allocate.
  LabelId label(std::string_view name);
  Word word(Node finished) const;                     ///< the word that ended here, light -> eye
  std::size_t size() const { return nodes_.size(); }  ///< nodes are 0 .. size()-1

 private:
  struct NodeData {
    std::uint32_t parent = 0;
    LabelId label = kNoLabel;
    Symbol letter = Symbol::Ep;
    std::array<std::uint32_t, kSymbolCount - 2>
        child{};  ///< by unlabelled light or event; 0: none yet (node 0 is a root)
  };
  struct LabelledStep {
    Node from;
    LabelId label;
    Symbol letter;
    bool operator==(const LabelledStep&) const = default;
  };
  struct LabelledStepHash {
    std::size_t operator()(const LabelledStep& step) const {
      const std::uint64_t both = std::uint64_t{step.from} << 32 | step.label;
      return static_cast<std::size_t>((both * kSymbolCount + index(step.letter)) * 0x9e3779b97f4a7c15u);
    }
  };
  Node grow(Node node, Symbol letter);
  Node step_labelled(Node node, Symbol letter, LabelId label);

  std::vector<NodeData> nodes_;
  std::unordered_map<LabelledStep, Node, LabelledStepHash> labelled_children_;
  std::map<std::string, LabelId, std::less<>> label_ids_;
  std::vector<std::string> labels_{""};  ///< by LabelId
};

}  // namespace heckbert::taxonomy
