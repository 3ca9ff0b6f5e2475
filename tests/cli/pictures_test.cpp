// What the pictures promise: asking afterwards is declaring before, any partition adds up, and the same seed gives the
// same bytes. All on a small render of the lecture's scene, which has diffuse, mirror and glass words.

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/record/file.h>
#include <heckbert/record/record.h>
#include <heckbert/report/json_parts.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using record::Layer;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class Pictures : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Renders the scene into name.exr and name.paths.exr; what half precision loses has a test of its own.
  void render(const std::string& name, const std::vector<std::string>& more = {},
              const std::string& precision = "float") const {
    std::vector<std::string> arguments{"render",
                                       "lecture",
                                       "--size",
                                       "48x48",
                                       "--spp",
                                       "4",
                                       "-o",
                                       path(name + ".exr"),
                                       "--record",
                                       path(name + ".paths.exr"),
                                       "--record-precision",
                                       precision};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  std::vector<Layer> query(const std::string& record, std::vector<std::string> expressions) const {
    expressions.insert(expressions.begin(), {"query", path(record + ".paths.exr"), "-o", path("query.exr")});
    const Outcome outcome = run(expressions);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return record::read_layers(path("query.exr"));
  }

  TemporaryFolder folder_;
};

double brightest(const record::Image& image) {
  double most = 0;
  for (const Rgb& pixel : image.pixels) most = std::max(most, static_cast<double>(max_channel(pixel)));
  return most;
}

TEST_F(Pictures, AQueryGivesTheBitsThatDeclaringGave) {
  render("a", {"--lpe", "LS+DE", "--lpe", "direct=LDE", "--lpe", "whitted=@whitted"});
  const std::vector<Layer> declared = record::read_layers(path("a.exr"));
  ASSERT_EQ(declared.size(), 4u);  // the picture and three classes
  for (const auto& [layer, expression] :
       std::map<std::string, std::string>{{"LS_DE", "LS+DE"}, {"direct", "LDE"}, {"whitted", "@whitted"}}) {
    const std::vector<Layer> asked = query("a", {expression});
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].name, "");
    int compared = 0;
    for (const Layer& candidate : declared) {
      if (candidate.name != layer) continue;
      EXPECT_EQ(candidate.image.window, asked[0].image.window);
      EXPECT_EQ(candidate.image.pixels, asked[0].image.pixels) << expression;
      EXPECT_GT(brightest(asked[0].image), 0) << expression;
      ++compared;
    }
    EXPECT_EQ(compared, 1) << layer;
  }
}

TEST_F(Pictures, OfAHalfRecordAreWithinItsRoundingAndItSaysSo) {
  render("a", {"--lpe", "direct=LDE"});
  render("half", {"--lpe", "direct=LDE"}, "half");
  const std::vector<Layer> declared = record::read_layers(path("half.exr"));
  EXPECT_EQ(declared[1].image.pixels, record::read_layers(path("a.exr"))[1].image.pixels)
      << "what is declared comes from exact sums";
  const std::vector<Rgb> asked = query("half", {"LDE"})[0].image.pixels;
  std::size_t rounded = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Rgb exact = declared[1].image.pixels[i];
    for (const auto& [a, b] : {std::pair{asked[i].r, exact.r}, {asked[i].g, exact.g}, {asked[i].b, exact.b}}) {
      EXPECT_LE(std::abs(a - b), std::max(b * 0x1p-11f, 0x1p-25f)) << "one word, hence one rounding";
      rounded += a != b ? 1 : 0;
    }
  }
  EXPECT_GT(rounded, asked.size());
  EXPECT_EQ(run({"report", path("half.paths.exr"), "-o", path("r.html")}).exit_code, 0);
  EXPECT_NE(read_bytes(path("r.html")).find("half in pixels"), std::string::npos);
}

