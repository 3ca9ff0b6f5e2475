#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/classifier.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {
namespace {

std::vector<Word> some_words() {
  std::vector<Word> words;
  std::vector<std::vector<Symbol>> bodies{{}};
  for (std::size_t i = 0; i < bodies.size() && bodies[i].size() < 4; ++i)
    for (const Symbol s : members(kEvents)) {
      bodies.push_back(bodies[i]);
      bodies.back().push_back(s);
    }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    words.push_back({static_cast<Symbol>(i % 4), bodies[i], i % 3 == 0 ? Symbol::El : Symbol::Ep});
  return words;
}

std::vector<Language> all_grammars() {
  std::vector<Language> languages;
  for (const Grammar& g : builtin_grammars().grammars)
    if (has_language(g)) languages.push_back(g.language);
  languages.push_back(Language::none());
  languages.push_back(Language::universe());
  return languages;
}

/// "exactly n events of this kind": independent of one another, so their states multiply.
std::vector<Language> counting_questions() {
  std::vector<Language> languages;
  for (const char* letter : {"Dr", "Dt", "Gr", "Gt", "Sr", "St", "V"})
    for (const char* count : {"1", "2"}) {
      const std::string others = std::string("[^") + letter + "]*";
      languages.push_back(compile("L " + others + "(" + letter + others + "){" + count + "} E"));
    }
  return languages;
}

Classifier::Prefix walk(const Classifier& classifier, const Word& word, WalkFrom from) {
  std::vector<Symbol> letters{word.light};
  letters.insert(letters.end(), word.events.begin(), word.events.end());
  letters.push_back(word.eye);
  if (from == WalkFrom::Eye) std::reverse(letters.begin(), letters.end());
  Classifier::Prefix at = classifier.start();
  for (const Symbol s : letters) at = classifier.step(at, s);
  return at;
}

Membership outcomes_at(const Classifier& classifier, Classifier::Prefix at) {
  Membership membership(classifier.language_count());
  for (std::size_t g = 0; g < classifier.group_count(); ++g) {
    const auto bits = classifier.members(classifier.outcome(at, g), g);
    for (std::size_t i = 0; i < membership.size(); ++i)
      if (bits[i / 64] >> i % 64 & 1) membership[i] = true;
  }
  return membership;
}

// The slow twin: each language by itself.
void expect_right_answers(const std::vector<Language>& languages, WalkFrom from, std::size_t budget) {
  const Classifier classifier(languages, from, budget);
  EXPECT_EQ(classifier.language_count(), languages.size());
  for (const Word& word : some_words()) {
    Membership expected;
    for (const Language& language : languages) expected.push_back(language.contains(word));
    ASSERT_EQ(classifier.classify(word), expected) << fine(word);
    const auto at = walk(classifier, word, from);
    ASSERT_EQ(outcomes_at(classifier, at), expected) << fine(word);
    std::vector<std::size_t> members;
    classifier.for_each_member(at, [&](std::size_t i) { members.push_back(i); });
    ASSERT_TRUE(std::is_sorted(members.begin(), members.end()));
    Membership listed(languages.size());
    for (const std::size_t i : members) listed[i] = true;
    ASSERT_EQ(listed, expected) << fine(word);
  }
}

TEST(Classifier, AnswersAsEachLanguageDoesFromEitherEnd) {
  ASSERT_EQ(some_words().size(), 1u + 7 + 49 + 343 + 2401);
  const auto languages = all_grammars();
  expect_right_answers(languages, WalkFrom::Light, kStateBudget);
  expect_right_answers(languages, WalkFrom::Eye, kStateBudget);
}

TEST(Classifier, AnswersTheSameInGroups) {
  const auto languages = all_grammars();
  for (const WalkFrom from : {WalkFrom::Light, WalkFrom::Eye}) {
    expect_right_answers(languages, from, 60);
    EXPECT_GT(Classifier(languages, from, 60).group_count(), 1u);
  }
  const auto questions = counting_questions();
  const Classifier grouped(questions, WalkFrom::Light, 100);
  EXPECT_GT(grouped.group_count(), 2u);
  EXPECT_LT(grouped.group_count(), questions.size());
  expect_right_answers(questions, WalkFrom::Eye, 100);
}

TEST(Classifier, HasMoreGroupsTheSmallerTheBudget) {
  const auto languages = all_grammars();
  std::vector<std::size_t> counts;
  for (const std::size_t budget : {kFusedStates, std::size_t{40}, std::size_t{10}, std::size_t{1}})
    counts.push_back(Classifier(languages, WalkFrom::Light, budget).group_count());
  EXPECT_EQ(counts.front(), 1u);
  EXPECT_EQ(counts.back(), languages.size());
  EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end()));
}

TEST(Classifier, KeepsEveryGroupWithinItsBudget) {
  const auto questions = counting_questions();
  for (const std::size_t budget : {std::size_t{50}, std::size_t{200}, kStateBudget}) {
    const Classifier classifier(questions, WalkFrom::Light, budget);
    EXPECT_LE(classifier.state_count(), budget * classifier.group_count());
  }
}

// A product of minimal automata has no state too many.
TEST(Classifier, IsMinimal) {
  // The start; between the ends, whether an S was met times whether the number of events is even; and after the eye,
  // which of the two languages have the word, the dead end being neither.
  const std::vector<Language> languages{compile("L .* S .* E"), compile("L (..)* E")};
  EXPECT_EQ(Classifier(languages).state_count(), 1u + 2 * 2 + 2 * 2);
}

