// Every expression of up to five nodes over D, S, G against the slow twins of tests/oracle.

#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>

#include "oracle/automaton.h"
#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

constexpr std::string_view kLetters = "DSG";

std::vector<oracle::RegexPtr> all_up_to(std::size_t nodes, std::string_view letters = kLetters) {
  std::vector<oracle::RegexPtr> all;
  for (std::size_t n = 1; n <= nodes; ++n)
    for (const auto& regex : oracle::all_of_size(n, letters)) all.push_back(regex);
  return all;
}

// The letters between any light and any eye, reflected or transmitted: `variant` picks which.
Word word_of(std::string_view letters, std::size_t variant) {
  Word word{static_cast<Symbol>(variant % 4), {}, variant % 2 == 0 ? Symbol::Ep : Symbol::El};
  for (std::size_t i = 0; i < letters.size(); ++i)
    word.events.push_back(*find_symbol(letters[i], (variant >> i) % 2 == 0 ? 'r' : 't'));
  return word;
}

TEST(Exhaustive, EveryExpressionAgreesWithABacktrackingMatcher) {
  const auto expressions = all_up_to(5);
  const auto words = oracle::all_words(6, kLetters);
  ASSERT_EQ(expressions.size(), 3u + 9u + 45u + 243u + 1431u);
  ASSERT_EQ(words.size(), 1093u);
  std::size_t matching = 0;
  for (const auto& regex : expressions) {
    const std::string text = "L(" + oracle::print(*regex) + ")E";
    const Language language = compile(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool expected = oracle::matches(*regex, words[i]);
      matching += expected;
      ASSERT_EQ(language.contains(word_of(words[i], i)), expected) << text << " on L" << words[i] << "E";
    }
  }
  std::printf("%zu expressions, %zu words each, %zu matches\n", expressions.size(), words.size(), matching);
}

TEST(Exhaustive, EveryAutomatonEqualsTheTableFillingTwin) {
  for (const auto& regex : all_up_to(5)) {
    const std::string text = "L(" + oracle::print(*regex) + ")E";
    const auto twin = oracle::automaton_of(*regex);
    const auto minimal = oracle::minimize_by_table(twin);
    ASSERT_EQ(compile(text).states(), minimal) << text;
    ASSERT_EQ(Language::from_automaton(twin).states(), minimal) << text;
    ASSERT_EQ(oracle::minimize_by_reversal(twin), minimal) << text;
  }
}

TEST(Exhaustive, ParenthesesThatPrecedenceImpliesChangeNothing) {
  for (const auto& regex : all_up_to(5))
    ASSERT_EQ(compile("L(" + oracle::print(*regex) + ")E"), compile("L(" + oracle::print(*regex, true) + ")E"))
        << oracle::print(*regex);
}

TEST(Exhaustive, AnExpressionFromTheEyeMatchesTheWordsTurnedRound) {
  const auto words = oracle::all_words(5, kLetters);
  for (const auto& regex : all_up_to(4)) {
    const std::string text = "E(" + oracle::print(*regex) + ")L";
    const Language language = compile(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Word from_light = word_of(std::string(words[i].rbegin(), words[i].rend()), i);
      ASSERT_EQ(language.contains(from_light), oracle::matches(*regex, words[i])) << text << " on E" << words[i] << "L";
    }
  }
}

bool is_path(std::string_view w) {
  return w.size() >= 2 && w.front() == 'L' && w.back() == 'E' && w.find_first_not_of('D', 1) == w.size() - 1;
}

std::string turned(const std::string& word) {
  return {word.rbegin(), word.rend()};
}

// Whether every word is a path, all of one direction within each operand of '|'.
bool has_good_ends(const oracle::Regex& regex, const std::vector<std::string>& words) {
  if (regex.kind == oracle::Regex::Kind::Either)
    return has_good_ends(*regex.left, words) && has_good_ends(*regex.right, words);
  bool forward = true, backward = true;
  for (const std::string& word : words) {
    if (!forward && !backward) return false;
    if (!oracle::matches(regex, word)) continue;
    forward = forward && is_path(word);
    backward = backward && is_path(turned(word));
  }
  return forward || backward;
}

TEST(Exhaustive, ExactlyTheExpressionsOfWholePathsAreAccepted) {
  // Letters and ends anywhere, to seven nodes (L D* E has six); words of six letters show every way to go wrong.
  const auto words = oracle::all_words(6, "LDE");
  std::size_t accepted = 0;
  for (const auto& regex : all_up_to(7, "LDE")) {
    const std::string text = oracle::print(*regex);
    const bool expected = has_good_ends(*regex, words);
    try {
      const Language language = compile(text);
      ASSERT_TRUE(expected) << text << " was accepted";
      ++accepted;
      for (const std::string& word : words)
        if (is_path(word)) {
          const bool matched = oracle::matches(*regex, word) || oracle::matches(*regex, turned(word));
          ASSERT_EQ(language.contains(word_of(word.substr(1, word.size() - 2), 0)), matched) << text << " on " << word;
        }
    } catch (const InputError& e) {
      ASSERT_FALSE(expected) << e.what();
    }
  }
  EXPECT_GT(accepted, 50u);
}

// One bit per word.
std::vector<bool> matched_by(const oracle::Regex& regex, const std::vector<std::string>& words) {
  std::vector<bool> set;
  for (const std::string& word : words) set.push_back(oracle::matches(regex, word));
  return set;
}

TEST(Exhaustive, SetOperatorsAgreeWithSetsOfWords) {
  const auto words = oracle::all_words(4, kLetters);
  struct Operand {
    std::string text;
    std::vector<bool> words;
  };
  std::vector<Operand> operands;
  for (const auto& regex : all_up_to(3, "DS"))
    operands.push_back({"L(" + oracle::print(*regex) + ")E", matched_by(*regex, words)});
  struct Operator {
    const char* sign;
    bool (*expected)(bool a, bool b);
  };
  const Operator operators[] = {
      {" | ", [](bool a, bool b) { return a || b; }},   {" & ", [](bool a, bool b) { return a && b; }},
      {" - ", [](bool a, bool b) { return a && !b; }},  {" & !", [](bool a, bool b) { return a && !b; }},
      {" | !", [](bool a, bool b) { return a || !b; }}, {" - !", [](bool a, bool b) { return a && b; }},
  };
  for (const Operand& a : operands)
    for (const Operand& b : operands)
      for (const Operator& op : operators) {
        const std::string text = a.text + op.sign + b.text;
        const Language language = compile(text);
        for (std::size_t i = 0; i < words.size(); ++i)
          ASSERT_EQ(language.contains(word_of(words[i], i)), op.expected(a.words[i], b.words[i]))
              << text << " on L" << words[i] << "E";
      }
}

}  // namespace
}  // namespace heckbert::taxonomy
