#include <heckbert/taxonomy/phases.h>

#include <algorithm>
#include <map>
#include <set>

#include <heckbert/taxonomy/dialect_parser.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression_parser.h>
#include <heckbert/taxonomy/live.h>
#include <heckbert/taxonomy/tree_language.h>

namespace heckbert::taxonomy {

namespace {

std::string name_of(const Node& node) {
  switch (node.kind) {
    case NodeKind::Letters:
      return write(node.set);
    case NodeKind::Sequence:
      return "sequence";
    case NodeKind::Alternation:
      return "one of";
    case NodeKind::Repeat:
      return "repeat " + std::to_string(node.at_least) +
             (node.at_most ? " to " + std::to_string(*node.at_most) : " or more");
    case NodeKind::Name:
      return "@" + node.name;
    case NodeKind::Both:
      return "both of";
    case NodeKind::Without:
      return "first without second";
    case NodeKind::Complement:
      return "all but";
    case NodeKind::Bad:
      break;
  }
  return "error";
}

void write_tree(const Node& node, std::size_t depth, std::string& text) {
  text += std::string(2 * depth, ' ') + name_of(node) + "\n";
  for (const Node& child : node.children) write_tree(child, depth + 1, text);
}

using Positions = std::set<std::size_t>;

// Letters of a tree numbered from 1 in the order of the text; 0 is the start.
class Glushkov {
 public:
  explicit Glushkov(const Node& tree) {
    const Fragment whole = add(tree);
    follow_[0] = whole.first;
    last_ = whole.last;
    if (whole.may_be_empty) last_.insert(0);
  }

  std::size_t size() const { return sets_.size(); }
  const LetterSet& letters(std::size_t position) const { return sets_[position]; }
  /// The letters that the sets of all positions tell apart.
  const Alphabet& alphabet() const { return alphabet_; }
  const Positions& follow(std::size_t position) const { return follow_[position]; }
  bool accepts(const Positions& at) const {
    return std::any_of(at.begin(), at.end(), [&](std::size_t p) { return last_.contains(p); });
  }
  Positions step(const Positions& at, const Letter& letter) const {
    Positions next;
    for (const std::size_t p : at)
      for (const std::size_t q : follow_[p])
        if (has(sets_[q].of(letter.label), letter.symbol)) next.insert(q);
    return next;
  }

 private:
  struct Fragment {
    bool may_be_empty = true;
    Positions first, last;
  };

  Fragment add(const Node& node) {
    switch (node.kind) {
      case NodeKind::Letters: {
        if (sets_.size() > kMostPositions)
          throw LimitError("the phases of an expression with more than " + std::to_string(kMostPositions) +
                           " letters are not shown");
        sets_.push_back(node.set);
        for (const LetterSet::OfLabel& one : node.set.of_labels())
          alphabet_ = taxonomy::joined(alphabet_, Alphabet{{one.label}});
        follow_.emplace_back();
        return {false, {sets_.size() - 1}, {sets_.size() - 1}};
      }
      case NodeKind::Alternation: {
        Fragment all{false, {}, {}};
        for (const Node& child : node.children) {
          const Fragment one = add(child);
          all.may_be_empty = all.may_be_empty || one.may_be_empty;
          all.first.insert(one.first.begin(), one.first.end());
          all.last.insert(one.last.begin(), one.last.end());
        }
        return all;
      }
      case NodeKind::Repeat:
        return add_repeat(node);
      default: {
        Fragment all;
        for (const Node& child : node.children) all = joined(std::move(all), add(child));
        return all;
      }
    }
  }

  // Counts are written out: a{2,3} is a a a?, a{2,} is a a+.
  Fragment add_repeat(const Node& node) {
    Fragment all;
    const unsigned copies = node.at_most.value_or(std::max(node.at_least, 1u));
    for (unsigned i = 0; i < copies; ++i) {
      Fragment one = add(node.children[0]);
      if (!node.at_most && i + 1 == copies) link(one.last, one.first);
      one.may_be_empty = one.may_be_empty || i >= node.at_least;
      all = joined(std::move(all), one);
    }
    return all;
  }

  Fragment joined(Fragment left, const Fragment& right) {
    link(left.last, right.first);
    if (left.may_be_empty) left.first.insert(right.first.begin(), right.first.end());
    if (!right.may_be_empty) left.last.clear();
    left.last.insert(right.last.begin(), right.last.end());
    left.may_be_empty = left.may_be_empty && right.may_be_empty;
    return left;
  }

  void link(const Positions& from, const Positions& to) {
    for (const std::size_t p : from) follow_[p].insert(to.begin(), to.end());
  }

