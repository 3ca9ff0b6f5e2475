// Verdicts on made-up renders whose truth is known: a word of a render is found at a pixel with some probability and
// then as bright as makes its mean right.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/report/verdict.h>
#include <heckbert/report/verdict_picture.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/word.h>

namespace heckbert::report {
namespace {

struct Light {
  double mean = 1;         ///< in every pixel, unless `factor` says otherwise
  double probability = 1;  ///< that a pixel finds it in one batch
  std::function<double(int x, int y)> factor = [](int, int) { return 1.0; };
};
using Lights = std::map<std::string, Light>;

constexpr int kSide = 64;

/// A pixel with more samples finds a rare word more often, and less of it each time.
record::Record batch_of(const Lights& lights, std::uint64_t seed, int samples_per_pixel = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::map<taxonomy::Word, const Light*> sorted;
  for (const auto& [word, light] : lights) sorted[taxonomy::parse_word(word)] = &light;
  record::Record record;
  record.info.window = {0, 0, kSide, kSide};
  record.info.samples_per_pixel = samples_per_pixel;
  for (const auto& [word, light] : sorted) record.words.push_back(word);
  record.offsets.push_back(0);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      std::uint32_t number = 0;
      for (const auto& [word, light] : sorted) {
        // Some noise besides that of being found.
        const double probability = std::min(light->probability * samples_per_pixel, 1.0);
        const double value = light->mean * light->factor(x, y) / probability * (0.5 + uniform(random));
        if (uniform(random) < probability) record.entries.push_back({number, Rgb(static_cast<float>(value)), 1});
        ++number;
      }
      record.offsets.push_back(record.entries.size());
    }
  return record;
}

Evidence evidence_of(const Lights& lights, std::uint64_t seed, int samples_per_pixel = 1) {
  Evidence evidence;
  for (std::uint64_t batch = 0; batch < record::kBatches; ++batch)
    evidence.add(batch_of(lights, seed * 1000 + batch, samples_per_pixel));
  return evidence;
}

Verification verified(const Lights& truth, const Lights& trial, const std::string& claimed = "L.*E",
                      std::uint64_t seed = 1, const VerdictOptions& options = {}) {
  // As many more samples for the witness as the commands take.
  const Evidence witness = evidence_of(truth, 2 * seed, 4), own = evidence_of(trial, 2 * seed + 1);
  return verify({{"tested", "", "", &own, taxonomy::compile(claimed)}},
                {{"reference", &witness, taxonomy::compile("L.*E")}}, {taxonomy::Symbol::La}, options);
}

const WordFinding& find(const AlgorithmVerdict& verdict, const std::string& word) {
  const auto found =
      std::find_if(verdict.words.begin(), verdict.words.end(), [&](const WordFinding& w) { return w.word == word; });
  if (found == verdict.words.end()) throw std::out_of_range(word);
  return *found;
}

const Lights kRoom{{"LE", {1, 0.1}}, {"LDE", {0.5, 0.9}}, {"LDDE", {0.2, 0.7}}, {"LSDE", {0.05, 0.02}}};

TEST(Verdict, IsThatAnAlgorithmCapturesExactlyWhatOnlyChanceTellsApart) {
  const AlgorithmVerdict verdict = verified(kRoom, kRoom).verdicts.at(0);
  EXPECT_EQ(verdict.ruling, Ruling::Captures);
  EXPECT_TRUE(verdict.is_expected);
  for (const WordFinding& word : verdict.words) {
    EXPECT_EQ(word.standing, Standing::Agrees) << word.word;
    EXPECT_EQ(word.blocks_compared, 4u) << word.word;
  }
  EXPECT_LT(verdict.ratio->lower, 1);
  EXPECT_GT(verdict.ratio->upper, 1);
  EXPECT_EQ(verdict.shortest, "");
}

TEST(Verdict, MeasuresABiasAndNamesItsWord) {
  Lights half = kRoom;
  half["LDDE"].mean /= 2;
  const AlgorithmVerdict verdict = verified(kRoom, half).verdicts.at(0);
  EXPECT_EQ(verdict.ruling, Ruling::WrongValues);
  EXPECT_FALSE(verdict.is_expected);
  EXPECT_EQ(verdict.shortest, "LDDE");
  EXPECT_EQ(verdict.words.front().word, "LDDE") << "what is wrong comes first";
  EXPECT_NEAR(verdict.words.front().ratio->mean, 0.5, 4 * verdict.words.front().ratio->standard_error);
  for (const std::string word : {"LE", "LDE", "LSDE"}) EXPECT_EQ(find(verdict, word).standing, Standing::Agrees);
}

TEST(Verdict, FindsADifferenceThatThePictureAsAWholeDoesNotHave) {
  Lights shifted = kRoom;
  // A quarter of the light of two blocks changes places.
  shifted["LDE"].factor = [](int x, int y) { return y >= 32 ? 1.0 : x < 32 ? 0.75 : 1.25; };
  const AlgorithmVerdict verdict = verified(kRoom, shifted).verdicts.at(0);
  const WordFinding& word = find(verdict, "LDE");
  EXPECT_EQ(word.standing, Standing::Differs);
  EXPECT_GT(word.comparison.p_value, 1e-4);
  EXPECT_EQ(word.blocks_that_differ, 2u);
  EXPECT_LT(word.worst_block->pixels.y0, 32);
}

TEST(Verdict, TellsWhatIsMissing) {
  Lights less = kRoom;
  less.erase("LSDE");
  less.erase("LDDE");
  const AlgorithmVerdict verdict = verified(kRoom, less).verdicts.at(0);
  EXPECT_EQ(verdict.ruling, Ruling::Misses);
  EXPECT_EQ(verdict.shortest, "LDDE");
  EXPECT_EQ(find(verdict, "LSDE").standing, Standing::Missing);
  EXPECT_GT(find(verdict, "LSDE").brightest->luminance, 0);
  EXPECT_EQ(verified(kRoom, less, "LD?E").verdicts.at(0).ruling, Ruling::Captures) << "it does not claim them";
}

TEST(Verdict, TellsWhatIsFoundThoughNotClaimedByOnePath) {
  Lights more = kRoom;
  more["LGE"] = {.mean = 1e-4, .probability = 1e-4};
  const AlgorithmVerdict verdict = verified(kRoom, more, "L[DS]*E").verdicts.at(0);
  EXPECT_EQ(verdict.ruling, Ruling::Oversteps);
  EXPECT_EQ(verdict.shortest, "LGE");
  const WordFinding& word = find(verdict, "LGE");
  EXPECT_GT(word.found_count, 0u);
  EXPECT_NEAR(word.brightest->luminance, 1, 0.51);
}

TEST(Verdict, OfARareWordIsHowManySamplesItNeeds) {
  Lights rare = kRoom;
  // Four paths are expected: far too few to be compared, and not too few to be believed in.
  rare["LSDE"] = {.mean = 0.5, .probability = 4.0 / (kSide * kSide * record::kBatches)};
  Lights truth = kRoom;
  truth["LSDE"].mean = 0.5;
  const AlgorithmVerdict verdict = verified(truth, rare).verdicts.at(0);
  EXPECT_EQ(verdict.ruling, Ruling::NeedsSamples);
  EXPECT_TRUE(verdict.is_expected);
  const WordFinding& word = find(verdict, "LSDE");
  EXPECT_EQ(word.standing, Standing::Rare);
  // One in 32 768 samples of a pixel finds it; an error of 5 % takes 400 finds.
  EXPECT_GT(*verdict.samples_needed, 32768.0 * 400 / 4.0);
  EXPECT_LT(*verdict.samples_needed, 32768.0 * 400 * 4.0);
}

TEST(Verdict, DoesNotCallMissingWhatMayHaveEscapedByChance) {
  Lights truth = kRoom, trial = kRoom;
  truth["LSSDE"] = {.mean = 1e-3, .probability = 30.0 / (kSide * kSide * record::kBatches)};
  trial["LSSDE"] = {.mean = 1e-3, .probability = 1e-9};  // in one of ten thousand renders
  const AlgorithmVerdict verdict = verified(truth, trial).verdicts.at(0);
  // Thirty of it were expected, and none was found: that is no chance.
  EXPECT_EQ(find(verdict, "LSSDE").standing, Standing::Missing);
  truth["LSSDE"].probability = 18.0 / (kSide * kSide * record::kBatches);
  truth["LSSDE"].mean = 1e-4;
  truth["LE"].probability = trial["LE"].probability = 0.001;  // its paths are bright, and that of LSSDE may be
  EXPECT_NE(find(verified(truth, trial).verdicts.at(0), "LSSDE").standing, Standing::Missing);
}

// An algorithm may find by few bright paths what the witness finds by many: what it has found once says how bright.
// Each of these words has 1.3 paths, so 27 of a hundred are absent. Taken to be as bright as the average contribution,
// which is one of LE, 23 of them were called missing.
TEST(Verdict, SupposesWhatIsAbsentToBeAsBrightAsWhatWasFoundOnce) {
  Lights truth{{"LE", {20, 1}}}, trial{{"LE", {20, 1}}};
  for (const char* word : {"LDE", "LGE", "LSE", "LDDE", "LGDE", "LSDE", "LDGE", "LGGE", "LSGE", "LDSE"}) {
    truth[word] = {0.05, 0.02};
    trial[word] = {0.05, 1e-5};
  }
  std::size_t absent = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const AlgorithmVerdict verdict = verified(truth, trial, "L.*E", seed).verdicts.at(0);
    for (const WordFinding& word : verdict.words) {
      absent += word.found_count == 0 ? 1 : 0;
      EXPECT_NE(word.standing, Standing::Missing) << word.word << ", seed " << seed;
    }
  }
  EXPECT_GT(absent, 10u);
}

