// Bitterli's scenes against the author's pictures: windows of the full picture, with the file's own filter, so that
// each pixel has its counterpart. Whole pictures: bitterli_long_test.cpp.

#include "end_to_end/bitterli.h"

namespace heckbert::bitterli {
namespace {

TEST_P(BitterliScene, IsUnderstoodWhole) {
  const Case& scene = GetParam();
  const record::Image picture = reference(scene);
  EXPECT_EQ(imported_.scene.defaults.width, picture.window.width());
  EXPECT_EQ(imported_.scene.defaults.height, picture.window.height());
  EXPECT_EQ(imported_.scene.defaults.max_depth, scene.segments - 1);
  EXPECT_EQ(imported_.account.ignored.size(), scene.ignored);
}

INSTANTIATE_TEST_SUITE_P(All, BitterliScene, testing::ValuesIn(kCases), name_of);

/// Those whose windows converge within a second or two.
class QuietScene : public BitterliScene {};

// The mean of a window, each channel: within 2 % of the reference and 3.6 standard errors of the run, which is 1 %
// after Sidak for three channels of three scenes by Student's test with 15 degrees of freedom. The standard errors
// themselves must be small enough for this to mean something.
TEST_P(QuietScene, HasTheColourOfTheReference) {
  const record::Record record = rendered(16, 1);
  const Mean mean = mean_of(record, comparable(record, GetParam()));
  const Colour expected = mean_of(reference(GetParam()), GetParam().window);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_LT(mean.standard_error[channel], 0.01 * expected[channel]) << channel;
    EXPECT_NEAR(mean.value[channel], expected[channel], 0.02 * expected[channel] + 3.6 * mean.standard_error[channel])
        << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(All, QuietScene, testing::Values(kCases[0], kCases[1], kCases[2]), name_of);

class QuietestScene : public BitterliScene {};

// The error of a pixel falls as one over the root of the samples: slope -1/2 between 4 and 64 samples per pixel, within
// four standard errors (Student's test with 15 degrees of freedom, 1 % after Sidak for two scenes, with room for groups
// of rows that are not quite alike).
TEST_P(QuietestScene, LosesItsErrorAsOneOverTheRootOfTheSamples) {
  const Slope found = slope(rendered(4, 2), rendered(64, 3), GetParam());
  EXPECT_LT(found.standard_error, 0.03);
  EXPECT_NEAR(found.value, -0.5, 4 * found.standard_error);
}

INSTANTIATE_TEST_SUITE_P(All, QuietestScene, testing::Values(kCases[0], kCases[1]), name_of);

// Why the picture of water-caustic is 20/19 of the truth: a photon map of twenty neighbours, made of the scene as it is
// in the file, has the picture's colour in every part of it, within the 2 % that are asked for. Last
// result: 1.006 1.006 1.006 over all, 0.997 to 1.013 by part. With the 19 of an unbiased estimate it is 0.955, and with
// the placeholders that the file has for the water's normals (docs/mitsuba-import.md) the parts depart from it by up to
// 30 %.
TEST(BitterliWaterCaustic, IsThePictureOfAPhotonMapOfTwentyNeighbours) {
  const Case& scene = kCases[3];
  if (!std::filesystem::exists(folder_of(scene)))
    GTEST_SKIP() << "SKIPPED: " << scene.name << " is not at " << kScenes << "; nothing was tested";
  constexpr int kSize = 256;
  const record::Image found =
      photon_mapped(import::load_scene(folder_of(scene) / "scene.xml").scene,
                    {.photons = 1'000'000, .neighbours = 20, .longest = scene.segments - 2}, kSize, kSize, 4);
  const record::Image expected = reference(scene);
  const int times = expected.window.width() / kSize;
  const struct {
    const char* name;
    record::Window window;
  } parts[] = {{"all", {0, 0, kSize, kSize}},
               {"ceiling", {60, 4, 200, 26}},
               {"wall above the water", {70, 35, 186, 50}},
               {"wall below the water", {30, 100, 224, 160}},
               {"floor", {30, 236, 226, 250}}};
  for (const auto& [name, w] : parts) {
    const Colour a = mean_of(found, w);
    const Colour b = mean_of(expected, {times * w.x0, times * w.y0, times * w.x1, times * w.y1});
    for (std::size_t channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(a[channel] / b[channel], 1, 0.02) << name << ", "
                                                    << "rgb"[channel];
  }
}

TEST(BitterliCornellBox, HasNoMirrorAndNoGlass) {
  const Case& scene = kCases[0];
  if (!std::filesystem::exists(folder_of(scene)))
    GTEST_SKIP() << "SKIPPED: " << scene.name << " is not at " << kScenes << "; nothing was tested";
  const import::Imported imported = load(scene);
  transport::RenderSettings settings = settings_of(imported, 16);
  settings.width = settings.height = 64;
  const record::Record record = transport::render(imported.scene, settings);
  const std::vector<bool> specular = record::members(record, taxonomy::compile("L .* S .* E"));
  EXPECT_EQ(std::count(specular.begin(), specular.end(), true), 0);
  EXPECT_GT(record.words.size(), 10u);
}

}  // namespace
}  // namespace heckbert::bitterli
