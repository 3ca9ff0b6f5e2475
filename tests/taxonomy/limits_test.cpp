// No expression takes much time or memory, whatever it says: its work is counted, and its memory measured by this
// program's own operator new. Times are for the benchmark of limits to print.

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/lattice.h>
#include <heckbert/taxonomy/partition.h>
#include <heckbert/taxonomy/work.h>
#include <taxonomy/hostile_expressions.h>

namespace {

std::size_t live_bytes = 0, peak_bytes = 0;

}  // namespace

void* operator new(std::size_t size) {
  void* block = std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  live_bytes += malloc_usable_size(block);
  peak_bytes = std::max(peak_bytes, live_bytes);
  return block;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* block = std::malloc(size);
  if (block != nullptr) live_bytes += malloc_usable_size(block);
  peak_bytes = std::max(peak_bytes, live_bytes);
  return block;
}
void operator delete(void* block) noexcept {
  live_bytes -= malloc_usable_size(block);
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}

namespace heckbert::taxonomy {
namespace {

using testing::HasSubstr;

constexpr std::size_t kMostBytes = 64 << 20;

enum class Outcome { Compiled, TooLarge, Wrong };

/// Reads the expression and expects that it keeps within the limits.
Outcome read_within_limits(const Hostile& hostile) {
  const std::size_t before = live_bytes;
  peak_bytes = before;
  const WorkLimit counter(kUnlimitedSteps);
  Outcome outcome = Outcome::Compiled;
  try {
    read_expression(hostile.text, hostile.dialect);
  } catch (const LimitError& error) {
    outcome = Outcome::TooLarge;
    // It says what is too large, with a caret under it.
    EXPECT_THAT(error.what(), HasSubstr("' is too large: ")) << hostile.name;
    EXPECT_THAT(error.what(), HasSubstr("^")) << hostile.name;
  } catch (const InputError&) {
    outcome = Outcome::Wrong;
  }
  EXPECT_LE(counter.spent(), kCompileSteps) << hostile.name;
  EXPECT_LE(peak_bytes - before, kMostBytes) << hostile.name;
  return outcome;
}

TEST(Limits, HoldForTheWorstExpressionsOfTheirKind) {
  std::size_t compiled = 0, too_large = 0;
  for (const Hostile& hostile : hostile_expressions()) {
    ASSERT_LE(hostile.text.size(), kLongestHostile) << hostile.name;
    const Outcome outcome = read_within_limits(hostile);
    compiled += outcome == Outcome::Compiled;
    too_large += outcome == Outcome::TooLarge;
  }
  EXPECT_GE(compiled, 60u);
  EXPECT_GE(too_large, 60u);
}

TEST(Limits, HoldForRandomExpressions) {
  std::mt19937_64 random(2026);
  for (const DialectFacts& dialect : kDialects) {
    std::size_t compiled = 0, wrong = 0;
    for (std::size_t i = 0; i < 30; ++i) {
      const std::string text = random_expression(dialect.dialect, 10u << i % 8, random);
      const Outcome outcome = read_within_limits({text, text, dialect.dialect});
      compiled += outcome == Outcome::Compiled;
      wrong += outcome == Outcome::Wrong;
      ASSERT_FALSE(testing::Test::HasFailure()) << text;
    }
    EXPECT_GE(compiled, 5u) << dialect.name;
    EXPECT_EQ(wrong, 0u) << dialect.name;
  }
}

TEST(Limits, NameTheCulprit) {
  struct Case {
    std::string text, culprit;
  };
  const std::vector<Case> cases{
      {"L.*D.{30}E", "'.*D.{30}'"},
      {"L D* (.*D.{30}) G E", "'.*D.{30}'"},
      {"L((X?){1000}){1000}E", "'((X?){1000}){1000}'"},
      {"L D G S (X?){1000} (DG){90} ((X?){1000}){1000} S E", "'((X?){1000}){1000}'"},
      {"LDE | LGE & L(D|G).*D.{20}S*E", "'.*D.{20}'"},
      {"E.{30}D.*L", "'.{30}D.*'"},
  };
  for (const Case& c : cases) try {
      compile(c.text);
      ADD_FAILURE() << c.text << " was accepted";
    } catch (const LimitError& error) {
      EXPECT_THAT(error.what(), HasSubstr(c.culprit + " is too large")) << c.text;
    }
}

TEST(Limits, BlameThePieceThatTookTheWorkNotTheOneThatCameLast) {
  // All pieces fit and each costs a third of what there is, save the last.
  std::string text = "L(";
  for (int i = 0; i < 40; ++i) text += ".{" + std::to_string(9900 + i) + "}|";
  try {
    compile(text + "D)E");
    ADD_FAILURE() << "accepted";
  } catch (const LimitError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'(.{9900}|.{9901}|"));
  }
}

TEST(Limits, AreSharedByAllOperationsOfAnExpression) {
  // One of these is cheap; two hundred are not.
  const std::string one = "&!L.{5000}DE";
  const WorkLimit counter(kUnlimitedSteps);
  EXPECT_NO_THROW(compile("L.*E" + one));
  std::string many = "L.*E";
  for (int i = 0; i < 200; ++i) many += one;
  EXPECT_THROW(compile(many), LimitError);
}

TEST(Limits, LeaveRoomForLongWordsAndManyWords) {
  const std::string word(9'998, 'D');
  EXPECT_EQ(compile("L" + word + "E").states().size(), word.size() + 4);
  const std::set<std::string> honest{"many words", "many whole words", "a long random word", "many labels",
                                     "a choice just not too long ago"};
  std::size_t found = 0;
  for (const Hostile& hostile : hostile_expressions()) {
    if (!honest.contains(hostile.name)) continue;
    EXPECT_EQ(read_within_limits(hostile), Outcome::Compiled) << hostile.name;
    ++found;
  }
  EXPECT_EQ(found, honest.size());
}

TEST(Limits, OfTextsThatAreWrongEverywhereListSomeErrors) {
  try {
    compile(std::string(5'000, 'Q'));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 101u);
    EXPECT_THAT(error.diagnostics().back().message, HasSubstr("too many errors"));
  }
}

// ---- several expressions

std::vector<Language> large_languages() {
  std::vector<Language> languages;
  for (int i = 0; i < 20; ++i) languages.push_back(compile("L(.{" + std::to_string(131 + 2 * i) + "})*E"));
  return languages;
}

TEST(Limits, HoldForQuestionsAboutManyLanguages) {
  const std::vector<Language> languages = large_languages();
  const std::size_t most = (languages.size() + 1) * kCompileSteps;
  const auto within = [&](auto ask) {
    const WorkLimit counter(kUnlimitedSteps);
    const std::size_t before = live_bytes;
    peak_bytes = before;
    try {
      ask();
    } catch (const LimitError&) {
      // A refusal is an answer.
    }
    EXPECT_LE(counter.spent(), most);
    EXPECT_LE(peak_bytes - before, kMostBytes);
  };
  within([&] { partition(languages); });
  std::vector<NamedLanguage> named;
  for (const Language& language : languages) named.push_back({"x", language});
  within([&] { lattice(named); });
}

TEST(WorkLimit, CountsForTheLimitAroundItAndNeverExceedsIt) {
  WorkLimit outer(100);
  outer.spend(10);
  {
    WorkLimit inner(50);
    inner.spend(30);
    EXPECT_THROW(inner.spend(21), WorkError);
    EXPECT_EQ(inner.spent(), 50u);
  }
  EXPECT_EQ(outer.spent(), 60u);
  {
    WorkLimit inner(1000);
    EXPECT_NO_THROW(inner.spend(40));
    try {
      inner.spend(1);
      FAIL();
    } catch (const WorkError& error) {
      EXPECT_THAT(error.what(), HasSubstr("more than 100 steps"));
    }
  }
  EXPECT_THROW(outer.spend(1), WorkError);
}

TEST(WorkLimit, AppliesToEveryOperation) {
  const Language large = compile("L.{5000}E"), star = compile("LD*E");
  const auto cost = [](auto operation) {
    const WorkLimit counter(kUnlimitedSteps);
    operation();
    return counter.spent();
  };
  const std::vector<std::size_t> costs{cost([&] { large | star; }),         cost([&] { large& star; }),
                                       cost([&] { large - star; }),         cost([&] { !large; }),
                                       cost([&] { concat(large, star); }),  cost([&] { repeat(large, 1, 1); }),
                                       cost([&] { reverse(large); }),       cost([&] { star.is_subset_of(!large); }),
                                       cost([&] { large.shortest_word(); })};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    EXPECT_GE(costs[i], i == 7 ? 100u : 5'000u) << i;
    EXPECT_LE(costs[i], 1'000'000u) << i;
  }
}

}  // namespace
}  // namespace heckbert::taxonomy
