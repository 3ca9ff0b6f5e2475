// The shipped grammars: what they hold, how they lie in each other, and that grammar/README.md tells the truth.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/spectrum.h>

#include "taxonomy/markdown.h"

namespace heckbert::taxonomy {
namespace {

using markdown::file_text;
using markdown::table;
using markdown::text_of_code;

const Language& named(std::string_view name) {
  const Grammar* grammar = builtin_grammars().find(name);
  if (grammar == nullptr) throw std::runtime_error("no grammar " + std::string(name));
  return grammar->language;
}

Language read(std::string_view text) {
  return compile(text, builtin_grammars().names());
}

TEST(ShippedGrammars, AreListedInTheOrderOfTeaching) {
  std::vector<std::string> core, classes;
  for (const Grammar& g : core_algorithms(builtin_grammars())) core.push_back(g.name);
  EXPECT_EQ(core, (std::vector<std::string>{"ray-casting", "radiosity", "whitted", "lecture",
                                            "distribution-ray-tracing", "path-tracing", "global-illumination"}));
  const auto& all = builtin_grammars().grammars;
  for (std::size_t i = 0; i < core.size(); ++i) EXPECT_EQ(all[i].name, core[i]);  // they stand first
  for (const Grammar& g : all)
    if (g.kind == GrammarKind::Class) classes.push_back(g.name);
  EXPECT_EQ(classes, (std::vector<std::string>{"emission", "direct", "indirect", "caustic-c0", "caustic-c1",
                                               "caustic-c2", "caustic", "sds"}));
}

TEST(ShippedGrammars, AreTheThirtyEightRowsOfTheTable) {
  std::map<int, std::string> rows;
  std::set<std::string> without;
  for (const Grammar& g : builtin_grammars().grammars) {
    if (g.kind == GrammarKind::Class) continue;
    ASSERT_TRUE(g.number) << g.name;
    EXPECT_TRUE(rows.emplace(*g.number, g.name).second) << g.name << " and " << rows[*g.number];
    if (!has_language(g)) without.insert(g.name);
    if (g.is_core)
      EXPECT_LT(g.order, 100) << g.name;
    else
      EXPECT_EQ(g.order, 100 + *g.number) << g.name;
  }
  EXPECT_EQ(rows.size(), 38u);
  EXPECT_EQ(rows.begin()->first, 1);
  EXPECT_EQ(rows.rbegin()->first, 38);
  EXPECT_EQ(rows[5], "whitted");
  EXPECT_EQ(rows[17], "bidirectional-path-tracing");
  EXPECT_EQ(without, (std::set<std::string>{"ambient-occlusion", "irradiance-caching", "manifold-next-event",
                                            "metropolis", "path-guiding", "restir-pt", "screen-space-reflections"}));
}

TEST(ShippedGrammars, AreTheFilesOfTheDirectory) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HECKBERT_GRAMMAR_DIR)) {
    if (entry.path().extension() != ".grammar") continue;
    ++files;
    const Grammar* built_in = builtin_grammars().find(entry.path().stem().string());
    ASSERT_NE(built_in, nullptr) << entry.path();
    GrammarLibrary others = builtin_grammars();
    std::erase_if(others.grammars, [&](const Grammar& g) { return g.name == built_in->name; });
    const Grammar read = parse_grammar(file_text(entry.path()), entry.path().string(), others);
    EXPECT_EQ(read.language, built_in->language) << entry.path();
    EXPECT_EQ(read.source, built_in->source) << entry.path();
    EXPECT_FALSE(read.title.empty() || read.source.empty()) << entry.path();
  }
  EXPECT_EQ(files, builtin_grammars().grammars.size());
}

