// Labels: what letters with labels match, that languages with labels are canonical, that they are written and read
// back, and every small expression with labels against the backtracking matcher.

#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/counting.h>
#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/enumeration.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/simplest.h>
#include <heckbert/taxonomy/word_trie.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Labels, SayWhichEventsALetterMeans) {
  const struct {
    std::string expression;
    std::vector<std::string> in, out;
  } table[] = {
      {"L D'wall' E", {"LD'wall'E", "L'key'D'wall'E", "LDt'wall'E"}, {"LDE", "LD'floor'E", "LS'wall'E"}},
      {"L D E", {"LDE", "LD'wall'E", "L'key'DE"}, {"LS'wall'E"}},
      {"L 'wall' E", {"LD'wall'E", "LS'wall'E", "LV'wall'E"}, {"LDE", "LD'floor'E"}},
      {"L [^'wall'] E", {"LDE", "LD'floor'E", "LSE"}, {"LD'wall'E", "LS'wall'E"}},
      {"L [^D'wall'] E", {"LDE", "LS'wall'E", "LD'floor'E"}, {"LD'wall'E"}},
      {"L [DS'ball'] E", {"LDE", "LD'ball'E", "LS'ball'E"}, {"LSE", "LS'wall'E"}},
      {"L [DS]'ball' E", {"LD'ball'E", "LS'ball'E"}, {"LDE", "LSE", "LG'ball'E"}},
      {"L D'' E", {"LDE"}, {"LD'wall'E"}},
      {"L [^''] E", {"LD'wall'E", "LS'x'E"}, {"LDE", "LSE"}},
      {"L'key' .* E", {"L'key'E", "L'key'DSE", "Lp'key'D'x'E"}, {"LE", "LDE", "L'fill'DE"}},
      {"[^L'key'] .* E", {"LE", "L'fill'DE", "LeS'key'E"}, {"L'key'E", "Lp'key'DE"}},
      {"[^La'key'] D E", {"LDE", "Lp'key'DE", "La'fill'DE"}, {"La'key'DE"}},
      {"E D'wall' L", {"LD'wall'E", "ED'wall'L"}, {"LDE"}},
      {"!(L .* 'wall' .* E)", {"LE", "LDDE", "LD'floor'E", "L'wall'DE"}, {"LD'wall'E", "LDS'wall'DE"}},
  };
  for (const auto& row : table) {
    const Language language = compile(row.expression);
    for (const std::string& word : row.in) EXPECT_TRUE(language.contains(parse_word(word))) << row.expression << word;
    for (const std::string& word : row.out) EXPECT_FALSE(language.contains(parse_word(word))) << row.expression << word;
  }
}

TEST(Labels, AreQuotedSoThatAnyNameCanBeWritten) {
  for (const std::string label : {"key light", "it's", "back\\slash", "\\'", "Wand groß", "a]b|c*", "\"", "#1"}) {
    const Word word{Symbol::La, {Symbol::Dr, Symbol::St}, Symbol::Ep, {"", label, ""}};
    EXPECT_EQ(parse_word(fine(word)), word) << fine(word);
    EXPECT_TRUE(compile("L D" + write_label(label) + " S E").contains(word)) << label;
    EXPECT_FALSE(compile("L D" + write_label(label + "x") + " S E").contains(word)) << label;
  }
  EXPECT_EQ(fine(parse_word("LD\"wall\"E")), "LaDr'wall'Ep");
  EXPECT_EQ(plain(parse_word("E S'ball' D L'key'")), "L'key'DS'ball'E");
}

TEST(Labels, OfWordsOrderAndCompare) {
  EXPECT_NE(parse_word("LD'a'E"), parse_word("LDE"));
  EXPECT_LT(parse_word("LDE"), parse_word("LD'a'E"));
  EXPECT_LT(parse_word("LD'a'E"), parse_word("LD'b'E"));
  EXPECT_LT(parse_word("LD'b'E"), parse_word("LSE"));
  EXPECT_EQ(parse_word("LD''E"), parse_word("LDE"));
}

TEST(Labels, MistakesInWordsAreNamed) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      parse_word(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("LD'wall"), HasSubstr("never closed"));
  EXPECT_THAT(error_of("'wall'LDE"), HasSubstr("a label without its letter"));
  EXPECT_THAT(error_of("LD 'wall'E"), HasSubstr("a label without its letter"));
  EXPECT_THAT(error_of("LDE'wall'"), HasSubstr("the eye has no label"));
}

