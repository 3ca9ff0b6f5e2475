#include <gtest/gtest.h>

#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/lattice.h>

namespace heckbert::taxonomy {
namespace {

std::vector<NamedLanguage> builtin() {
  std::vector<NamedLanguage> languages;
  for (const Grammar& g : builtin_grammars().grammars) languages.push_back({g.name, g.language});
  return languages;
}

TEST(Lattice, JoinsExactlyTheNeighboursOfInclusion) {
  const auto languages = builtin();
  const Lattice found = lattice(languages);
  const auto proper = [&](std::size_t a, std::size_t b) {
    return a != b && found.nodes[a].language.is_subset_of(found.nodes[b].language);
  };
  std::size_t edge = 0;
  for (std::size_t a = 0; a < found.nodes.size(); ++a)
    for (std::size_t b = 0; b < found.nodes.size(); ++b) {
      bool is_neighbour = proper(a, b);
      for (std::size_t c = 0; c < found.nodes.size(); ++c)
        is_neighbour = is_neighbour && !(proper(a, c) && proper(c, b));
      if (!is_neighbour) continue;
      ASSERT_LT(edge, found.edges.size());
      EXPECT_EQ(found.edges[edge].below, a);
      EXPECT_EQ(found.edges[edge].above, b);
      EXPECT_EQ(found.edges[edge].witness, witness_outside(found.nodes[b].language, found.nodes[a].language));
      EXPECT_LT(found.nodes[a].level, found.nodes[b].level);
      ++edge;
    }
  EXPECT_EQ(edge, found.edges.size());
  EXPECT_GT(edge, 0u);
}

TEST(Lattice, MergesEqualLanguagesAndLosesNone) {
  const auto languages = builtin();
  const Lattice found = lattice(languages);
  std::size_t names = 0;
  for (const LatticeNode& node : found.nodes)
    for (const std::string& name : node.names) {
      EXPECT_EQ(builtin_grammars().find(name)->language, node.language) << name;
      ++names;
    }
  EXPECT_EQ(names, languages.size());
  for (std::size_t a = 0; a < found.nodes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_NE(found.nodes[a].language, found.nodes[b].language);
}

// Taxonomy notes 2.1: the chain of a teacher, for lights that can be hit.
TEST(Lattice, OfTheTeachingChainIsAChainWithWitnesses) {
  const std::vector<NamedLanguage> chain{{"all", compile("LX*E")},
                                         {"whitted", compile("LN?S*E")},
                                         {"ray casting", compile("LN?E")},
                                         {"emission", compile("LE")}};
  const Lattice found = lattice(chain);
  ASSERT_EQ(found.edges.size(), 3u);
  std::string text;
  for (const LatticeEdge& e : found.edges)
    text += found.nodes[e.below].names[0] + " " + plain(e.witness) + " " + found.nodes[e.above].names[0] + "\n";
  EXPECT_EQ(text, "emission LDE ray casting\nray casting LSE whitted\nwhitted LDDE all\n");
  for (std::size_t level = 0; level < chain.size(); ++level) EXPECT_EQ(found.nodes[level].level, level);
  EXPECT_TRUE(lattice({}).nodes.empty());
}

}  // namespace
}  // namespace heckbert::taxonomy
