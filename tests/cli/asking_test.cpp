// Questions to a record, as a person asks them: by label, of a region, with demands of a script, as a Cryptomatte. All
// on one small render of the lecture's scene with labels.

#include <bit>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <heckbert/record/file.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class Asking : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const Outcome outcome = run({"render", "lecture", "--size", "32x32", "--spp", "32", "--labels",
                                 "object,light-group", "--record", record(), "--record-precision", "float"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return (*folder_ / name).string(); }
  static std::string record() { return path("a.paths.exr"); }

  static Json json(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, record());
    arguments.emplace_back("--json");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }

  static TemporaryFolder* folder_;
};

TemporaryFolder* Asking::folder_ = nullptr;

double share_of(const Json& group) {
  return group["share"]["mean"].get<double>();
}

TEST_F(Asking, ForLabelsInExpressions) {
  const Json classes = json({"query", "L'lamp' .* 'glass ball' .* E", "L .* E & !(L .* 'glass ball' .* E)",
                             "L'sun' .* E", "L .* 'mirror ball' E"})["classes"];
  EXPECT_GT(share_of(classes[0]), 0.001);
  EXPECT_NEAR(share_of(classes[0]) + share_of(classes[1]), 1, 1e-6);
  EXPECT_EQ(share_of(classes[2]), 0);
  // What is seen on an object is what classify sorts under it.
  const Json seen = json({"classify", "--by", "seen"});
  for (const Json& group : seen["groups"])
    if (group["name"] == "mirror ball") {
      EXPECT_NEAR(share_of(group), share_of(classes[3]), 1e-6);
    }
}

TEST_F(Asking, ForWhatIsSeenOnAnObject) {
  const Json whole = json({"coverage", "--grammar", "whitted"});
  const Json ball = json({"coverage", "--grammar", "whitted", "--object", "mirror ball"});
  EXPECT_EQ(ball["part"], "what is seen on 'mirror ball'");
  EXPECT_LT(ball["total"]["mean"].get<double>(), whole["total"]["mean"].get<double>());
  const Json ball_again = json({"coverage", "--grammar", "whitted", "--of", "L .* 'mirror ball' E"});
  EXPECT_EQ(ball["grammars"], ball_again["grammars"]);
  EXPECT_NEAR(json({"coverage", "--light-group", "lamp"})["total"]["mean"].get<double>(),
              whole["total"]["mean"].get<double>(), 1e-6)
      << "there is no other light";
}

