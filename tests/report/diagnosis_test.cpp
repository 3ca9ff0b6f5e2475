// What an algorithm lacks, on renders made by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/report/diagnosis.h>
#include <heckbert/report/diagnosis_text.h>
#include <heckbert/taxonomy/expression.h>

namespace heckbert::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Thirty-two renders of one pixel in which each word has its energy, give or take a little.
Evidence evidence_of(const std::vector<std::pair<std::string, float>>& words) {
  Evidence evidence;
  for (int batch = 0; batch < record::kBatches; ++batch) {
    record::Record record;
    record.info.window = {0, 0, 1, 1};
    record.info.samples_per_pixel = 1;
    for (const auto& [word, energy] : words) {
      record.entries.push_back(
          {static_cast<std::uint32_t>(record.words.size()), Rgb(energy * (batch % 2 == 0 ? 0.9f : 1.1f)), 1});
      record.words.push_back(taxonomy::parse_word(word));
    }
    record.offsets = {0, record.entries.size()};
    evidence.add(record);
  }
  return evidence;
}

const std::vector<std::pair<std::string, float>> kScene{{"LpDrEp", 5}, {"LpDrDrEp", 3}, {"LpSrDrEp", 2}};

class Diagnosed : public ::testing::Test {
 protected:
  Evidence all_ = evidence_of(kScene), found_ = evidence_of({{"LpDrEp", 5}});
  taxonomy::Language words_ = taxonomy::compile("Lp.*Ep");
  std::vector<Witness> witnesses_{{"everything", &all_, taxonomy::compile("L.*E")}};
  Suspect suspect_{.algorithm = "direct",
                   .title = "",
                   .evidence = &found_,
                   .claimed = taxonomy::compile("LDE"),
                   .has = [](const taxonomy::Word&, const taxonomy::Strategy& s) { return s.light_vertices <= 1; }};
};

TEST_F(Diagnosed, WordsThatCannotBeFoundComeByEnergy) {
  const Diagnosis diagnosis = diagnose(suspect_, witnesses_, {}, {}, words_);
  EXPECT_NEAR(diagnosis.total, 10, 1e-5);
  EXPECT_NEAR(diagnosis.unreachable, 0.5, 1e-6);
  EXPECT_EQ(diagnosis.rare, 0);
  ASSERT_EQ(diagnosis.causes.size(), 2u);
  EXPECT_EQ(diagnosis.causes[0].word, "LDDE");
  EXPECT_NEAR(diagnosis.causes[0].share, 0.3, 1e-6);
  EXPECT_EQ(diagnosis.causes[1].word, "LSDE");
}

TEST_F(Diagnosed, StrategiesAreThoseOfTheRuleAndMarkedWhereTheAlgorithmHasThem) {
  const Diagnosis diagnosis = diagnose(
      suspect_, witnesses_, {},
      {{.word = taxonomy::parse_word("LpDrDrEp"), .light_vertices = 1, .count = 7, .mean = 1.5, .standard_error = 0.1}},
      words_);
  // LDDE of a point light and a pinhole: next event, connect, light tracing.
  const std::vector<StrategyUse>& uses = diagnosis.causes[0].strategies;
  ASSERT_EQ(uses.size(), 3u);
  EXPECT_TRUE(uses[0].is_had);
  EXPECT_FALSE(uses[1].is_had);
  EXPECT_EQ(uses[0].measured->count, 7u);
  EXPECT_FALSE(uses[1].measured.has_value());
  // LSDE: light tracing alone, which is none of its techniques.
  ASSERT_EQ(diagnosis.causes[1].strategies.size(), 1u);
  EXPECT_FALSE(diagnosis.causes[1].strategies[0].is_had);
  EXPECT_THAT(diagnosis_text(diagnosis), HasSubstr("next event (1,3): 7 paths, 50.00 % of the word"));
}

TEST_F(Diagnosed, WhatIsClaimedAndNotFoundIsRare) {
  suspect_.claimed = taxonomy::compile("LDE | LSDE");
  const Diagnosis diagnosis = diagnose(suspect_, witnesses_, {}, {}, words_);
  EXPECT_NEAR(diagnosis.rare, 0.2, 1e-6);
  EXPECT_EQ(diagnosis.causes.back().word, "LSDE");
  EXPECT_TRUE(diagnosis.causes.back().is_claimed);
  EXPECT_FALSE(diagnosis.causes.back().samples_needed.has_value());
}

TEST_F(Diagnosed, TheCheapestThatIsEnoughIsTheQuickestAndTheMinimalClaimsLeast) {
  const Diagnosis diagnosis = diagnose(suspect_, witnesses_,
                                       {{"slow", taxonomy::compile("L D? D E | LSDE"), 20.0},
                                        {"all", taxonomy::compile("L.*E"), 5.0},
                                        {"direct", taxonomy::compile("LDE"), 1.0},
                                        {"unknown", taxonomy::compile("L.+E")}},
                                       {}, words_);
  std::vector<std::string> order;
  for (const Candidate& candidate : diagnosis.candidates) order.push_back(candidate.algorithm);
  EXPECT_THAT(order, ElementsAre("direct", "all", "slow", "unknown"));
  EXPECT_NEAR(diagnosis.candidates[0].share, 0.5, 1e-6);
  EXPECT_FALSE(diagnosis.candidates[0].is_minimal) << "not enough";
  EXPECT_FALSE(diagnosis.candidates[1].is_minimal) << "claims more than need be";
  EXPECT_TRUE(diagnosis.candidates[2].is_minimal);
  EXPECT_THAT(diagnosis.causes[1].finders, ElementsAre("all", "slow", "unknown"));
  const std::string text = diagnosis_text(diagnosis), svg = candidates_svg(diagnosis);
  EXPECT_THAT(text, HasSubstr("The cheapest that claims 99.00 % of the energy: all, 5.0 s."));
  EXPECT_THAT(svg, HasSubstr(">slow</text>"));
  EXPECT_THAT(svg, Not(HasSubstr(">unknown</text>")));
}

TEST(SamplesForAPicture, GrowWithTheSquareOfTheError) {
  const NoisyImage image{{{0, 0, 2, 1}, {Rgb(1), Rgb(3)}}, {0.3, 0.1}};
  // Root mean square 0.2236 over a mean of 2.
  EXPECT_NEAR(*samples_for_picture(image, 10, 0.05), 10 * 0.05 / 4 / 0.0025, 1e-3);
  EXPECT_FALSE(samples_for_picture({{{0, 0, 1, 1}, {Rgb(0)}}, {0}}, 10, 0.05).has_value());
}

}  // namespace
}  // namespace heckbert::report
