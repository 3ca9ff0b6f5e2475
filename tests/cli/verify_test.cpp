// `heckbert verify` and `heckbert why` as people run them.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

TEST(Verify, EndsWellWhenEveryGrammarCameTrue) {
  const Outcome outcome = run({"verify", "caustic", "--algorithm", "whitted", "--size", "32x32", "--spp", "32"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("captures exactly"));
}

TEST(Verify, ComparesWithARecord) {
  const TemporaryFolder folder;
  const std::string record = (folder / "a.paths.exr").string();
  ASSERT_EQ(run({"render", "lecture", "--record", record, "--size", "32x32", "--spp", "64"}).exit_code, 0);
  const std::vector<std::string> verify{"verify", "lecture", "--algorithm", "whitted", "--spp",
                                        "32",     "--json",  "--reference", record};
  std::vector<std::string> sized = verify;
  sized.insert(sized.end(), {"--size", "32x32"});
  const Outcome outcome = run(sized);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["references"][0]["samples_per_pixel"], 64);
  EXPECT_EQ(document["verdicts"][0]["verdict"], "captures");
  EXPECT_EQ(document["verdicts"][0]["samples_per_pixel"], 32) << "once is enough";
  const Outcome other_size = run(verify);
  EXPECT_EQ(other_size.exit_code, 3);
  EXPECT_THAT(other_size.err, HasSubstr("has another size than 128x128"));
}

TEST(Verify, WordsOfOtherValuesThanTheReferenceSaysAreANo) {
  // The record is of the same room in twice the light.
  const TemporaryFolder folder;
  const std::string dim = folder.write("dim.json", R"({
    "camera": { "position": [0, 1, 4], "look_at": [0, 0.5, 0] },
    "materials": [ { "name": "grey", "type": "lambert", "albedo": 0.3 },
                   { "name": "lamp", "type": "lambert", "albedo": 0.5, "emission": 12 } ],
    "shapes": [ { "type": "quad", "material": "grey", "corner": [-3, 0, 3], "edge_u": [6, 0, 0], "edge_v": [0, 0, -6] },
                { "type": "quad", "material": "lamp", "corner": [-0.5, 2, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1] } ] })");
  std::string text = read_bytes(dim);
  text.replace(text.find("0.3 }"), 5, "0.6 }");
  const std::string bright = folder.write("bright.json", text);
  const std::string record = (folder / "bright.paths.exr").string();
  ASSERT_EQ(run({"render", bright, "--record", record, "--size", "32x32", "--spp", "64"}).exit_code, 0);
  const Outcome outcome = run(
      {"verify", dim, "--algorithm", "ray-casting", "--spp", "32", "--size", "32x32", "--reference", record, "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json verdict = json::parse(outcome.out)["verdicts"][0];
  EXPECT_EQ(verdict["verdict"], "wrong-values");
  EXPECT_EQ(verdict["shortest"], "LDE");
  EXPECT_EQ(verdict["samples_per_pixel"], 4 * 32) << "it was tried again before it was accused";
  EXPECT_NEAR(verdict["words"][0]["ratio"]["mean"].get<double>(), 0.5, 0.01);
}

TEST(Verify, FollowsErrorsOfPhotonsThroughCoarserRadii) {
  const std::vector<std::string> verify{"verify", "cornell", "--algorithm", "photon-map",      "--size",
                                        "32x32",  "--spp",   "64",          "--reference-spp", "128"};
  std::vector<std::string> coarse = verify;
  coarse.insert(coarse.end(), {"--method", "photon-radius=0.04", "--json"});
  const Outcome outcome = run(coarse);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json verdict = json::parse(outcome.out)["verdicts"][0];
  EXPECT_EQ(verdict["verdict"], "converges");
  EXPECT_EQ(verdict["refined_by"], "photon-radius");
  ASSERT_EQ(verdict["sizes"].size(), 3u);
  EXPECT_FLOAT_EQ(verdict["sizes"][0].get<float>(), 0.16f);
  EXPECT_FLOAT_EQ(verdict["sizes"][2].get<float>(), 0.04f);
  const json& word = verdict["words"][0];
  EXPECT_EQ(word["standing"], "converges");
  EXPECT_LT(word["sequence"]["ratios"][0]["mean"], word["sequence"]["ratios"][1]["mean"]);
  EXPECT_LT(word["sequence"]["ratios"][1]["mean"], word["sequence"]["ratios"][2]["mean"]);
  std::vector<std::string> too_coarse = verify;
  too_coarse.insert(too_coarse.end(), {"--method", "photon-radius=0.3"});
  const Outcome refused = run(too_coarse);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("at most 0.25"));
}

