#include <heckbert/taxonomy/dialect_printer.h>

#include <utility>
#include <vector>

#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/regular_expression.h>

namespace heckbert::taxonomy {

namespace {

// ---- letters -------------------------------------------------------------------------------------------------------

struct Items {
  std::string text;
  std::size_t count = 0;
  SymbolSet covered = 0;
  void add(const std::string& item, SymbolSet set) {
    text += item;
    ++count;
    covered |= set;
  }
};

bool within(SymbolSet part, SymbolSet whole) {
  return part != 0 && (part & ~whole) == 0;
}

void add_grouped(Items& items, SymbolSet set, const DialectFacts& dialect) {
  for (const KindLetter& kind : dialect.kinds)
    if (const SymbolSet both = symbols_of(kind); within(both, set)) items.add(std::string(1, kind.letter), both);
  for (const auto& [type, subscript] : {std::pair{'R', 'r'}, std::pair{'T', 't'}}) {
    std::string letters;
    SymbolSet covered = 0;
    for (const KindLetter& kind : dialect.kinds) {
      const SymbolSet one = symbols_of(kind) & with_mode(subscript);
      if (within(one, set) && (one & items.covered) == 0) {
        letters += kind.letter;
        covered |= one;
      }
    }
    if (letters.empty()) continue;
    if (covered == with_mode(subscript)) letters = ".";
    items.add("<" + std::string(1, type) + (letters.size() > 1 ? "[" + letters + "]" : letters) + ">", covered);
  }
}

void add_subscripted(Items& items, SymbolSet set) {
  for (const Symbol s : members(set & kEvents)) {
    const SymbolSet whole = with_letter(facts(s).letter);
    if (facts(s).letter == 'V') continue;
    if (!within(whole, set))
      items.add(name(s), single(s));
    else if (facts(s).subscript == 'r')
      items.add(std::string(1, facts(s).letter), whole);
  }
}

void add_lights(Items& items, SymbolSet set, const DialectFacts& dialect) {
  // All lights: every letter that adds to the others or that people expect beside them, as in [LOB].
  const bool everything = within(kLights, set) && dialect.orientation == Orientation::CameraFirst;
  for (const LightLetter& light : dialect.lights) {
    const SymbolSet one = symbols_of(light);
    if (within(one, set) && (everything || (one & ~items.covered) != 0)) items.add(std::string(light.text), one);
  }
}

void add_eyes(Items& items, SymbolSet set, const DialectFacts& dialect) {
  if (within(kEyes, set)) return items.add(std::string(1, dialect.eyes[0]), kEyes);
  if (dialect.has_groups) return;
  for (const Symbol s : members(set & kEyes)) items.add(name(s), single(s));
}

// ---- repetitions that the dialect has -------------------------------------------------------------------------------

Node repeated(Node a, unsigned at_least, std::optional<unsigned> at_most) {
  Node node{.kind = NodeKind::Repeat, .at_least = at_least, .at_most = at_most};
  node.children.push_back(std::move(a));
  return node;
}

class Lowering {
 public:
  explicit Lowering(const DialectFacts& dialect) : dialect_(dialect) {}

  // Nothing when it grows beyond the budget. What may be missing is left as {0,1} where the dialect can say so or not.
  std::optional<Node> run(const Node& tree) {
    Node lowered = lower(tree);
    if (!can_omit() && !too_large_) {
      auto [may_be_missing, rest] = split(lowered);
      if (may_be_missing || !rest) return std::nullopt;  // the empty path, which no language of paths has
      lowered = std::move(*rest);
    }
    if (too_large_) return std::nullopt;
    return lowered;
  }

 private:
  bool can_omit() const { return dialect_.has_optional || dialect_.has_range; }

  Node copies(const Node& a, unsigned count, std::optional<Node> last = {}) {
    std::vector<Node> pieces;
    used_ += size_of(a) * count;
    if (used_ > kTreeBudget) {
      too_large_ = true;
      return a;
    }
    for (unsigned i = 0; i < count; ++i) pieces.push_back(a);
    if (last) pieces.push_back(std::move(*last));
    Node node{.kind = NodeKind::Sequence};
    node.children = std::move(pieces);
    return node;
  }

  Node lower(const Node& tree) {
    Node node = tree;
    for (Node& child : node.children) child = lower(child);
    if (node.kind != NodeKind::Repeat) return node;
    const unsigned least = node.at_least;
    const auto most = node.at_most;
    const Node inner = node.children[0];
    if (!most) {
      if (least <= 1 || dialect_.has_open) return node;
      return copies(inner, least - 1, repeated(inner, 1, std::nullopt));
    }
    if (least == 0 && *most == 1) return node;
    if (least == *most && dialect_.has_exact && least > 0) return node;
    if (dialect_.has_range && *most > 0) return node;
    Node tail{.kind = NodeKind::Sequence};
    used_ += size_of(inner) * (*most - least);
    if (used_ > kTreeBudget || *most > kTreeBudget) {
      too_large_ = true;
      return node;
    }
    for (unsigned i = least; i < *most; ++i) tail = repeated(sequence_of({inner, std::move(tail)}), 0, 1);
    return copies(inner, least, std::move(tail));
  }

  // The strings of a tree as the empty one, or not, and a tree without {0,1}: how a dialect that cannot say "may be
  // missing" is told both cases.
  struct Split {
    bool may_be_missing = false;
    std::optional<Node> rest;
  };

