// What expressions mean is tested in exhaustive_test.cpp (against a matcher) and grammar_files_test.cpp (the tables of
// the documentation); here are the corners of the syntax and the errors.

#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {
namespace {

Language read(std::string_view text) {
  return compile(text, builtin_grammars().names());
}

TEST(Expression, DifferentTextsOfOneLanguageAreEqual) {
  struct Case {
    const char* one;
    const char* other;
  };
  const Case cases[] = {
      {"LDE", "EDL"},
      {"LDE", "CDL"},
      {"LaSrDtEl", "ElDtSrLa"},
      {"E(D|S)*DL", "LD(D|S)*E"},
      {"L D # the first\n S # the second\r\n\tE", "LDSE"},
      {"LDE|ESL", "L[DS]E"},
      {"(LDE|ESL) - CSL", "LDE"},
      {"(LD|LS)E", "L(D|S)E"},
      {"(La|Lp)DE | [LdLe]D(Ep|El)", "LDE"},
      {"L{1}D{1,1}E{1}", "LDE"},
      {"LD{0}E", "LE"},
      {"LD{ 1 , 2 }E", "LDE | LDDE"},
      {"LD+?E", "LD*E"},
      {"LD**E", "LD*E"},
      {"L[^ Dt Sr ]E", "L[DrGStV]E"},
      {"L[X]E", "LXE"},
      {"L[^X]E", "LVE"},
      {"L[.]E", "L.E"},
      {"!!LDE", "LDE"},
      {"!LDE&!LSE", "!(LDE|LSE)"},
      {"(((LDE)))", "LDE"},
      {"@whitted-@radiosity", "@whitted - @radiosity"},
      {"@caustic-c1 -LSDE", "LS+DS*E - LSDE"},
      {"!@global-illumination", "LDE & LSE"},
      {"LDE - @direct | @emission", "LE"},
  };
  for (const Case& c : cases) EXPECT_EQ(read(c.one), read(c.other)) << c.one << " and " << c.other;
}

struct Expected {
  std::size_t line, column, length;
  const char* message;     ///< a part of it
  const char* suggestion;  ///< a part of it; "" none expected
};

struct Malformed {
  const char* text;
  std::vector<Expected> errors;
};

const std::vector<Malformed>& malformed() {
  static const std::vector<Malformed> cases = {
      // No or strange text.
      {"", {{1, 1, 1, "empty expression", ""}}},
      {"  # only a comment", {{1, 1, 1, "empty expression", ""}}},
      {"LD\x01"
       "E",
       {{1, 3, 1, "control character", ""}}},
      {"LD\xFF"
       "E",
       {{1, 3, 1, "not UTF-8", ""}}},
      {"LD%E", {{1, 3, 1, "unknown letter '%'; expected L, D, G, S, V, E, X, N or '.'", ""}}},
      // Letters.
      {"LQE", {{1, 2, 1, "unknown letter 'Q'", ""}}},
      {"ldse", {{1, 1, 4, "small letters are subscripts", "did you mean 'LDSE'?"}}},
      {"LsE", {{1, 1, 2, "'Ls' is no letter; expected L alone, or La, Lp, Ld, Le", "did you mean 'LS'?"}}},
      {"LDxE", {{1, 2, 2, "'Dx' is no letter; expected D alone, or Dr, Dt", "did you mean 'DX'?"}}},
      {"LXrE", {{1, 2, 2, "'Xr' is no letter; expected X without a subscript", "did you mean '[DrGrSr]'?"}}},
      {"L.tE", {{1, 2, 2, "'.t' is no letter; expected . without a subscript", "did you mean '[DtGtSt]'?"}}},
      {"LVrE", {{1, 2, 2, "expected V without a subscript", ""}}},
      {"CpDL", {{1, 1, 2, "expected C without a subscript", "did you mean 'Ep'?"}}},
      {"LRE", {{1, 2, 1, "reflection is a subscript", "Dr, Gr or Sr"}}},
      {"CDB", {{1, 3, 1, "the background", "Le"}}},
      {"L\xD0\x95", {{1, 2, 1, "a Cyrillic letter that looks like E", "did you mean 'E'?"}}},
      {"LD\xE2\x88\x97\xCE\x95",
       {{1, 3, 1, "an asterisk that is not '*'", "did you mean '*'?"},
        {1, 4, 1, "a Greek letter that looks like E", "'E'"}}},
      {"L\xC2\xA0"
       "DE",
       {{1, 2, 1, "a no-break space", "did you mean ' '?"}}},
      {"L\xEF\xBC\xA4"
       "E",
       {{1, 2, 1, "full-width", "did you mean 'D'?"}}},
      // Sets.
      {"L[]E", {{1, 2, 2, "an empty set", ""}}},
      {"L[^DGSV]E", {{1, 2, 7, "an empty set; expected [^ ] to leave some", ""}}},
      {"L[^]E", {{1, 2, 3, "an empty set", "'.'"}}},
      {"L[^L]E", {{1, 4, 1, "an end inside [^ ]", "[LaLe]"}}},
      {"L[DS", {{1, 2, 1, "'[' is never closed", ""}}},
      {"LDS]E", {{1, 4, 1, "']' closes nothing", ""}}},
      {"L[D|S]E", {{1, 4, 1, "letters stand side by side", "[DG]"}}},
      {"L[DdS]E", {{1, 3, 2, "'Dd' is no letter", "'DD'"}}},
      // Counts.
      {"LD{3,2}E", {{1, 3, 5, "the least number of this count exceeds the greatest", "did you mean '{2,3}'?"}}},
      {"LD{,3}E", {{1, 3, 4, "a count is written", "did you mean '{0,3}'?"}}},
      {"LD{}E", {{1, 3, 2, "a count is written", ""}}},
      {"LD{two}E", {{1, 3, 5, "a count is written {n}, {n,} or {n,m}", ""}}},
      {"LD{2E", {{1, 3, 1, "'{' is never closed", ""}}},
      {"LD{99999999999999999999}E", {{1, 3, 22, "a count above 10000", ""}}},
      {"LD}E", {{1, 3, 1, "'}' closes nothing", ""}}},
      // Structure.
      {"L(DE", {{1, 2, 1, "'(' is never closed", ""}}},
      {"LDE)", {{1, 4, 1, "')' closes nothing", ""}}},
      {"L(D|S))E)", {{1, 7, 1, "')' closes nothing", ""}, {1, 9, 1, "')' closes nothing", ""}}},
      {"L()E", {{1, 2, 2, "empty parentheses", "(...)?"}}},
      {"L(D|)E", {{1, 4, 1, "an empty alternative", "'?'"}}},
      {"|LDE", {{1, 1, 1, "an empty alternative", "'?'"}}},
      {"LDE||LSE", {{1, 4, 2, "'||' is no operator", "did you mean '|'?"}}},
      {"*LDE", {{1, 1, 1, "nothing to repeat before '*'", ""}}},
      {"L(+D)E", {{1, 3, 1, "nothing to repeat before '+'", ""}}},
      {"LDE &", {{1, 5, 1, "expected a whole expression after '&'", ""}}},
      {"- LDE", {{1, 1, 1, "expected a whole expression before '-'", ""}}},
      {"!", {{1, 1, 1, "expected a whole expression after '!'", ""}}},
      {"L!SE", {{1, 2, 1, "'!' works on whole paths", "[^S]"}}},
      // Set operators and names inside a word.
      {"L(D&S)E", {{1, 2, 5, "'&' works on whole paths", "(L..E) & (L..E)"}}},
      {"L(D-S)E", {{1, 2, 5, "'-' works on whole paths", "[^S]"}}},
      {"L(!S)E", {{1, 2, 4, "'!' works on whole paths", "[^S]"}}},
      {"L@causticE", {{1, 2, 9, "'@causticE' works on whole paths", "| & - !"}}},
      {"@caustic*", {{1, 1, 8, "'@caustic' works on whole paths", ""}}},
      {"@whited", {{1, 1, 7, "no class or algorithm is called 'whited'", "did you mean '@whitted'?"}}},
      {"@caustic-LDE", {{1, 1, 12, "no class or algorithm is called", "did you mean '@caustic - LDE'?"}}},
      {"@ LDE", {{1, 1, 1, "'@' without a name", ""}}},
      // Other notations.
      {"C<RD>L", {{1, 2, 4, "'<..>' groups", "did you mean 'Dr'?"}}},
      {"C<.S>+L", {{1, 2, 4, "'<..>' groups", "did you mean 'S'?"}}},
      {"C<R.>L", {{1, 2, 4, "'<..>' groups", "did you mean '[DrGrSr]'?"}}},
      {"CD'key", {{1, 3, 1, "the label is never closed", ""}}},
      {"LDE'key'", {{1, 4, 5, "the eye has no label", ""}}},
      {"L[D'a']'b'E", {{1, 8, 3, "none of the letters before this label has it", ""}}},
      {"L[^LaDp'a']E", {{1, 6, 2, "'Dp' is no letter", ""}}},
      {"[^L'a'D]DE", {{1, 3, 4, "an end inside [^ ]", "[LaLe]"}}},
      {"^LDE", {{1, 1, 1, "'^' is no operator here", "'!'"}}},
      // Ends.
      {"S+D", {{1, 1, 3, "no light end L and no eye end E", "did you mean 'L S+D E'?"}}},
      {"LDS", {{1, 1, 3, "no eye end E", "did you mean 'LDS E'?"}}},
      {"DSE", {{1, 1, 3, "no light end L", "did you mean 'L DSE'?"}}},
      {"EDS", {{1, 1, 3, "no light end L", "did you mean 'EDS L'?"}}},
      {"LD|SE", {{1, 1, 2, "no eye end E", "'LD E'"}, {1, 4, 2, "no light end L", "'L SE'"}}},
      {"D*", {{1, 1, 2, "matches the empty path", "did you mean 'L D* E'?"}}},
      {"(LDE)?", {{1, 1, 6, "matches the empty path", ""}}},
      {"LDL", {{1, 3, 1, "both ends are light ends (L)", "must be E"}}},
      {"ElSEp", {{1, 4, 2, "both ends are eye ends (E)", "must be L"}}},
      {"LDLSE", {{1, 3, 1, "'L' is an end in the middle", ""}}},
      {"LD(E|S)SE", {{1, 4, 1, "'E' is an end in the middle", ""}}},
      {"L+DE", {{1, 1, 1, "'L' is an end in the middle", ""}}},
      {"(LDE)+", {{1, 2, 1, "'L' is an end in the middle", ""}, {1, 4, 1, "'E' is an end in the middle", ""}}},
      {"L?DE", {{1, 3, 1, "'D' at the beginning of a path; expected L", ""}}},
      {"L(E|D+)", {{1, 5, 1, "'D' at the end of a path; expected E", ""}}},
      {"(L|D+)E", {{1, 4, 1, "'D' at the beginning of a path; expected L", ""}}},
      {"(L|S)DE", {{1, 4, 1, "'S' at the beginning of a path", ""}}},
      {"LD(E|S)", {{1, 6, 1, "'S' at the end of a path; expected E", ""}}},
      {"L[DE]E", {{1, 2, 4, "'[DE]' is an end in the middle", ""}}},
      {"LDE - S+D", {{1, 7, 3, "no light end L and no eye end E", "'L S+D E'"}}},
      // Several, in several lines.
      {"LqE\n| @none\n| LD{2,1}E",
       {{1, 1, 2, "'Lq' is no letter", ""}, {2, 3, 5, "is called 'none'", ""}, {3, 5, 5, "least", ""}}},
  };
  return cases;
}

TEST(ExpressionErrors, AreAllFoundWithPlaceAndSuggestion) {
  ASSERT_GE(malformed().size(), 60u);
  for (const Malformed& m : malformed()) {
    try {
      read(m.text);
      ADD_FAILURE() << "accepted: " << m.text;
    } catch (const InputError& e) {
      ASSERT_EQ(e.diagnostics().size(), m.errors.size()) << m.text << "\n" << e.what();
      for (std::size_t i = 0; i < m.errors.size(); ++i) {
        const Diagnostic& d = e.diagnostics()[i];
        const Expected& x = m.errors[i];
        EXPECT_EQ(std::tuple(d.line, d.column, d.length), std::tuple(x.line, x.column, x.length)) << e.what();
        EXPECT_NE(d.message.find(x.message), std::string::npos) << e.what();
        EXPECT_FALSE(d.code.empty()) << e.what();
        EXPECT_NE(d.suggestion.find(x.suggestion), std::string::npos) << e.what();
        EXPECT_EQ(d.source, "expression");
      }
    }
  }
}

TEST(ExpressionErrors, SuggestionsThatQuoteAnExpressionAreRight) {
  // A suggestion for a whole expression must itself be one.
  for (const char* text : {"S+D", "LDS", "DSE", "EDS", "ldse", "D*"}) {
    try {
      read(text);
    } catch (const InputError& e) {
      const std::string& s = e.diagnostics().at(0).suggestion;
      const std::size_t open = s.find('\''), close = s.rfind('\'');
      ASSERT_LT(open, close) << s;
      EXPECT_NO_THROW(read(s.substr(open + 1, close - open - 1))) << s;
    }
  }
}

TEST(ExpressionErrors, DeepNestingIsRefusedNotFatal) {
  const std::string parentheses(100000, '('), bangs(100000, '!'), stars = "LD" + std::string(100000, '*') + "E";
  std::string differences = "LDE";
  for (int i = 0; i < 20000; ++i) differences += "-LSE";
  for (const std::string& text : {parentheses, bangs, stars, differences}) {
    try {
      read(text);
      ADD_FAILURE() << "accepted";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("nested deeper than 500 levels"), std::string::npos);
    }
  }
  EXPECT_EQ(read("L" + std::string(400, '(') + "D" + std::string(400, ')') + "E"), read("LDE"));
}

TEST(Expression, AnyTextIsAcceptedWithinTheUniverseOrRefusedWithAPlace) {
  // Random strings of the notation's own characters, seed fixed: no crash, no language outside the universe.
  constexpr std::string_view kCharacters = "LLEEDGSVXN.arpt()|*+?{}12,[]^&-!@ #'<\n";
  std::mt19937 random(11);
  std::size_t accepted = 0;
  for (int round = 0; round < 40000; ++round) {
    std::string text;
    if (round % 2 == 0) text = "L";
    for (std::size_t n = random() % 9; n > 0; --n) text += kCharacters[random() % kCharacters.size()];
    if (round % 2 == 0) text += "E";
    try {
      const Language language = read(text);
      ASSERT_TRUE(language.is_subset_of(Language::universe())) << text;
      ++accepted;
    } catch (const InputError& e) {
      for (const Diagnostic& d : e.diagnostics()) {
        ASSERT_GE(d.line, 1u) << text;
        ASSERT_GE(d.column, 1u) << text;
        ASSERT_FALSE(d.message.empty()) << text;
      }
    }
  }
  EXPECT_GT(accepted, 500u);
}

}  // namespace
}  // namespace heckbert::taxonomy
