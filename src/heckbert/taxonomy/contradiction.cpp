#include <heckbert/taxonomy/contradiction.h>

#include <algorithm>
#include <vector>

#include <heckbert/taxonomy/characters.h>
#include <heckbert/taxonomy/dialect_parser.h>
#include <heckbert/taxonomy/expression_parser.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

// ---- what a language demands of its paths ---------------------------------------------------------------------------

/// A superset of a language, in words: "begins at La", [La].*E.
struct Demand {
  std::string phrase;  ///< the end of "every path of it ..."
  Language language;
};

class Demands {
 public:
  explicit Demands(const Language& language) : language_(language) {
    add_set("begins at ", "", kLights, "[", "].*E");
    add_set("ends at ", "", kEyes, "L.*[", "]");
    add_events();
    add_lengths();
    add_set("has ", " beside the light", kEvents, "L[", "].*E");
    add_set("has ", " beside the eye", kEvents, "L.*[", "]E");
  }
  const std::vector<Demand>& all() const { return demands_; }

 private:
  bool has_path_in(const std::string& expression) const { return !(language_ & compile(expression)).is_empty(); }

  void add(std::string phrase, const std::string& expression) {
    Language wider = compile(expression);
    if (language_.is_subset_of(wider)) demands_.push_back({std::move(phrase), std::move(wider)});
  }

  // Which symbols of `role` occur at one place, when not all do.
  void add_set(const std::string& phrase, const std::string& place, SymbolSet role, const std::string& before,
               const std::string& after) {
    const SymbolSet used = symbols_where(
        [&](const SymbolFacts& f) { return has(role, f.symbol) && has_path_in(before + name(f.symbol) + after); });
    if (used != 0 && used != role) add(phrase + describe(used) + place, before + spelled(used) + after);
  }

  void add_events() {
    const SymbolSet used = symbols_where(
        [&](const SymbolFacts& f) { return has(kEvents, f.symbol) && has_path_in("L.*" + name(f.symbol) + ".*E"); });
    if (used == 0)
      add("has no event", "LE");
    else if (used != kEvents)
      add("has no event but " + describe(used), "L[" + spelled(used) + "]*E");
    for (const char kind : {'D', 'G', 'S', 'V'}) add(std::string("has ") + kind, std::string("L.*") + kind + ".*E");
    for (const Symbol s : members(kEvents)) add("has " + name(s), "L.*" + name(s) + ".*E");
  }

  void add_lengths() {
    constexpr std::size_t kLongest = 50;
    const auto shortest = language_.shortest_word();
    if (!shortest) return;
    const std::size_t least = shortest->length();
    for (std::size_t most = least; most <= kLongest; ++most) {
      const std::string count = std::to_string(most) + (most == 1 ? " event" : " events");
      const bool is_exact = most == least;
      const std::string expression = (is_exact ? "L.{" : "L.{0,") + std::to_string(most) + "}E";
      if (!language_.is_subset_of(compile(expression))) continue;
      add((is_exact ? "has exactly " : "has at most ") + count, expression);
      break;
    }
    if (least > 0)
      add("has at least " + std::to_string(least) + (least == 1 ? " event" : " events"),
          "L.{" + std::to_string(least) + ",}E");
  }

  static std::string spelled(SymbolSet set) {
    std::string text;
    for (const Symbol s : members(set)) text += name(s);
    return text;
  }

  const Language& language_;
  std::vector<Demand> demands_;
};

// ---- which operands leave nothing
// ------------------------------------------------------------------------------------

/// An operand of '&', or of '-' or '!': then what is left without it.
struct Operand {
  const Node* node = nullptr;
  bool taken_away = false;
  Language left;
};

class Search {
 public:
  Search(std::string_view text, Dialect dialect, const Names& names) : text_(text), dialect_(dialect), names_(names) {}

  std::optional<std::string> run(const Node& node) const {
    switch (node.kind) {
      case NodeKind::Alternation:
        for (const Node& child : node.children)
          if (auto reason = run(child)) return reason;
        return std::nullopt;
      case NodeKind::Both:
      case NodeKind::Without:
      case NodeKind::Complement: {
        std::vector<Operand> operands;
        collect(node, operands);
        return blame(operands);
      }
      case NodeKind::Name:
        return shown(node) + " has no path";
      default:
        return std::nullopt;
    }
  }

