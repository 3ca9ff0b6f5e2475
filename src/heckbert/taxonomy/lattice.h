#pragma once
// Languages ordered by inclusion: which algorithm captures all that another one does, and the shortest word that it
// captures beyond. Equal languages are one node; only neighbours are joined, the rest follows (Hasse's diagram).

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

struct NamedLanguage {
  std::string name;
  Language language;
};

struct LatticeNode {
  std::vector<std::string> names;  ///< of all that are equal, in the order given
  Language language;
  std::size_t level = 0;  ///< 0 for the smallest; else one above the highest language directly below
};

struct LatticeEdge {
  std::size_t below = 0, above = 0;  ///< places in nodes
  Word witness;                      ///< the shortest word that `above` has beyond `below`
};

struct Lattice {
  std::vector<LatticeNode> nodes;  ///< by level, then in the order given
  std::vector<LatticeEdge> edges;  ///< by `below`, then `above`
};

/// Cost: one inclusion test per ordered pair. Errors: LimitError when they take more work than reading that many
/// expressions may.
Lattice lattice(std::span<const NamedLanguage> languages);

/// A digraph in the DOT language, small languages at the bottom.
std::string dot(const Lattice& lattice);

}  // namespace heckbert::taxonomy
