#include <heckbert/report/classify.h>

#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using test::grammar_of;
using test::sample_record;
using test::SampleWord;
using ::testing::ElementsAre;

record::Record some_record() {
  return sample_record(2, 1,
                       {{.word = "LaE", .batches = {1, 1}, .count = 1},
                        {.word = "LaDrE", .batches = {2, 2}, .count = 2},
                        {.word = "LpDrE", .batches = {2, 2}, .count = 3},
                        {.word = "LaSDE", .batches = {3, 3}, .count = 4}});
}

taxonomy::GrammarLibrary some_library() {
  taxonomy::GrammarLibrary library;
  library.grammars = {grammar_of("ray-casting", "Ray casting", "LD?E"), grammar_of("caustic", "Caustic", "LS+DE"),
                      grammar_of("last-diffuse", "Last is diffuse", "L.*DE")};
  library.grammars[1].kind = library.grammars[2].kind = taxonomy::GrammarKind::Class;
  return library;
}

struct Row {
  std::string name;
  double share;
  std::uint64_t count;
  std::size_t words;
};

struct Case {
  GroupBy by;
  std::vector<Row> rows;
};

TEST(Classify, SortsTheEnergyIntoGroups) {
  const std::vector<Case> cases{
      {GroupBy::Word, {{"LDE", 0.5, 10, 2}, {"LSDE", 0.375, 8, 1}, {"LE", 0.125, 2, 1}}},
      {GroupBy::FineWord,
       {{"LaSrDrEp", 0.375, 8, 1}, {"LaDrEp", 0.25, 4, 1}, {"LpDrEp", 0.25, 6, 1}, {"LaEp", 0.125, 2, 1}}},
      {GroupBy::Length, {{"0", 0.125, 2, 1}, {"1", 0.5, 10, 2}, {"2", 0.375, 8, 1}}},
      {GroupBy::Diffuse, {{"0", 0.125, 2, 1}, {"1", 0.875, 18, 3}}},
      {GroupBy::Glossy, {{"0", 1, 20, 4}}},
      {GroupBy::Specular, {{"0", 0.625, 12, 3}, {"1", 0.375, 8, 1}}},
      {GroupBy::Class, {{"caustic", 0.375, 8, 1}, {"last-diffuse", 0.875, 18, 3}}},
      {GroupBy::Algorithm, {{"ray-casting", 0.625, 12, 3}}},
      {GroupBy::Light, {{"La", 0.75, 14, 3}, {"Lp", 0.25, 6, 1}}},
      {GroupBy::Seen, {{"(no label)", 0.875, 18, 3}, {"(a light)", 0.125, 2, 1}}},
      {GroupBy::Label, {{"(no label)", 0.875, 18, 3}}},
  };
  ASSERT_EQ(cases.size(), kGroupings.size());
  for (const Case& c : cases) {
    const auto groups = classify(some_record(), c.by, some_library()).groups;
    ASSERT_EQ(groups.size(), c.rows.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
      EXPECT_EQ(groups[i].name, c.rows[i].name);
      EXPECT_NEAR(groups[i].share.mean, c.rows[i].share, 1e-6) << groups[i].name;
      EXPECT_EQ(groups[i].count, c.rows[i].count) << groups[i].name;
      EXPECT_EQ(groups[i].words, c.rows[i].words) << groups[i].name;
    }
  }
}

TEST(Classify, PartitionsAddUpToOne) {
  const record::Record record = test::lecture_like_record(4, 4);
  for (const GroupByFacts& grouping : kGroupings) {
    if (!grouping.is_partition) continue;
    double sum = 0;
    for (const WordGroup& group : classify(record, grouping.by, {}).groups) sum += group.share.mean;
    EXPECT_NEAR(sum, 1, 1e-6) << grouping.name;
  }
}

TEST(Classify, EmptyRecordHasNoWordsButAllClasses) {
  const record::Record empty = sample_record(1, 1, {});
  EXPECT_TRUE(classify(empty, GroupBy::Word, some_library()).groups.empty());
  EXPECT_TRUE(classify(empty, GroupBy::Length, some_library()).groups.empty());
  EXPECT_EQ(classify(empty, GroupBy::Class, some_library()).groups.size(), 2u);
}

std::vector<std::string> names(const std::vector<WordGroup>& groups) {
  std::vector<std::string> result;
  for (const WordGroup& group : groups) result.push_back(group.name);
  return result;
}

record::Record labelled_record() {
  return sample_record(2, 1,
                       {{.word = "L'key'E", .batches = {1, 1}},
                        {.word = "L'key'D'floor'E", .batches = {4, 4}},
                        {.word = "L'key'D'floor'D'wall'E", .batches = {2, 2}},
                        {.word = "L'rim'D'wall'D'wall'E", .batches = {1, 1}}});
}

TEST(Classify, SortsByLabels) {
  const record::Record record = labelled_record();
  const auto shares = [&](GroupBy by) {
    std::map<std::string, double> result;
    for (const WordGroup& group : classify(record, by, {}).groups) result[group.name] = group.share.mean;
    return result;
  };
  using Shares = std::map<std::string, double>;
  EXPECT_EQ(shares(GroupBy::Light), (Shares{{"La'key'", 7.0 / 8}, {"La'rim'", 1.0 / 8}}));
  EXPECT_EQ(shares(GroupBy::Seen), (Shares{{"(a light)", 1.0 / 8}, {"floor", 4.0 / 8}, {"wall", 3.0 / 8}}));
  EXPECT_EQ(shares(GroupBy::Label), (Shares{{"floor", 6.0 / 8}, {"wall", 3.0 / 8}})) << "one word touches both";
}

