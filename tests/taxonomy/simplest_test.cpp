// Expressions back from automata: the language is kept for every small expression, and the text is what a person would
// have written.

#include <gtest/gtest.h>

#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/simplest.h>
#include <heckbert/taxonomy/work.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

TEST(SimplestExpression, KeepsTheLanguageOfEverySmallExpressionAndIsNoLonger) {
  for (std::size_t size = 1; size <= 5; ++size)
    for (const auto& regex : oracle::all_of_size(size, "DSG")) {
      const std::string text = "L(" + oracle::print(*regex) + ")E";
      const Language language = compile(text);
      const auto simplest = simplest_expression(language);
      ASSERT_TRUE(simplest) << text;
      ASSERT_EQ(compile(*simplest), language) << text << " became " << *simplest;
      std::string letters;
      for (const char c : *simplest)
        if (c != ' ') letters += c;
      EXPECT_LE(letters.size(), text.size()) << text << " became " << *simplest;
    }
}

TEST(SimplestExpression, KeepsTheLanguageOfEveryBuiltInGrammar) {
  ASSERT_FALSE(builtin_grammars().grammars.empty());
  for (const Grammar& grammar : builtin_grammars().grammars) {
    const auto simplest = simplest_expression(grammar.language);
    ASSERT_TRUE(simplest) << grammar.name;
    EXPECT_EQ(compile(*simplest), grammar.language) << grammar.name << " became " << *simplest;
  }
}

TEST(SimplestExpression, IsWhatAPersonWouldWrite) {
  struct Case {
    const char* expression;
    const char* simplest;
  };
  const Case cases[] = {
      {"L D E | L S E | L G E", "L X E"},
      {"LE | L(D|G)E | LS+E | L(D|G)S+E", "L N? S* E"},
      {"E(S*(D|G)?)L", "L N? S* E"},
      {"L(D*S*)*E", "L [DS]* E"},
      {"L(S*D)*S*E", "L [DS]* E"},
      {"LE | LDE | LDDE | LDD+DE", "L D* E"},
      {"LS+DE", "L S+ D E"},
      {"L(D|G|S|V)*E", "L .* E"},
      {"L(D|G|V)E", "L [^S] E"},
      {"LDrE | LDtE", "L D E"},
      {"LaDE | LeDE | LpDE", "[LaLpLe] D E"},
      {"LaDE | LDEl", "La D E | [LpLdLe] D El"},
      {"[LaLe]N?S*E | [LpLd]NS*E", "L N S* E | [LaLe] S* E"},
      {"L D{5} E", "L D{5} E"},
      {"LE", "L E"},
      {"LDE & LSE", "L E - L E"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(simplest_expression(compile(c.expression)), c.simplest) << c.expression;
    EXPECT_EQ(compile(c.simplest), compile(c.expression)) << c.expression;
  }
}

// Automata that edits would make too large, and more letters with labels than edits could ever be tried on.
TEST(SimplestExpression, TakesABoundedNumberOfSteps) {
  std::string labels = "L ";
  for (int i = 0; i < 18; ++i) labels += "[D'" + std::to_string(i) + "'S] ";
  for (const std::string& text : {std::string("L .* D.* .{24} E"), labels + "E"}) {
    const Language language = compile(text);
    const WorkLimit limit(kUnlimitedSteps);
    const auto simplest = simplest_expression(language);
    EXPECT_LT(limit.spent(), 20'000'000u) << text;
    EXPECT_TRUE(!simplest || compile(*simplest) == language) << text;
  }
}

}  // namespace
}  // namespace heckbert::taxonomy
