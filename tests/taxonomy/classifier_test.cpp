#include <algorithm>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/classifier.h>
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

TEST(Classifier, AnswersAsEachLanguageDoesWhateverTheBudget) {
  std::vector<Language> languages;
  for (const Grammar& g : builtin_grammars().grammars)
    if (has_language(g)) languages.push_back(g.language);
  languages.push_back(Language::none());
  languages.push_back(Language::universe());
  const auto words = some_words();
  ASSERT_EQ(words.size(), 1u + 7 + 49 + 343 + 2401);
  std::vector<std::size_t> group_counts;
  for (const std::size_t budget : {kStateBudget, std::size_t{40}, std::size_t{10}, std::size_t{1}}) {
    const Classifier classifier(languages, budget);
    EXPECT_EQ(classifier.language_count(), languages.size());
    group_counts.push_back(classifier.group_count());
    for (const Word& word : words) {
      const Membership membership = classifier.classify(word);
      ASSERT_EQ(membership.size(), languages.size());
      for (std::size_t i = 0; i < languages.size(); ++i)
        ASSERT_EQ(membership[i], languages[i].contains(word)) << fine(word) << " in language " << i;
    }
  }
  EXPECT_EQ(group_counts.front(), 1u);
  EXPECT_EQ(group_counts.back(), languages.size());
  EXPECT_TRUE(std::is_sorted(group_counts.begin(), group_counts.end()));
  EXPECT_GT(group_counts[2], 1u);
}

TEST(Classifier, OfNoLanguagesAnswersNothing) {
  const Classifier classifier({});
  EXPECT_EQ(classifier.language_count(), 0u);
  EXPECT_TRUE(classifier.classify(parse_word("LDE")).empty());
}

}  // namespace
}  // namespace heckbert::taxonomy