TEST_F(Asking, ForLabelsThatAreNotThere) {
  const std::string plain = path("plain.paths.exr");
  ASSERT_EQ(run({"render", "lecture", "--size", "8x8", "--spp", "1", "--record", plain}).exit_code, 0);
  const Outcome outcome = run({"coverage", plain, "--object", "mirror ball"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--object: this record has no such labels; render it with --labels object"));
}

TEST_F(Asking, ForARegionWhosePixelsAddUpToThePicture) {
  double sum = 0;
  for (const char* region : {"0,0,16,32", "16,0,32,10", "16,10,32,32"}) {
    const Json part = json({"coverage", "--grammar", "whitted", "--region", region});
    const double pixels = std::string(region) == "0,0,16,32" ? 512 : std::string(region) == "16,0,32,10" ? 160 : 352;
    sum += part["grammars"][0]["captured_energy"]["mean"].get<double>() * pixels / 1024;
  }
  const double whole = json({"coverage", "--grammar", "whitted"})["grammars"][0]["captured_energy"]["mean"];
  EXPECT_NEAR(sum, whole, 1e-5 * whole);
  EXPECT_EQ(json({"classify", "--pixel", "3,4"})["part"], "pixel 3, 4");
  EXPECT_EQ(run({"coverage", record(), "--region", "0,0,33,1"}).exit_code, 2);
  EXPECT_EQ(run({"coverage", record(), "--pixel", "32,0"}).exit_code, 2);
}

TEST_F(Asking, ForTheFewestWordsThatReachAShare) {
  const Json words = json({"classify", "--reach", "0.9"});
  const auto count = words["spread"]["groups_to_reach"].get<std::size_t>();
  double reached = 0;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_LT(reached, 0.9);
    reached += share_of(words["groups"][i]);
  }
  EXPECT_GE(reached, 0.9);
  EXPECT_THAT(run({"classify", record(), "--reach", "90"}).err, HasSubstr("--reach: '90' is not a number"));
  EXPECT_EQ(run({"classify", record(), "--reach", "0.9", "--by", "class"}).exit_code, 2);
}

TEST_F(Asking, WithDemandsOfAScript) {
  const Outcome met = run({"coverage", record(), "--require", "global-illumination>=0.99", "--require", "LDE>=10%"});
  EXPECT_EQ(met.exit_code, 0) << met.err;
  EXPECT_THAT(met.err, HasSubstr("global-illumination>=0.99 holds"));
  const Outcome missed = run({"coverage", record(), "--require", "whitted>=0.95", "--require", "LDE>=10%", "--json"});
  EXPECT_EQ(missed.exit_code, 1);
  EXPECT_THAT(missed.err, HasSubstr("whitted>=0.95 does not hold: whitted captures"));
  EXPECT_THAT(missed.err, HasSubstr("it misses L"));
  const Json verdicts = Json::parse(missed.out)["requirements"];
  EXPECT_EQ(verdicts[0]["holds"], false);
  EXPECT_EQ(verdicts[1]["holds"], true);
  EXPECT_EQ(run({"coverage", record(), "--require", "whitted"}).exit_code, 2);
  EXPECT_EQ(run({"coverage", record(), "--require", "whited>=0.5"}).exit_code, 3);
  EXPECT_EQ(run({"coverage", record(), "--require", "whitted>=1.5"}).exit_code, 2);
}

TEST_F(Asking, ForPicturesOfAllClassesAtOnce) {
  ASSERT_EQ(run({"query", record(), "a=LE", "b=L.+E", "--preview", path("class-{}.png")}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("class-a.png")));
  EXPECT_TRUE(std::filesystem::exists(path("class-b.png")));
  EXPECT_NE(read_bytes(path("class-a.png")), read_bytes(path("class-b.png")));
}

TEST_F(Asking, TellsHowLayersAreCalled) {
  const Outcome outcome = run({"query", record(), "LD+E", "x=LE", "depth=LSE", "X=LDE", "-o", path("names.exr")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the layer of 'LD+E' is called LD_E"));
  EXPECT_THAT(outcome.err, HasSubstr("the layer of 'depth' is called depth_2"));
  EXPECT_THAT(outcome.err, HasSubstr("the layer of 'X' is called X_2"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("'x'")));
  for (const record::Layer& layer : record::read_layers(path("names.exr")))
    if (layer.name == "LD_E") {
      EXPECT_EQ(layer.attributes.at("name"), "LD+E");
    }
}

/// A channel of a flat EXR over 32x32 pixels, and its text attributes.
std::vector<float> channel(Imf::InputFile& file, const std::string& name) {
  std::vector<float> pixels(1024);
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice::Make(Imf::FLOAT, pixels.data(), file.header().dataWindow(), sizeof(float)));
  file.setFrameBuffer(frame);
  file.readPixels(0, 31);
  return pixels;
}

TEST_F(Asking, ForACryptomatteThatDecodes) {
  ASSERT_EQ(run({"query", record(), "lamps=LE", "matt=LD+E", "diffuse=LDE", "rest=L .* S .* E", "-o", path("c.exr"),
                 "--cryptomatte"})
                .exit_code,
            0);
  Imf::InputFile file(path("c.exr").c_str());
  // The key is the first seven digits of the hash of the name.
  const std::string key = "cryptomatte/9c90576/";
  const auto text = [&](const std::string& name) {
    const auto* found = file.header().findTypedAttribute<Imf::StringAttribute>(key + name);
    return found == nullptr ? std::string() : found->value();
  };
  EXPECT_EQ(text("name"), "PathClass");
  EXPECT_EQ(text("hash"), "MurmurHash3_32");
  EXPECT_EQ(text("conversion"), "uint32_to_float32");
  std::map<std::uint32_t, std::string> names;
  const Json manifest = Json::parse(text("manifest"));
  for (const auto& [name, hex] : manifest.items())
    names[static_cast<std::uint32_t>(std::stoul(hex.get<std::string>(), nullptr, 16))] = name;
  ASSERT_EQ(names.size(), 4u);

  // A matte of a class, picked as a compositor does, is the share of its picture in the whole.
  const auto luminance_of = [](Rgb c) { return static_cast<double>(luminance(c)); };
  ASSERT_EQ(run({"query", record(), "all=L.*E", "matt=LD+E", "-o", path("m.exr")}).exit_code, 0);
  record::Image all, matt;
  for (const record::Layer& layer : record::read_layers(path("m.exr")))
    (layer.name == "all" ? all : matt) = layer.image;
  std::vector<double> coverage(1024), total(1024);
  std::vector<float> last(1024, 1);
  for (const char* layer : {"PathClass00", "PathClass01", "PathClass02", "PathClass03"})
    for (const auto& [id_channel, share_channel] : {std::pair{".R", ".G"}, {".B", ".A"}}) {
      const std::vector<float> id = channel(file, std::string(layer) + id_channel);
      const std::vector<float> share = channel(file, std::string(layer) + share_channel);
      for (std::size_t i = 0; i < id.size(); ++i) {
        EXPECT_LE(share[i], last[i]) << "ranks fall";
        last[i] = share[i];
        total[i] += static_cast<double>(share[i]);
        if (share[i] == 0) continue;
        ASSERT_TRUE(names.contains(std::bit_cast<std::uint32_t>(id[i])));
        EXPECT_TRUE(std::isnormal(id[i]));
        if (names[std::bit_cast<std::uint32_t>(id[i])] == "matt") coverage[i] += static_cast<double>(share[i]);
      }
    }
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    EXPECT_NEAR(total[i], 1, 1e-5) << "all words have a class";
    EXPECT_NEAR(coverage[i], luminance_of(matt.pixels[i]) / luminance_of(all.pixels[i]), 1e-5);
  }
}

TEST_F(Asking, ForThePathsOfAPixel) {
  const Json words = json({"paths", "--pixel", "20,26"});
  double sum = 0;
  for (const Json& word : words["words"]) sum += share_of(word);
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_TRUE(words["paths"].empty());

  const Json traced = json({"paths", "--pixel", "20,26", "--trace", "--fine"});
  std::map<std::string, std::pair<double, int>> found;
  double last = std::numeric_limits<double>::infinity();
  for (const Json& path : traced["paths"]) {
    const Rgb value{path["value"][0], path["value"][1], path["value"][2]};
    const auto light = static_cast<double>(luminance(value));
    EXPECT_LE(light, last) << "heaviest first";
    last = light;
    found[path["word"]].first += light / 32;
    ++found[path["word"]].second;
    EXPECT_EQ(path["vertices"][0]["label"], "lamp");
    EXPECT_NEAR(path["vertices"][0]["position"][1].get<double>(), 2.15, 1e-4) << "where the lamp hangs";
  }
  ASSERT_EQ(found.size(), traced["words"].size());
  for (const Json& word : traced["words"]) {
    const auto& [energy, count] = found.at(word["word"]);
    EXPECT_EQ(count, word["count"]);
    EXPECT_NEAR(energy, word["energy"]["mean"].get<double>(), 1e-5 * energy);
  }
  const Outcome text = run({"paths", record(), "--pixel", "20,26", "--trace", "--top", "2"});
  EXPECT_THAT(text.out, HasSubstr("La'lamp'"));
  EXPECT_THAT(text.out, HasSubstr("more paths"));
}

TEST_F(Asking, ForPathsOnlyOfTheSceneThatWasRendered) {
  const Outcome other = run({"paths", record(), "--pixel", "3,4", "--trace", "--scene", "cornell"});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("'cornell' is not the scene of this record"));
  EXPECT_EQ(run({"paths", record(), "--pixel", "32,4"}).exit_code, 2);
  EXPECT_EQ(run({"paths", record()}).exit_code, 2);
}

TEST_F(Asking, NeedsAFileForACryptomatte) {
  EXPECT_EQ(run({"query", record(), "LE", "--cryptomatte"}).exit_code, 2);
  EXPECT_EQ(run({"render", "lecture", "--record", path("x.exr"), "--cryptomatte"}).exit_code, 2);
}

}  // namespace
}  // namespace heckbert::cli::testing
