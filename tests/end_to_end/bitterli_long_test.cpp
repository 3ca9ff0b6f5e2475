// Bitterli's scenes, the whole pictures at a quarter of their size: the mean colour within 2 % of the author's, and the
// error that falls as one over the root of the samples where that takes long to see.
//
// Last result (2026-11-28), mean over reference of red, green and blue, and slope of the error:
//   cornell-box    1.000 1.000 1.000 +- 0.0001   -0.490 +- 0.006
//   veach-mis      0.998 0.998 0.998 +- 0.004    -0.491 +- 0.007
//   veach-bidir    1.002 1.002 1.001 +- 0.002    -0.485 +- 0.012
//   water-caustic  1.000 0.995 0.993 +- 0.007    -0.506 +- 0.024

#include <iostream>

#include "end_to_end/bitterli.h"

namespace heckbert::bitterli {
namespace {

// The box filter, since the whole picture's mean is asked for and the file's filter would reach beyond its edge.
TEST_P(BitterliScene, HasTheMeanColourOfTheReference) {
  const Case& scene = GetParam();
  transport::RenderSettings settings = settings_of(imported_, 512);
  settings.width /= 4;
  settings.height /= 4;
  settings.filter = {};
  const record::Record record = transport::render(imported_.scene, settings);
  const Mean mean = mean_of(record, comparable(record, scene));
  const record::Image picture = reference(scene);
  const Colour expected = mean_of(picture, picture.window);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double ratio = scene.bias * mean.value[channel] / expected[channel];
    const double error = scene.bias * mean.standard_error[channel] / expected[channel];
    std::cout << scene.name << " "
              << "rgb"[channel] << " " << ratio << " +- " << error << std::endl;
    EXPECT_LT(error, 0.01);
    EXPECT_NEAR(ratio, 1, 0.02);
  }
}

// Between 16 and 256 samples per pixel; bounds as in bitterli_test.cpp.
TEST_P(BitterliScene, LosesItsErrorAsOneOverTheRootOfTheSamples) {
  const Slope found = slope(rendered(16, 4), rendered(256, 5), GetParam());
  std::cout << GetParam().name << " slope " << found.value << " +- " << found.standard_error << std::endl;
  EXPECT_LT(found.standard_error, 0.1);
  EXPECT_NEAR(found.value, -0.5, 4 * found.standard_error);
}

INSTANTIATE_TEST_SUITE_P(Long, BitterliScene, testing::ValuesIn(kCases), name_of);

}  // namespace
}  // namespace heckbert::bitterli
