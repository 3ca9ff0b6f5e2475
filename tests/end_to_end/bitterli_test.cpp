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