TEST(ShippedGrammars, LanguageDependsOnTheKindOfLight) {
  struct Case {
    const char* name;
    const char* hit;
    const char* delta;
  };
  const Case cases[] = {
      {"ray-casting", "LN?E", "LNE"},
      {"radiosity", "LD*E", "LD+E"},
      {"whitted", "LN?S*E", "LNS*E"},
      {"lecture", "LD?S*E", "LDS*E"},
      {"distribution-ray-tracing", "LD?(G|S)*E", "L(D|G)(G|S)*E"},
      {"path-tracing", "LX*E", "LNX*E"},
      {"global-illumination", "L.*E", "L.*E"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(named(c.name) & compile("[LaLe].*E"), compile(c.hit) & compile("[LaLe].*E")) << c.name;
    EXPECT_EQ(named(c.name) & compile("[LpLd].*E"), compile(c.delta) & compile("[LpLd].*E")) << c.name;
  }
}

TEST(ShippedGrammars, LieInEachOtherAsDerived) {
  const Language area = compile("La.*Ep");
  struct Case {
    const char* smaller;
    const char* larger;
  };
  const Case inside[] = {
      {"emission", "ray-casting"},
      {"ray-casting", "whitted"},
      {"emission", "radiosity"},
      {"lecture", "whitted"},
      {"lecture", "distribution-ray-tracing"},
      {"whitted", "path-tracing"},
      {"radiosity", "path-tracing"},
      {"distribution-ray-tracing", "path-tracing"},
      {"path-tracing", "global-illumination"},
      {"caustic-c0", "caustic-c1"},
      {"caustic-c1", "caustic-c2"},
      {"caustic-c2", "indirect"},
      {"whitted", "distribution-ray-tracing"},
  };
  for (const Case& c : inside) {
    EXPECT_TRUE((named(c.smaller) & area).is_subset_of(named(c.larger))) << c.smaller << " " << c.larger;
    EXPECT_FALSE((named(c.larger) & area).is_subset_of(named(c.smaller))) << c.smaller << " " << c.larger;
  }
}

TEST(ShippedGrammars, DifferAtTheShortestWitness) {
  struct Case {
    const char* holds;
    const char* lacks;
    const char* witness;  ///< plain, for area lights
  };
  const Case cases[] = {
      {"whitted", "radiosity", "LGE"},
      {"radiosity", "whitted", "LDDE"},
      {"lecture", "radiosity", "LSE"},
      {"path-tracing", "whitted", "LDDE"},
      {"path-tracing", "radiosity", "LGE"},
      {"path-tracing", "distribution-ray-tracing", "LDDE"},
      {"distribution-ray-tracing", "whitted", "LDGE"},
      {"whitted", "lecture", "LGE"},
      {"global-illumination", "path-tracing", "LVE"},
      {"caustic-c1", "caustic-c0", "LSDSE"},
      {"caustic-c2", "caustic-c1", "LSGE"},
      {"sds", "caustic-c1", "LSGSE"},
  };
  for (const Case& c : cases) {
    const auto witness = ((named(c.holds) - named(c.lacks)) & compile("La.*Ep")).shortest_word();
    ASSERT_TRUE(witness) << c.holds << " " << c.lacks;
    EXPECT_EQ(plain(*witness), c.witness) << c.holds << " " << c.lacks;
  }
  // A path tracer finds no caustic of a point light and nothing that it lights through mirrors.
  EXPECT_EQ(plain(*(compile("LpX*E") - named("path-tracing")).shortest_word()), "LE");
  EXPECT_EQ((named("path-tracing") & named("caustic") & compile("Lp.*E")).shortest_word(), std::nullopt);
}

TEST(ShippedClasses, EmissionDirectIndirectArePartition) {
  EXPECT_EQ(read("@emission | @direct | @indirect"), Language::universe());
  EXPECT_TRUE(read("@emission & @direct | @direct & @indirect | @emission & @indirect").is_empty());
  EXPECT_EQ(named("caustic"), named("caustic-c0"));
  EXPECT_EQ(named("sds"), read("LX*(S)(D|G)(S)X*E"));
}

// Counts of words with La, Ep, reflections only: the letters of a two- or three-letter notation.
SymbolWeights weights(double d, double s, double g = 0) {
  SymbolWeights w{};
  w[index(Symbol::La)] = w[index(Symbol::Ep)] = 1;
  w[index(Symbol::Dr)] = d;
  w[index(Symbol::Sr)] = s;
  w[index(Symbol::Gr)] = g;
  return w;
}

TEST(Spectrum, CountsWordsOfEachLength) {
  struct Case {
    const char* expression;
    std::vector<double> counts;
  };
  const Case cases[] = {
      {"@global-illumination", {1, 2, 4, 8, 16, 32, 64, 128, 256}},
      {"@radiosity", {1, 1, 1, 1, 1, 1, 1, 1, 1}},
      {"@whitted", {1, 2, 2, 2, 2, 2, 2, 2, 2}},
      {"@lecture", {1, 2, 2, 2, 2, 2, 2, 2, 2}},
      {"LS*D?S*E", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"LD*S*E", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"L(S?D)*S*E", {1, 2, 4, 7, 12, 20, 33, 54, 88}},
      {"LDX*E", {0, 1, 2, 4, 8, 16, 32, 64, 128}},
      {"LS*E | LNS*E | LX*NNS*E", {1, 2, 3, 5, 9, 17, 33, 65, 129}},
      // What no local strategy finds between a point light and a pinhole: the Fibonacci numbers.
      {"LS+(NS+)*E", {0, 1, 1, 2, 3, 5, 8, 13, 21}},
      // 2^n less the strings without 101 (OEIS A005251).
      {"@sds", {0, 0, 0, 1, 4, 11, 27, 63, 142}},
  };
  for (const Case& c : cases)
    EXPECT_EQ(length_spectrum(read(c.expression), weights(1, 1), 8), c.counts) << c.expression;
}

TEST(Spectrum, FurnaceEnergyEqualsItsClosedForm) {
  const double d = 0.5, s = 0.3;
  struct Case {
    const char* expression;
    double energy;
  };
  const Case cases[] = {
      {"@ray-casting", 1 + d},
      {"@whitted", (1 + d) / (1 - s)},
      {"@lecture", 15.0 / 7},
      {"@radiosity", 1 / (1 - d)},
      {"LS*D?S*E", 120.0 / 49},
      {"LD*S*E", 20.0 / 7},
      {"L(S?D)*S*E", 200.0 / 49},
      {"LDX*E", 2.5},
      {"LS*E | LNS*E | LX*NNS*E", 55.0 / 14},
      {"L.*E - LS+(NS+)*E", 49.0 / 11},
      {"@caustic", s * d / (1 - s)},
      {"@path-tracing", 5},
      {"@global-illumination", 5},
  };
  for (const Case& c : cases) {
    double total = 0;
    for (const double part : length_spectrum(read(c.expression), weights(d, s), 200)) total += part;
    EXPECT_NEAR(total, c.energy, 1e-12) << c.expression;  // the tail beyond 200 is below 0.8^200
  }
}

// --- grammar/README.md ---

const std::filesystem::path kReadme = std::filesystem::path(HECKBERT_GRAMMAR_DIR) / "README.md";

TEST(GrammarReadme, ListsWhatIsShipped) {
  const auto& grammars = builtin_grammars().grammars;
  std::size_t i = 0;
  for (const char* header : {"| teaching set | no. | lights hit | other lights |",
                             "| further algorithm | no. | lights hit | other lights |"})
    for (const auto& row : table(kReadme, header)) {
      const Grammar& g = grammars.at(i++);
      EXPECT_EQ(text_of_code(row[0]), g.name);
      EXPECT_EQ(row[1], std::to_string(g.number.value_or(0))) << g.name;
      EXPECT_EQ(text_of_code(row[2]), g.expression);
      EXPECT_EQ(text_of_code(row[3]), g.expression_delta) << g.name;
    }
  for (const auto& row : table(kReadme, "| no language | no. | kind | host |")) {
    const Grammar& g = grammars.at(i++);
    EXPECT_EQ(text_of_code(row[0]), g.name);
    EXPECT_EQ(row[1], std::to_string(g.number.value_or(0))) << g.name;
    EXPECT_EQ(text_of_code(row[2]), facts(g.kind).name) << g.name;
    EXPECT_EQ(row[3].empty() ? "" : text_of_code(row[3]), g.host) << g.name;
  }
  for (const auto& row : table(kReadme, "| class | expression |")) {
    const Grammar& g = grammars.at(i++);
    EXPECT_EQ(text_of_code(row[0]), g.name);
    EXPECT_EQ(text_of_code(row[1]), g.expression);
  }
  EXPECT_EQ(i, grammars.size());
}

TEST(GrammarReadme, ExampleFileIsRead) {
  const std::string readme = file_text(kReadme);
  const std::string fence = "```grammar\n";
  const std::size_t begin = readme.find(fence) + fence.size();
  const Grammar g =
      parse_grammar(readme.substr(begin, readme.find("```", begin) - begin), "README.md", builtin_grammars());
  EXPECT_EQ(g.name, "final-gathering");
  EXPECT_EQ(g.language, read("[LaLe]D?DS*E | [LpLd]DD?S*E"));
  EXPECT_EQ(g.biases.size(), 1u);
  EXPECT_EQ(g.variances.size(), 1u);
  EXPECT_EQ(g.preconditions.size(), 1u);
}

}  // namespace
}  // namespace heckbert::taxonomy