TEST(Verdict, ComparesRareWordsTogether) {
  Lights truth = kRoom, trial = kRoom;
  for (int length = 4; length < 24; ++length) {
    const std::string word = "L" + std::string(static_cast<std::size_t>(length), 'D') + "E";
    truth[word] = {.mean = 1e-3, .probability = 8.0 / (kSide * kSide * record::kBatches)};
    trial[word] = {.mean = 2.5e-4, .probability = 8.0 / (kSide * kSide * record::kBatches)};
  }
  const auto pooled = [](const AlgorithmVerdict& verdict) {
    return *std::find_if(verdict.words.begin(), verdict.words.end(), [](const auto& w) { return w.pooled > 1; });
  };
  const WordFinding differs = pooled(verified(truth, trial).verdicts.at(0));
  EXPECT_EQ(differs.standing, Standing::Differs);
  EXPECT_GT(differs.pooled, 10u);
  EXPECT_LT(differs.ratio->mean, 0.5);
  EXPECT_EQ(pooled(verified(truth, truth).verdicts.at(0)).standing, Standing::Agrees);
}

TEST(Verdict, HasNothingToSayWhereNobodyVouches) {
  const Evidence own = evidence_of(kRoom, 1), nobody = evidence_of({}, 2);
  const Verification verification =
      verify({{"tested", "", "", &own, taxonomy::compile("L.*E")}}, {{"nobody", &nobody, taxonomy::compile("LE")}},
             {taxonomy::Symbol::La, taxonomy::Symbol::Lp});
  EXPECT_EQ(verification.verdicts.at(0).ruling, Ruling::Untold);
  EXPECT_EQ(verification.verdicts.at(1).ruling, Ruling::Nothing) << "of another kind of light";
}

