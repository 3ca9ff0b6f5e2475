// Shares, energies, intervals, grouping and rankings of records whose numbers are known.

#include <heckbert/report/coverage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/report/requirement.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using test::four_grammars;
using test::grammar_of;
using test::sample_record;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> names(const std::vector<WordEnergy>& words) {
  std::vector<std::string> result;
  result.reserve(words.size());
  for (const WordEnergy& word : words) result.push_back(word.word);
  return result;
}

/// Powers of two, so that every sum and share is exact.
record::Record simple_record() {
  return sample_record(2, 2,
                       {{.word = "LDE", .batches = {2, 2}, .count = 3},
                        {.word = "LSE", .batches = {1, 1}},
                        {.word = "LDDE", .batches = {4, 4}},
                        {.word = "LSDE", .batches = {1, 1}}});
}

TEST(Coverage, GivesTheShareOfTheCapturedWords) {
  const Coverage result = coverage(simple_record(), four_grammars());
  EXPECT_NEAR(result.total.mean, 8, 1e-6);
  const std::vector<std::pair<std::string, double>> expected{
      {"ray-casting", 2.0 / 8}, {"radiosity", 6.0 / 8}, {"lecture", 3.0 / 8}, {"global-illumination", 1}};
  ASSERT_EQ(result.grammars.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(result.grammars[i].name, expected[i].first);
    EXPECT_NEAR(result.grammars[i].share.mean, expected[i].second, 1e-6) << expected[i].first;
    EXPECT_NEAR(result.grammars[i].captured_energy.mean, 8 * expected[i].second, 1e-5) << expected[i].first;
  }
}

TEST(Coverage, ListsWhatIsCapturedAndMissedMostFirst) {
  const Coverage result = coverage(simple_record(), four_grammars());
  EXPECT_THAT(names(result.words), ElementsAre("LDDE", "LDE", "LSE", "LSDE"));
  EXPECT_THAT(names(result.grammars[0].top_captured), ElementsAre("LDE"));
  EXPECT_THAT(names(result.grammars[0].top_missed), ElementsAre("LDDE", "LSE", "LSDE"));
  EXPECT_THAT(names(result.grammars[3].top_missed), IsEmpty());
}

TEST(Coverage, CountsLightThatNoPathCarriesApart) {
  record::Record record = simple_record();
  const Coverage without = coverage(record, four_grammars());
  EXPECT_EQ(without.ambient, 0);
  record.ambient = {Rgb(0), Rgb(1), Rgb(2), Rgb(5)};
  record.phantom.assign(4, Rgb(0, 1, 0));
  const Coverage with = coverage(record, four_grammars());
  EXPECT_NEAR(with.ambient, 2, 1e-6);
  EXPECT_NEAR(with.phantom, 0.7152, 1e-6);
  EXPECT_EQ(with.total.mean, without.total.mean);
  EXPECT_EQ(with.grammars[0].share.mean, without.grammars[0].share.mean);
}

TEST(Coverage, CutsTheListsAtTheNumberAskedFor) {
  const Coverage result = coverage(simple_record(), four_grammars(), {.top = 2});
  EXPECT_THAT(names(result.grammars[0].top_missed), ElementsAre("LDDE", "LSE"));
  EXPECT_EQ(result.words.size(), 4u) << "the words of the scene are never cut";
}

TEST(Coverage, LeavesWordsWithoutEnergyOutOfTheTopLists) {
  const record::Record record =
      sample_record(1, 1, {{.word = "LDE", .batches = {1, 1}}, {.word = "LSE", .batches = {0, 0}}});
  const Coverage result = coverage(record, {grammar_of("a", "A", "LDE")});
  EXPECT_THAT(names(result.words), ElementsAre("LDE", "LSE"));
  EXPECT_THAT(names(result.grammars[0].top_missed), IsEmpty());
}

TEST(Coverage, AgreesWithTheStatisticsOfTheRecordItself) {
  const record::Record record = test::lecture_like_record(8, 8);
  const std::vector<bool> all(record.words.size(), true);
  const Coverage result = coverage(record, four_grammars(), {.confidence = 0.9});
  ASSERT_EQ(result.grammars.size(), 4u);
  for (const GrammarCoverage& grammar : result.grammars) {
    const record::Estimate share = record::share(record, grammar.captured, all, 0.9);
    const record::Estimate energy = record::energy(record, grammar.captured, 0.9);
    EXPECT_NEAR(grammar.share.mean, share.mean, 1e-6) << grammar.name;
    EXPECT_NEAR(grammar.share.lower, share.lower, 1e-6) << grammar.name;
    EXPECT_NEAR(grammar.share.upper, share.upper, 1e-6) << grammar.name;
    EXPECT_NEAR(grammar.captured_energy.lower, energy.lower, 1e-6) << grammar.name;
    EXPECT_NEAR(grammar.captured_energy.upper, energy.upper, 1e-6) << grammar.name;
  }
  ASSERT_EQ(result.words.size(), record.words.size());
  for (const WordEnergy& word : result.words) {
    const record::Record& r = record;
    std::vector<bool> chosen(r.words.size());
    for (std::size_t w = 0; w < chosen.size(); ++w) chosen[w] = plain(r.words[w]) == word.word;
    EXPECT_NEAR(word.energy.upper, record::energy(r, chosen, 0.9).upper, 1e-6) << word.word;
    EXPECT_NEAR(word.share.lower, record::share(r, chosen, all, 0.9).lower, 1e-6) << word.word;
  }
}

