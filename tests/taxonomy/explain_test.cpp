#include <gtest/gtest.h>

#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {
namespace {

TEST(Explain, SaysWhereAWordLeavesTheLanguage) {
  struct Case {
    const char* expression;
    const char* word;
    std::size_t letters_read;
    const char* text;
  };
  const Case cases[] = {
      {"LD?S*E", "LDSE", 4, "LDSE matches"},
      {"LD?S*E", "LSDE", 2, "LSDE: after LS expected S or E, not D"},
      {"LD?S*E", "LDDE", 2, "LDDE: after LD expected S or E, not D"},
      {"LDE", "LE", 1, "LE: after L expected D, not E"},
      {"LpDE", "LDE", 0, "LaDrEp: at the beginning expected Lp, not La"},
      {"LDtE", "LDE", 1, "LaDrEp: after L expected Dt, not Dr"},
      {"LD.*E - LDSE", "LDSE", 3, "LDSE: after LDS expected D, G, S or V, not E"},
      {"LD+E", "LGE", 1, "LGE: after L expected D, not G"},
  };
  for (const Case& c : cases) {
    const Language language = compile(c.expression);
    const Word word = parse_word(c.word);
    const Explanation e = explain(language, word);
    EXPECT_EQ(e.matches, language.contains(word)) << c.expression;
    EXPECT_EQ(e.letters_read, c.letters_read) << c.expression;
    EXPECT_EQ(describe(e, word), c.text);
  }
}

TEST(Explain, OfTheEmptyLanguageExpectsNothing) {
  const Word word = parse_word("LDE");
  const Explanation e = explain(Language::none(), word);
  EXPECT_FALSE(e.matches);
  EXPECT_EQ(e.expected, 0);
  EXPECT_EQ(describe(e, word), "LDE: no word matches at all");
}

TEST(Witness, IsTheShortestWordOutsideOrNothing) {
  EXPECT_EQ(witness_outside(compile("LD*E"), compile("LD?E")), parse_word("LDDE"));
  EXPECT_EQ(witness_outside(compile("LD?E"), compile("LD*E")), std::nullopt);
}

}  // namespace
}  // namespace heckbert::taxonomy
