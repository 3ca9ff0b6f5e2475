#include <heckbert/report/classify.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using test::grammar_of;
using test::sample_record;
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
      {GroupBy::Class, {{"caustic", 0.375, 8, 1}, {"last-diffuse", 0.875, 18, 3}}},
      {GroupBy::Algorithm, {{"ray-casting", 0.625, 12, 3}}},
  };
  ASSERT_EQ(cases.size(), kGroupings.size());
  for (const Case& c : cases) {
    const auto groups = classify(some_record(), c.by, some_library());
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
  for (const GroupBy by : {GroupBy::Word, GroupBy::FineWord, GroupBy::Length}) {
    double sum = 0;
    for (const WordGroup& group : classify(record, by, {})) sum += group.share.mean;
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(Classify, EmptyRecordHasNoWordsButAllClasses) {
  const record::Record empty = sample_record(1, 1, {});
  EXPECT_TRUE(classify(empty, GroupBy::Word, some_library()).empty());
  EXPECT_TRUE(classify(empty, GroupBy::Length, some_library()).empty());
  EXPECT_EQ(classify(empty, GroupBy::Class, some_library()).size(), 2u);
}

}  // namespace
}  // namespace heckbert::report
