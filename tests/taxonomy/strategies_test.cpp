// The rule of samplability against its table, and against the languages of what no strategy finds.

#include <gtest/gtest.h>

#include <heckbert/taxonomy/enumeration.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/possible.h>
#include <heckbert/taxonomy/strategies.h>

namespace heckbert::taxonomy {
namespace {

std::size_t count(const char* text, Symbol light, Symbol eye) {
  Word word = parse_word(text);
  word.light = light;
  word.eye = eye;
  return strategies(word).size();
}

// Taxonomy notes 1.4.
TEST(Strategies, AreThoseOfTheTable) {
  struct Row {
    const char* word;
    std::size_t area_pinhole, point_pinhole, area_lens;
  };
  const Row table[] = {{"LE", 2, 1, 3},    {"LDE", 3, 2, 4},   {"LSE", 1, 0, 2},  {"LDSE", 2, 1, 3},
                       {"LSDE", 2, 1, 3},  {"LSSE", 1, 0, 2},  {"LDDE", 4, 3, 5}, {"LSDSE", 1, 0, 2},
                       {"LDSDE", 3, 2, 4}, {"LSDDSE", 2, 1, 3}};
  for (const Row& row : table) {
    for (const Symbol light : {Symbol::La, Symbol::Le}) {
      EXPECT_EQ(count(row.word, light, Symbol::Ep), row.area_pinhole) << row.word;
      EXPECT_EQ(count(row.word, light, Symbol::El), row.area_lens) << row.word;
    }
    for (const Symbol light : {Symbol::Lp, Symbol::Ld})
      EXPECT_EQ(count(row.word, light, Symbol::Ep), row.point_pinhole) << row.word;
  }
}

TEST(Strategies, HaveNamesAndVertexCountsThatAddUp) {
  using Names = std::vector<std::string_view>;
  const auto names = [](const char* text) {
    const Word word = parse_word(text);
    Names list;
    for (const Strategy& s : strategies(word)) {
      EXPECT_EQ(s.light_vertices + s.eye_vertices, word.length() + 2) << text;
      list.push_back(s.name);
    }
    return list;
  };
  EXPECT_EQ(names("LE"), (Names{"hit the light", "connect light and eye"}));
  EXPECT_EQ(names("LaDEl"), (Names{"hit the light", "next event", "light tracing", "hit the lens"}));
  EXPECT_EQ(names("LaSDDSEp"), (Names{"hit the light", "connect"}));
  EXPECT_EQ(names("LpSDEp"), (Names{"light tracing"}));
  EXPECT_EQ(names("LpDSEp"), (Names{"next event"}));
  EXPECT_EQ(names("LpSSEp"), (Names{}));
  EXPECT_EQ(names("LpGVEp").size(), 3u);
}

TEST(Strategies, AreNoneForASpecularChainAroundLoneDiffuseBouncesFromAPointToAPinhole) {
  const Language unreachable = compile("LS+(NS+)*E");
  std::size_t none = 0;
  for (const Word& word :
       first_words(plain_words(possible_words({.events = static_cast<SymbolSet>(kEvents & ~with_letter('V'))})),
                   {.max_length = 7})) {
    Word point = word;
    point.light = Symbol::Lp;
    EXPECT_EQ(strategies(point).empty(), unreachable.contains(point)) << plain(point);
    none += strategies(point).empty();
    EXPECT_FALSE(strategies(word).empty()) << plain(word);
  }
  EXPECT_EQ(none, 1u + 1 + 3 + 5 + 11 + 21 + 43);  // over D, G, S; over D and S alone Fibonacci's numbers
}

}  // namespace
}  // namespace heckbert::taxonomy
