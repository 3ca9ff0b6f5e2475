#include <heckbert/taxonomy/word_trie.h>

#include <cassert>
#include <utility>

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
  std::vector<std::string> labels{labels_[nodes_[finished].label]};
  Node node = nodes_[finished].parent;
  for (; !is_eye(nodes_[node].letter); node = nodes_[node].parent) {
    word.events.push_back(nodes_[node].letter);
    labels.push_back(labels_[nodes_[node].label]);
  }
  word.eye = nodes_[node].letter;
  word.set_labels(std::move(labels));
  return word;
}

WordTrie::Node WordTrie::grow(Node node, Symbol letter) {
  assert(!is_eye(letter) && !is_light(nodes_[node].letter));
  const auto child = static_cast<Node>(nodes_.size());
  nodes_[node].child[index(letter)] = child;
  nodes_.push_back({.parent = node, .letter = letter});
  return child;
}

WordTrie::Node WordTrie::step_labelled(Node node, Symbol letter, LabelId label) {
  assert(!is_eye(letter) && !is_light(nodes_[node].letter) && label < labels_.size());
  const auto [at, is_new] = labelled_children_.try_emplace({node, label, letter}, static_cast<Node>(nodes_.size()));
  if (is_new) nodes_.push_back({.parent = node, .label = label, .letter = letter});
  return at->second;
}

WordTrie::LabelId WordTrie::label(std::string_view name) {
  if (name.empty()) return kNoLabel;
  if (const auto at = label_ids_.find(name); at != label_ids_.end()) return at->second;
  const auto id = static_cast<LabelId>(labels_.size());
  labels_.emplace_back(name);
  label_ids_.emplace(name, id);
  return id;
}

}  // namespace heckbert::taxonomy
