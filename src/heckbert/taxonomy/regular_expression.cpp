#include <heckbert/taxonomy/regular_expression.h>

#include <algorithm>
#include <map>
#include <utility>

#include <heckbert/taxonomy/live.h>

namespace heckbert::taxonomy {

namespace {

Node nothing_needed() {
  return {.kind = NodeKind::Sequence};  // the empty string
}

bool is_empty_string(const Node& a) {
  return a.kind == NodeKind::Sequence && a.children.empty();
}

Node repetition(Node a, unsigned at_least, std::optional<unsigned> at_most) {
  Node node{.kind = NodeKind::Repeat, .at_least = at_least, .at_most = at_most};
  node.height = a.height + 1;
  node.children.push_back(std::move(a));
  return node;
}

bool is_unbounded(const Node& a) {
  return a.kind == NodeKind::Repeat && !a.at_most && a.at_least <= 1;
}

bool may_be_empty(const Node& a) {
  switch (a.kind) {
    case NodeKind::Letters:
      return false;
    case NodeKind::Repeat:
      return a.at_least == 0 || may_be_empty(a.children[0]);
    case NodeKind::Alternation:
      return std::any_of(a.children.begin(), a.children.end(), may_be_empty);
    default:
      return std::all_of(a.children.begin(), a.children.end(), may_be_empty);
  }
}

std::vector<Node> pieces_of(Node a) {
  if (a.kind == NodeKind::Sequence) return std::move(a.children);
  std::vector<Node> one;
  one.push_back(std::move(a));
  return one;
}

Node optional_of(Node a) {
  if (may_be_empty(a)) return a;
  if (is_unbounded(a)) return repetition(std::move(a.children[0]), 0, std::nullopt);
  return repetition(std::move(a), 0, 1);
}

// a | b by what they have in common at both ends; nothing when there is nothing in common.
std::optional<Node> factored(const Node& a, const Node& b) {
  std::vector<Node> left = pieces_of(a), right = pieces_of(b), front, back;
  while (!left.empty() && !right.empty() && same(left.front(), right.front())) {
    front.push_back(left.front());
    left.erase(left.begin());
    right.erase(right.begin());
  }
  while (!left.empty() && !right.empty() && same(left.back(), right.back())) {
    back.insert(back.begin(), left.back());
    left.pop_back();
    right.pop_back();
  }
  if (front.empty() && back.empty()) return std::nullopt;
  Node middle = either(sequence_of(std::move(left)), sequence_of(std::move(right)));
  std::vector<Node> all = std::move(front);
  all.push_back(std::move(middle));
  all.insert(all.end(), back.begin(), back.end());
  return sequence_of(std::move(all));
}

}  // namespace

bool same(const Node& a, const Node& b) {
  return a.kind == b.kind && a.set == b.set && a.at_least == b.at_least && a.at_most == b.at_most &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), same);
}

std::size_t size_of(const Node& tree) {
  std::size_t size = 1;
  for (const Node& child : tree.children) size += size_of(child);
  return size;
}

Node sequence_of(std::vector<Node> pieces) {
  std::vector<Node> flat;
  for (Node& piece : pieces)
    for (Node& part : pieces_of(std::move(piece))) {
      // a a* and a* a are a+, a* a* is a*.
      if (!flat.empty()) {
        Node& last = flat.back();
        if (is_unbounded(part) && part.at_least == 0 && same(part.children[0], last)) {
          last = repetition(std::move(last), 1, std::nullopt);
          continue;
        }
        if (is_unbounded(last) && last.at_least == 0 && same(last.children[0], part)) {
          last.at_least = 1;
          continue;
        }
        if (is_unbounded(last) && is_unbounded(part) && same(last.children[0], part.children[0]) &&
            last.at_least + part.at_least <= 1) {
          last.at_least += part.at_least;
          continue;
        }
      }
      flat.push_back(std::move(part));
    }
  if (flat.size() == 1) return std::move(flat[0]);
  Node node{.kind = NodeKind::Sequence};
  for (Node& part : flat) {
    node.height = std::max(node.height, part.height + 1);
    node.children.push_back(std::move(part));
  }
  return node;
}