TEST(Classify, TakesThePartThatIsAskedFor) {
  const record::Record record = labelled_record();
  const Part key{
      .pixels = {}, .words = record::members(record, taxonomy::compile("L'key' .* E")), .description = "key"};
  const auto groups = classify(record, GroupBy::Length, {}, {.part = key}).groups;
  ASSERT_THAT(names(groups), ElementsAre("0", "1", "2"));
  EXPECT_NEAR(groups[2].share.mean, 2.0 / 7, 1e-6);
  EXPECT_EQ(groups[2].words, 1u);
}

TEST(Classify, CountsTheFewestGroupsThatReachAShare) {
  // Shares 0.5, 0.375 and 0.125.
  for (const auto& [reach, count] :
       std::map<double, std::size_t>{{0.4, 1}, {0.5, 1}, {0.51, 2}, {0.875, 2}, {0.9, 3}}) {
    const Classification words = classify(some_record(), GroupBy::Word, {}, {.reach = reach});
    EXPECT_EQ(words.spread->groups_to_reach, count) << reach;
    EXPECT_EQ(fewest_to_reach(words).size(), count);
  }
  EXPECT_THAT(names(fewest_to_reach(classify(some_record(), GroupBy::Length, {}, {.reach = 0.8}))),
              ElementsAre("1", "2"))
      << "by energy, not by number";
  EXPECT_FALSE(classify(some_record(), GroupBy::Class, some_library()).spread.has_value());
}

TEST(Classify, EntropyOfEqualGroupsIsTheLogarithmOfTheirNumber) {
  const record::Record record = sample_record(1, 1,
                                              {{.word = "LE", .batches = {1, 1}},
                                               {.word = "LDE", .batches = {1, 1}},
                                               {.word = "LSE", .batches = {1, 1}},
                                               {.word = "LDDE", .batches = {1, 1}}});
  const Spread spread = *classify(record, GroupBy::Word, {}).spread;
  EXPECT_NEAR(spread.entropy.mean, 2, 1e-6);
  EXPECT_NEAR(spread.effective_groups, 4, 1e-5);
  EXPECT_TRUE(spread.entropy.known);
}

/// A2 of docs/anchors.md with albedos 0.5 and 0.3, words to `longest` scatterings.
record::Record exact_furnace(std::size_t longest) {
  std::vector<SampleWord> words{{.word = "LE", .batches = {1, 1}}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string interior = words[i].word.substr(1, words[i].word.size() - 2);
    if (interior.size() == longest) break;
    const float energy = words[i].batches[0];
    words.push_back({.word = "L" + interior + "DE", .batches = {0.5f * energy, 0.5f * energy}});
    words.push_back({.word = "L" + interior + "SE", .batches = {0.3f * energy, 0.3f * energy}});
  }
  return sample_record(1, 1, words);
}

TEST(Classify, EntropyOfAFurnaceHasItsClosedForm) {
  // With L(w) = 0.5^#D 0.3^#S, and T the sum of L: H = log2 T - (sum of L log2 L) / T, where words of n scatterings add
  // up to 0.8^n and n 0.8^(n-1) (0.5 log2 0.5 + 0.3 log2 0.3).
  const double per_letter = 0.5 * std::log2(0.5) + 0.3 * std::log2(0.3);
  const auto closed_form = [&](double longest) {
    double total = 0, sum = 0;
    for (double n = 0; n <= longest; ++n) {
      total += std::pow(0.8, n);
      sum += n * std::pow(0.8, n - 1) * per_letter;
    }
    return std::log2(total) - sum / total;
  };
  EXPECT_NEAR(closed_form(400), 7.427, 0.0005) << "A2: the whole furnace";
  for (const std::size_t longest : {1, 4, 10}) {
    const record::Record record = exact_furnace(longest);
    ASSERT_EQ(record.words.size(), (std::size_t{2} << longest) - 1);
    EXPECT_NEAR(classify(record, GroupBy::Word, {}).spread->entropy.mean, closed_form(static_cast<double>(longest)),
                1e-5);
  }
}

TEST(Classify, SpectraOfAFurnaceAreGeometric) {
  const Classification words = classify(exact_furnace(10), GroupBy::Word, {});
  ASSERT_EQ(words.spectra.size(), 4u);
  EXPECT_EQ(words.spectra[0].name, "length");
  ASSERT_EQ(words.spectra[0].shares.size(), 11u);
  const double total = (1 - std::pow(0.8, 11)) / 0.2;
  for (std::size_t n = 0; n <= 10; ++n)
    EXPECT_NEAR(words.spectra[0].shares[n].mean, std::pow(0.8, n) / total, 1e-6) << n;
  EXPECT_EQ(words.spectra[2].name, "glossy");
  EXPECT_EQ(words.spectra[2].shares.size(), 1u);
  EXPECT_NEAR(words.spectra[1].shares[10].mean, std::pow(0.5, 10) / total, 1e-8) << "only LD..DE has ten D";
}

}  // namespace
}  // namespace heckbert::report