TEST(Verdict, TakesEachWordFromTheFirstWhoVouchesForIt) {
  Lights wrong = kRoom;
  wrong["LDE"].mean *= 2;
  const Evidence own = evidence_of(kRoom, 1), first = evidence_of(kRoom, 2), second = evidence_of(wrong, 3);
  const std::vector<Trial> trials{{"tested", "", "", &own, taxonomy::compile("L.*E")}};
  const Witness direct{"first", &first, taxonomy::compile("LD?E")}, all{"second", &second, taxonomy::compile("L.*E")};
  EXPECT_EQ(verify(trials, {direct, all}, {taxonomy::Symbol::La}).verdicts.at(0).ruling, Ruling::Captures);
  EXPECT_EQ(verify(trials, {all, direct}, {taxonomy::Symbol::La}).verdicts.at(0).shortest, "LDE");
}

/// Verifications of the same truth under different seeds raise false alarm as often as they say, and not more: of 200
/// at 5 %, by the binomial distribution, at most 20 with a probability of 99.8 %.
TEST(Verdict, RaisesFalseAlarmAsSeldomAsItSays) {
  // The last word is found by a third of the trials and is bright.
  const Lights room{
      {"LE", {1, 0.01}}, {"LDE", {0.5, 0.2}}, {"LSDE", {0.05, 0.0008}}, {"LSDDE", {0.05, 0.4 / (32 * kSide * kSide)}}};
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    if (!verified(room, room, "L.*E", seed, {.significance = 0.05}).verdicts.at(0).is_expected) ++alarms;
  EXPECT_LE(alarms, 20);
  EXPECT_GE(alarms, 1) << "a test that never raises alarm is none";
}

