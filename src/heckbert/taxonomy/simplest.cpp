#include <heckbert/taxonomy/simplest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/regular_expression.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/taxonomy/tree_language.h>
#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

namespace {

constexpr std::size_t kLongest = 2'000;         // characters of a text that somebody might read
constexpr std::size_t kEditedNodes = 150;       // larger trees are left as elimination made them
constexpr std::size_t kEditSteps = 10'000'000;  // for all edits together

// ---- text ----------------------------------------------------------------------------------------------------------

std::string text_of(const Node& tree);

std::string operand(const Node& tree) {
  const std::string text = text_of(tree);
  return tree.kind == NodeKind::Letters ? text : "(" + text + ")";
}

std::string suffix(const Node& repeat) {
  const std::string least = std::to_string(repeat.at_least);
  if (!repeat.at_most) return repeat.at_least == 0 ? "*" : repeat.at_least == 1 ? "+" : "{" + least + ",}";
  if (*repeat.at_most == repeat.at_least) return "{" + least + "}";
  return repeat.at_least == 0 && *repeat.at_most == 1 ? "?" : "{" + least + "," + std::to_string(*repeat.at_most) + "}";
}

std::string text_of(const Node& tree) {
  std::string text;
  switch (tree.kind) {
    case NodeKind::Letters:
      return write(tree.set);
    case NodeKind::Repeat:
      return operand(tree.children[0]) + suffix(tree);
    case NodeKind::Alternation:
      for (const Node& child : tree.children) text += (text.empty() ? "" : "|") + text_of(child);
      return text;
    default:
      for (const Node& child : tree.children)
        text += child.kind == NodeKind::Alternation ? operand(child) : text_of(child);
      return text;
  }
}

/// The pieces of a path with blanks between them: "N? S*".
std::string spaced(const Node& tree) {
  if (tree.kind != NodeKind::Sequence) return tree.kind == NodeKind::Alternation ? operand(tree) : text_of(tree);
  std::string text;
  for (const Node& child : tree.children) text += (text.empty() ? "" : " ") + spaced(child);
  return text;
}

// ---- edits ---------------------------------------------------------------------------------------------------------

Node repeated(Node a, unsigned at_least, std::optional<unsigned> at_most) {
  Node node{.kind = NodeKind::Repeat, .at_least = at_least, .at_most = at_most};
  node.children.push_back(std::move(a));
  return node;
}

bool is_optional(const Node& a) {
  return a.kind == NodeKind::Repeat && a.at_least == 0 && a.at_most == 1u;
}
bool is_star_of_letters(const Node& a) {
  return a.kind == NodeKind::Repeat && a.at_least == 0 && !a.at_most && a.children[0].kind == NodeKind::Letters;
}

void collect_sets(const Node& tree, std::vector<LetterSet>& sets) {
  if (tree.kind == NodeKind::Letters) sets.push_back(tree.set);
  for (const Node& child : tree.children) collect_sets(child, sets);
}

/// What elimination makes of a language of events, from the light or from the eye.
std::vector<Node> eliminated(const Language& language) {
  std::vector<Node> trees;
  if (auto tree = regular_expression(language)) trees.push_back(std::move(*tree));
  if (auto tree = regular_expression(reverse(language))) trees.push_back(reversed(std::move(*tree)));
  return trees;
}

// (X S*)? is N? S*: of what may be missing before a repetition, the repetition covers its own letters.
void split_optional(const Node& node, std::vector<Node>& out) {
  const Node& inner = node.children[0];
  if (inner.kind != NodeKind::Sequence || inner.children.size() != 2) return;
  const auto offer = [&](const Node& letters, const Node& star, bool letters_first) {
    if (letters.kind != NodeKind::Letters || !is_star_of_letters(star)) return;
    Node rest = letters;
    rest.set = letters.set - star.children[0].set;
    if (rest.set.is_empty()) return;
    rest = repeated(std::move(rest), 0, 1);
    out.push_back(letters_first ? sequence_of({rest, star}) : sequence_of({star, rest}));
  };
  offer(inner.children[0], inner.children[1], true);
  offer(inner.children[1], inner.children[0], false);
  // (D D?)? is D? D?.
  const Node &first = inner.children[0], &second = inner.children[1];
  if (second.kind == NodeKind::Repeat && same(first, second.children[0]) && second.at_least == 0 && second.at_most)
    out.push_back(repeated(first, 0, *second.at_most + 1));
  out.push_back(sequence_of({repeated(first, 0, 1), second}));
  out.push_back(sequence_of({first, repeated(second, 0, 1)}));
}

// D (S?D)* S? is (D S?)+: a run of pieces round a repetition is the same repetition begun elsewhere.
void rotate_repetition(const Node& sequence, std::vector<Node>& out) {
  const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  const std::size_t size = sequence.children.size();
  for (std::size_t star = 0; star < size; ++star) {
    const Node& repeat = sequence.children[star];
    if (repeat.kind != NodeKind::Repeat || repeat.at_most || repeat.children[0].kind != NodeKind::Sequence) continue;
    std::vector<Node> pieces = repeat.children[0].children;
    for (std::size_t turn = 0; turn < pieces.size(); ++turn) {
      std::rotate(pieces.begin(), pieces.begin() + 1, pieces.end());
      Node rotated{.kind = NodeKind::Sequence};
      rotated.children = pieces;
      for (std::size_t begin = 0; begin <= star; ++begin)
        for (std::size_t end = std::max(star + 1, begin + 2); end <= size; ++end) {
          Node shorter = sequence;
          shorter.children.erase(shorter.children.begin() + at(begin), shorter.children.begin() + at(end));
          shorter.children.insert(shorter.children.begin() + at(begin), repeated(rotated, 1, std::nullopt));
          out.push_back(shorter.children.size() == 1 ? shorter.children[0] : shorter);
        }
    }
  }
}

bool is_plus(const Node& a) {
  return a.kind == NodeKind::Repeat && a.at_least == 1 && !a.at_most;
}

// (D|S+)? and D?|S+ are D|S*: what may be missing is said where it costs nothing.
void move_optional(const Node& alternation, std::vector<Node>& out) {
  for (std::size_t j = 0; j < alternation.children.size(); ++j) {
    if (!is_plus(alternation.children[j])) continue;
    Node starred = alternation;
    starred.children[j].at_least = 0;
    for (Node& child : starred.children)
      if (is_optional(child)) {
        const Node inner = child.children[0];
        child = inner;
      }
    out.push_back(std::move(starred));
  }
}

// Trees that may stand for a node; which of them do is found by comparing languages.
std::vector<Node> edits(const Node& node, const std::vector<LetterSet>& sets) {
  std::vector<Node> out = node.children;
  if (node.kind == NodeKind::Letters) {
    for (const LetterSet& other : sets) {
      Node wider = node;
      wider.set |= other;
      out.push_back(std::move(wider));
    }
    return out;
  }
  if (node.kind == NodeKind::Repeat) {
    if (is_optional(node)) split_optional(node, out);
    if (is_optional(node) && node.children[0].kind == NodeKind::Alternation) move_optional(node.children[0], out);
    for (const Node& grandchild : node.children[0].children) {
      Node same_of_less = node;
      same_of_less.children[0] = grandchild;
      out.push_back(std::move(same_of_less));
    }
  }
  if (node.kind == NodeKind::Alternation || node.kind == NodeKind::Sequence)
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      Node less = node;
      less.children.erase(less.children.begin() + static_cast<std::ptrdiff_t>(i));
      out.push_back(less.children.size() == 1 ? less.children[0] : less);
    }
  if (node.kind == NodeKind::Sequence) {
    out.push_back(sequence_of(node.children));
    rotate_repetition(node, out);
    std::size_t run = 1;
    for (std::size_t i = 1; i <= node.children.size(); ++i) {
      if (i < node.children.size() && same(node.children[i], node.children[i - 1])) {
        ++run;
        continue;
      }
      if (run > 2) {
        Node counted = node;
        const auto end = counted.children.begin() + static_cast<std::ptrdiff_t>(i);
        *(end - 1) = repeated(*(end - 1), static_cast<unsigned>(run), static_cast<unsigned>(run));
        counted.children.erase(end - static_cast<std::ptrdiff_t>(run), end - 1);
        out.push_back(counted.children.size() == 1 ? counted.children[0] : counted);
      }
      run = 1;
    }
  }
  if (node.kind == NodeKind::Alternation) move_optional(node, out);
  if (node.kind == NodeKind::Alternation)
    for (std::size_t i = 0; i < node.children.size(); ++i)
      for (std::size_t j = i + 1; j < node.children.size(); ++j) {
        Node joined = node;
        joined.children[i] = either(node.children[i], node.children[j]);
        joined.children.erase(joined.children.begin() + static_cast<std::ptrdiff_t>(j));
        out.push_back(joined.children.size() == 1 ? joined.children[0] : joined);
      }
  return out;
}

