// Where a setting's value comes from: flag, environment, config file, scene file, default, in this order. Every pair of
// layers is tried, for every setting that a scene file can hold, and the pairs above the scene for the others.

#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using Json = nlohmann::json;

/// One value per layer, all different; the default is what a render without any layer has.
struct SettingCase {
  std::string name;      ///< --name, and name = in a config file
  std::string variable;  ///< HECKBERT_...
  std::string flag, environment, config;
  std::string scene;  ///< JSON of the scene's "render" object; empty: a scene cannot say
  std::function<Json(const Json& render)> read;
  Json by_flag, by_environment, by_config, by_scene, by_default;
};

const std::string kSpheres =
    R"("camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "fov": 40},
       "materials": [{"name": "lamp", "type": "lambert", "albedo": 0.5, "emission": 1}],
       "shapes": [{"type": "sphere", "name": "ball", "material": "lamp", "center": [0, 0, 0], "radius": 1}])";

std::vector<SettingCase> cases() {
  const auto key = [](const std::string& name) { return [name](const Json& render) { return render[name]; }; };
  const auto size = [](const Json& render) { return Json{render["width"], render["height"]}; };
  return {
      {"spp", "HECKBERT_SPP", "2", "3", "4", R"("spp": 5)", key("samples_per_pixel"), 2, 3, 4, 5, 64},
      {"max-depth", "HECKBERT_MAX_DEPTH", "2", "3", "4", R"("max_depth": 5)", key("max_depth"), 2, 3, 4, 5, 32},
      {"seed", "HECKBERT_SEED", "2", "3", "4", R"("seed": 5)", key("seed"), 2, 3, 4, 5, 1},
      {"size",
       "HECKBERT_SIZE",
       "2x3",
       "4x5",
       "\"6x7\"",
       R"("width": 8, "height": 9)",
       size,
       {2, 3},
       {4, 5},
       {6, 7},
       {8, 9},
       {512, 512}},
      {"crop", "HECKBERT_CROP", "0,0,1,1", "0,0,2,2", "0,0,3,3", "",
       [](const Json& render) { return render["window"]["x1"]; }, 1, 2, 3, nullptr, 8},
  };
}

/// Layers as bits, strongest first.
enum LayerBit : unsigned { kFlag = 1, kEnvironment = 2, kConfig = 4, kScene = 8 };

TEST(Precedence, HoldsForEverySetOfLayers) {
  const TemporaryFolder folder;
  for (const SettingCase& setting : cases()) {
    for (unsigned layers = 0; layers < 16; ++layers) {
      if ((layers & kScene) != 0 && setting.scene.empty()) continue;
      std::string defaults = (layers & kScene) != 0 ? setting.scene : "";
      // Keep the render small whatever is asked: the defaults of the tool are large.
      std::vector<std::string> arguments{"render", "", "-o", (folder / "out.exr").string(), "--json", "--no-preview"};
      if (setting.name != "spp") arguments.insert(arguments.end(), {"--spp", "1"});
      if (setting.name != "size") arguments.insert(arguments.end(), {"--size", "8x8"});
      arguments[1] = folder.write("scene.json", "{" + kSpheres + R"(, "render": {)" + defaults + "}}");

      RunOptions options;
      if ((layers & kFlag) != 0) arguments.insert(arguments.end(), {"--" + setting.name, setting.flag});
      if ((layers & kEnvironment) != 0) options.environment[setting.variable] = setting.environment;
      if ((layers & kConfig) != 0)
        arguments.insert(arguments.end(), {"--config", folder.write("a.toml", "# ours\n" + setting.name + " = " +
                                                                                  setting.config + "\n")});

      const Outcome outcome = run(arguments, options);
      ASSERT_EQ(outcome.exit_code, 0) << setting.name << " " << layers << "\n" << outcome.err;
      const Json expected = (layers & kFlag) != 0          ? setting.by_flag
                            : (layers & kEnvironment) != 0 ? setting.by_environment
                            : (layers & kConfig) != 0      ? setting.by_config
                            : (layers & kScene) != 0       ? setting.by_scene
                                                           : setting.by_default;
      EXPECT_EQ(setting.read(Json::parse(outcome.out)["render"]), expected) << setting.name << " layers " << layers;
    }
  }
}

TEST(Precedence, AFlagHidesItsRivalInLowerLayers) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.exr").string();
  const Outcome outcome = run({"render", "cornell", "-o", out, "--size", "8x8", "--time", "0.05"},
                              {.environment = {{"HECKBERT_SPP", "2"}}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("samples per pixel fit into 0.05 s"), std::string::npos) << outcome.err;
  const std::string config = folder.write("quiet.toml", "quiet = true");
  EXPECT_EQ(run({"render", "cornell", "-o", out, "--size", "8x8", "--spp", "1", "--config", config}).err, "");
  EXPECT_NE(run({"render", "cornell", "-o", out, "--size", "8x8", "--spp", "1", "--config", config, "--verbose"}).err,
            "");
}

TEST(Precedence, TheConfigFileItselfMayComeFromTheEnvironment) {
  const TemporaryFolder folder;
  const std::string config = folder.write("a.toml", "glossy = 'diffuse'  # D and G alike\n");
  const RunOptions options{.environment = {{"HECKBERT_CONFIG", config}}};
  EXPECT_EQ(run({"match", "LDE", "LGE"}, options).exit_code, 0);
  EXPECT_EQ(run({"match", "LDE", "LGE"}).exit_code, 1);
  EXPECT_EQ(run({"match", "LDE", "LGE", "--glossy", "keep"}, options).exit_code, 1);
}

}  // namespace
}  // namespace heckbert::cli::testing