// Forty paths of a witness with four times the samples are ten of the trial, and the witness is sure of five: at this
// significance chance may hide as many. It may not hide fifty.
TEST(Verdict, SupposesPathsAsBrightAsTheyAreAmongTheTrialsSamples) {
  for (const double paths : {10.0, 100.0}) {
    Lights room{{"LE", {1, 0.5}}, {"LSDE", {0.03 * paths, paths / (32 * kSide * kSide)}}};
    Lights less = room;
    less.erase("LSDE");
    const AlgorithmVerdict verdict = verified(room, less).verdicts.at(0);
    EXPECT_EQ(find(verdict, "LSDE").standing, paths > 50 ? Standing::Missing : Standing::Rare) << paths;
  }
}

/// An adaptive render of 32 samples per pixel that repeats each, and finds the lamp alone.
Evidence of_repeated_samples(std::uint64_t repeats) {
  record::Record record;
  record.info.window = {0, 0, kSide, kSide};
  record.info.samples_per_pixel = record::kBatches;
  record.words = {taxonomy::parse_word("LE")};
  record.tally.samples = repeats * record::kBatches * record.info.window.pixel_count();
  record.counts = {record.tally.samples};
  record.offsets.push_back(0);
  for (std::size_t pixel = 0; pixel < record.info.window.pixel_count(); ++pixel) {
    record.entries.push_back({0, Rgb(1), static_cast<std::uint32_t>(repeats * record::kBatches)});
    record.offsets.push_back(record.entries.size());
  }
  for (int batch = 0; batch < record::kBatches; ++batch)
    record.batch_means.push_back(Rgb(1 + 0.001f * static_cast<float>(batch % 2)));
  Evidence evidence;
  evidence.take_batches_of(record);
  return evidence;
}

// The forty paths of the witness are ten of 32 samples per pixel, and a hundred and sixty where each was repeated
// sixteen times.
TEST(Verdict, CountsTheSamplesThatAnAdaptiveRenderTook) {
  const Lights room{{"LE", {1, 0.5}}, {"LSDE", {0.3, 10.0 / (32 * kSide * kSide)}}};
  const Evidence witness = evidence_of(room, 2, 4);
  for (const std::uint64_t repeats : {1u, 16u}) {
    const Evidence own = of_repeated_samples(repeats);
    EXPECT_EQ(own.samples_per_pixel(), static_cast<double>(repeats * 32));
    const AlgorithmVerdict verdict =
        verify({{"tested", "", "", &own, taxonomy::compile("L.*E")}},
               {{"reference", &witness, taxonomy::compile("L.*E")}}, {taxonomy::Symbol::La})
            .verdicts.at(0);
    EXPECT_EQ(verdict.samples_per_pixel, static_cast<int>(repeats * 32));
    EXPECT_EQ(find(verdict, "LSDE").standing, repeats > 1 ? Standing::Missing : Standing::Rare) << repeats;
  }
}

TEST(Verdict, DoesNotCallMissingWhatOnlyAWalkIntoTheLensFinds) {
  Lights less = kRoom;
  less.erase("LSDE");
  const Evidence witness = evidence_of(kRoom, 1, 4), own = evidence_of(less, 2);
  for (const bool by_lens : {false, true}) {
    Trial trial{"tested", "", "", &own, taxonomy::compile("L.*E")};
    if (by_lens) trial.is_by_lens = [](const taxonomy::Word& word) { return plain(word).starts_with("LS"); };
    const AlgorithmVerdict verdict =
        verify({trial}, {{"reference", &witness, taxonomy::compile("L.*E")}}, {taxonomy::Symbol::La}).verdicts.at(0);
    EXPECT_EQ(find(verdict, "LSDE").standing, by_lens ? Standing::Rare : Standing::Missing);
  }
}

// ---- algorithms that are right only in the limit ------------------------------------------------------------------

