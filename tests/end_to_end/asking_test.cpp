// What is said about a record against truth: entropy and intervals of regions in the furnace, where every share is
// known.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <heckbert/import/import.h>
#include <heckbert/report/classify.h>
#include <heckbert/report/coverage.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/render.h>

namespace heckbert {
namespace {

/// Sum of the energies of all words of at most `longest` scatterings, A2 of docs/anchors.md.
double furnace_total(int longest) {
  return (1 - std::pow(0.8, longest + 1)) / 0.2;
}

TEST(Asking, EntropyOfTheFurnaceIsItsClosedForm) {
  constexpr int kLongest = 8;
  const record::Record record =
      transport::render(import::load_scene_or_builtin("furnace").scene,
                        {.width = 32, .height = 32, .samples_per_pixel = 256, .max_depth = kLongest});
  const double per_letter = 0.5 * std::log2(0.5) + 0.3 * std::log2(0.3);
  double sum = 0;
  for (int n = 1; n <= kLongest; ++n) sum += n * std::pow(0.8, n - 1) * per_letter;
  const double truth = std::log2(furnace_total(kLongest)) - sum / furnace_total(kLongest);

  const report::Spread spread = *report::classify(record, report::GroupBy::Word, {}).spread;
  // Noise in the shares makes them look more different than they are: by some (words - 1) / (2 samples ln 2) bits.
  const double bias = 510 / (2 * 1024 * 256 * std::log(2.0));
  const double bound = record::student_quantile(0.995, record::kBatches - 1);
  EXPECT_NEAR(spread.entropy.mean, truth, bound * spread.entropy.standard_error + 2 * bias);
  EXPECT_LT(spread.entropy.standard_error, 0.01);

  // By length it is geometric, and there is no such bias.
  const report::Spread lengths = *report::classify(record, report::GroupBy::Length, {}).spread;
  double by_length = 0;
  for (int n = 0; n <= kLongest; ++n) {
    const double p = std::pow(0.8, n) / furnace_total(kLongest);
    by_length -= p * std::log2(p);
  }
  EXPECT_NEAR(lengths.entropy.mean, by_length, bound * lengths.entropy.standard_error);
}

// Shares of a region have intervals from counts and from the noise of the picture; energies.h says how. 95 % intervals,
// 200 seeds; a binomial count of 190 has a standard deviation of 3.
TEST(Asking, IntervalsOfARegionHoldTheTruthMostOfTheTime) {
  constexpr int kSeeds = 200, kLongest = 12;
  const transport::Scene scene = import::load_scene_or_builtin("furnace").scene;
  const report::Part corner{.pixels = record::Window{3, 2, 11, 10}, .words = {}, .description = "corner"};
  struct Row {
    const char* expression;
    double energy;
    int held = 0;
  };
  std::array<Row, 4> rows{{{"LDE", 0.5}, {"LD+E", 1 - std::pow(0.5, kLongest)}, {"LSSE", 0.09}, {"LSSSE", 0.027}}};
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const record::Record record = transport::render(scene, {.width = 16,
                                                            .height = 16,
                                                            .samples_per_pixel = 32,
                                                            .max_depth = kLongest,
                                                            .seed = static_cast<std::uint64_t>(seed)});
    std::vector<taxonomy::Grammar> grammars;
    for (const Row& row : rows) {
      taxonomy::Grammar& grammar = grammars.emplace_back();
      grammar.kind = taxonomy::GrammarKind::Class;
      grammar.name = grammar.expression = row.expression;
      grammar.language = taxonomy::compile(row.expression);
    }
    const report::Coverage coverage = report::coverage(record, grammars, {.part = corner});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const record::Estimate share = coverage.grammars[i].share;
      const double truth = rows[i].energy / furnace_total(kLongest);
      rows[i].held += share.known && share.lower <= truth && truth <= share.upper ? 1 : 0;
    }
  }
  for (const Row& row : rows) {
    EXPECT_GE(row.held, 180) << row.expression;
    EXPECT_LE(row.held, 198) << row.expression;
  }
}

}  // namespace
}  // namespace heckbert
