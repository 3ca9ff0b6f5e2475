#include <heckbert/report/picture.h>

#include <gtest/gtest.h>

#include "report/decode_png.h"

namespace heckbert::report {
namespace {

record::Image image_of_pixels(int width, int height, std::vector<Rgb> pixels) {
  return {{0, 0, width, height}, std::move(pixels)};
}

TEST(ToSrgb, FollowsTheStandardsCurve) {
  // IEC 61966-2-1: the linear toe, the join, middle grey, a half, white and beyond.
  const std::vector<std::pair<float, int>> expected{{-1.0f, 0},   {0.0f, 0},   {0.002f, 7}, {0.0031308f, 10},
                                                    {0.18f, 118}, {0.5f, 188}, {1.0f, 255}, {40.0f, 255}};
  for (const auto& [linear, byte] : expected)
    EXPECT_EQ(to_srgb(image_of_pixels(1, 1, {Rgb(linear)}), 1).rgb[1], byte) << linear;
}

TEST(ToSrgb, ExposureIsAFactor) {
  const record::Image image = image_of_pixels(2, 1, {{0.1f, 0.2f, 0.3f}, {0.01f, 0.02f, 0.03f}});
  EXPECT_EQ(to_srgb(image, 4).rgb, to_srgb(image_of_pixels(2, 1, {{0.4f, 0.8f, 1.2f}, {0.04f, 0.08f, 0.12f}}), 1).rgb);
}

TEST(AutoExposure, BringsTheLogAverageToMiddleGrey) {
  EXPECT_NEAR(auto_exposure(image_of_pixels(1, 1, {Rgb(0.36f)})), 0.5, 1e-6);
  // Log-average of 0.1 and 10 is 1.
  EXPECT_NEAR(auto_exposure(image_of_pixels(2, 1, {Rgb(0.1f), Rgb(10.0f)})), 0.18, 1e-6);
}

TEST(AutoExposure, IgnoresADarkBackground) {
  EXPECT_EQ(auto_exposure(image_of_pixels(3, 1, {Rgb(0.36f), Rgb(), Rgb()})),
            auto_exposure(image_of_pixels(1, 1, {Rgb(0.36f)})));
}

TEST(AutoExposure, OfBlackIsOne) {
  EXPECT_EQ(auto_exposure(image_of_pixels(2, 1, {Rgb(), Rgb()})), 1);
  EXPECT_EQ(auto_exposure(image_of_pixels(0, 0, {})), 1);
}

TEST(Shrunk, AveragesBlocksAndSmallerOnesAtTheEdge) {
  const record::Image image = image_of_pixels(3, 2, {Rgb(1), Rgb(3), Rgb(8), Rgb(5), Rgb(7), Rgb(4)});
  const record::Image small = shrunk(image, 2);
  ASSERT_EQ(small.window, (record::Window{0, 0, 2, 1}));
  EXPECT_EQ(small.pixels[0], Rgb(4));
  EXPECT_EQ(small.pixels[1], Rgb(6));
  EXPECT_EQ(shrunk(image, 3).pixels, image.pixels);
}

TEST(Shrunk, StartsAtTheCornerOfACroppedWindow) {
  record::Image image = image_of_pixels(2, 2, {Rgb(1), Rgb(2), Rgb(3), Rgb(6)});
  image.window = {5, 7, 7, 9};
  EXPECT_EQ(shrunk(image, 1).pixels, std::vector<Rgb>{Rgb(3)});
}

TEST(EncodePng, DecodesToTheSamePixels) {
  Picture picture{5, 3, {}};
  for (int i = 0; i < 45; ++i) picture.rgb.push_back(static_cast<std::uint8_t>(i * 37));
  const Picture decoded = test::decode_png(encode_png(picture));
  EXPECT_EQ(decoded.width, 5);
  EXPECT_EQ(decoded.height, 3);
  EXPECT_EQ(decoded.rgb, picture.rgb);
}

TEST(EncodePng, RefusesAPictureWithoutPixels) {
  EXPECT_THROW(encode_png({0, 0, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace heckbert::report