  Split split(const Node& tree) {
    if (too_large_ || (used_ += 1) > kTreeBudget * 4) {
      too_large_ = true;
      return {};
    }
    switch (tree.kind) {
      case NodeKind::Letters:
        return {false, tree};
      case NodeKind::Alternation: {
        Split all;
        for (const Node& child : tree.children) {
          Split one = split(child);
          all.may_be_missing = all.may_be_missing || one.may_be_missing;
          if (one.rest) all.rest = all.rest ? either(std::move(*all.rest), std::move(*one.rest)) : std::move(*one.rest);
        }
        return all;
      }
      case NodeKind::Repeat:
        return split_repeat(tree);
      default:
        return split_sequence(tree.children);
    }
  }

  Split split_repeat(const Node& tree) {
    Split inner = split(tree.children[0]);
    if (!inner.rest) return {true, std::nullopt};
    if (tree.at_least == 0 && tree.at_most == 1u) return {true, std::move(inner.rest)};
    if (!tree.at_most) {
      const bool skips = inner.may_be_missing || tree.at_least == 0;
      if (skips) return {false, repeated(std::move(*inner.rest), 0, std::nullopt)};
      return {false, repeated(std::move(*inner.rest), tree.at_least, std::nullopt)};
    }
    if (!inner.may_be_missing) return {false, repeated(std::move(*inner.rest), tree.at_least, tree.at_most)};
    return split_sequence(std::vector<Node>(*tree.at_most, tree.children[0]));
  }

  Split split_sequence(const std::vector<Node>& children) {
    Split all{true, std::nullopt};
    for (std::size_t i = children.size(); i-- > 0;) {
      Split one = split(children[i]);
      std::optional<Node> rest;
      const auto join = [&](std::optional<Node> a) {
        if (!a) return;
        used_ += size_of(*a);
        // Kept apart: factoring would bring the {0,1} back.
        if (!rest) {
          rest = std::move(a);
        } else if (!same(*rest, *a)) {
          Node both{.kind = NodeKind::Alternation};
          both.children.push_back(std::move(*rest));
          both.children.push_back(std::move(*a));
          rest = std::move(both);
        }
      };
      if (one.rest && all.rest) join(sequence_of({*one.rest, *all.rest}));
      if (one.may_be_missing) join(all.rest);
      if (all.may_be_missing) join(one.rest);
      all = {one.may_be_missing && all.may_be_missing, std::move(rest)};
    }
    return all;
  }

  const DialectFacts& dialect_;
  std::size_t used_ = 0;
  bool too_large_ = false;
};

// ---- text ----------------------------------------------------------------------------------------------------------

class Printer {
 public:
  explicit Printer(const DialectFacts& dialect) : dialect_(dialect) {}

  std::string print(const Node& node) {
    switch (node.kind) {
      case NodeKind::Letters: {
        const auto item = item_text(node.set, dialect_);
        failed_ = failed_ || !item;
        return item.value_or("");
      }
      case NodeKind::Alternation: {
        std::string text;
        for (const Node& child : node.children) {
          const bool bare = !dialect_.bar_binds_tightest || is_item(child);
          text += (text.empty() ? "" : "|") + (bare ? print(child) : "(" + print(child) + ")");
        }
        return text;
      }
      case NodeKind::Repeat: {
        const Node& inner = node.children[0];
        return (inner.kind == NodeKind::Letters ? print(inner) : "(" + print(inner) + ")") + sign(node);
      }
      default: {
        std::string text;
        for (const Node& child : node.children)
          text += child.kind == NodeKind::Alternation ? "(" + print(child) + ")" : print(child);
        return text;
      }
    }
  }

  bool failed() const { return failed_; }

 private:
  static bool is_item(const Node& node) { return node.kind == NodeKind::Letters || node.kind == NodeKind::Repeat; }

  std::string sign(const Node& node) const {
    const std::string least = std::to_string(node.at_least);
    if (!node.at_most) return node.at_least == 0 ? "*" : node.at_least == 1 ? "+" : "{" + least + ",}";
    if (node.at_least == *node.at_most) return "{" + least + "}";
    if (node.at_least == 0 && *node.at_most == 1 && dialect_.has_optional) return "?";
    return "{" + least + "," + std::to_string(*node.at_most) + "}";
  }

  const DialectFacts& dialect_;
  bool failed_ = false;
};

}  // namespace

std::optional<std::string> item_text(SymbolSet set, const DialectFacts& dialect) {
  if (set == kEvents || set == any_of(dialect)) return ".";
  Items items;
  if (dialect.has_groups)
    add_grouped(items, set, dialect);
  else
    add_subscripted(items, set);
  if (has(set, Symbol::V)) items.add("V", single(Symbol::V));
  add_lights(items, set, dialect);
  add_eyes(items, set, dialect);
  if (items.covered != set || set == 0) return std::nullopt;
  return items.count == 1 ? items.text : "[" + items.text + "]";
}

std::optional<std::string> print(const Node& tree, const DialectFacts& dialect) {
  const auto lowered = Lowering(dialect).run(tree);
  if (!lowered) return std::nullopt;
  Printer printer(dialect);
  std::string text = printer.print(*lowered);
  if (printer.failed()) return std::nullopt;
  return text;
}

}  // namespace heckbert::taxonomy