  Alphabet alphabet_;
  std::vector<LetterSet> sets_{{}};
  std::vector<Positions> follow_{{}};
  Positions last_;
};

std::string list_of(const Positions& positions) {
  std::string text;
  for (const std::size_t p : positions) text += (text.empty() ? "" : " ") + std::to_string(p);
  return text;
}

PartPhases phases_of(const Node& tree, std::string expression) {
  const Glushkov automaton(tree);
  PartPhases part{std::move(expression), {}, {}, 0};
  for (std::size_t p = 0; p < automaton.size(); ++p) {
    part.positions += std::to_string(p) + " " + (p == 0 ? "start" : write(automaton.letters(p)));
    if (!automaton.follow(p).empty()) part.positions += " -> " + list_of(automaton.follow(p));
    part.positions += automaton.accepts({p}) ? " accepts\n" : "\n";
  }
  std::vector<Positions> sets{{0}};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (sets.size() > kStateBudget) throw LimitError("the sets of letters are too many to show");
    const Positions at = sets[i];
    std::map<Positions, std::vector<std::size_t>> edges;
    for (std::size_t c = 0; c < automaton.alphabet().size(); ++c)
      if (Positions next = automaton.step(at, automaton.alphabet().letter(c)); !next.empty())
        edges[std::move(next)].push_back(c);
    const std::string from = "{" + list_of(at) + "}";
    if (automaton.accepts(at)) part.subsets += from + " accepts\n";
    for (const auto& [next, columns] : edges) {
      part.subsets += from + " -" + write(automaton.alphabet().letters(columns)) + "-> {" + list_of(next) + "}\n";
      if (std::find(sets.begin(), sets.end(), next) == sets.end()) sets.push_back(next);
    }
  }
  part.deterministic = sets.size();
  return part;
}

bool has_operators(const Node& node) {
  return node.kind == NodeKind::Name || node.kind == NodeKind::Both || node.kind == NodeKind::Without ||
         node.kind == NodeKind::Complement || std::any_of(node.children.begin(), node.children.end(), has_operators);
}

// Which way round the letters of a sound expression are written; an undirected dialect may mean both.
bool runs_from_light(const Node& node, Dialect dialect) {
  if (facts(dialect).orientation == Orientation::CameraFirst) return false;
  return !(language_of(node) & Language::universe()).is_empty();
}

// The largest subtrees of letters, each light -> eye.
void collect_parts(const Node& node, Dialect dialect, std::string_view text, std::vector<PartPhases>& parts) {
  if (node.kind == NodeKind::Name) return;
  if (has_operators(node) || node.kind == NodeKind::Alternation) {
    for (const Node& child : node.children) collect_parts(child, dialect, text, parts);
    return;
  }
  parts.push_back(phases_of(runs_from_light(node, dialect) ? node : reversed(node),
                            std::string(text.substr(node.offset, node.length))));
}

// The expression is known to be sound.
FormPhases form_of(std::string_view text, Dialect dialect, std::string lights = {}) {
  ExpressionSource source{"expression", text, 0, text.size(), {}};
  const Node tree =
      dialect == Dialect::Heckbert ? parse_expression(source) : parse_dialect(source, facts(dialect)).root;
  FormPhases form{std::string(text), std::move(lights), {}, {}};
  write_tree(tree, 0, form.tree);
  collect_parts(tree, dialect, text, form.parts);
  return form;
}

Phases phases_of(std::vector<FormPhases> forms, const Language& language) {
  Phases result{std::move(forms), {}, 0};
  const std::vector<State>& states = language.states();
  for (StateId q = 0; q < states.size(); ++q) {
    if (states[q].accepting) result.minimal += std::to_string(q) + " accepts\n";
    for (const auto& [to, set] : moves(language, q))
      result.minimal += std::to_string(q) + " -" + write(set) + "-> " + std::to_string(to) + "\n";
    result.states += !is_dead(language, q);
  }
  return result;
}

}  // namespace

Phases phases(std::string_view text, Dialect dialect, const Names& names, std::string_view source) {
  const Language language = read_expression(text, dialect, names, source).language;
  return phases_of({form_of(text, dialect)}, language);
}

Phases phases(const Grammar& grammar) {
  std::vector<FormPhases> forms;
  const auto add = [&](const std::string& expression, const std::string& lights) {
    if (!expression.empty() && expression != kNoPath) forms.push_back(form_of(expression, Dialect::Heckbert, lights));
  };
  const bool has_two = !grammar.expression_delta.empty();
  add(grammar.expression, has_two ? "lights that a ray can hit, La and Le" : "");
  add(grammar.expression_delta, "lights that no ray can hit, Lp and Ld");
  return phases_of(std::move(forms), grammar.language);
}

}  // namespace heckbert::taxonomy
