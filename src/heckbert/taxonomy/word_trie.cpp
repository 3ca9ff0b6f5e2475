#include <heckbert/taxonomy/word_trie.h>

#include <cassert>

namespace heckbert::taxonomy {

WordTrie::WordTrie() {
  nodes_.push_back({.letter = Symbol::Ep});
  nodes_.push_back({.letter = Symbol::El});
}

WordTrie::Node WordTrie::eye(Symbol eye_kind) const {
  assert(is_eye(eye_kind));
  return eye_kind == Symbol::Ep ? 0 : 1;
}

Word WordTrie::word(Node finished) const {
  assert(is_light(nodes_[finished].letter));
  Word word;
  word.light = nodes_[finished].letter;
  Node node = nodes_[finished].parent;
  for (; !is_eye(nodes_[node].letter); node = nodes_[node].parent) word.events.push_back(nodes_[node].letter);
  word.eye = nodes_[node].letter;
  return word;
}

WordTrie::Node WordTrie::grow(Node node, Symbol letter) {
  assert(!is_eye(letter) && !is_light(nodes_[node].letter));
  const auto child = static_cast<Node>(nodes_.size());
  nodes_[node].child[index(letter)] = child;
  nodes_.push_back({.parent = node, .letter = letter});
  return child;
}

}  // namespace heckbert::taxonomy
