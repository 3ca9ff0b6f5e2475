#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/taxonomy/dot.h>
#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/identification.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::taxonomy {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::vector<std::string> names_of(const std::string& expression) {
  std::vector<std::string> names;
  const auto found = identify(compile(expression, builtin_grammars().names()), builtin_grammars());
  for (const Match& m : found.same) names.push_back(describe(m));
  return names;
}

TEST(Identify, KnowsEveryBuiltInGrammarByItsOwnExpressions) {
  ASSERT_FALSE(builtin_grammars().grammars.empty());
  for (const Grammar& g : builtin_grammars().grammars) {
    if (g.language.is_empty()) continue;
    EXPECT_THAT(names_of("@" + g.name), Contains(g.title));
    const Language hit = in_form(g, LightForm::Hit), delta = in_form(g, LightForm::Delta);
    for (const Language& form : {hit, delta})
      EXPECT_NE(identify(form, builtin_grammars()).same.empty(), !form.is_empty()) << g.name;
  }
}

TEST(Identify, SaysForWhichLightsAndLetters) {
  EXPECT_THAT(names_of("LNS*E"), Contains("Whitted's recursive ray tracing, with lights that cannot be hit"));
  EXPECT_THAT(names_of("LN?S*E"), Contains("Whitted's recursive ray tracing, with lights that can be hit"));
  EXPECT_THAT(names_of("LpNS*Ep"), Contains("Whitted's recursive ray tracing, of Lp only, of Ep only"));
  EXPECT_THAT(names_of("LD(D|S)*E"), Contains(HasSubstr("of D or S only")));
}

TEST(Identify, NamesTheNearestNeighboursOtherwise) {
  const auto found = identify(compile("LD?S?E"), builtin_grammars());
  EXPECT_TRUE(found.same.empty());
  ASSERT_FALSE(found.containing.empty());
  ASSERT_FALSE(found.contained.empty());
  const Language asked = compile("LD?S?E");
  for (const Neighbour& n : found.containing) {
    EXPECT_TRUE(asked.is_subset_of(in_form(*n.grammar, n.form))) << n.grammar->name;
    EXPECT_EQ(n.witness, witness_outside(in_form(*n.grammar, n.form), asked));
  }
  for (const Neighbour& n : found.contained) {
    EXPECT_TRUE(in_form(*n.grammar, n.form).is_subset_of(asked)) << n.grammar->name;
    EXPECT_EQ(n.witness, witness_outside(asked, in_form(*n.grammar, n.form)));
  }
  // The lecture's tracer is the least of what contains it; Whitted's and all others contain that one.
  ASSERT_EQ(found.containing.size(), 1u);
  EXPECT_EQ(found.containing[0].grammar->name, "lecture");
  EXPECT_TRUE(identify(Language::none(), builtin_grammars()).same.empty());
}

TEST(Identify, ListsNothingTwice) {
  // Among area lights, Whitted's tracer as written and with lights that can be hit are the same.
  const Language whitted = builtin_grammars().find("whitted")->language;
  const auto found = identify(whitted & possible_words({.lights = single(Symbol::La)}), builtin_grammars());
  const auto is_whitted = [](const Match& m) { return m.grammar->name == "whitted"; };
  EXPECT_EQ(std::count_if(found.same.begin(), found.same.end(), is_whitted), 1);
  EXPECT_EQ(identify(whitted, builtin_grammars()).same.at(0).within, 0);
  // Many grammars are one language, with lights that can be hit or at all; a word less, it has them above it, and a
  // word more, below.
  const auto expect_distinct = [](const std::vector<Neighbour>& list, const std::string& grammar) {
    for (std::size_t i = 0; i < list.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NE(in_form(*list[i].grammar, list[i].form), in_form(*list[j].grammar, list[j].form))
            << grammar << ": " << list[i].grammar->name << " and " << list[j].grammar->name;
  };
  for (const char* name : {"ray-casting", "local-shading", "caustic", "photon-mapping"}) {
    const Language language = builtin_grammars().find(name)->language;
    const Language word = Language::of(*language.shortest_word());
    expect_distinct(identify(language - word, builtin_grammars()).containing, name);
    const Language outside = Language::of(*(Language::universe() - language).shortest_word());
    expect_distinct(identify(language | outside, builtin_grammars()).contained, name);
  }
}

TEST(Trace, VisitsTheStatesOfTheAutomaton) {
  const Language language = compile("LD?S*E");
  const auto steps = trace(language, parse_word("LDSDE"));
  ASSERT_EQ(steps.size(), 4u);
  StateId at = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].from, at);
    EXPECT_EQ(has(steps[i].expected.symbols(), steps[i].letter.symbol), steps[i].to.has_value());
    at = steps[i].to.value_or(0);
  }
  EXPECT_EQ(write(steps[3].expected), "[SE]");
  EXPECT_FALSE(steps[3].to);
}

TEST(Dot, HasAnEdgeForEachPairOfStatesAndNoDeadState) {
  EXPECT_EQ(dot(compile("LN?S*E"), "a \"b\""),
            "digraph {\n"
            "  label=\"a \\\"b\\\"\";\n"
            "  rankdir=LR;\n"
            "  node [shape=circle];\n"
            "  start [shape=point];\n"
            "  start -> 0;\n"
            "  0;\n"
            "  0 -> 1 [label=\"L\"];\n"
            "  1;\n"
            "  1 -> 3 [label=\"X\"];\n"
            "  1 -> 4 [label=\"E\"];\n"
            "  3;\n"
            "  3 -> 3 [label=\"S\"];\n"
            "  3 -> 4 [label=\"E\"];\n"
            "  4 [shape=doublecircle];\n"
            "}\n");
}

TEST(WriteSet, IsShortAndReadBack) {
  for (unsigned bits = 1; bits < (1u << kSymbolCount); ++bits) {
    const auto set = static_cast<SymbolSet>(bits);
    const std::string text = write(set);
    if ((set & kLights) != 0 && (set & (kEvents | kEyes)) == 0) {
      EXPECT_EQ(compile(text + "E"), concat(Language::of(set), Language::of(kEyes))) << text;
    } else if ((set & kEvents) == set) {
      EXPECT_EQ(compile("L" + text + "E"),
                concat(Language::of(kLights), concat(Language::of(set), Language::of(kEyes))))
          << text;
    }
  }
  EXPECT_EQ(write(kEvents), ".");
  EXPECT_EQ(write(with_letter('S')), "S");
  EXPECT_EQ(write(static_cast<SymbolSet>(kEvents & ~with_letter('S'))), "[^S]");
  EXPECT_EQ(write(static_cast<SymbolSet>(with_letter('S') | single(Symbol::Dr))), "[DrS]");
}

}  // namespace
}  // namespace heckbert::taxonomy