/// The ruling on renders whose light is off by these factors, the coarsest first; each is half as coarse as the last.
AlgorithmVerdict refined(const std::vector<Lights>& stages) {
  const Evidence witness = evidence_of(kRoom, 1, 4);
  std::vector<Evidence> evidence;
  for (const Lights& lights : stages) evidence.push_back(evidence_of(lights, 2));
  Trial trial{"tested", "", "", &evidence.back(), taxonomy::compile("L.*E")};
  trial.refinement = {.option = "edge", .order = 1, .size = 1};
  for (std::size_t i = 0; i + 1 < stages.size(); ++i)
    trial.refinement->coarser.push_back({std::exp2(stages.size() - 1 - i), &evidence[i]});
  return verify({trial}, {{"reference", &witness, taxonomy::compile("L.*E")}}, {taxonomy::Symbol::La}).verdicts.at(0);
}

Lights with(double factor) {
  Lights lights = kRoom;
  lights["LDDE"].mean *= factor;
  return lights;
}

TEST(Verdict, IsThatValuesComeNearerWhenTheirErrorShrinks) {
  const AlgorithmVerdict verdict = refined({with(0.6), with(0.8), with(0.9)});
  EXPECT_EQ(verdict.ruling, Ruling::Converges);
  EXPECT_TRUE(verdict.is_expected);
  EXPECT_EQ(verdict.shortest, "LDDE");
  EXPECT_EQ(verdict.refined_by, "edge");
  EXPECT_EQ(verdict.sizes, (std::vector<double>{4, 2, 1}));
  const WordFinding& word = find(verdict, "LDDE");
  EXPECT_EQ(word.standing, Standing::Converges);
  EXPECT_NEAR(word.sequence->order->mean, 1, 3 * word.sequence->order->standard_error);
  EXPECT_EQ(find(verdict, "LDE").standing, Standing::Agrees);
}

TEST(Verdict, IsThatValuesAreWrongWhenTheirErrorStays) {
  const AlgorithmVerdict verdict = refined({with(0.9), with(0.9), with(0.9)});
  EXPECT_EQ(verdict.ruling, Ruling::WrongValues);
  EXPECT_FALSE(verdict.is_expected) << "what is right in the limit has to come nearer";
  EXPECT_EQ(refined({with(0.6), with(0.8), with(1)}).ruling, Ruling::Captures);
}

TEST(Verdict, FollowsBlocksToo) {
  const auto shifted = [](double by) {
    Lights lights = kRoom;
    lights["LDE"].factor = [by](int x, int y) { return y >= 32 ? 1.0 : x < 32 ? 1 - by : 1 + by; };
    return lights;
  };
  EXPECT_EQ(refined({shifted(0.6), shifted(0.3), shifted(0.15)}).ruling, Ruling::Converges);
  EXPECT_EQ(refined({shifted(0.15), shifted(0.15), shifted(0.15)}).ruling, Ruling::WrongValues);
}

TEST(Verdict, AsksForMoreWhereAllPixelsShareTheirLight) {
  const Lights room{{"LE", {1, 0.5}}, {"LSDE", {0.05, 30.0 / (32 * kSide * kSide)}}};  // some thirty contributions
  for (const bool shares : {false, true}) {
    const Evidence witness = evidence_of(room, 2, 4), own = evidence_of(room, 3);
    Trial trial{"tested", "", "", &own, taxonomy::compile("L.*E")};
    trial.shares_light = shares;
    const AlgorithmVerdict verdict =
        verify({trial}, {{"reference", &witness, taxonomy::compile("L.*E")}}, {taxonomy::Symbol::La}).verdicts.at(0);
    EXPECT_EQ(find(verdict, "LSDE").standing, shares ? Standing::Rare : Standing::Agrees);
  }
}

// ---- what verdicts are made of --------------------------------------------------------------------------------------

TEST(Comparison, IsStudentsTest) {
  // Tables of Student's t.
  EXPECT_NEAR(record::student_tails(2.0423, 30), 0.05, 1e-5);
  EXPECT_NEAR(record::student_tails(3.6460, 30), 0.001, 1e-6);
  EXPECT_NEAR(record::student_tails(12.7062, 1), 0.05, 1e-6);
  const record::Estimate a{1, 0.03, 0, 0, true}, b{1.1, 0.04, 0, 0, true};
  const Comparison comparison = compare(a, 32, b, 32);
  EXPECT_NEAR(comparison.standard_errors, (0.1 - kResolution * 1.1) / 0.05, 1e-9);
  EXPECT_NEAR(comparison.p_value, record::student_tails(comparison.standard_errors, 57), 1e-12);  // Welch
}

