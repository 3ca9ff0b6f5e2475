// A2 of docs/anchors.md: in a closed box whose every surface emits one and reflects with constant albedos, the energy
// of a word is the product of its letters' albedos, whatever the geometry, and every grammar's share is the value of
// its generating function (furnace principle: Smits and Jensen, "Global Illumination Test Scenes").

#include <gtest/gtest.h>

#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/expression.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr float kD = 0.5f, kS = 0.3f;

const record::Record& furnace_record() {
  static const record::Record record =
      render(furnace(kD, kS), {.width = 32, .height = 32, .samples_per_pixel = 512, .max_depth = 64});
  return record;
}

TEST(Furnace, EveryWordToFourScatteringsHasItsClosedForm) {
  std::map<std::string, double> truth;
  for (const std::string& word : words_over_ds(4)) truth[word] = product_of_albedos(word, kD, kS);
  ASSERT_EQ(truth.size(), 31u);
  expect_energies(furnace_record(), truth);
}

TEST(Furnace, EveryGrammarsShareEqualsItsGeneratingFunction) {
  struct Row {
    const char* expression;
    double energy;
  };
  const double d = kD, s = kS;
  const Row rows[] = {
      {"L D? E", 1 + d},
      {"L D? S* E", (1 + d) / (1 - s)},
      {"L D* E", 1 / (1 - d)},
      {"L S* D? S* E", 1 / (1 - s) + d / ((1 - s) * (1 - s))},
      {"L D* S* E", 1 / ((1 - d) * (1 - s))},
      {"L (S? D)* S* E", 1 / ((1 - d - d * s) * (1 - s))},
      {"L D (D|S)* E", d / (1 - d - s)},
      {"L S+ D E", s * d / (1 - s)},
      {"(L S* E) | (L N S* E) | (L X* N N S* E)", 55.0 / 14.0},
      {"L X* E - L S+ (N S+)* E", 49.0 / 11.0},
  };
  const record::Record& record = furnace_record();
  const std::vector<bool> all(record.words.size(), true);
  const double total = 1 / (1 - d - s);
  const int degrees = record::batch_count(record.info.samples_per_pixel) - 1;
  const double bound = record::student_quantile(1 - 0.005 / std::size(rows), degrees);
  for (const Row& row : rows) {
    const auto share = record::share(record, record::members(record, taxonomy::compile(row.expression)), all);
    EXPECT_NEAR(share.mean, row.energy / total, bound * share.standard_error) << row.expression;
    EXPECT_LT(share.standard_error, 0.005) << row.expression;
  }
}

TEST(Furnace, NothingIsLostToTheDepthLimitOrRejected) {
  const record::Record& record = furnace_record();
  EXPECT_EQ(record.tally.rejected_not_finite + record.tally.rejected_negative, 0u);
  EXPECT_EQ(record.tally.escaped, 0u);
  EXPECT_EQ(record.tally.samples, 32u * 32u * 512u);
}

TEST(Furnace, TheRecursiveTracerFindsItsGrammarAndNothingElse) {
  const record::Record record =
      render(furnace(kD, kS),
             {.algorithm = AlgorithmId::Whitted, .width = 32, .height = 32, .samples_per_pixel = 128, .max_depth = 32});
  const taxonomy::Language whitted = taxonomy::compile("L N? S* E");
  for (const taxonomy::Word& word : record.words) EXPECT_TRUE(whitted.contains(word)) << taxonomy::fine(word);
  expect_energies(record, {{"LE", 1},
                           {"LDE", kD},
                           {"LSE", kS},
                           {"LDSE", kD * kS},
                           {"LSSE", kS * kS},
                           {"LDSSE", kD * kS * kS},
                           {"LSSSE", kS * kS * kS}});
}

}  // namespace
}  // namespace heckbert::transport