TEST(Classifier, KeepsOneColumnForLettersThatNoLanguageTellsApart) {
  // L, D, other events, E, and the outcome.
  const std::vector<Language> languages{compile("L D* E"), compile("L .* E")};
  const Classifier classifier(languages);
  EXPECT_EQ(classifier.table_bytes(), classifier.state_count() * 5 * sizeof(std::uint16_t));
}

TEST(Classifier, RefusesToWalkMoreThanAPrefixHoldsAndStillClassifies) {
  auto languages = counting_questions();
  const auto more = all_grammars();
  languages.insert(languages.end(), more.begin(), more.end());
  const Classifier classifier(languages, WalkFrom::Light, 1);
  EXPECT_EQ(classifier.group_count(), languages.size());
  EXPECT_THROW(classifier.start(), LimitError);
  for (const Word& word : some_words()) {
    const Membership membership = classifier.classify(word);
    for (std::size_t i = 0; i < languages.size(); ++i)
      ASSERT_EQ(membership[i], languages[i].contains(word)) << fine(word) << " in language " << i;
  }
}

TEST(Classifier, NamesTheLanguageThatIsTooLargeReadFromTheEye) {
  const std::vector<Language> languages{compile("LDE"), compile("L .{14} D .* E")};
  EXPECT_NO_THROW(Classifier(languages, WalkFrom::Light));
  try {
    const Classifier classifier(languages, WalkFrom::Eye);
    FAIL() << classifier.state_count() << " states";
  } catch (const LimitError& e) {
    EXPECT_NE(std::string(e.what()).find("language 2 of 2"), std::string::npos) << e.what();
  }
}

TEST(Classifier, HoldsMoreLanguagesThanABlockHasBits) {
  std::vector<Language> languages;
  for (int n = 0; n < 100; ++n) languages.push_back(compile("L .{" + std::to_string(n) + "} E"));
  const Classifier classifier(languages);
  EXPECT_EQ(classifier.group_count(), 1u);
  EXPECT_EQ(classifier.outcome_count(0), 101u);
  for (std::size_t n = 0; n < 100; ++n) {
    const Word word{Symbol::La, std::vector<Symbol>(n, Symbol::Gt), Symbol::El};
    std::vector<std::size_t> members;
    classifier.for_each_member(walk(classifier, word, WalkFrom::Light), [&](std::size_t i) { members.push_back(i); });
    EXPECT_EQ(members, std::vector{n});
  }
}

/// "touches object i", which are independent of one another.
std::vector<Language> touching(int objects) {
  std::vector<Language> languages;
  for (int i = 0; i < objects; ++i) languages.push_back(compile("L .* .'o" + std::to_string(i) + "' .* E"));
  return languages;
}

TEST(Classifier, OfTenObjectsTouchedStaysSmall) {
  const Classifier classifier(touching(10));
  EXPECT_EQ(classifier.group_count(), 1u);
  EXPECT_EQ(classifier.state_count(), 1u + 1024 + 1024);  // the start; before and after the eye, which were touched
}

TEST(Classifier, OfFortyObjectsTouchedIsWalkedInGroups) {
  const auto languages = touching(40);
  for (const WalkFrom from : {WalkFrom::Light, WalkFrom::Eye}) {
    const Classifier classifier(languages, from);
    EXPECT_EQ(classifier.group_count(), 4u);
    const Symbol first = from == WalkFrom::Light ? Symbol::La : Symbol::Ep;
    const Symbol last = from == WalkFrom::Light ? Symbol::Ep : Symbol::La;
    auto at = classifier.step(classifier.start(), first);
    for (const char* object : {"o3", "o39", "table", "o12", "o3"})
      at = classifier.step(at, Symbol::Dr, classifier.label_class(object));
    at = classifier.step(classifier.step(at, Symbol::Sr), last);
    std::vector<std::size_t> touched;
    classifier.for_each_member(at, [&](std::size_t i) { touched.push_back(i); });
    EXPECT_EQ(touched, (std::vector<std::size_t>{3, 12, 39}));
    Membership expected(40);
    for (const std::size_t i : touched) expected[i] = true;
    EXPECT_EQ(classifier.classify(parse_word("LD'o3'D'o39'D'table'D'o12'SE")), expected);
  }
}

TEST(Classifier, TellsUnlabelledEventsFromOthers) {
  const std::vector<Language> languages{compile("L D[^'a'] E"), compile("L D'' E"), compile("L D'a' E")};
  const Classifier classifier(languages);
  for (const char* text : {"LDE", "LD'a'E", "LD'b'E"}) {
    const Word word = parse_word(text);
    Membership expected;
    for (const Language& language : languages) expected.push_back(language.contains(word));
    EXPECT_EQ(classifier.classify(word), expected) << text;
    auto at = classifier.step(classifier.start(), Symbol::La);
    at = word.labels.empty() ? classifier.step(at, Symbol::Dr)
                             : classifier.step(at, Symbol::Dr, classifier.label_class(word.label(1)));
    at = classifier.step(at, Symbol::Ep);
    EXPECT_EQ(outcomes_at(classifier, at), expected) << text;
  }
}

TEST(Classifier, OfNoLanguagesAnswersNothing) {
  const Classifier classifier({});
  EXPECT_EQ(classifier.language_count(), 0u);
  EXPECT_TRUE(classifier.classify(parse_word("LDE")).empty());
  classifier.for_each_member(classifier.step(classifier.start(), Symbol::La), [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace heckbert::taxonomy