TEST_F(Pictures, ThePictureIsTheSumOfAllWords) {
  render("a");
  const std::vector<Layer> picture = record::read_layers(path("a.exr"));
  ASSERT_EQ(picture.size(), 1u);
  EXPECT_GT(brightest(picture[0].image), 0);
  EXPECT_EQ(query("a", {"L.*E"})[0].image.pixels, picture[0].image.pixels);
  const record::Record record = record::read_record(path("a.paths.exr"));
  EXPECT_EQ(record::beauty(record).pixels, picture[0].image.pixels);
}

TEST_F(Pictures, OpenImageIOFlattensARecordToThePicture) {
  if (std::system("oiiotool --help > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "no oiiotool (openimageio-tools): what other programs make of a record is NOT tested";
  render("a");
  const std::string flatten = fmt::format("oiiotool '{}' --flatten --subimage 0 --ch R,G,B -d float -o '{}'",
                                          path("a.paths.exr"), path("flat.exr"));
  ASSERT_EQ(std::system(flatten.c_str()), 0);
  const record::Image flat = record::read_layers(path("flat.exr"))[0].image;
  const record::Image picture = record::read_layers(path("a.exr"))[0].image;
  ASSERT_EQ(flat.pixels.size(), picture.pixels.size());
  // It adds some thirty words of a pixel up in float, each time with a rounding of 6e-8 at most.
  for (std::size_t i = 0; i < flat.pixels.size(); ++i) {
    const Rgb a = flat.pixels[i], b = picture.pixels[i];
    EXPECT_LE(std::max(max_channel(a - b), max_channel(b - a)), 2e-6f * max_channel(b)) << i;
  }
}

TEST_F(Pictures, ACryptomatteAskedForLaterIsTheOneDeclared) {
  const std::vector<std::string> classes{"direct=LDE", "caustic=LS+DE"};
  render("a", {"--lpe", classes[0], "--lpe", classes[1], "--cryptomatte"});
  render("lone", {"--cryptomatte"});
  const auto mattes = [&](const std::string& name) {
    std::vector<std::vector<Rgb>> found;
    for (const Layer& layer : record::read_layers(path(name)))
      if (layer.name.starts_with("PathClass")) found.push_back(layer.image.pixels);
    return found;
  };
  query("a", {classes[0], classes[1], "--cryptomatte"});
  ASSERT_EQ(mattes("a.exr").size(), 4u);
  EXPECT_EQ(mattes("a.exr"), mattes("query.exr"));
  EXPECT_EQ(read_bytes(path("lone.paths.exr")), read_bytes(path("a.paths.exr"))) << "and the record is the same";
}

TEST_F(Pictures, AClassAndItsComplementAddUpToThePicture) {
  render("a");
  const std::vector<Rgb> picture = record::read_layers(path("a.exr"))[0].image.pixels;
  for (const std::string expression : {"LS+DE", "L.*DE", "@whitted"}) {
    const std::vector<Layer> parts = query("a", {"in=" + expression, "out=!(" + expression + ")"});
    ASSERT_EQ(parts.size(), 2u);
    for (std::size_t i = 0; i < picture.size(); ++i) {
      const Rgb sum = parts[0].image.pixels[i] + parts[1].image.pixels[i];
      // Each part is rounded once to float, and so is their sum.
      const float rounding = 3 * 6e-8f * max_channel(picture[i]);
      EXPECT_NEAR(sum.r, picture[i].r, rounding);
      EXPECT_NEAR(sum.g, picture[i].g, rounding);
      EXPECT_NEAR(sum.b, picture[i].b, rounding);
    }
  }
}

TEST_F(Pictures, AreTheSameBytesForAnyNumberOfThreadsAndOthersForAnotherSeed) {
  const auto bytes = [&](const std::vector<std::string>& more) {
    render("a", more);
    return read_bytes(path("a.exr")) + read_bytes(path("a.paths.exr")) + read_bytes(path("a.png"));
  };
  const std::string one = bytes({"--threads", "1"});
  EXPECT_GT(one.size(), 10'000u);
  EXPECT_TRUE(one == bytes({"--threads", "2"}));
  EXPECT_TRUE(one == bytes({"--threads", "3"}));
  EXPECT_FALSE(one == bytes({"--threads", "1", "--seed", "2"}));
}

TEST_F(Pictures, ACropHasThePixelsOfTheWhole) {
  render("whole");
  render("crop", {"--crop", "8,16,40,32"});
  const record::Image whole = record::read_layers(path("whole.exr"))[0].image;
  const record::Image crop = record::read_layers(path("crop.exr"))[0].image;
  EXPECT_EQ(crop.window, (record::Window{8, 16, 40, 32}));
  for (int y = 16; y < 32; ++y)
    for (int x = 8; x < 40; ++x) EXPECT_EQ(crop.at(x, y), whole.at(x, y));
}

TEST_F(Pictures, GoToStandardOutputAndComeFromStandardInput) {
  render("a");
  const std::string record = read_bytes(path("a.paths.exr"));
  const Outcome piped = run({"query", "-", "LDE", "-o", "-"}, {.input = record});
  ASSERT_EQ(piped.exit_code, 0) << piped.err;
  query("a", {"LDE"});
  EXPECT_TRUE(piped.out == read_bytes(path("query.exr")));
  const Outcome rendered = run({"render", "lecture", "--size", "48x48", "--spp", "4", "--record", "-",
                                "--record-precision", "float", "--quiet"});
  EXPECT_EQ(rendered.err, "");
  EXPECT_TRUE(rendered.out == record);
}

// Samples go elsewhere, the energies stay: two-sample z-test, 1 %, of the caustic's energy with and without.
TEST_F(Pictures, AdaptiveSamplingMovesSamplesAndNotTheEnergy) {
  using Json = report::Json;
  const auto rendered = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render", "lecture",  "--size",       "32x32", "--spp",
                                       "128",    "--record", path("paths"),  "-o",    path("a.exr"),
                                       "--json", "--lpe",    "caustic=LS+DE"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const Outcome even = rendered({"--seed", "5"}), adaptive = rendered({"--adaptive"});
  ASSERT_EQ(adaptive.exit_code, 0) << adaptive.err;
  EXPECT_THAT(adaptive.err, ContainsRegex("adaptive: [0-9]+ to [0-9]+ samples per pixel, 12[0-9.]+ on average"));
  EXPECT_EQ(even.err.find("adaptive"), std::string::npos) << even.err;
  const Json a = Json::parse(adaptive.out), b = Json::parse(even.out);
  EXPECT_EQ(a["render"]["sampler"], "sobol, adaptive");
  EXPECT_NEAR(a["tally"]["samples"].get<double>() / b["tally"]["samples"].get<double>(), 1, 0.1);
  const Json& x = a["classes"][0]["energy"];
  const Json& y = b["classes"][0]["energy"];
  const double error = std::hypot(x["standard_error"].get<double>(), y["standard_error"].get<double>());
  EXPECT_NEAR(x["mean"].get<double>(), y["mean"].get<double>(), 2.58 * error);
  EXPECT_LT(error, 0.1 * y["mean"].get<double>());

  EXPECT_THAT(run({"paths", path("paths"), "--pixel", "9,9", "--trace"}).err,
              HasSubstr("does not say where --adaptive put its samples"));
}

TEST_F(Pictures, AdaptiveSamplingIsNotForWhatIsTracedInPieces) {
  const std::vector<std::vector<std::string>> pieces{
      {"--part", "1/2"}, {"--resume", path("old")}, {"--exact"}, {"--checkpoint", "9"}};
  for (const std::vector<std::string>& piece : pieces) {
    std::vector<std::string> arguments{"render", "cornell", "--spp", "4", "--record", path("paths"), "--adaptive"};
    arguments.insert(arguments.end(), piece.begin(), piece.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << piece.front();
    EXPECT_THAT(outcome.err, HasSubstr("--adaptive plans the samples of one render as a whole")) << piece.front();
    EXPECT_FALSE(std::filesystem::exists(path("paths"))) << piece.front();
  }
  for (const char* algorithm : {"light", "bidirectional", "sppm", "vpl"}) {
    const Outcome outcome =
        run({"render", "cornell", "--record", path("paths"), "--adaptive", "--algorithm", algorithm});
    EXPECT_EQ(outcome.exit_code, 2) << algorithm;
    EXPECT_THAT(outcome.err, HasSubstr(fmt::format("but '{}' also walks from the light", algorithm)));
  }
}

// Whatever way the record takes, its pixels and its batches tell one mean, which they would not if a pixel counted by
// its samples.
TEST_F(Pictures, AdaptiveSamplingGoesWithAllThatIsOneRender) {
  const std::vector<std::vector<std::string>> ways{
      {"--spp", "8"},
      {"--time", "0.2"},
      {"--spp", "8", "--crop", "3,5,30,29"},
      {"--spp", "8", "--cryptomatte"},
      {"--spp", "8", "--memory", "64M"},
      {"--spp", "8", "--labels", "object"},
      {"--spp", "8", "--record-precision", "float"},
      {"--spp", "8", "--algorithm", "lecture"},
      {"--spp", "8", "--algorithm", "radiosity", "--method", "patch-edge=0.5"}};
  for (const std::vector<std::string>& way : ways) {
    const std::string name = fmt::format("{}", fmt::join(way, " "));
    std::vector<std::string> arguments{"render",      "lecture", "--size",      "32x32",     "--record",
                                       path("paths"), "-o",      path("a.exr"), "--adaptive"};
    arguments.insert(arguments.end(), way.begin(), way.end());
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << name << outcome.err;
    const record::Record record = record::read_record(path("paths"));
    const std::uint64_t nominal = record.info.samples_per_pixel * record.info.window.pixel_count();
    EXPECT_GE(record.tally.samples, nominal) << name;
    // How far a time reaches is the machine's affair.
    if (way.front() != "--time") {
      EXPECT_GT(record.tally.samples, nominal) << name;
    }
    const record::Image beauty = record::beauty(record);
    double sum = 0;
    for (const Rgb& pixel : beauty.pixels) sum += static_cast<double>(luminance(pixel));
    const double total = record::energy(record, std::vector<bool>(record.words.size(), true)).mean;
    EXPECT_GT(total, 0) << name;
    EXPECT_NEAR(sum / static_cast<double>(beauty.pixels.size()), total, 1e-3 * total) << name << ": half floats";
  }
  // Its sums are not kept, and so it cannot be added to.
  const Outcome merged = run({"record", "merge", path("paths"), path("paths"), "-o", path("both")});
  EXPECT_NE(merged.exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(path("both")));
}

TEST_F(Pictures, LightThatNoPathCarriesHasLayersOfItsOwn) {
  render("a", {"--algorithm", "lecture", "--lpe", "ambient=LDE"});
  const std::vector<Layer> layers = record::read_layers(path("a.exr"));
  std::vector<std::string> names;
  for (const Layer& layer : layers) {
    names.push_back(layer.name);
    EXPECT_GT(brightest(layer.image), 0) << layer.name;
  }
  ASSERT_EQ(names.size(), 4u);
  EXPECT_EQ(names[0], "");
  EXPECT_EQ(names[1], "ambient");  // the class that was asked for keeps its name
  EXPECT_EQ(layers[1].attributes.count("note"), 0u);
  EXPECT_EQ(layers[2].attributes.count("note"), 1u);
  EXPECT_EQ(names[3], "phantom");
  EXPECT_EQ(query("a", {"L.*E"})[0].image.pixels, layers[0].image.pixels);
}

TEST_F(Pictures, LayersSayTheirExpressionAndTheRuleForGlossy) {
  render("a", {"--lpe", "spec=LSE", "--glossy", "specular"});
  const std::vector<Layer> layers = record::read_layers(path("a.exr"));
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[1].name, "spec");
  EXPECT_EQ(layers[1].attributes.at("expression"), "LSE");
  EXPECT_EQ(layers[1].attributes.at("glossy"), "specular");
}

}  // namespace
}  // namespace heckbert::cli::testing