// A third more light than the reference has is no matter of the radius.
TEST(Verify, FindsThatPhotonsOfTooMuchPowerDoNotConverge) {
  const TemporaryFolder folder;
  const auto room = [&](const std::string& name, double emission) {
    return folder.write(name, fmt::format(R"({{
      "camera": {{ "position": [0, 1, 4], "look_at": [0, 0.5, 0] }},
      "materials": [ {{ "name": "grey", "type": "lambert", "albedo": 0.5 }},
                     {{ "name": "lamp", "type": "lambert", "albedo": 0.5, "emission": {} }} ],
      "shapes": [ {{ "type": "quad", "material": "grey", "corner": [-3, 0, 3], "edge_u": [6, 0, 0], "edge_v": [0, 0, -6] }},
                  {{ "type": "quad", "material": "lamp", "corner": [-0.5, 2, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1] }} ] }})",
                                          emission));
  };
  const std::string record = (folder / "dim.paths.exr").string();
  ASSERT_EQ(run({"render", room("dim.json", 9), "--record", record, "--size", "32x32", "--spp", "64"}).exit_code, 0);
  const Outcome outcome = run({"verify", room("bright.json", 12), "--algorithm", "photon-map", "--spp", "64", "--size",
                               "32x32", "--reference", record, "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json verdict = json::parse(outcome.out)["verdicts"][0];
  EXPECT_EQ(verdict["verdict"], "wrong-values");
  EXPECT_EQ(verdict["words"][0]["word"], "LDE");
  EXPECT_LT(verdict["words"][0]["sequence"]["p_value"], 1e-4);
}

TEST(Verify, WritesPictures) {
  const TemporaryFolder folder;
  const std::filesystem::path pictures = folder / "pictures";
  const Outcome outcome = run(
      {"verify", "lecture", "--algorithm", "ray-casting", "--size", "16x16", "--spp", "32", "-o", pictures.string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* what : {"predicted", "rendered", "difference"})
    EXPECT_TRUE(std::filesystem::exists(pictures / fmt::format("ray-casting-{}.png", what))) << what;
}

TEST(Verify, LooksForAPlaceForItsPicturesBeforeItRenders) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "file";
  std::ofstream(file) << "no folder";
  const Outcome outcome = run({"verify", "lecture", "--size", "16x16", "-o", file.string()});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("cannot make this folder"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("samples per pixel")));
}

TEST(Verify, ShowsItsProgress) {
  const Outcome outcome = run(
      {"verify", "furnace", "--algorithm", "ray-casting", "--size", "16x16", "--spp", "32", "--progress", "always"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("100 %"));
}

TEST(Verify, RefusesWhatCannotBeVerified) {
  EXPECT_THAT(run({"verify", "lecture", "--algorithm", "ambient-occlusion"}).err, HasSubstr("no light of the scene"));
  EXPECT_EQ(run({"verify", "lecture", "--algorithm", "whited"}).exit_code, 2);
}

// ---- in fog ---------------------------------------------------------------------------------------------------------

/// A lamp and the eye outside of a box of fog, whose particles scatter forwards or, where negative, backwards. So light
/// comes from no point within it and goes to none, which would leave words without a variance.
std::string foggy_floor(const TemporaryFolder& folder, double anisotropy) {
  return folder.write(fmt::format("fog{}.json", anisotropy), fmt::format(R"({{
    "camera": {{ "position": [0, 1, 4], "look_at": [0, 0.6, 0] }},
    "media": [ {{ "name": "fog", "absorption": 0.2, "scattering": 0.6, "anisotropy": {} }} ],
    "materials": [ {{ "name": "grey", "type": "lambert", "albedo": 0.5 }},
                   {{ "name": "lamp", "type": "lambert", "albedo": 0.5, "emission": 9 }},
                   {{ "name": "fog", "index_matched": true, "medium": "fog" }} ],
    "shapes": [ {{ "type": "quad", "material": "grey", "corner": [-3, 0, 3], "edge_u": [6, 0, 0], "edge_v": [0, 0, -6] }},
                {{ "type": "quad", "material": "lamp", "corner": [-0.5, 2, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1] }},
                {{ "type": "box", "material": "fog", "low": [-1.2, 0.1, -1], "high": [1.2, 1.3, 1] }} ] }})",
                                                                         anisotropy));
}

/// What `verify` says of each algorithm at 32 by 32 pixels, by its name.
std::map<std::string, json> verdicts(const std::string& scene, const std::vector<std::string>& algorithms,
                                     const std::vector<std::string>& more, int exit_code) {
  std::vector<std::string> command{"verify", scene, "--size", "32x32", "--spp", "32", "--json"};
  for (const std::string& algorithm : algorithms) command.insert(command.end(), {"--algorithm", algorithm});
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  std::map<std::string, json> verdicts;
  const json document = json::parse(outcome.out);
  for (const json& verdict : document["verdicts"]) verdicts[verdict["algorithm"]] = verdict;
  return verdicts;
}