TEST(Coverage, IntervalOfTwoBatchesHasOneDegreeOfFreedom) {
  // Batches 3 and 5: mean 4, standard error 1, t(0.75, 1 degree) = 1; sixteen contributions of a quarter.
  const record::Record record = sample_record(1, 1, {{.word = "LDE", .batches = {3, 5}}});
  const Coverage result = coverage(record, {grammar_of("a", "A", "LDE")}, {.confidence = 0.5});
  const auto quantile = [](double shape, double z) {
    return shape * std::pow(1 - 1 / (9 * shape) + z / (3 * std::sqrt(shape)), 3);
  };
  EXPECT_NEAR(result.total.lower, quantile(16, -1) / 4, 1e-6);
  EXPECT_NEAR(result.total.upper, quantile(17, 1) / 4, 1e-6);
  EXPECT_NEAR(result.grammars[0].share.lower, 1, 1e-9) << "a share of everything does not waver";
}

TEST(Coverage, OneSampleGivesNoInterval) {
  const record::Record record = sample_record(1, 1, {{.word = "LDE", .batches = {3}}, {.word = "LSE", .batches = {1}}});
  const Coverage result = coverage(record, {grammar_of("a", "A", "LDE")});
  EXPECT_FALSE(result.grammars[0].share.known);
  EXPECT_NEAR(result.grammars[0].share.mean, 0.75, 1e-6);
}

TEST(Coverage, GlossyRuleSaysWhetherLGEIsLDE) {
  const record::Record record =
      sample_record(1, 1, {{.word = "LDE", .batches = {1, 1}}, {.word = "LGE", .batches = {1, 1}}});
  const std::vector<std::pair<taxonomy::GlossyRule, double>> expected{
      {taxonomy::GlossyRule::Keep, 0.5}, {taxonomy::GlossyRule::Diffuse, 1}, {taxonomy::GlossyRule::Specular, 0.5}};
  for (const auto& [rule, share] : expected) {
    const Coverage result = coverage(record, {grammar_of("a", "A", "LD?E")}, {.glossy_rule = rule});
    EXPECT_NEAR(result.grammars[0].share.mean, share, 1e-6);
    EXPECT_EQ(result.glossy_rule, rule);
  }
}

/// Three words that print LDE.
record::Record alike_record() {
  return sample_record(1, 2,
                       {{.word = "LaDrEp", .batches = {1, 1}, .count = 2},
                        {.word = "LpDrEp", .batches = {2, 2}, .count = 3},
                        {.word = "LaDtEp", .batches = {4, 4}, .count = 5},
                        {.word = "LaSrEp", .batches = {1, 1}, .count = 7}});
}

TEST(WordsByEnergy, PutsWordsThatPrintAlikeTogether) {
  const auto words = words_by_energy(alike_record(), {true, true, true, true});
  ASSERT_THAT(names(words), ElementsAre("LDE", "LSE"));
  EXPECT_NEAR(words[0].energy.mean, 7, 1e-6);
  EXPECT_NEAR(words[0].share.mean, 7.0 / 8, 1e-6);
  EXPECT_EQ(words[0].count, 2u * (2 + 3 + 5)) << "over both pixels";
  EXPECT_EQ(words[0].length, 1u);
}

TEST(WordsByEnergy, TellsThemApartInFineSpelling) {
  const auto words = words_by_energy(alike_record(), {true, true, true, true}, Spelling::Fine);
  EXPECT_THAT(names(words), ElementsAre("LaDtEp", "LpDrEp", "LaDrEp", "LaSrEp"));
}

TEST(WordsByEnergy, LeavesOutWordsThatAreNotChosenButNotFromTheWhole) {
  const record::Record record = alike_record();
  std::vector<bool> only_point(record.words.size());
  for (std::size_t w = 0; w < only_point.size(); ++w) only_point[w] = record.words[w].light == taxonomy::Symbol::Lp;
  const auto words = words_by_energy(record, only_point);
  ASSERT_THAT(names(words), ElementsAre("LDE"));
  EXPECT_NEAR(words[0].share.mean, 2.0 / 8, 1e-6);
}

