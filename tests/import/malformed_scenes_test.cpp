// Every way to get a scene wrong has its message, and the message points at the culprit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kGood = R"({
  "camera": { "position": [0, 1, 4], "look_at": [0, 0, 0] },
  "environment": 1,  // white
  "materials": [ { "name": "grey", "type": "lambert", "albedo": 0.5 } ],
  "shapes": [ { "type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1 } ]
})";

/// One change to kGood and the one error that it causes. `instead` marks the culprit with ^; where the error is not at
/// the change, `at` is the text that the caret stands under.
struct Malformed {
  std::string_view what, instead;
  std::string_view message;
  std::string_view suggestion;
  std::string_view pointer;
  std::string_view at;
};

const Malformed kMalformed[] = {
    // JSON itself
    {kGood, "^", "unexpected end of input", "", "", ""},
    {"\"radius\": 1 } ]\n}", "\"radius\": 1 } ]\n^", "unexpected end of input", "", "", ""},
    {"[0, 1, 4]", "[0, ^, 4]", "unexpected ','", "", "", ""},
    {"[0, 1, 4]", "[0, ^NaN, 4]", "invalid literal", "", "", ""},
    {"[0, 1, 4]", "[0, ^1e999, 4]", "number overflow", "", "", ""},
    {R"("name": "grey")", "\"name\": ^\"gr\xFFy\"", "ill-formed UTF-8", "", "", ""},
    {"\"grey\", \"type\"", "^\"grey\n\", \"type\"", "control character", "", "", ""},
    {R"("albedo": 0.5)", R"("albedo": 0.5, ^"albedo": 0.6)", "\"albedo\" stands twice", "", "/materials/0/albedo", ""},
    // keys
    {R"("environment")", R"(^"enviroment")", "scene has no key", "did you mean \"environment\"?", "/enviroment", ""},
    {R"("radius": 1)", R"("radius": 1, ^"colour": 1)", "sphere has no key \"colour\"",
     "known: type, name, label, material", "/shapes/0/colour", ""},
    {R"("look_at": [0, 0, 0])", R"("fov": 40)", "camera needs \"look_at\"", "", "/camera", "{ \"position\""},
    {R"("type": "sphere", )", "", "shape needs \"type\": one of quad, box", "", "/shapes/0", "{ \"material\""},
    {R"("type": "sphere")", R"("type": ^"shpere")", "expected one of quad, box, sphere", "did you mean \"sphere\"?",
     "/shapes/0/type", ""},
    // values
    {R"("radius": 1)", R"("radius": ^-1)", "expected number above 0, at most 1e+09, found -1", "", "/shapes/0/radius",
     ""},
    {R"("radius": 1)", R"("radius": ^"1")", "expected number above 0, at most 1e+09, found a string", "",
     "/shapes/0/radius", ""},
    {R"("albedo": 0.5)", R"("albedo": [0.5, ^1.5, 0.5])", "expected number from 0 to 1, found 1.5", "",
     "/materials/0/albedo/1", ""},
    {R"("albedo": 0.5)", R"("albedo": ^[0.5, 0.5])", "expected grey number or [r, g, b]", "", "/materials/0/albedo",
     ""},
    {R"("environment": 1)", R"("environment": ^-1)", "from 0 to 1e+09, found -1", "", "/environment", ""},
    {"[0, 1, 4]", "[0, ^1e30, 4]", "expected number from -1e+09 to 1e+09, found 1e+30", "", "/camera/position/1", ""},
    {R"("environment": 1)", R"("environment": 1, "render": { "width": ^0 })", "expected integer from 1 to 16384", "",
     "/render/width", ""},
    {R"("environment": 1)", R"("environment": 1, "render": { "spp": ^1.5 })", "expected integer from 1", "",
     "/render/spp", ""},
    {R"("environment": 1)", R"("environment": 1, "render": { "seed": ^-3 })", "expected integer from 0", "",
     "/render/seed", ""},
    {R"({ "type": "sphere")", R"(^7, { "type": "sphere")", "expected an object (shape), found a number", "",
     "/shapes/0", ""},
    // meaning
    {R"("material": "grey")", R"("material": ^"gray")", "there is no material \"gray\"", "did you mean \"grey\"?",
     "/shapes/0/material", ""},
    {R"("look_at": [0, 0, 0])", R"("look_at": ^[0, 1, 4])", "looks at the place where it stands", "move",
     "/camera/look_at", ""},
    {R"("look_at": [0, 0, 0])", R"("look_at": [0, 0, 4])", "\"up\" must not be", "", "/camera", "{ \"position\""},
    {R"("environment": 1,)", "", "nothing in this scene gives light", "emission", "", "{"},
    {R"({ "type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1 })", "", "this scene is empty", "", "",
     "{"},
    {R"("type": "lambert", "albedo": 0.5)",
     R"("lobes": [{"type": "lambert", "albedo": 0.7}, {"type": "mirror", "reflectance": 0.4}])",
     "Lambert 0.7, mirror 0.4 add up to 1.1, expected at most 1", "", "/materials/0", "{ \"name\""},
    {R"("albedo": 0.5)", R"("albedo": 0.5, "lobes": ^[])", "\"type\" or \"lobes\", not both", "", "/materials/0/lobes",
     ""},
    {R"(, "type": "lambert", "albedo": 0.5)", "", "says nothing about light", "\"lobes\": []", "/materials/0",
     "{ \"name\""},
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "ggx", "f0": 1, "alpha": 0.1, "roughness": 0.1)",
     "\"roughness\" or \"alpha\", not both", "", "/materials/0", "{ \"name\""},
    {R"("albedo": 0.5 })", R"("albedo": 0.5 }, { "name": ^"grey", "type": "lambert", "albedo": 0.5 })",
     "two materials with the name \"grey\"", "", "/materials/1/name", ""},
    {R"("type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1)",
     R"("type": "quad", "material": "grey", "corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [-2, 0, 0])",
     "this quad has no area", "", "/shapes/0", "{ \"type\": \"quad\""},
    {R"("type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1)",
     R"("type": "box", "material": "grey", "low": [0, 0, 0], "high": [1, -1, 1])", "expected \"low\" below \"high\"",
     "", "/shapes/0", "{ \"type\": \"box\""},
    {R"("type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1)",
     R"("type": "mesh", "material": "grey", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2],^[0,1,3]])",
     "there are 3 positions", "", "/shapes/0/triangles/1", ""},
    {R"("type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1)",
     R"("type": "mesh", "material": "grey", "positions": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [^[0,1,1]])",
     "this triangle has no area", "", "/shapes/0/triangles/0", ""},
    {R"("type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1)",
     R"("type": "obj", "material": "grey", "file": ^"nowhere.obj")", "nowhere.obj: cannot read", "", "/shapes/0/file",
     ""},
    {R"("radius": 1)", R"("radius": 1, "transform": ^[{"scale": [1, 2, 1]}])", "stretches the sphere",
     "a stretched one can be a mesh", "/shapes/0/transform", ""},
    {R"("radius": 1)", R"("radius": 1, "transform": [{"scale": ^0}])", "flattens the shape", "",
     "/shapes/0/transform/0/scale", ""},
    {R"("radius": 1)", R"("radius": 1, "transform": [{"rotate": {"axis": ^[0, 0, 0], "degrees": 9}}])",
     "axis of a rotation must not be zero", "", "/shapes/0/transform/0/rotate/axis", ""},
    {R"("radius": 1)", R"("radius": 1, "transform": [^{"scale": 1, "translate": [0, 0, 0]}])", "exactly one key", "",
     "/shapes/0/transform/0", ""},
    {R"("environment": 1)",
     R"("environment": 1, "groups": [{"name": "g", "shapes": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]}],
        "instances": [{"group": "g", "transform": ^[{"scale": [1, 2, 1]}]}])",
     "stretches a sphere or disk of its group", "a stretched one can be a mesh", "/instances/0/transform", ""},
    // lights, sky, eye
    {R"("environment": 1)",
     R"("lights": [{"type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "intensity": 1, "falloff": ^30}])",
     "cannot begin to fall beyond its cutoff of 20", "", "/lights/0/falloff", ""},
    {R"("environment": 1)", R"("lights": [^{"type": "distant", "direction": [0, 0, 0], "irradiance": 1}])",
     "\"direction\" must not be zero", "", "/lights/0", ""},
    {R"("look_at": [0, 0, 0])", R"("look_at": [0, 0, 0], "projection": "panoramic", "fov": ^40)",
     "only a camera with \"projection\": \"perspective\" takes \"fov\"", "", "/camera/fov", ""},
    {R"("environment": 1)", R"("environment": 1, "render": { "filter": ^"gausian" })", "expected one of box, tent",
     "did you mean \"gaussian\"?", "/render/filter", ""},
    {R"("environment": 1)", R"("environment_image": {"file": ^"nowhere.hdr"})", "nowhere.hdr': ", "",
     "/environment_image/file", ""},
    {R"("environment": 1)", R"("environment_image": {"file": "nowhere.hdr", "transform": ^[{"scale": 2}]})",
     "can only be turned or mirrored", "", "/environment_image/transform", ""},
    // lobes and textures
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "lambert", "albedo": 0.5, "albedo_texture": ^"wod")",
     "there is no texture \"wod\"", "there are none", "/materials/0/albedo_texture", ""},
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "ggx", "metal": ^"Cv", "alpha": 0.1)",
     "there is no metal \"Cv\"", "did you mean \"Cr\"", "/materials/0/metal", ""},
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "ggx", "metal": "Cu", "f0": 1, "alpha": 0.1)",
     "expected one of \"f0\", \"metal\", or \"eta\" and \"k\"", "", "/materials/0", "{ \"name\""},
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "mirror", "eta": 1)", "make a metal together", "",
     "/materials/0", "{ \"name\""},
    {R"("type": "lambert", "albedo": 0.5)", R"("type": "rough-dielectric", "ior": ^1, "alpha": 0.1)",
     "an index of refraction other than 1", "", "/materials/0/ior", ""},
    {R"("environment": 1)", R"("environment": 1, "textures": [{"type": "image", "name": "t", "file": ^"nowhere.png"}])",
     "nowhere.png", "", "/textures/0/file", ""},
    {R"("environment": 1)", R"("environment": 1, "instances": [{"group": ^"towr"}])", "there is no group \"towr\"",
     "there are none", "/instances/0/group", ""},
};

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << "the table names a text that is not in the good scene: " << what;
  return text.replace(at, what.size(), with);
}

