// Words listed and counted, against enumeration by a backtracking matcher and the counts of the literature.

#include <algorithm>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/counting.h>
#include <heckbert/taxonomy/enumeration.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/possible.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

/// One light, one eye, each plain letter counted once.
Language counted(const Language& language, std::string_view letters) {
  std::vector<SymbolSet> sets{single(Symbol::La), single(Symbol::Ep)};
  for (const char c : letters) sets.push_back(with_letter(c));
  return read_as(language, sets);
}

TEST(FirstWords, AreThoseOfTheMatcherInOrder) {
  constexpr std::string_view kLetters = "DSG";
  const auto candidates = oracle::all_words(6, kLetters);
  for (std::size_t size = 1; size <= 4; ++size)
    for (const auto& regex : oracle::all_of_size(size, kLetters)) {
      const std::string text = "La(" + oracle::print(*regex) + ")Ep";
      std::vector<Word> expected;
      for (const std::string& middle : candidates)
        if (oracle::matches(*regex, middle)) expected.push_back(parse_word("L" + middle + "E"));
      std::sort(expected.begin(), expected.end());
      const Language plain = plain_words(compile(text));
      ASSERT_EQ(first_words(plain, {.max_length = 6}), expected) << text;
      const std::size_t few = std::min<std::size_t>(3, expected.size());
      ASSERT_EQ(first_words(plain, {.count = few, .max_length = 6}),
                std::vector(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(few)));

      std::vector<Natural> counts(7);
      for (const Word& word : expected) counts[word.length()].add(Natural(1));
      ASSERT_EQ(count_words(counted(compile(text), kLetters), 6), counts) << text;
    }
}

TEST(FirstWords, TellSubscriptsApart) {
  std::vector<std::string> words;
  for (const Word& word : first_words(compile("LpS?E"), {})) words.push_back(fine(word));
  EXPECT_EQ(words, (std::vector<std::string>{"LpEp", "LpEl", "LpSrEp", "LpSrEl", "LpStEp", "LpStEl"}));
}

TEST(FirstWords, EndWithAFiniteLanguageAndCrossGapsInTheLengths) {
  EXPECT_TRUE(first_words(Language::none(), {}).empty());
  std::vector<std::string> words;
  for (const Word& word : first_words(plain_words(compile("LaD{9}Ep | LaEp")), {})) words.push_back(plain(word));
  EXPECT_EQ(words, (std::vector<std::string>{"LE", "LDDDDDDDDDE"}));
  EXPECT_EQ(first_words(plain_words(compile("La(D{7})*Ep")), {.count = 3}).back().length(), 14u);
}

TEST(ReadAs, KeepsAWordWhenAnyOfItsReadingsBelongs) {
  const Language plain = plain_words(compile("LdDtSrEl"));
  EXPECT_EQ(plain, Language::of(parse_word("LDSE")));
  EXPECT_TRUE(counted(compile("LaDGEp"), "D").is_empty());
}

struct Series {
  const char* expression;
  std::vector<std::uint32_t> counts;
  const char* function;
};

// Taxonomy notes 2.1, over D and S: n = 0 .. 8.
TEST(CountWords, OfTheAlgorithmsOverDAndS) {
  const Series table[] = {
      {"LX*E", {1, 2, 4, 8, 16, 32, 64, 128, 256}, "1 / (1 - 2 x)"},
      {"LD*E", {1, 1, 1, 1, 1, 1, 1, 1, 1}, "1 / (1 - x)"},
      {"LN?S*E", {1, 2, 2, 2, 2, 2, 2, 2, 2}, "(1 + x) / (1 - x)"},
      {"LS*D?S*E", {1, 2, 3, 4, 5, 6, 7, 8, 9}, "1 / (1 - 2 x + x^2)"},
      {"LD*S*E", {1, 2, 3, 4, 5, 6, 7, 8, 9}, "1 / (1 - 2 x + x^2)"},
      {"L(S?D)*S*E", {1, 2, 4, 7, 12, 20, 33, 54, 88}, "1 / (1 - 2 x + x^3)"},
      {"LNX*E", {0, 1, 2, 4, 8, 16, 32, 64, 128}, "x / (1 - 2 x)"},
      {"LS*E | LNS*E | LX*NNS*E", {1, 2, 3, 5, 9, 17, 33, 65, 129}, "(1 - x - x^2) / (1 - 3 x + 2 x^2)"},
      // What no local sampling method finds between a point light and a pinhole: Fibonacci's numbers.
      {"LS+(NS+)*E", {0, 1, 1, 2, 3, 5, 8, 13, 21}, "x / (1 - x - x^2)"},
      {"LX*E - (LS+(NS+)*E | LE)", {0, 1, 3, 6, 13, 27, 56, 115, 235}, "(x - 2 x^3) / (1 - 3 x + x^2 + 2 x^3)"},
      {"LS+DE", {0, 0, 1, 1, 1, 1, 1, 1, 1}, "x^2 / (1 - x)"},
      {"LD{2}E", {0, 0, 1, 0, 0, 0, 0, 0, 0}, "x^2"},
      {"LGE", {0, 0, 0, 0, 0, 0, 0, 0, 0}, "0"},
  };
  for (const Series& row : table) {
    const Language language = counted(compile(row.expression), "DS");
    std::vector<Natural> expected;
    for (const std::uint32_t n : row.counts) expected.emplace_back(n);
    EXPECT_EQ(count_words(language, 8), expected) << row.expression;
    const auto function = generating_function(language);
    ASSERT_TRUE(function) << row.expression;
    EXPECT_EQ(write(*function), row.function) << row.expression;
  }
}