 private:
  static constexpr std::size_t kMostOperands = 12;

  std::string shown(const Node& node) const {
    constexpr std::size_t kLongest = 60;
    std::string_view text = text_.substr(node.offset, node.length);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return quoted(text.size() > kLongest ? std::string(text.substr(0, kLongest)) + "..." : std::string(text));
  }

  // Operands keep their own text, so each is read as the whole was.
  Language meaning(const Node& node) const {
    return read_expression(text_.substr(node.offset, node.length), dialect_, names_).language;
  }

  void collect(const Node& node, std::vector<Operand>& operands) const {
    if (node.kind == NodeKind::Both) {
      for (const Node& child : node.children) collect(child, operands);
    } else if (node.kind == NodeKind::Without) {
      collect(node.children[0], operands);
      operands.push_back({&node.children[1], true, !meaning(node.children[1])});
    } else if (node.kind == NodeKind::Complement) {
      operands.push_back({&node.children[0], true, !meaning(node.children[0])});
    } else {
      operands.push_back({&node, false, meaning(node)});
    }
  }

  /// The smallest set of operands that leaves no path, the first of those in the order of the text.
  static std::vector<Operand> culprits(const std::vector<Operand>& operands) {
    const std::size_t count = std::min(operands.size(), kMostOperands);
    std::vector<Operand> best = operands;
    for (unsigned set = 1; set < (1u << count); ++set) {
      std::vector<Operand> some;
      Language left = Language::universe();
      for (std::size_t i = 0; i < count; ++i)
        if ((set >> i & 1u) != 0) some.push_back(operands[i]);
      if (some.size() >= best.size()) continue;
      for (const Operand& operand : some) left = left & operand.left;
      if (left.is_empty()) best = std::move(some);
    }
    return best;
  }

  std::string blame(const std::vector<Operand>& operands) const {
    const std::vector<Operand> few = culprits(operands);
    if (few.size() == 1) {
      if (few[0].taken_away) return "every path is in " + shown(*few[0].node) + ", which is taken away";
      return run(*few[0].node).value_or(shown(*few[0].node) + " has no path");
    }
    std::vector<std::string> kept, taken;
    for (const Operand& operand : few) (operand.taken_away ? taken : kept).push_back(shown(*operand.node));
    if (few.size() == 2 && taken.empty())
      if (const auto demands = opposed(few[0].left, few[1].left))
        return "every path of " + kept[0] + " " + demands->first + ", and every path of " + kept[1] + " " +
               demands->second;
    if (taken.empty())
      return few.size() == 2 ? kept[0] + " and " + kept[1] + " have no path in common"
                             : "no path is in all of " + listed(kept, "and");
    return (kept.empty() ? "every path" : "every path of " + listed(kept, "and")) + " is in " + listed(taken, "or") +
           ", which " + (taken.size() == 1 ? "is" : "are") + " taken away";
  }

  static std::string listed(const std::vector<std::string>& texts, const std::string& last) {
    std::string list = texts[0];
    for (std::size_t i = 1; i < texts.size(); ++i) list += (i + 1 == texts.size() ? " " + last + " " : ", ") + texts[i];
    return list;
  }

  /// A demand of each that contradict each other.
  static std::optional<std::pair<std::string, std::string>> opposed(const Language& a, const Language& b) {
    const Demands of_a(a), of_b(b);
    for (const Demand& one : of_a.all())
      for (const Demand& other : of_b.all())
        if ((one.language & other.language).is_empty()) return std::pair(one.phrase, other.phrase);
    return std::nullopt;
  }

  std::string_view text_;
  Dialect dialect_;
  const Names& names_;
};

}  // namespace

std::optional<std::string> why_empty(std::string_view text, Dialect dialect, const Names& names) {
  if (!read_expression(text, dialect, names).language.is_empty()) return std::nullopt;
  ExpressionSource source{"expression", text, 0, text.size(), {}};
  const Node tree =
      dialect == Dialect::Heckbert ? parse_expression(source) : parse_dialect(source, facts(dialect)).root;
  return Search(text, dialect, names).run(tree);
}

}  // namespace heckbert::taxonomy