/// The same language, as far as that can be told in the steps that are left.
bool means(const Node& tree, const Language& language) {
  try {
    return language_of(tree) == language;
  } catch (const LimitError&) {
    return false;
  }
}

class Editor {
 public:
  /// Takes no more than `steps`, and takes off what it took.
  Editor(Node& root, const Language& language, std::size_t& steps) : root_(root), language_(language), steps_(steps) {}

  void run() {
    const WorkLimit limit(steps_);
    try {
      while (size_of(root_) <= kEditedNodes) {
        sets_ = {kEvents, with_letter('D') | with_letter('G') | with_letter('S')};
        collect_sets(root_, sets_);
        if (!improve(root_)) break;
      }
    } catch (const LimitError&) {
      // What was made shorter until then stands.
    }
    steps_ -= limit.spent();
  }

 private:
  bool improve(Node& node) {
    const std::size_t length = text_of(node).size();
    const Language here = language_of(node);
    std::vector<Node> candidates = edits(node, sets_);
    if (size_of(node) > 3)
      for (Node& tree : eliminated(here)) candidates.push_back(std::move(tree));
    for (Node& candidate : candidates) {
      if (text_of(candidate).size() >= length) continue;
      const bool is_same_here = means(candidate, here);
      std::swap(node, candidate);
      if (is_same_here || means(root_, language_)) return true;
      std::swap(node, candidate);
    }
    for (Node& child : node.children)
      if (improve(child)) return true;
    return false;
  }

