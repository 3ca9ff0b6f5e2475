// What can occur at all, and whether classes divide it, against enumeration of all short words.

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/partition.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::taxonomy {
namespace {

std::vector<Word> all_words(std::size_t max_length) {
  std::vector<std::vector<Symbol>> middles{{}};
  std::size_t begin = 0;
  for (std::size_t n = 0; n < max_length; ++n) {
    const std::size_t end = middles.size();
    for (; begin < end; ++begin)
      for (const Symbol s : members(kEvents)) {
        middles.push_back(middles[begin]);
        middles.back().push_back(s);
      }
  }
  std::vector<Word> words;
  for (const auto& middle : middles)
    for (const Symbol light : members(kLights))
      for (const Symbol eye : members(kEyes)) words.push_back({light, middle, eye});
  return words;
}

TEST(PossibleWords, AreThoseThatMeetEveryCondition) {
  const Conditions conditions{.lights = single(Symbol::Lp),
                              .events = static_cast<SymbolSet>(with_letter('S') | single(Symbol::Dr)),
                              .eyes = kEyes,
                              .max_length = 2};
  const Language possible = possible_words(conditions);
  std::size_t count = 0;
  for (const Word& word : all_words(3)) {
    bool meets = word.light == Symbol::Lp && word.length() <= 2;
    for (const Symbol s : word.events) meets = meets && has(conditions.events, s);
    EXPECT_EQ(possible.contains(word), meets) << fine(word);
    count += meets;
  }
  EXPECT_EQ(count, 2u * (1 + 3 + 9));
  EXPECT_EQ(possible_words({}), Language::universe());
}

TEST(WhyNever, NamesTheFirstConditionThatLeavesNothing) {
  struct Case {
    const char* expression;
    Conditions conditions;
    const char* reason;  ///< nullptr: it can match
  };
  const SymbolSet d = with_letter('D'), ds = static_cast<SymbolSet>(d | with_letter('S'));
  const Case cases[] = {
      {"LS+DE", {}, nullptr},
      {"LDE & LSE", {}, "it has no word at all"},
      {"[LpLd]DE", {.lights = single(Symbol::La)}, "its words begin at Lp or Ld, and the only lights are La"},
      {"LDEl", {.eyes = single(Symbol::Ep)}, "its words end at El, and the only eye is Ep"},
      {"LDE | LpEl", {.lights = single(Symbol::Lp), .eyes = single(Symbol::Ep)}, nullptr},
      {"LaDE | LpEl",
       {.lights = single(Symbol::Lp), .eyes = single(Symbol::Ep)},
       "its words that are left end at El, and the only eye is Ep"},
      {"LS+DE", {.events = d}, "all its words have S, and the only events are D"},
      {"LSGE", {.events = d}, "all its words have G and S, and the only events are D"},
      {"L(S|G)E", {.events = d}, "all its words have some other event, and the only events are D"},
      {"LS+DE", {.events = 0}, "all its words have D and S, and nothing scatters"},
      {"LDtE", {.events = single(Symbol::Dr)}, "all its words have Dt, and the only events are Dr"},
      {"LD{3}E", {.max_length = 2}, "the shortest of its words, LDDDE, has 3 scatterings, and the depth allows 2"},
      {"LDE", {.max_length = 0}, "the shortest of its words, LDE, has 1 scattering, and the depth allows 0"},
      {"LGE | LDSDE",
       {.events = ds, .max_length = 2},
       "the shortest of its words that are left, LDSDE, has 3 scatterings, and the depth allows 2"},
  };
  for (const Case& c : cases) {
    const auto reason = why_never(compile(c.expression), c.conditions);
    EXPECT_EQ(reason, c.reason == nullptr ? std::nullopt : std::optional<std::string>(c.reason)) << c.expression;
    const bool possible = !(compile(c.expression) & possible_words(c.conditions)).is_empty();
    EXPECT_EQ(!reason, possible) << c.expression;
  }
}

TEST(Partition, AgreesWithCountingTheClassesOfEachWord) {
  const std::vector<std::vector<const char*>> lists{
      {"LE", "LDE", "L.+E"}, {"LE", "L.E", "L..+E"}, {"LDS*E", "LS+DS*E", "LX*DS*DS*E", "LS*E"}, {"LDtE"}, {}};
  const std::vector<Word> words = all_words(3);
  for (const auto& list : lists) {
    std::vector<Language> classes;
    for (const char* text : list) classes.push_back(compile(text));
    std::map<std::pair<std::size_t, std::size_t>, Word> overlaps;
    std::optional<Word> gap;
    for (const Word& word : words) {
      std::vector<std::size_t> of;
      for (std::size_t i = 0; i < classes.size(); ++i)
        if (classes[i].contains(word)) of.push_back(i);
      if (of.empty() && (!gap || word < *gap)) gap = word;
      for (std::size_t i = 0; i < of.size(); ++i)
        for (std::size_t j = i + 1; j < of.size(); ++j) {
          const auto [at, is_new] = overlaps.try_emplace({of[i], of[j]}, word);
          if (!is_new && word < at->second) at->second = word;
        }
    }
    const Partition p = partition(classes);
    EXPECT_EQ(p.gap, gap);
    ASSERT_EQ(p.overlaps.size(), overlaps.size());
    for (const Overlap& o : p.overlaps) EXPECT_EQ(o.shortest, overlaps.at({o.first, o.second}));
  }
}

// Jensen 1996: direct light, caustics and indirect light, together with what comes over mirrors only, are all of it.
TEST(Partition, OfJensensFourClassesHoldsForDiffuseAndSpecular) {
  const std::vector<Language> jensen{compile("LDS*E"), compile("LS+DS*E"), compile("LX*DS*DS*E"), compile("LS*E")};
  const SymbolSet ds = static_cast<SymbolSet>(with_letter('D') | with_letter('S'));
  const Partition p = partition(jensen, possible_words({.events = ds}));
  EXPECT_TRUE(p.is_disjoint());
  EXPECT_TRUE(p.is_exhaustive());
  EXPECT_EQ(plain(*partition(jensen).gap), "LGE");
  EXPECT_EQ(plain(*partition(std::span(jensen).first(3), possible_words({.events = ds})).gap), "LE");
}

TEST(Partition, AsksOnlyWithinTheWhole) {
  const std::vector<Language> classes{compile("LE | LDE | LDDE"), compile("LE | LSE | LDDE")};
  EXPECT_TRUE(partition(classes, compile("LDE | LSE")).is_disjoint());
  const Partition p = partition(classes, compile("LDE | LDDE"));
  ASSERT_EQ(p.overlaps.size(), 1u);
  EXPECT_EQ(plain(p.overlaps[0].shortest), "LDDE");
}

}  // namespace
}  // namespace heckbert::taxonomy