/// The words of a verdict that stand so.
std::vector<std::string> words_that(const std::string& standing, const json& verdict) {
  std::vector<std::string> words;
  for (const json& word : verdict["words"])
    if (word["standing"] == standing) words.push_back(word["word"]);
  return words;
}

TEST(Verify, ComparesWordsThroughFog) {
  const TemporaryFolder folder;
  auto of = verdicts(foggy_floor(folder, 0.3), {"path", "light", "bidirectional", "photon-map"},
                     {"--reference-spp", "64"}, 0);
  ASSERT_EQ(of.size(), 4u);
  for (const auto& [algorithm, verdict] : of) {
    EXPECT_EQ(verdict["verdict"], "captures") << algorithm;
    EXPECT_TRUE(verdict["expected"]) << algorithm;
  }
  for (const char* scatters : {"path", "light", "bidirectional"})
    EXPECT_THAT(words_that("agrees", of[scatters]), IsSupersetOf({"LDE", "LVE", "LVVE", "LVDE", "LDVE", "LVVDE"}))
        << scatters;
  // Photons do not scatter there; what light they and their eye's walks bring is dimmed.
  EXPECT_THAT(words_that("agrees", of["photon-map"]), UnorderedElementsAre("LE", "LDE"));
  for (const json& word : of["photon-map"]["words"]) EXPECT_THAT(word["word"].get<std::string>(), Not(HasSubstr("V")));
}

// The record is of fog that throws light back where the scene's throws it on, and dims it alike.
TEST(Verify, FindsFogOfAnotherPhaseInTheWordsThatScatterThere) {
  const TemporaryFolder folder;
  const std::string record = (folder / "back.paths.exr").string();
  ASSERT_EQ(run({"render", foggy_floor(folder, -0.3), "--record", record, "--size", "32x32", "--spp", "64"}).exit_code,
            0);
  auto of = verdicts(foggy_floor(folder, 0.3), {"light", "bidirectional", "photon-map"}, {"--reference", record}, 1);
  for (const char* scatters : {"light", "bidirectional"}) {
    EXPECT_EQ(of[scatters]["verdict"], "wrong-values") << scatters;
    EXPECT_EQ(of[scatters]["shortest"], "LVE") << scatters;
    EXPECT_THAT(words_that("differs", of[scatters]), AllOf(Contains("LVVE"), Contains("LVDE"), Each(HasSubstr("V"))))
        << scatters;
    EXPECT_THAT(words_that("agrees", of[scatters]), Contains("LDE")) << scatters;
  }
  EXPECT_EQ(of["photon-map"]["verdict"], "captures");
}

// ---- why ------------------------------------------------------------------------------------------------------------

TEST(Why, NamesTheWordsThatAnAlgorithmCannotFind) {
  const Outcome outcome = run({"why", "caustic", "--algorithm", "whitted", "--size", "32x32", "--spp", "32", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_GT(document["unreachable"], 0.1);
  EXPECT_EQ(document["words"][0]["claimed"], false);
  EXPECT_EQ(document["words"][0]["witness"], "path");
  std::vector<std::string> words;
  for (const json& word : document["words"]) words.push_back(word["word"]);
  EXPECT_THAT(words, Contains("LSDE"));
  EXPECT_THAT(words, Contains("LDDE"));
  EXPECT_THAT(words, Not(Contains("LDSE")));
}

TEST(Why, OfAPixelIsAboutThatPixel) {
  const Outcome outcome =
      run({"why", "caustic", "--algorithm", "whitted", "--pixel", "256,300", "--spp", "64", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["window"]["x0"], 256);
  EXPECT_EQ(document["window"]["y1"], 301);
  for (const json& word : document["words"]) EXPECT_EQ(word["brightest"]["x"], 256);
  EXPECT_EQ(run({"why", "caustic", "--pixel", "512,0"}).exit_code, 2);
  EXPECT_EQ(run({"why", "caustic", "--region", "1,2,3"}).exit_code, 2);
}

TEST(Why, PlotsWhatAlgorithmsCaptureOverTheirTime) {
  const TemporaryFolder folder;
  const std::string plot = (folder / "plot.svg").string();
  const Outcome outcome =
      run({"why", "lecture", "--size", "16x16", "--spp", "32", "--method", "patch-edge=0.25", "--plot", plot});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("The cheapest that claims 99.00 % of the energy: "));
  EXPECT_THAT(read_bytes(plot), HasSubstr(">whitted</text>"));
}

}  // namespace
}  // namespace heckbert::cli::testing