std::vector<Diagnostic> errors_of(std::string_view text) {
  try {
    read_json_scene(text, "room.json", ".");
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(MalformedScenes, TheSceneThatTheTableSpoilsIsGood) {
  EXPECT_NO_THROW(read_json_scene(kGood, "good", "."));
}

TEST(MalformedScenes, EachHasItsOneMessageUnderTheCulprit) {
  for (const Malformed& row : kMalformed) {
    std::string text = replaced(std::string(kGood), row.what, row.instead);
    SCOPED_TRACE(text);
    const std::size_t culprit = row.at.empty() ? text.find('^') : text.find(row.at);
    ASSERT_NE(culprit, std::string::npos);
    if (row.at.empty()) {
      text.erase(culprit, 1);
    }
    const auto line_begin = culprit == 0 ? 0 : text.rfind('\n', culprit - 1) + 1;
    const auto line =
        static_cast<std::size_t>(std::count(text.begin(), text.begin() + std::ptrdiff_t(culprit), '\n')) + 1;

    const std::vector<Diagnostic> errors = errors_of(text);
    ASSERT_EQ(errors.size(), 1u) << InputError(errors).what();
    EXPECT_EQ(errors[0].source, "room.json");
    EXPECT_EQ(errors[0].line, line);
    EXPECT_EQ(errors[0].column, culprit - line_begin + 1);
    EXPECT_THAT(errors[0].message, HasSubstr(row.message));
    EXPECT_THAT(errors[0].suggestion, HasSubstr(row.suggestion));
    EXPECT_EQ(errors[0].suggestion.empty(), row.suggestion.empty()) << errors[0].suggestion;
    EXPECT_EQ(errors[0].pointer, row.pointer);
  }
}

TEST(MalformedScenes, AllErrorsAreReportedInTheOrderOfTheText) {
  std::string text = replaced(std::string(kGood), "[0, 1, 4]", "[0, 1]");
  text = replaced(text, "\"environment\"", "\"enviroment\"");
  text = replaced(text, "0.5", "2");
  text = replaced(text, "\"radius\": 1", "\"radius\": 0");
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const Diagnostic& d : errors_of(text)) {
    found.emplace_back(d.line, d.pointer);
  }
  EXPECT_THAT(found, ::testing::ElementsAre(std::pair(2, "/camera/position"), std::pair(3, "/enviroment"),
                                            std::pair(4, "/materials/0/albedo"), std::pair(5, "/shapes/0/radius")));
}

TEST(MalformedScenes, CommentsAndByteOrderMarkDoNotShiftPlaces) {
  const std::string text =
      "\xEF\xBB\xBF/* \"camera\": { , */ " + replaced(std::string(kGood), "[0, 1, 4]", "/* [ */ 7");
  const std::vector<Diagnostic> errors = errors_of(text);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].line, 2u);
  EXPECT_EQ(errors[0].excerpt.substr(errors[0].column - 1, errors[0].length), "7");
  EXPECT_EQ(errors[0].pointer, "/camera/position");
}

