#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/taxonomy/word_literal.h>

#include "oracle/automaton.h"

namespace heckbert::taxonomy {
namespace {

using namespace literals;

// Distinct languages of all small expressions, and some with subscripts, media and several ends.
const std::vector<Language>& sample() {
  static const std::vector<Language> samples = [] {
    std::vector<Language> list{Language::none(), Language::universe()};
    std::vector<std::string> texts{"LaDrEp",  "[LpLd].*El", "L.*StV?E", "L(Dr|Dt)*E",
                                   "L(..)*E", "!L.*S.*E",   "LeX{2,3}E"};
    for (std::size_t nodes = 1; nodes <= 3; ++nodes)
      for (const auto& regex : oracle::all_of_size(nodes, "DSG")) texts.push_back("L(" + oracle::print(*regex) + ")E");
    for (const std::string& text : texts) {
      const Language language = compile(text);
      if (std::find(list.begin(), list.end(), language) == list.end()) list.push_back(language);
    }
    return list;
  }();
  return samples;
}

TEST(Language, SampleIsRich) {
  EXPECT_GE(sample().size(), 25u);
}

TEST(Language, BooleanLawsHoldForPairs) {
  for (const Language& a : sample()) {
    EXPECT_EQ(!!a, a);
    EXPECT_EQ(a | !a, Language::universe());
    EXPECT_EQ(a & !a, Language::none());
    EXPECT_EQ(a - a, Language::none());
    EXPECT_EQ(a | a, a);
    EXPECT_EQ(a & a, a);
    for (const Language& b : sample()) {
      ASSERT_EQ(a | b, b | a);
      ASSERT_EQ(a & b, b & a);
      ASSERT_EQ(!(a | b), (!a) & (!b));
      ASSERT_EQ(!(a & b), (!a) | (!b));
      ASSERT_EQ(a - b, a & !b);
      ASSERT_EQ(a | (a & b), a);
      ASSERT_EQ(a.is_subset_of(b), (a - b).is_empty());
      ASSERT_EQ(a.is_subset_of(b) && b.is_subset_of(a), a == b);
      ASSERT_EQ(reverse(a | b), reverse(a) | reverse(b));
    }
  }
}

TEST(Language, LawsHoldForTriples) {
  const std::vector<Language> few(sample().begin(), sample().begin() + 14);
  for (const Language& a : few)
    for (const Language& b : few)
      for (const Language& c : few) {
        ASSERT_EQ(a & (b | c), (a & b) | (a & c));
        ASSERT_EQ((a | b) | c, a | (b | c));
        ASSERT_EQ(concat(concat(a, b), c), concat(a, concat(b, c)));
        ASSERT_EQ(concat(a, b | c), concat(a, b) | concat(a, c));
        ASSERT_TRUE(!(a.is_subset_of(b) && b.is_subset_of(c)) || a.is_subset_of(c));
      }
}

TEST(Language, ReversalTwiceIsTheSameAndTurnsProductsRound) {
  for (const Language& a : sample()) {
    EXPECT_EQ(reverse(reverse(a)), a);
    for (const Language& b : sample()) ASSERT_EQ(reverse(concat(a, b)), concat(reverse(b), reverse(a)));
  }
}

TEST(Language, RepetitionIsRepeatedConcatenation) {
  const Language d = Language::of(with_letter('D')), s = Language::of(single(Symbol::Sr));
  for (const Language& a : {d, d | s, concat(d, s), d | Language::epsilon(), concat(d, s) | d, Language::epsilon(),
                            Language::none(), repeat(d, 0, std::nullopt), concat(d, d) | concat(s, s)}) {
    std::vector<Language> powers{Language::epsilon()};
    for (int n = 1; n <= 6; ++n) powers.push_back(concat(powers.back(), a));
    for (unsigned least = 0; least <= 5; ++least) {
      Language sum = powers[least];
      for (unsigned most = least; most <= 6; ++most) {
        sum = sum | powers[most];
        ASSERT_EQ(repeat(a, least, most), sum) << least << ".." << most;
      }
      // a{n,} = a{n} a*, and a* is the least solution of x = () | a x.
      const Language star = repeat(a, 0, std::nullopt);
      ASSERT_EQ(repeat(a, least, std::nullopt), concat(powers[least], star));
      ASSERT_EQ(star, Language::epsilon() | concat(a, star));
    }
    EXPECT_EQ(repeat(a, 3, 2), Language::none());
  }
}

TEST(Language, RandomAutomataMinimiseAsTheSlowTwinsDo) {
  std::mt19937 random(2025);
  std::size_t shrunk = 0;
  for (int round = 0; round < 300; ++round) {
    // Few groups of letters and few accepting states leave many states equivalent.
    const auto states = static_cast<StateId>(1 + random() % 24);
    const std::size_t groups = 1 + random() % 3, sparse = 2 + random() % 6;
    std::vector<State> automaton(states);
    for (State& s : automaton) {
      s.next.resize(kSymbolCount);
      s.accepting = random() % sparse == 0;
      for (std::size_t i = 0; i < kSymbolCount; ++i)
        s.next[i] = i < groups ? static_cast<StateId>(random() % states) : s.next[i % groups];
    }
    const Language language = Language::from_automaton(automaton);
    ASSERT_EQ(language.states(), oracle::minimize_by_table(automaton)) << "round " << round;
    if (states < 9) {
      ASSERT_EQ(language.states(), oracle::minimize_by_reversal(automaton)) << "round " << round;
    }
    shrunk += language.states().size() > 1 && language.states().size() < states;
  }
  EXPECT_GT(shrunk, 100u);
}

TEST(Language, BasicLanguagesHoldWhatTheySay) {
  EXPECT_TRUE(Language::none().is_empty());
  EXPECT_FALSE(Language::epsilon().is_empty());
  EXPECT_TRUE(Language::epsilon().contains(std::span<const Symbol>{}));
  const Language one = Language::of("LaDrStEl"_word);
  EXPECT_TRUE(one.contains("LaDrStEl"_word));
  EXPECT_EQ(one.shortest_word(), "LaDrStEl"_word);
  EXPECT_EQ(one, compile("LaDrStEl"));
  EXPECT_EQ(Language::universe(), compile("L.*E"));
  EXPECT_EQ(Language::universe().states().size(), 4u);
  EXPECT_FALSE(Language::none().shortest());
  EXPECT_FALSE(Language::of(single(Symbol::Sr)).shortest_word());
}

TEST(Language, ShortestWordIsTheFirstOfTheShortest) {
  struct Case {
    const char* expression;
    Word shortest;
  };
  const Case cases[] = {
      {"L.*E", "LE"_word},           {"L.+E", "LDE"_word},         {"L(S|D)(S|G)E", "LDGE"_word},
      {"LX*SX*NX*E", "LSDE"_word},   {"[LeLp]VE", "LpVE"_word},    {"!(LX*E)", "LVE"_word},
      {"LDDDE | LSSE", "LSSE"_word}, {"LStE | LGtE", "LGtE"_word}, {"L.*VE - L.{0,2}E", "LDDVE"_word},
  };
  for (const Case& c : cases) EXPECT_EQ(compile(c.expression).shortest_word(), c.shortest) << c.expression;
}

TEST(Language, GlossyRulesReadGlossyAsTheySay) {
  EXPECT_EQ(apply(GlossyRule::Keep, compile("LDE")), compile("LDE"));
  EXPECT_EQ(apply(GlossyRule::Diffuse, compile("LDS*E")), compile("L[DG]S*E"));
  EXPECT_EQ(apply(GlossyRule::Specular, compile("LDS*E")), compile("LD[SG]*E"));
  EXPECT_EQ(apply(GlossyRule::Diffuse, compile("LDrE | LDtSE")), compile("L[DrGr]E | L[DtGt]SE"));
  // Once G is read as something else no word with G is left for an expression that asks for it.
  EXPECT_EQ(apply(GlossyRule::Specular, compile("LGE")), Language::none());
  for (const Language& a : sample())
    for (const GlossyRuleFacts& f : kGlossyRules) {
      EXPECT_TRUE(apply(f.rule, a).is_subset_of(Language::universe()));
      EXPECT_EQ(apply(f.rule, !a), !apply(f.rule, a));
    }
}

TEST(Budget, NamesTheCulprit) {
  struct Case {
    const char* expression;
    const char* culprit;
    const char* limit;
  };
  const Case cases[] = {
      {"L(D|S)*D(D|S){30}E", "expression:1:2: error: '(D|S)*D(D|S){30}' is too large", "20000 states"},
      {"LSE | L(D|S)*D(D|S){30}E", "1:8: error: '(D|S)*D(D|S){30}'", "20000 states"},
      {"L(D (S|.*G.{40}))E", "1:8: error: '.*G.{40}'", "20000 states"},
      {"L(.*G.{40} | S)E", "1:3: error: '.*G.{40}'", "20000 states"},
      {"L(X{1000}){1000}E", "1:2: error: '(X{1000}){1000}'", "20000 states"},
      {"L(X{10000}){10000}E", "1:2: error: '(X{10000}){10000}'", "10000 times"},
      {"L(X{0,1000}){1000}E", "1:2: error: '(X{0,1000}){1000}'", "steps"},
      {"L((X?){1000}){1000}E", "1:2: error: '((X?){1000}){1000}'", "steps"},
      {"L(D{101})*E & L(D{103})*E & L(D{107})*E", "1:1: error: 'L(D{101})*E & L(D{103})*E & L(D{107})*E'",
       "20000 states"},
  };
  for (const Case& c : cases) {
    try {
      compile(c.expression);
      ADD_FAILURE() << c.expression << " was accepted";
    } catch (const LimitError& e) {
      EXPECT_NE(std::string(e.what()).find(c.culprit), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(c.limit), std::string::npos) << e.what();
    }
  }
}

TEST(Budget, LeavesRoomForLargeButHonestExpressions) {
  EXPECT_EQ(compile("LX{10000}E").states().size(), 10004u);
  EXPECT_EQ(compile("L(X?){1000}E").states().size(), 1004u);
  EXPECT_EQ(compile("L(X*){1000}E"), compile("LX*E"));
  EXPECT_EQ(compile("L(D|S)*D(D|S){12}E").states().size(), 8195u);
  // Hard from one end, easy from the other: what counts is the side from which words are read, not the writing.
  EXPECT_EQ(compile("E(D|S)*D(D|S){30}L"), compile("L(D|S){30}D(D|S)*E"));
}

}  // namespace
}  // namespace heckbert::taxonomy