TEST(Labels, ThatALanguageDoesNotTellApartLeaveNoTrace) {
  EXPECT_EQ(compile("L (D'a'|[^'a']|[GSV]) E"), compile("L . E"));
  EXPECT_EQ(compile("L D'a' E | L [^'a'GSV] E"), compile("L D E"));
  EXPECT_EQ(compile("L D'a' E - L D'b' E"), compile("L D'a' E"));
  EXPECT_THAT(compile("L D'b' S'a' E").alphabet().labels, ElementsAre("a", "b"));
  EXPECT_TRUE(compile("L D'b' E & L D'a' E").is_empty());
  EXPECT_EQ(compile("L D'b' E & L D'a' E"), Language::none());
  EXPECT_EQ(!(!compile("L'k' 'a'* E")), compile("L'k' 'a'* E"));
  EXPECT_EQ(reverse(reverse(compile("L'k' 'a' D* E"))), compile("L'k' 'a' D* E"));
}

TEST(Labels, OfWitnessesAreOnesThatMatter) {
  EXPECT_EQ(plain(*witness_outside(compile("L D E"), compile("L D'a' E"))), "LDE");
  EXPECT_EQ(plain(*witness_outside(compile("L D E"), compile("L [^D'a'] E"))), "LD'a'E");
  // Only a label that neither names tells these apart.
  const Word other = *witness_outside(compile("L [^'other'''] E"), compile("L S E"));
  EXPECT_EQ(plain(other), "LD'other 2'E");
  EXPECT_THAT(describe(explain(compile("L D'a' E"), parse_word("LDE")), parse_word("LDE")),
              HasSubstr("expected D'a', not Dr without a label"));
  EXPECT_THAT(describe(explain(compile("L D'a' E"), parse_word("LD'b'E")), parse_word("LD'b'E")),
              HasSubstr("expected D'a', not Dr'b'"));
  const auto expected = [](const std::string& expression, const std::string& word) {
    return describe(explain(compile(expression), parse_word(word)).expected);
  };
  EXPECT_EQ(expected("L D'a'* E", "LDE"), "D'a' or E");
  EXPECT_EQ(expected("L [^'a']* E", "LD'a'E"), "[^.'a'] or E");
  EXPECT_EQ(expected("L ([^SD'a']|S'b')* E", "LD'a'E"), "[^SD'a'], [.'b'] or E");
  // Labels that make no difference where they stand are not told one by one.
  EXPECT_EQ(first_words(compile("L [D'a'S'b'] E"), {.count = 99}).size(), 4u * 4u * 2u);
  EXPECT_EQ(count_words(compile("La [D'a'S'b']* Ep"), 2).back(), Natural(4u * 4u));
}

TEST(Labels, TouchQuestionsTogetherStaySmall) {
  std::vector<Language> questions;
  Language all = Language::none(), every = Language::universe();
  for (int i = 0; i < 10; ++i) {
    questions.push_back(compile("L .* 'o" + std::to_string(i) + "' .* E"));
    EXPECT_EQ(questions.back().states().size(), 5u);
    all = all | questions.back();
    every = every & questions.back();
  }
  EXPECT_EQ(all.states().size(), 5u);                      // some object: nothing to remember
  EXPECT_EQ(every.states().size(), 1u + 1024u + 1u + 1u);  // which of the ten: 2^10, start, end, dead
  const Classifier together(questions);
  EXPECT_EQ(together.group_count(), 1u);
  const Membership touched = together.classify(parse_word("LD'o3'S'o7'D'o3'DE"));
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(touched[i], i == 3 || i == 7) << i;

  // Forty objects would need 2^40 states; they are asked in groups, and the answers are the same.
  for (int i = 10; i < 40; ++i) questions.push_back(compile("L .* 'o" + std::to_string(i) + "' .* E"));
  const Classifier grouped(questions);
  EXPECT_GT(grouped.group_count(), 1u);
  const Membership of_many = grouped.classify(parse_word("LD'o3'S'o37'D'o3'DE"));
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(of_many[i], i == 3 || i == 37) << i;
}

TEST(Labels, AreFollowedByTheTrie) {
  WordTrie trie;
  const auto wall = trie.label("wall"), key = trie.label("key");
  EXPECT_EQ(trie.label("wall"), wall);
  EXPECT_NE(wall, key);
  EXPECT_EQ(trie.label(""), WordTrie::kNoLabel);
  const auto walk = [&](WordTrie::LabelId event, WordTrie::LabelId light) {
    const auto node = trie.step(trie.step(trie.eye(Symbol::Ep), Symbol::Sr), Symbol::Dr, event);
    return trie.step(node, Symbol::La, light);
  };
  EXPECT_EQ(trie.word(walk(wall, key)), parse_word("L'key'D'wall'SE"));
  EXPECT_EQ(trie.word(walk(wall, WordTrie::kNoLabel)), parse_word("LD'wall'SE"));
  EXPECT_EQ(trie.word(walk(WordTrie::kNoLabel, WordTrie::kNoLabel)), parse_word("LDSE"));
  EXPECT_EQ(walk(wall, key), walk(wall, key));
}