TEST(MalformedScenes, BracketBombsEndInAnError) {
  for (const std::string& bomb :
       {std::string(1000000, '['), replaced(std::string(kGood), "[0, 1, 4]", std::string(65, '['))}) {
    const std::vector<Diagnostic> errors = errors_of(bomb);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_THAT(errors[0].message, HasSubstr("nested deeper than 64"));
  }
}

TEST(MalformedScenes, FloodsOfErrorsAreCut) {
  std::string numbers;
  for (int i = 0; i < 1000; ++i) {
    numbers += "\"x\", ";
  }
  const std::vector<Diagnostic> errors =
      errors_of(replaced(std::string(kGood), "\"shapes\": [", "\"shapes\": [" + numbers));
  ASSERT_EQ(errors.size(), 101u);
  EXPECT_THAT(errors.back().message, HasSubstr("more than 100 errors"));
}

TEST(MalformedScenes, EveryTruncationIsAnErrorAndNeverACrash) {
  for (std::size_t length = 0; length < kGood.size(); ++length) {
    EXPECT_FALSE(errors_of(kGood.substr(0, length)).empty()) << kGood.substr(0, length);
  }
}

TEST(MalformedScenes, FilesThatCannotBeReadSayWhy) {
  const TemporaryFolder folder;
  const struct {
    std::filesystem::path path;
    std::string message;
  } kRows[] = {{"/nowhere/at/all.json", "No such file"},
               {folder.write("scene.txt", kGood), "expected .json, .obj or .xml"},
               {kSourceDir / "nowhere.obj", "No such file"}};
  for (const auto& row : kRows) {
    try {
      load_scene(row.path);
      ADD_FAILURE() << row.path;
    } catch (const ReadError& error) {
      EXPECT_THAT(error.what(), HasSubstr(row.message));
      EXPECT_THAT(error.what(), HasSubstr(row.path.string()));
    }
  }
}

}  // namespace
}  // namespace heckbert::import