TEST(Coverage, SplitsAWordThatIsCapturedForOneLightOnly) {
  const Coverage result = coverage(alike_record(), {grammar_of("a", "A", "LaDrE | LaSE")});
  EXPECT_THAT(names(result.grammars[0].top_captured), ElementsAre("LDE", "LSE"));
  ASSERT_THAT(names(result.grammars[0].top_missed), ElementsAre("LDE"));
  EXPECT_NEAR(result.grammars[0].top_missed[0].energy.mean, 6, 1e-6);
}

TEST(Coverage, OfARecordWithoutLightIsNought) {
  for (const record::Record& record :
       {sample_record(2, 2, {}), sample_record(2, 2, {{.word = "LDE", .batches = {0, 0}}})}) {
    const Coverage result = coverage(record, four_grammars());
    EXPECT_EQ(result.total.mean, 0);
    ASSERT_EQ(result.grammars.size(), 4u);
    for (const GrammarCoverage& grammar : result.grammars) {
      EXPECT_EQ(grammar.share.mean, 0);
      EXPECT_EQ(missed_share(result, grammar), 0);
      EXPECT_THAT(grammar.top_missed, IsEmpty());
    }
  }
}

/// Two pixels side by side: the left one lit by LDE, the right one by LSE and a little LDDE.
record::Record left_and_right() {
  const auto left = [](float light) { return [light](int x, int) { return x == 0 ? Rgb(light) : Rgb(0); }; };
  const auto right = [](float light) { return [light](int x, int) { return x == 1 ? Rgb(light) : Rgb(0); }; };
  return sample_record(2, 1,
                       {{.word = "LDE", .batches = {3, 3, 3, 3}, .count = 4, .light = left(6)},
                        {.word = "LSE", .batches = {0.5f, 1.5f, 0.5f, 1.5f}, .count = 2, .light = right(2)},
                        {.word = "LDDE", .batches = {1, 1, 1, 1}, .count = 4, .light = right(2)}});
}

TEST(Coverage, OfARegionIsThatOfItsPixels) {
  const record::Record record = left_and_right();
  const Part right{.pixels = record::Window{1, 0, 2, 1}, .words = {}, .description = "right"};
  const Coverage result = coverage(record, {grammar_of("a", "A", "LD*E")}, {.part = right});
  EXPECT_NEAR(result.total.mean, 4, 1e-6);
  EXPECT_NEAR(result.grammars[0].share.mean, 0.5, 1e-6);
  EXPECT_NEAR(result.grammars[0].captured_energy.mean, 2, 1e-6);
  ASSERT_EQ(result.words.size(), 3u);
  EXPECT_FALSE(result.words.back().share.known) << "LDE was not found there, which does not prove that it is nought";
}

TEST(Coverage, IntervalOfARegionComesFromCountsAndThePicturesBatches) {
  // All of LSE lies in the right pixel, so that its error there is the picture's, in the pixel's own units: the batches
  // give a standard error of 0.5 / sqrt(3) on the mean of two pixels.
  const record::Record record = left_and_right();
  const Part right{.pixels = record::Window{1, 0, 2, 1}, .words = {}, .description = "right"};
  const Coverage result = coverage(record, {grammar_of("a", "A", "LSE")}, {.part = right});
  const record::Estimate energy = result.grammars[0].captured_energy, share = result.grammars[0].share;
  EXPECT_NEAR(energy.standard_error, 2 * 0.5 / std::sqrt(3), 1e-6);
  EXPECT_NEAR(share.standard_error, 0.5 * energy.standard_error / 4, 1e-6) << "(1 - share) of it, over the total";
}

TEST(Coverage, OfSomeWordsIsSharesOfThem) {
  const record::Record record = left_and_right();
  std::vector<bool> diffuse(3);
  for (std::size_t w = 0; w < 3; ++w) diffuse[w] = plain(record.words[w]) != "LSE";
  const Coverage result = coverage(record, {grammar_of("a", "A", "LD?S?E")},
                                   {.part = {.pixels = {}, .words = diffuse, .description = "diffuse"}});
  EXPECT_NEAR(result.total.mean, 4, 1e-6);
  EXPECT_NEAR(result.grammars[0].share.mean, 0.75, 1e-6);
  EXPECT_THAT(names(result.words), ElementsAre("LDE", "LDDE"));
}

