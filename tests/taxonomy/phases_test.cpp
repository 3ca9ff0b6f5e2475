// The stages of an expression agree with the engine that never builds them.

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/live.h>
#include <heckbert/taxonomy/phases.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

// The automaton that the text of a part's subsets describes, read back.
Language language_of(const std::string& subsets) {
  std::map<std::string, StateId> number;
  std::vector<State> states;
  const auto state = [&](const std::string& name) {
    const auto [at, is_new] = number.try_emplace(name, static_cast<StateId>(states.size()));
    if (is_new) states.push_back({std::vector<StateId>(kSymbolCount, 1), false});
    return at->second;
  };
  state("{0}");
  state("nowhere");  // number 1
  std::size_t begin = 0;
  for (std::size_t end = subsets.find('\n'); end != std::string::npos; end = subsets.find('\n', begin)) {
    const std::string line = subsets.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t close = line.find('}') + 1, arrow = line.find("-> ");
    const StateId from = state(line.substr(0, close));
    if (arrow == std::string::npos) {
      states[from].accepting = true;
      continue;
    }
    const std::string letters = line.substr(close + 2, arrow - close - 2);
    const StateId to = state(line.substr(arrow + 3));
    SymbolSet set = 0;
    for (unsigned bits = 1; bits < (1u << kSymbolCount) && set == 0; ++bits)
      if (write(static_cast<SymbolSet>(bits)) == letters) set = static_cast<SymbolSet>(bits);
    for (const Symbol s : members(set)) states[from].next[index(s)] = to;
  }
  return Language::from_automaton(states);
}

TEST(Phases, HaveTheLanguageOfTheExpressionAtEveryStage) {
  for (std::size_t size = 1; size <= 3; ++size)
    for (const auto& regex : oracle::all_of_size(size, "DS")) {
      const std::string text = "L(" + oracle::print(*regex) + ")E";
      const Phases found = phases(text);
      ASSERT_EQ(found.forms.size(), 1u) << text;
      const std::vector<PartPhases>& parts = found.forms[0].parts;
      ASSERT_EQ(parts.size(), 1u) << text;
      ASSERT_EQ(language_of(parts[0].subsets), compile(text)) << text << "\n" << parts[0].subsets;
      ASSERT_LE(found.states, parts[0].deterministic) << text;
    }
}

TEST(Phases, AreShownForEachPartOfAnExpression) {
  const FormPhases found = phases("LDD?E - E[DS]L").forms.at(0);
  EXPECT_EQ(found.tree,
            "first without second\n"
            "  sequence\n    L\n    D\n    repeat 0 to 1\n      D\n    E\n"
            "  sequence\n    E\n    [DS]\n    L\n");
  ASSERT_EQ(found.parts.size(), 2u);
  EXPECT_EQ(found.parts[0].expression, "LDD?E");
  EXPECT_EQ(found.parts[0].positions, "0 start -> 1\n1 L -> 2\n2 D -> 3 4\n3 D -> 4\n4 E accepts\n");
  EXPECT_EQ(found.parts[0].subsets,
            "{0} -L-> {1}\n{1} -D-> {2}\n{2} -D-> {3}\n{2} -E-> {4}\n{3} -E-> {4}\n{4} accepts\n");
  EXPECT_EQ(found.parts[1].subsets, "{0} -L-> {1}\n{1} -[DS]-> {2}\n{2} -E-> {3}\n{3} accepts\n");
  EXPECT_THROW(phases("LD{300}E"), LimitError);
  EXPECT_THROW(phases("LDDL"), InputError);
}

TEST(Phases, OfOtherDialectsAreShownInOurLettersFromTheLight) {
  const Phases found = phases("CD|S<TG>O", Dialect::Osl);
  const FormPhases& form = found.forms.at(0);
  EXPECT_EQ(form.tree, "sequence\n  E\n  one of\n    D\n    S\n  Gt\n  La\n");
  ASSERT_EQ(form.parts.size(), 1u);
  EXPECT_EQ(form.parts[0].expression, "CD|S<TG>O");
  EXPECT_EQ(language_of(form.parts[0].subsets), compile("LaGt[DS]E"));
  const Phases operators = phases("CDO | ^CL", Dialect::VRay);
  EXPECT_EQ(operators.forms.at(0).parts.size(), 2u);
  EXPECT_EQ(phases("E D La", Dialect::Iray).minimal, phases("LaDE").minimal);
  EXPECT_THROW(phases("CD?L", Dialect::Osl), InputError);
}

TEST(Phases, OfAGrammarAreThoseOfBothItsExpressions) {
  for (const Grammar& grammar : builtin_grammars().grammars) {
    if (!has_language(grammar)) continue;
    const Phases found = phases(grammar);
    std::size_t forms = grammar.expression != kNoPath;
    forms += !grammar.expression_delta.empty() && grammar.expression_delta != kNoPath;
    EXPECT_EQ(found.forms.size(), forms) << grammar.name;
  }
  const Phases whitted = phases(*builtin_grammars().find("whitted"));
  ASSERT_EQ(whitted.forms.size(), 2u);
  EXPECT_EQ(whitted.forms[0].lights, "lights that a ray can hit, La and Le");
  EXPECT_EQ(language_of(whitted.forms[1].parts.at(0).subsets), compile("LNS*E"));
  EXPECT_EQ(whitted.minimal, phases("[LaLe]N?S*E | [LpLd]NS*E").minimal);
}

}  // namespace
}  // namespace heckbert::taxonomy