TEST(Labels, AreReadAndWrittenByTheDialects) {
  const struct {
    Dialect dialect;
    std::string text, ours;
  } table[] = {
      {Dialect::Osl, "C<RD'wall'>L", "[LaLpLd] Dr'wall' E"},
      {Dialect::Osl, "C<.D'wall'>[LO]", "[LaLpLd] D'wall' E"},
      {Dialect::Osl, "C'wall'L", "[LaLpLd] 'wall' E"},
      {Dialect::Osl, "CD<L.'key'>", "[LaLpLd]'key' D E"},
      {Dialect::RenderMan, "CD<L.'key'>", "L'key' D E"},
      {Dialect::Arnold, "C[^'coat']L", "[LaLpLd] [^'coat'] E"},
      {Dialect::VRay, "C[^'1''2']*L", "[LaLpLd] [^'1''2']* E"},
      {Dialect::Iray, "L<RD['a''b']>E", "L [Dr'a'Dr'b'] E"},
      {Dialect::Iray, "L<RD[^'a']>E", "L [^'a'DtGSV] E"},
      {Dialect::MoonRay, "C<RG'mat.coat'>L", "[LaLpLd] Gr'mat.coat' E"},
  };
  for (const auto& row : table) {
    const Language read = read_expression(row.text, row.dialect).language;
    EXPECT_EQ(read, compile(row.ours)) << row.text << " is " << simplest_expression(read).value_or("?");
  }
  for (const std::string text : {"La D'wall' E", "La [^'wall'GSV]* E", "[La'k'La'm'] [D'a'G'b']+ E", "La 'a' D* E"})
    for (const Dialect dialect : {Dialect::Osl, Dialect::Iray, Dialect::MoonRay, Dialect::Heckbert}) {
      const Language language = compile(text);
      const Writing written = write_expression(language, dialect);
      if (written.text.empty()) {
        EXPECT_FALSE(written.refusal.empty()) << text;
      } else {
        EXPECT_EQ(read_expression(written.text, dialect).language, language) << text << " as " << written.text;
      }
    }
}

// ---- exhaustively --------------------------------------------------------------------------------------------------

// Letters of words, each a character for the oracle, and of expressions, each a set of those.
const std::map<char, std::string> kConcrete{{'D', "Dr"}, {'d', "Dr'a'"}, {'e', "Dr'b'"},
                                            {'S', "Sr"}, {'s', "Sr'a'"}, {'t', "Sr'b'"}};
const std::map<char, std::pair<std::string, std::string>> kAtoms{
    {'1', {"D", "Dde"}}, {'2', {"D'a'", "d"}}, {'3', {"[^'a']", "DeSt"}}, {'4', {"''", "DS"}}, {'5', {"'b'", "et"}}};

oracle::RegexPtr with_sets(const oracle::RegexPtr& regex) {
  if (!regex) return nullptr;
  auto copy = std::make_shared<oracle::Regex>(*regex);
  if (copy->kind == oracle::Regex::Kind::Letter) {
    copy->kind = oracle::Regex::Kind::Set;
    copy->letters = kAtoms.at(regex->letter).second;
  }
  copy->left = with_sets(regex->left);
  copy->right = with_sets(regex->right);
  return copy;
}

TEST(Labels, EverySmallExpressionAgreesWithABacktrackingMatcher) {
  std::vector<std::string> keys = oracle::all_words(3, "DdeSst");
  std::vector<Word> words;
  for (const std::string& key : keys) {
    std::string text = "La";
    for (const char c : key) text += kConcrete.at(c);
    words.push_back(parse_word(text + "Ep"));
  }
  std::size_t matching = 0, expressions = 0;
  for (std::size_t size = 1; size <= 4; ++size)
    for (const auto& regex : oracle::all_of_size(size, "12345")) {
      std::string text;
      for (const char c : oracle::print(*regex)) {
        const auto atom = kAtoms.find(c);
        // Apart, or a label would belong to the letter before it.
        text += atom == kAtoms.end() ? std::string(1, c) : " " + atom->second.first;
      }
      const Language language = compile("L(" + text + ")E");
      const auto twin = with_sets(regex);
      for (std::size_t i = 0; i < words.size(); ++i) {
        const bool expected = oracle::matches(*twin, keys[i]);
        matching += expected;
        ASSERT_EQ(language.contains(words[i]), expected) << text << " on " << fine(words[i]);
      }
      if (++expressions % 7 != 0) continue;
      const auto simplest = simplest_expression(language);
      ASSERT_TRUE(simplest) << text;
      ASSERT_EQ(compile(*simplest), language) << text << " as " << *simplest;
    }
  EXPECT_EQ(expressions, 5u + 15u + 95u + 585u);
  EXPECT_GT(matching, 10'000u);
}

}  // namespace
}  // namespace heckbert::taxonomy