Node either(Node a, Node b) {
  if (same(a, b)) return a;
  if (is_empty_string(a)) return optional_of(std::move(b));
  if (is_empty_string(b)) return optional_of(std::move(a));
  if (a.kind == NodeKind::Letters && b.kind == NodeKind::Letters) {
    a.set |= b.set;
    return a;
  }
  if (auto shared = factored(a, b)) return std::move(*shared);
  Node node{.kind = NodeKind::Alternation};
  for (Node* side : {&a, &b}) {
    std::vector<Node> parts;
    if (side->kind == NodeKind::Alternation)
      parts = std::move(side->children);
    else
      parts.push_back(std::move(*side));
    for (Node& part : parts) {
      const auto twin = std::find_if(node.children.begin(), node.children.end(),
                                     [&](const Node& child) { return same(child, part); });
      const auto letters = std::find_if(node.children.begin(), node.children.end(),
                                        [](const Node& child) { return child.kind == NodeKind::Letters; });
      if (twin != node.children.end()) continue;
      if (part.kind == NodeKind::Letters && letters != node.children.end()) {
        letters->set |= part.set;
        continue;
      }
      node.height = std::max(node.height, part.height + 1);
      node.children.push_back(std::move(part));
    }
  }
  if (node.children.size() == 1) return std::move(node.children[0]);
  return node;
}

Node star_of(Node a) {
  if (is_empty_string(a)) return a;
  if (is_unbounded(a) || (a.kind == NodeKind::Repeat && a.at_least == 0 && a.at_most == 1u)) {
    Node inner = std::move(a.children[0]);
    return star_of(std::move(inner));
  }
  return repetition(std::move(a), 0, std::nullopt);
}

std::optional<Node> regular_expression(const Language& language) {
  // Edges of a growing-shrinking graph: 0 is the start before the automaton, 1 the end behind it, state q is q + 2.
  using Edges = std::map<std::size_t, Node>;
  const std::vector<State>& states = language.states();
  if (states.size() > kTreeStates) return std::nullopt;
  std::vector<Edges> out(states.size() + 2);
  const auto add = [&](std::size_t from, std::size_t to, Node label) {
    const auto at = out[from].find(to);
    if (at == out[from].end())
      out[from].emplace(to, std::move(label));
    else
      at->second = either(std::move(at->second), std::move(label));
  };
  add(0, 2, nothing_needed());
  for (std::size_t q = 0; q < states.size(); ++q) {
    if (states[q].accepting) add(q + 2, 1, nothing_needed());
    for (const auto& [to, letters] : moves(language, static_cast<StateId>(q)))
      add(q + 2, to + 2, {.kind = NodeKind::Letters, .set = letters});
  }

  std::vector<std::size_t> rest(states.size());
  for (std::size_t q = 0; q < rest.size(); ++q) rest[q] = q + 2;
  while (!rest.empty()) {
    // The state whose going writes least: Delgado and Morais 2004.
    std::size_t best = 0, best_weight = static_cast<std::size_t>(-1);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      std::size_t in = 0, ways_in = 0, out_size = 0, ways_out = 0, loop = 0;
      for (std::size_t from = 0; from < out.size(); ++from)
        for (const auto& [to, label] : out[from]) {
          const std::size_t size = size_of(label);
          if (from == rest[i] && to == rest[i]) {
            loop = size;
          } else if (to == rest[i]) {
            in += size;
            ++ways_in;
          } else if (from == rest[i]) {
            out_size += size;
            ++ways_out;
          }
        }
      const std::size_t weight = in * ways_out + out_size * ways_in + loop * ways_in * ways_out;
      if (weight < best_weight) {
        best_weight = weight;
        best = i;
      }
    }
    const std::size_t q = rest[best];
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    if (best_weight > kTreeBudget) return std::nullopt;
    Edges leaving = std::move(out[q]);
    out[q].clear();
    Node loop = nothing_needed();
    if (const auto at = leaving.find(q); at != leaving.end()) {
      loop = star_of(std::move(at->second));
      leaving.erase(at);
    }
    for (std::size_t from = 0; from < out.size(); ++from) {
      const auto at = out[from].find(q);
      if (at == out[from].end()) continue;
      const Node entering = std::move(at->second);
      out[from].erase(at);
      for (const auto& [to, label] : leaving) add(from, to, sequence_of({entering, loop, label}));
    }
  }
  const auto result = out[0].find(1);
  if (result == out[0].end() || size_of(result->second) > kTreeBudget) return std::nullopt;
  return std::move(result->second);
}

}  // namespace heckbert::taxonomy