/// The first coefficients of numerator / denominator, by long division.
std::vector<std::int64_t> expand(const GeneratingFunction& f, std::size_t terms) {
  std::vector<std::int64_t> series;
  for (std::size_t n = 0; n < terms; ++n) {
    std::int64_t c = n < f.numerator.size() ? f.numerator[n] : 0;
    for (std::size_t i = 1; i < f.denominator.size() && i <= n; ++i) c -= f.denominator[i] * series[n - i];
    series.push_back(c);
  }
  return series;
}

TEST(GeneratingFunction, IsInLowestTermsOrNothing) {
  const auto of = [](const char* text) { return generating_function(compile(text)); };
  EXPECT_EQ(of("La (Dr{5})* Ep"), (GeneratingFunction{{1}, {1, 0, 0, 0, 0, -1}}));
  EXPECT_EQ(of("La .{10} Ep")->numerator.back(), 282'475'249);  // 7^10
  EXPECT_FALSE(of("La .{12} Ep"));
}

// Words without eight D in a row: the counts are powers of two at first, and only the sixteenth tells all of the
// recurrence, which is that of Fibonacci's numbers of eight terms.
TEST(GeneratingFunction, IsThatOfAllCountsWhereTheFirstFollowAShorterRecurrence) {
  const auto function = generating_function(compile("La (Dr|Sr)* Ep - La (Dr|Sr)* Dr{8} (Dr|Sr)* Ep"));
  EXPECT_EQ(function, (GeneratingFunction{std::vector<std::int64_t>(8, 1), {1, -1, -1, -1, -1, -1, -1, -1, -1}}));
}

TEST(GeneratingFunction, ExpandsToTheCountsOfEverySmallExpression) {
  constexpr std::size_t kTerms = 15;
  for (std::size_t size = 1; size <= 5; ++size)
    for (const auto& regex : oracle::all_of_size(size, "DS")) {
      const Language language = counted(compile("L(" + oracle::print(*regex) + ")E"), "DS");
      const auto function = generating_function(language);
      ASSERT_TRUE(function) << oracle::print(*regex);
      EXPECT_EQ(function->denominator.front(), 1);
      const auto counts = count_words(language, kTerms - 1);
      const auto series = expand(*function, kTerms);
      for (std::size_t n = 0; n < kTerms; ++n)
        ASSERT_EQ(std::to_string(series[n]), to_string(counts[n])) << oracle::print(*regex) << " at " << n;
    }
}

TEST(Natural, GrowsBeyondMachineWords) {
  const Language all = compile("La.*Ep");
  EXPECT_EQ(to_string(count_words(all, 30)[30]), "22539340290692258087863249");                    // 7^30
  EXPECT_EQ(to_string(count_words(compile("LaN{0,40}Ep"), 40)[40]), "1208925819614629174706176");  // 4^40
  Natural n(4'000'000'000u);
  n.add(n, 4'000'000'000u);
  EXPECT_EQ(to_string(n), "16000000004000000000");
  EXPECT_EQ(n.modulo(1'000'003), 16000000004000000000u % 1'000'003);
  EXPECT_EQ(to_string(Natural()), "0");
}

}  // namespace
}  // namespace heckbert::taxonomy
