#include <heckbert/taxonomy/dialect_printer.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/label.h>
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

// `label` is the third field of a group, empty for any.
void add_grouped(Items& items, SymbolSet set, const DialectFacts& dialect, const std::string& label) {
  for (const KindLetter& kind : dialect.kinds)
    if (const SymbolSet both = symbols_of(kind); within(both, set)) {
      const std::string letter(1, kind.letter);
      items.add(label.empty() ? letter : "<." + letter + label + ">", both);
    }
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
    items.add("<" + std::string(1, type) + (letters.size() > 1 ? "[" + letters + "]" : letters) + label + ">", covered);
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

void add_lights(Items& items, SymbolSet set, const DialectFacts& dialect, const std::string& label) {
  // All lights: every letter that adds to the others or that people expect beside them, as in [LOB].
  const bool everything = within(kLights, set) && dialect.orientation == Orientation::CameraFirst;
  for (const LightLetter& light : dialect.lights) {
    const SymbolSet one = symbols_of(light);
    if (within(one, set) && (everything || (one & ~items.covered) != 0))
      items.add(label.empty() ? std::string(light.text) : "<" + std::string(light.text) + "." + label + ">", one);
  }
}

void add_eyes(Items& items, SymbolSet set, const DialectFacts& dialect) {
  if (within(kEyes, set)) return items.add(std::string(1, dialect.eyes[0]), kEyes);
  if (dialect.has_groups) return;
  for (const Symbol s : members(set & kEyes)) items.add(name(s), single(s));
}

// ---- labels --------------------------------------------------------------------------------------------------------

struct Labelled {
  SymbolSet symbols = 0;
  std::string label;  ///< as the third field of a group: "", "'a'", "[^'a''b']"
};

// A set as the symbols that it holds with any label, those of a single one, and those of all but a few.
std::vector<Labelled> by_labels(const LetterSet& set) {
  SymbolSet any = set.others();
  for (const LetterSet::OfLabel& one : set.of_labels()) any = static_cast<SymbolSet>(any & (one.symbols | kEyes));
  std::vector<Labelled> parts;
  if (any != 0) parts.push_back({any, ""});
  for (const LetterSet::OfLabel& one : set.of_labels())
    if (const auto only = static_cast<SymbolSet>(one.symbols & ~set.others()); only != 0)
      parts.push_back({only, write_label(one.label)});
  for (const Symbol s : members(static_cast<SymbolSet>(set.others() & ~any))) {
    std::string labels;
    for (const LetterSet::OfLabel& one : set.of_labels())
      if (!has(one.symbols, s)) labels += write_label(one.label);
    labels = "[^" + labels + "]";
    const auto alike = std::find_if(parts.begin(), parts.end(), [&](const Labelled& p) { return p.label == labels; });
    if (alike != parts.end())
      alike->symbols = static_cast<SymbolSet>(alike->symbols | single(s));
    else
      parts.push_back({single(s), labels});
  }
  return parts;
}

// [^'a''b']: whatever '.' is, but for a few labels; nothing when something else of these labels is in the set.
std::optional<std::string> all_but(const LetterSet& missing, const DialectFacts& dialect) {
  std::string text;
  for (const LetterSet::OfLabel& one : missing.of_labels()) {
    if (one.symbols != (any_of(dialect) & ~kEyes)) return std::nullopt;
    text += write_label(one.label);
  }
  return "[^" + text + "]";
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

std::optional<std::string> item_text(const LetterSet& set, const DialectFacts& dialect) {
  if (set == LetterSet(kEvents) || set == LetterSet(any_of(dialect))) return ".";
  if (!dialect.has_groups && !set.of_labels().empty()) return write(set);
  const LetterSet missing = LetterSet(any_of(dialect)) - set;
  if (missing.others() == 0)
    if (auto text = all_but(missing, dialect)) return text;
  Items items;
  for (const Labelled& part : by_labels(set)) {
    Items one;
    if (dialect.has_groups)
      add_grouped(one, part.symbols, dialect, part.label);
    else
      add_subscripted(one, part.symbols);
    if (has(part.symbols, Symbol::V)) one.add(part.label.empty() ? "V" : "<V." + part.label + ">", single(Symbol::V));
    add_lights(one, part.symbols, dialect, part.label);
    if (part.label.empty()) add_eyes(one, part.symbols, dialect);
    if (one.covered != part.symbols) return std::nullopt;
    items.text += one.text;
    items.count += one.count;
  }
  if (items.count == 0) return std::nullopt;
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