  Node& root_;
  const Language& language_;
  std::size_t& steps_;
  std::vector<LetterSet> sets_;
};

/// The shortest of the trees found for a language of events, not empty.
std::optional<Node> shortest_tree(const Language& events, std::size_t& steps) {
  std::optional<Node> best;
  for (Node& tree : eliminated(events)) {
    Editor(tree, events, steps).run();
    if (!best || text_of(tree).size() < text_of(*best).size()) best = std::move(tree);
  }
  return best;
}

// ---- ends ----------------------------------------------------------------------------------------------------------

/// What stands between one light letter, a column of the alphabet, and one eye.
Language between(const Language& words, std::size_t light, Symbol eye) {
  std::vector<State> states = words.states();
  const auto dead = static_cast<StateId>(states.size());
  states.push_back({std::vector<StateId>(words.alphabet().size(), dead), false});
  const StateId first = words.states()[0].next[light];
  for (StateId q = 0; q < dead; ++q) {
    states[q].accepting = words.states()[words.states()[q].next[index(eye)]].accepting;
    for (std::size_t c = 0; c < words.alphabet().size(); ++c)
      if (!is_event(Alphabet::symbol(c))) states[q].next[c] = dead;
  }
  // The start of an automaton is state 0, where no event leads: it becomes a copy of the state behind the light.
  states[0] = states[first];
  return Language::from_automaton(states, words.alphabet());
}

struct Piece {
  LetterSet lights;
  SymbolSet eyes = 0;
  Language events;
};

/// The language as a union of pieces lights events eyes, lights and eyes that are treated alike together.
std::vector<Piece> pieces_of(const Language& words) {
  std::vector<Piece> columns;  // one set of lights per distinct pair of languages, eyes joined
  for (std::size_t light = 0; light < words.alphabet().size(); ++light) {
    if (!is_light(Alphabet::symbol(light))) continue;
    std::vector<Piece> row;
    for (const Symbol eye : members(kEyes)) {
      Language events = between(words, light, eye);
      if (events.is_empty()) continue;
      const auto twin = std::find_if(row.begin(), row.end(), [&](const Piece& p) { return p.events == events; });
      if (twin != row.end())
        twin->eyes |= single(eye);
      else
        row.push_back({words.alphabet().letters({light}), single(eye), std::move(events)});
    }
    for (Piece& piece : row) {
      const auto twin = std::find_if(columns.begin(), columns.end(),
                                     [&](const Piece& p) { return p.eyes == piece.eyes && p.events == piece.events; });
      if (twin != columns.end())
        twin->lights |= piece.lights;
      else
        columns.push_back(std::move(piece));
    }
  }
  return columns;
}

std::optional<std::string> text_of(const std::vector<Piece>& pieces, std::size_t& steps) {
  std::string text;
  for (const Piece& piece : pieces) {
    const auto tree = shortest_tree(piece.events, steps);
    if (!tree) return std::nullopt;
    const std::string middle = spaced(*tree);
    text += (text.empty() ? "" : " | ") + write(piece.lights) + (middle.empty() ? "" : " " + middle) + " " +
            write(piece.eyes);
    if (text.size() > kLongest) return std::nullopt;
  }
  return text;
}

// When one of two pieces holds all that the other does, that may be said for both at once, and then what is left.
std::vector<std::vector<Piece>> ways_to_share(const std::vector<Piece>& pieces) {
  std::vector<std::vector<Piece>> ways;
  if (pieces.size() != 2 || pieces[0].eyes != pieces[1].eyes) return ways;
  for (const std::size_t small : {0u, 1u}) {
    const Piece &less = pieces[small], &more = pieces[1 - small];
    if (!less.events.is_subset_of(more.events)) continue;
    const LetterSet both = less.lights | more.lights;
    ways.push_back({{both, less.eyes, less.events}, {more.lights, more.eyes, more.events - less.events}});
    ways.push_back({{both, less.eyes, less.events}, more});
  }
  return ways;
}

}  // namespace

std::optional<std::string> simplest_expression(const Language& language) {
  const Language words = language & Language::universe();
  if (words.is_empty()) return "L E - L E";
  const std::vector<Piece> pieces = pieces_of(words);
  std::size_t steps = kEditSteps;
  std::optional<std::string> best = text_of(pieces, steps);
  for (const auto& way : ways_to_share(pieces))
    if (auto text = text_of(way, steps); text && (!best || text->size() < best->size())) best = std::move(text);
  if (!best) return std::nullopt;
  try {
    if (compile(*best) == words) return best;
  } catch (const LimitError&) {
    return std::nullopt;  // a text that cannot be read back is none
  }
  throw std::logic_error("internal error: '" + *best + "' is not the language that it was made from");
}

}  // namespace heckbert::taxonomy
