#include <heckbert/taxonomy/tree_language.h>

#include <algorithm>

namespace heckbert::taxonomy {

namespace {

// Halves first: a chain of n letters costs O(n log n), not O(n^2).
template <class Join>
Language fold(const std::vector<Node>& pieces, std::size_t begin, std::size_t end, Join join) {
  if (end - begin == 1) return language_of(pieces[begin]);
  const std::size_t middle = begin + (end - begin) / 2;
  const Language left = fold(pieces, begin, middle, join);
  return join(left, fold(pieces, middle, end, join));
}

}  // namespace

Language language_of(const Node& tree) {
  switch (tree.kind) {
    case NodeKind::Letters:
      return Language::of(tree.set);
    case NodeKind::Repeat:
      return repeat(language_of(tree.children[0]), tree.at_least, tree.at_most);
    case NodeKind::Alternation:
      return fold(tree.children, 0, tree.children.size(), [](const Language& a, const Language& b) { return a | b; });
    default:  // a sequence
      if (tree.children.empty()) return Language::epsilon();
      return fold(tree.children, 0, tree.children.size(),
                  [](const Language& a, const Language& b) { return concat(a, b); });
  }
}

Node reversed(Node tree) {
  if (tree.kind == NodeKind::Sequence) std::reverse(tree.children.begin(), tree.children.end());
  for (Node& child : tree.children) child = reversed(std::move(child));
  return tree;
}

bool has_kind(const Node& tree, NodeKind kind) {
  return tree.kind == kind || std::any_of(tree.children.begin(), tree.children.end(),
                                          [kind](const Node& child) { return has_kind(child, kind); });
}

bool is_word_tree(const Node& tree) {
  for (const NodeKind kind : {NodeKind::Name, NodeKind::Both, NodeKind::Without, NodeKind::Complement, NodeKind::Bad})
    if (has_kind(tree, kind)) return false;
  return true;
}

}  // namespace heckbert::taxonomy