TEST(Coverage, NamesThePixelOfWhichLeastIsCaptured) {
  const Coverage result = coverage(
      left_and_right(), {grammar_of("a", "A", "LD*E"), grammar_of("b", "B", "LSE"), grammar_of("c", "C", "L.*E")});
  const auto worst = [&](std::size_t grammar) { return *result.grammars[grammar].worst_pixel; };
  EXPECT_EQ(worst(0).x, 1);
  EXPECT_NEAR(worst(0).share, 0.5, 1e-6);
  EXPECT_EQ(worst(1).x, 0);
  EXPECT_EQ(worst(1).share, 0);
  EXPECT_NEAR(worst(2).share, 1, 1e-6);
  EXPECT_FALSE(coverage(sample_record(2, 2, {}), four_grammars()).grammars[0].worst_pixel.has_value());
}

TEST(Coverage, TakesRowsInAnyOrderAndNoPixelsBesides) {
  const record::Record record = simple_record();
  const std::vector<taxonomy::Grammar> grammars{grammar_of("a", "A", "LD*E"), grammar_of("b", "B", "L.*E")};
  std::vector<record::PixelRow> rows;
  record::rows_of(record)([&](const record::PixelRow& row) { rows.insert(rows.begin(), row); });
  record::Record totals = record;
  totals.offsets.clear();
  totals.entries.clear();
  const Coverage whole = coverage(record, grammars);
  const Coverage by_rows = coverage(
      totals, [&](const record::RowVisitor& visit) { std::for_each(rows.begin(), rows.end(), visit); }, grammars);
  for (std::size_t g = 0; g < grammars.size(); ++g) {
    EXPECT_EQ(by_rows.grammars[g].worst_pixel->x, whole.grammars[g].worst_pixel->x);
    EXPECT_EQ(by_rows.grammars[g].worst_pixel->y, whole.grammars[g].worst_pixel->y);
    EXPECT_EQ(by_rows.grammars[g].worst_pixel->share, whole.grammars[g].worst_pixel->share);
    EXPECT_EQ(by_rows.grammars[g].share.lower, whole.grammars[g].share.lower);
  }
}

TEST(Coverage, SaysHowManySamplesAWordNeeds) {
  // LSE: batches of one sample each, 0.5 and 1.5, with mean 1 over two pixels. One sample's variance at a pixel is that
  // of the mean of two pixels times two: 2 (0.25 * 4/3) / 1 = 2/3 of the square of the mean. For 10 %: 100 times that.
  const Coverage result = coverage(left_and_right(), {grammar_of("a", "A", "L.*E")}, {.error = 0.1, .budget = 60});
  for (const WordEnergy& word : result.words) {
    ASSERT_TRUE(word.samples_needed.has_value()) << word.word;
    EXPECT_NEAR(*word.samples_needed, word.word == "LSE" ? 200.0 / 3 : 0.0, 1e-3) << word.word;
    EXPECT_EQ(is_practical(word, 60), word.word != "LSE");
  }
  EXPECT_NEAR(result.grammars[0].practical_share, 4.0 / 5, 1e-6);
  EXPECT_NEAR(result.grammars[0].share.mean, 1, 1e-6);
}

TEST(Requirement, HoldsWhenTheLowerEndReachesIt) {
  // Batches 3 and 5 of LDE beside 4 of LSE: the share wavers.
  const record::Record record =
      sample_record(1, 1, {{.word = "LDE", .batches = {6, 7, 6, 7}}, {.word = "LSE", .batches = {3, 3, 3, 3}}});
  const Coverage result = coverage(record, {grammar_of("matt", "Matt", "LD*E")});
  const record::Estimate share = result.grammars[0].share;
  ASSERT_LT(share.lower, share.mean);
  const auto verdicts = judge(
      result, {{"matt>=low", "matt", share.lower - 1e-6}, {"matt>=mean", "matt", share.mean}, {"matt>=1", "matt", 1}});
  ASSERT_EQ(verdicts.size(), 3u);
  EXPECT_TRUE(verdicts[0].holds);
  EXPECT_FALSE(verdicts[1].holds) << "noise must not decide";
  EXPECT_FALSE(verdicts[2].holds);
  EXPECT_THAT(sentence(verdicts[2], result), ::testing::HasSubstr("matt>=1 does not hold: matt captures 68.4"));
  EXPECT_THAT(sentence(verdicts[2], result), ::testing::HasSubstr("it misses LSE (31.5"));
  EXPECT_THROW(judge(result, {{"x>=1", "x", 1}}), std::out_of_range);
}

TEST(Requirement, DoesNotHoldOnOneSample) {
  const record::Record record = sample_record(1, 1, {{.word = "LDE", .batches = {6}}, {.word = "LSE", .batches = {3}}});
  const Coverage result = coverage(record, {grammar_of("matt", "Matt", "LD*E")});
  EXPECT_FALSE(judge(result, {{"matt>=0.1", "matt", 0.1}})[0].holds);
}

}  // namespace
}  // namespace heckbert::report
