// `heckbert verify` as people run it, and the table of verdicts on the built-in scenes, which docs/verify.md and
// README.md show. HECKBERT_UPDATE_DOCS=1 in the environment of this test writes it anew.

#include <algorithm>
#include <cstdlib>
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
using ::testing::HasSubstr;

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
  EXPECT_NEAR(verdict["words"][0]["ratio"]["mean"].get<double>(), 0.5, 0.01);
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

TEST(Verify, RefusesWhatCannotBeVerified) {
  EXPECT_THAT(run({"verify", "lecture", "--algorithm", "ambient-occlusion"}).err, HasSubstr("no light of the scene"));
  EXPECT_EQ(run({"verify", "lecture", "--algorithm", "whited"}).exit_code, 2);
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
  EXPECT_THAT(words, ::testing::Contains("LSDE"));
  EXPECT_THAT(words, ::testing::Contains("LDDE"));
  EXPECT_THAT(words, ::testing::Not(::testing::Contains("LDSE")));
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
  const Outcome outcome = run({"why", "lecture", "--size", "16x16", "--spp", "32", "--plot", plot});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("The cheapest that claims 99.00 % of the energy: "));
  EXPECT_THAT(read_bytes(plot), HasSubstr(">whitted</text>"));
}

// ---- the table ------------------------------------------------------------------------------------------------------

/// Not photons and radiosity, which would take minutes here, nor instant radiosity: docs/verify.md says why.
constexpr const char* kTabled[] = {"path",    "path-hits", "path-next-event", "light",       "bidirectional",
                                   "whitted", "lecture",   "distribution",    "ray-casting", "local-shading"};
constexpr const char* kScenes[] = {"cornell",       "cornell-balls", "lecture", "caustic",
                                   "caustic-point", "door",          "lantern"};

/// One row an algorithm, one column a scene.
std::string table_of_verdicts() {
  std::vector<std::string> names;
  std::map<std::string, std::map<std::string, std::string>> cells;
  std::string head = "| algorithm |", line = "|---|";
  for (const std::string scene : kScenes) {
    std::vector<std::string> command{"verify",          scene, "--size", "48x48", "--spp", "32",
                                     "--reference-spp", "64",  "--json"};
    for (const char* name : kTabled) command.insert(command.end(), {"--algorithm", name});
    const Outcome outcome = run(command);
    const json document = json::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(document.is_object()) << scene << ": " << outcome.err;
    if (!document.is_object()) return {};
    EXPECT_EQ(outcome.exit_code, 0) << scene << ": some algorithm does not do what its grammar says";
    head += fmt::format(" {}, {} |", scene, document["verdicts"][0]["light"].get<std::string>());
    line += "---|";
    for (const json& verdict : document["verdicts"]) {
      const std::string name = verdict["algorithm"], word = verdict["shortest"];
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      const std::string ruling = verdict["verdict"];
      cells[name][scene] =
          (verdict["expected"] ? ruling : "**" + ruling + "**") + (word.empty() ? "" : fmt::format(", `{}`", word));
    }
  }
  std::string table = head + "\n" + line + "\n";
  for (const std::string& name : names) {
    table += fmt::format("| `{}` |", name);
    for (const std::string scene : kScenes) table += fmt::format(" {} |", cells[name][scene]);
    table += "\n";
  }
  return table;
}

/// The text with its first table that begins like this one in place of it.
std::string with_table(const std::string& text, const std::string& table) {
  const std::size_t begin = text.find("| algorithm | cornell");
  if (begin == std::string::npos) throw std::runtime_error("the document has no table of verdicts");
  const std::size_t end = text.find("\n\n", begin);
  return text.substr(0, begin) + table + (end == std::string::npos ? "" : text.substr(end + 1));
}

TEST(VerdictTable, IsWhatTheDocumentsShow) {
  const std::string table = table_of_verdicts();
  ASSERT_FALSE(table.empty());
  for (const std::string name : {"/docs/verify.md", "/README.md"}) {
    const std::string file = HECKBERT_SOURCE_DIR + name;
    const std::string text = read_bytes(file), expected = with_table(text, table);
    if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) std::ofstream(file) << expected;
    EXPECT_EQ(read_bytes(file), expected) << "write it anew: HECKBERT_UPDATE_DOCS=1 cli_test";
  }
}

}  // namespace
}  // namespace heckbert::cli::testing