TEST(Comparison, WithoutSpreadKnowsOnlyEqualAndUnequal) {
  const record::Estimate one{1, 0, 1, 1, true}, more{1.01, 0, 1.01, 1.01, true}, same{1.0004, 0, 1.0004, 1.0004, true};
  EXPECT_EQ(compare(one, 32, same, 32).p_value, 1);
  EXPECT_EQ(compare(one, 32, more, 32).p_value, 0);
}

TEST(Comparison, SidaksLevelsAddUpToTheSignificance) {
  EXPECT_NEAR(1 - std::pow(1 - sidak(0.01, 500), 500), 0.01, 1e-12);
}

TEST(Evidence, CutsThePictureIntoBlocks) {
  const auto blocks = blocks_of({0, 0, 70, 33});
  ASSERT_EQ(blocks.size(), 6u);
  EXPECT_EQ(blocks.back(), (record::Window{64, 32, 70, 33}));
  const Evidence evidence = evidence_of(
      {{"LE", {.mean = 2, .probability = 1, .factor = [](int x, int y) { return x >= 32 && y >= 32 ? 4.0 : 0.0; }}}},
      1);
  const WordEvidence& word = evidence.words().begin()->second;
  EXPECT_NEAR(evidence.statistics(0.95).energy(word.picture.values).mean, 2, 0.05);
  EXPECT_NEAR(evidence.statistics(0.95).energy(word.blocks.at(3).values).mean, 8, 0.2);
  EXPECT_GE(word.brightest.x, 32);
}

TEST(Evidence, SupposesWhatWasNotFoundToResembleWhatWasFoundOnce) {
  Evidence evidence;
  record::Record batch;
  batch.info.window = {0, 0, 2, 1};
  batch.info.samples_per_pixel = 1;
  batch.words = {taxonomy::parse_word("LE"), taxonomy::parse_word("LDE"), taxonomy::parse_word("LSE")};
  batch.entries = {{0, Rgb(1), 3}, {1, Rgb(4), 1}, {2, Rgb(8), 1}};
  batch.offsets = {0, 3, 3};
  evidence.add(batch);
  EXPECT_DOUBLE_EQ(evidence.contribution_if_none(), (4 + 8) / 2.0 / 2);  // of LDE and LSE, over two pixels
  batch.words.pop_back();
  batch.entries.pop_back();
  batch.offsets = {0, 2, 2};
  evidence.add(batch);  // LSE alone was found once now
  EXPECT_NEAR(evidence.contribution_if_none(), 8.0 / 2 / 2, 1e-6);
  evidence.add(batch);
  batch.words[0] = taxonomy::parse_word("LSE");
  evidence.add(batch);
  EXPECT_NEAR(evidence.contribution_if_none(), (3.0 * 1 + 4 * 4 + 8 + 1) / (3 * 3 + 4 + 1 + 3) / 2 / 4, 1e-6);
}

TEST(Evidence, RefusesBatchesOfOtherPictures) {
  Evidence evidence = evidence_of(kRoom, 1);
  EXPECT_THROW(evidence.add(batch_of(kRoom, 7)), std::invalid_argument) << "one too many";
  Evidence other;
  other.add(batch_of(kRoom, 1));
  record::Record small = batch_of(kRoom, 2);
  small.info.window = {0, 0, 1, 1};
  EXPECT_THROW(other.add(small), std::invalid_argument);
}

TEST(DifferencePicture, CountsInStandardErrors) {
  const record::Window window{0, 0, 3, 1};
  const NoisyImage predicted{{window, {Rgb(1), Rgb(1), Rgb(1)}}, {0.3, 0.3, 0}};
  const NoisyImage found{{window, {Rgb(2), Rgb(0), Rgb(1)}}, {0.4, 0.4, 0}};
  const Picture picture = difference_picture(predicted, found);
  const auto level = static_cast<std::uint8_t>(std::lround(255 * (1 / 0.5) / kFullColour));
  EXPECT_EQ(picture.rgb, (std::vector<std::uint8_t>{level, static_cast<std::uint8_t>(level / 3), 0, 0,
                                                    static_cast<std::uint8_t>(level / 3), level, 0, 0, 0}));
}

}  // namespace
}  // namespace heckbert::report
