#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/symbol_set.h>
#include <heckbert/taxonomy/word.h>
#include <heckbert/taxonomy/word_literal.h>
#include <heckbert/taxonomy/word_trie.h>

namespace heckbert::taxonomy {
namespace {

using namespace literals;

// All words with up to `length` events.
std::vector<Word> all_words(std::size_t length) {
  std::vector<std::vector<Symbol>> bodies{{}};
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].size() < length)
      for (const Symbol s : members(kEvents)) {
        bodies.push_back(bodies[i]);
        bodies.back().push_back(s);
      }
  std::vector<Word> words;
  for (const auto& body : bodies)
    for (const Symbol light : members(kLights))
      for (const Symbol eye : members(kEyes)) words.push_back({light, body, eye});
  return words;
}

TEST(Word, FineFormIsReadBack) {
  const auto words = all_words(3);
  ASSERT_EQ(words.size(), 8u * (1 + 7 + 49 + 343));
  for (const Word& word : words) ASSERT_EQ(parse_word(fine(word)), word) << fine(word);
}

TEST(Word, IsReadFromTheLightAndFromTheEye) {
  struct Case {
    const char* text;
    Word word;
  };
  const Case cases[] = {
      {"LE", {Symbol::La, {}, Symbol::Ep}},
      {"EL", {Symbol::La, {}, Symbol::Ep}},
      {"LDSE", {Symbol::La, {Symbol::Dr, Symbol::Sr}, Symbol::Ep}},
      {"ESDL", {Symbol::La, {Symbol::Dr, Symbol::Sr}, Symbol::Ep}},
      {"CSDL", {Symbol::La, {Symbol::Dr, Symbol::Sr}, Symbol::Ep}},
      {" Lp Dt V El ", {Symbol::Lp, {Symbol::Dt, Symbol::V}, Symbol::El}},
      {"ElGtLd", {Symbol::Ld, {Symbol::Gt}, Symbol::El}},
  };
  for (const Case& c : cases) EXPECT_EQ(parse_word(c.text), c.word) << c.text;
  EXPECT_EQ("LeStDEl"_word, (Word{Symbol::Le, {Symbol::St, Symbol::Dr}, Symbol::El}));
}

TEST(Word, PrintsPlainAndFine) {
  const Word word = "LpDtVSEl"_word;
  EXPECT_EQ(plain(word), "LDVSE");
  EXPECT_EQ(fine(word), "LpDtVSrEl");
  EXPECT_EQ(word.length(), 3u);
}

TEST(Word, FromEyePathTurnsTheWalkRound) {
  EXPECT_EQ(Word::from_eye_path(Symbol::El, {Symbol::Sr, Symbol::Dt}, Symbol::Le), "LeDtSrEl"_word);
}

TEST(Word, OrderIsByLengthThenLetterByLetter) {
  auto words = all_words(2);
  std::shuffle(words.begin(), words.end(), std::mt19937(7));
  std::sort(words.begin(), words.end());
  const auto letters = [](const Word& w) {
    std::vector<Symbol> all{w.light};
    for (const Symbol s : w.events) all.push_back(s);
    all.push_back(w.eye);
    return all;
  };
  for (std::size_t i = 1; i < words.size(); ++i) {
    ASSERT_NE(words[i - 1], words[i]);
    ASSERT_TRUE(words[i - 1].length() < words[i].length() ||
                (words[i - 1].length() == words[i].length() && letters(words[i - 1]) < letters(words[i])))
        << fine(words[i - 1]) << " " << fine(words[i]);
  }
}

TEST(Word, BadTextIsRefusedAtItsPlace) {
  struct Case {
    const char* text;
    std::vector<std::size_t> columns;
    const char* message;
  };
  const Case cases[] = {
      {"", {1}, "an empty word"},
      {"LDX*E", {3, 4}, "stands for several words"},
      {"DSE", {1}, "at the beginning of a path"},
      {"LDS", {3}, "at the end of a path"},
      {"DS", {1, 2}, "at the beginning of a path"},
      {"LDL", {3}, "both ends are light ends"},
      {"L", {1}, "both ends are light ends"},
      {"LDLE", {3}, "is an end in the middle"},
      {"LDsE", {2}, "expected Dr, Dt"},
      {"LVrE", {2}, "expected V without a subscript"},
      {"dE", {1}, "small letters are subscripts"},
      {"L\xD0\x95", {2}, "unknown letter"},
      {"LQD?E", {2, 4}, "unknown letter"},
  };
  for (const Case& c : cases) {
    try {
      parse_word(c.text);
      ADD_FAILURE() << "'" << c.text << "' was accepted";
    } catch (const InputError& e) {
      std::vector<std::size_t> columns;
      for (const Diagnostic& d : e.diagnostics()) columns.push_back(d.column);
      EXPECT_EQ(columns, c.columns) << e.what();
      EXPECT_NE(std::string(e.what()).find(c.message), std::string::npos) << e.what();
    }
  }
}

TEST(WordTrie, EqualWordsEndAtEqualNodes) {
  WordTrie trie;
  std::vector<WordTrie::Node> nodes;
  const auto words = all_words(3);
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < words.size(); ++i) {
      WordTrie::Node node = trie.eye(words[i].eye);
      for (auto s = words[i].events.rbegin(); s != words[i].events.rend(); ++s) node = trie.step(node, *s);
      node = trie.step(node, words[i].light);
      if (round == 0)
        nodes.push_back(node);
      else
        ASSERT_EQ(node, nodes[i]);
      ASSERT_EQ(trie.word(node), words[i]);
    }
  std::sort(nodes.begin(), nodes.end());
  EXPECT_EQ(std::unique(nodes.begin(), nodes.end()), nodes.end());
  EXPECT_EQ(trie.size(), words.size() + 2 * (1 + 7 + 49 + 343));  // finished words and their prefixes
}

TEST(WordTrie, HoldsLongWords) {
  WordTrie trie;
  Word word{Symbol::Lp, std::vector<Symbol>(5000, Symbol::St), Symbol::El};
  word.events[17] = Symbol::V;
  WordTrie::Node node = trie.eye(word.eye);
  for (auto s = word.events.rbegin(); s != word.events.rend(); ++s) node = trie.step(node, *s);
  EXPECT_EQ(trie.word(trie.step(node, word.light)), word);
}

TEST(SymbolSet, DescribesLettersForPeople) {
  struct Case {
    SymbolSet set;
    const char* text;
  };
  const Case cases[] = {
      {0, ""},
      {single(Symbol::Sr), "Sr"},
      {kEyes, "E"},
      {kEvents, "D, G, S or V"},
      {static_cast<SymbolSet>(with_letter('D') | single(Symbol::Sr) | kEyes), "D, Sr or E"},
  };
  for (const Case& c : cases) EXPECT_EQ(describe(c.set), c.text);
}

}  // namespace
}  // namespace heckbert::taxonomy
