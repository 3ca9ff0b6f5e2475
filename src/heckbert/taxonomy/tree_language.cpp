#include <heckbert/taxonomy/tree_language.h>

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/error_codes.h>
#include <heckbert/taxonomy/joins.h>

namespace heckbert::taxonomy {

namespace {

struct InSomeOrder {
  bool operator()(const LetterSet& a, const LetterSet& b) const {
    const auto before = [](const LetterSet::OfLabel& x, const LetterSet::OfLabel& y) {
      return std::tie(x.label, x.symbols) < std::tie(y.label, y.symbols);
    };
    if (a.others() != b.others()) return a.others() < b.others();
    return std::lexicographical_compare(a.of_labels().begin(), a.of_labels().end(), b.of_labels().begin(),
                                        b.of_labels().end(), before);
  }
};

class Builder {
 public:
  Language build(const Node& node) {
    return place_limits(node, [&] { return build_unplaced(node); });
  }

 private:
  Language build_unplaced(const Node& node) {
    if (node.kind == NodeKind::Letters) return letters(node.set);
    if (node.kind == NodeKind::Repeat) return repeat(build(node.children[0]), node.at_least, node.at_most);
    if (node.kind == NodeKind::Alternation) return alternatives(node);
    // Most pieces are letters, of which there are few kinds.
    std::deque<Language> built;
    std::vector<const Language*> pieces;
    for (const Node& child : node.children) {
      const bool is_letter = child.kind == NodeKind::Letters;
      pieces.push_back(is_letter ? &letters(child.set) : &built.emplace_back(build(child)));
    }
    try {
      return concat(pieces);
    } catch (const WorkError&) {
      throw;
    } catch (const LimitError& error) {
      throw_for_run(node.children, pieces, error);
    }
  }

  // Single letters are one set of letters.
  Language alternatives(const Node& node) {
    LetterSet single;
    std::deque<Language> built;
    std::vector<const Language*> pieces;
    for (const Node& child : node.children) {
      if (child.kind == NodeKind::Letters)
        single |= child.set;
      else
        pieces.push_back(&built.emplace_back(build(child)));
    }
    if (!single.is_empty()) pieces.push_back(&letters(single));
    return unite(pieces);
  }

  const Language& letters(const LetterSet& set) {
    const auto at = letters_.find(set);
    return at != letters_.end() ? at->second : letters_.emplace(set, Language::of(set)).first->second;
  }

  // Of a sequence that is too large the shortest run of pieces that is too large by itself, as far as the work that is
  // left suffices to find it.
  [[noreturn]] static void throw_for_run(const std::vector<Node>& nodes, std::span<const Language* const> pieces,
                                         const LimitError& error) {
    std::size_t begin = 0, end = pieces.size();
    const auto fits = [&](std::size_t from, std::size_t to) {
      try {
        concat(pieces.subspan(from, to - from));
        return true;
      } catch (const WorkError&) {
        throw;
      } catch (const LimitError&) {
        return false;
      }
    };
    try {
      for (std::size_t fitting = 1; end - fitting > 1;) {
        const std::size_t middle = fitting + (end - fitting) / 2;
        (fits(0, middle) ? fitting : end) = middle;
      }
      for (std::size_t fitting = end - 1; fitting - begin > 1;) {
        const std::size_t middle = begin + (fitting - begin) / 2;
        (fits(middle, end) ? fitting : begin) = middle;
      }
    } catch (const WorkError&) {
      // The run found so far is too large, and perhaps not the shortest.
    }
    std::size_t first = nodes[begin].offset, last = first;
    for (std::size_t i = begin; i < end; ++i) {
      first = std::min(first, nodes[i].offset);
      last = std::max(last, nodes[i].offset + nodes[i].length);
    }
    throw PlacedLimitError(error, first, last - first, true);
  }

  std::map<LetterSet, Language, InSomeOrder> letters_;
};

}  // namespace

Language language_of(const Node& tree) {
  return Builder().build(tree);
}

void throw_too_large(const ExpressionSource& source, const PlacedLimitError& error) {
  constexpr std::size_t kShown = 60;
  std::string text = source.text(error.offset(), std::min(error.length(), kShown));
  if (error.length() > kShown) text += "...";
  const bool is_counting = text.find('{') != std::string::npos;
  std::string message = format(diagnose(
      ErrorCode::TooLarge, source.name, source.document, error.offset(), error.length(), {quoted(text), error.what()},
      is_counting ? "lower a count, or take away a '*' or '+' beside one" : "split the expression into smaller ones"));
  message.pop_back();  // the newline
  throw LimitError(message);
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
