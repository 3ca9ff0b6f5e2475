#include <heckbert/taxonomy/lattice.h>

#include <algorithm>
#include <tuple>

#include <heckbert/taxonomy/dot.h>
#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

namespace {

std::vector<LatticeNode> merged(std::span<const NamedLanguage> languages) {
  std::vector<LatticeNode> nodes;
  for (const NamedLanguage& l : languages) {
    const auto twin =
        std::find_if(nodes.begin(), nodes.end(), [&](const LatticeNode& n) { return n.language == l.language; });
    if (twin == nodes.end())
      nodes.push_back({{l.name}, l.language, 0});
    else
      twin->names.push_back(l.name);
  }
  return nodes;
}

using Relation = std::vector<std::vector<bool>>;  // [a][b]: a is a proper part of b

Relation proper_parts(const std::vector<LatticeNode>& nodes) {
  Relation below(nodes.size(), std::vector<bool>(nodes.size()));
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < nodes.size(); ++b)
      below[a][b] = a != b && nodes[a].language.is_subset_of(nodes[b].language);
  return below;
}

// The longest chain below each node. A node has more nodes below it than any of those has, so that order will do.
void set_levels(std::vector<LatticeNode>& nodes) {
  const Relation below = proper_parts(nodes);
  std::vector<std::pair<std::size_t, std::size_t>> by_count;
  for (std::size_t b = 0; b < nodes.size(); ++b) {
    std::size_t count = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) count += below[a][b];
    by_count.emplace_back(count, b);
  }
  std::sort(by_count.begin(), by_count.end());
  for (const auto& [count, b] : by_count)
    for (std::size_t a = 0; a < nodes.size(); ++a)
      if (below[a][b]) nodes[b].level = std::max(nodes[b].level, nodes[a].level + 1);
}

}  // namespace

Lattice lattice(std::span<const NamedLanguage> languages) {
  const WorkLimit limit((languages.size() + 1) * kCompileSteps);
  Lattice result{merged(languages), {}};
  set_levels(result.nodes);
  std::stable_sort(result.nodes.begin(), result.nodes.end(),
                   [](const LatticeNode& a, const LatticeNode& b) { return a.level < b.level; });
  const Relation below = proper_parts(result.nodes);
  for (std::size_t a = 0; a < result.nodes.size(); ++a)
    for (std::size_t b = 0; b < result.nodes.size(); ++b) {
      if (!below[a][b]) continue;
      bool is_direct = true;
      for (std::size_t c = 0; c < result.nodes.size(); ++c) is_direct = is_direct && !(below[a][c] && below[c][b]);
      if (is_direct)
        result.edges.push_back({a, b, *witness_outside(result.nodes[b].language, result.nodes[a].language)});
    }
  return result;
}

std::string dot(const Lattice& lattice) {
  std::string text = "digraph {\n  rankdir=BT;\n  node [shape=box];\n";
  for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
    std::string names;
    for (const std::string& name : lattice.nodes[i].names) names += (names.empty() ? "" : " = ") + name;
    text += "  " + std::to_string(i) + " [label=" + dot_string(names) + "];\n";
  }
  for (const LatticeEdge& e : lattice.edges)
    text += "  " + std::to_string(e.below) + " -> " + std::to_string(e.above) +
            " [label=" + dot_string(plain(e.witness)) + "];\n";
  return text + "}\n";
}

}  // namespace heckbert::taxonomy
