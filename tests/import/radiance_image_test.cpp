// Pictures of light: what was written is what is read, in every compression of OpenEXR; what is no picture is refused.

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <heckbert/import/radiance_image.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

constexpr int kWidth = 33, kHeight = 17;

float value_at(int x, int y, int channel) {
  return 0.5f +
         0.4f * std::sin(0.2f * static_cast<float>(x) + 0.3f * static_cast<float>(y) + static_cast<float>(channel));
}

/// A data window away from the origin, as croppers leave it.
void write_exr(const std::filesystem::path& path, Imf::Compression compression,
               const std::vector<std::string>& channels) {
  const Imath::Box2i box({5, -3}, {5 + kWidth - 1, -3 + kHeight - 1});
  Imf::Header header(box, box);
  header.compression() = compression;
  std::vector<std::vector<float>> planes;
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    header.channels().insert(channels[c], Imf::Channel(Imf::FLOAT));
    auto& plane = planes.emplace_back();
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) plane.push_back(value_at(x, y, static_cast<int>(c)));
  }
  for (std::size_t c = 0; c < channels.size(); ++c)
    frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, planes[c].data(), box));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(kHeight);
}

TEST(RadianceImage, ReadsEveryCompressionOfOpenExr) {
  const TemporaryFolder folder;
  const struct {
    Imf::Compression compression;
    float tolerance;
  } rows[] = {{Imf::NO_COMPRESSION, 0},  {Imf::RLE_COMPRESSION, 0},      {Imf::ZIPS_COMPRESSION, 0},
              {Imf::ZIP_COMPRESSION, 0}, {Imf::PIZ_COMPRESSION, 0},      {Imf::PXR24_COMPRESSION, 1e-4f},
              {Imf::B44_COMPRESSION, 0}, {Imf::DWAA_COMPRESSION, 0.02f}, {Imf::DWAB_COMPRESSION, 0.02f}};
  for (const auto& row : rows) {
    const std::filesystem::path path = folder.path() / "picture.exr";
    write_exr(path, row.compression, {"R", "G", "B"});
    const RadianceImage image = read_radiance_image(path);
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const Rgb pixel = image.pixels[static_cast<std::size_t>(y * kWidth + x)];
        ASSERT_NEAR(pixel.r, value_at(x, y, 0), row.tolerance) << row.compression;
        ASSERT_NEAR(pixel.g, value_at(x, y, 1), row.tolerance) << row.compression;
        ASSERT_NEAR(pixel.b, value_at(x, y, 2), row.tolerance) << row.compression;
      }
  }
}

TEST(RadianceImage, GreyFilesFillAllThreeColours) {
  const TemporaryFolder folder;
  for (const char* name : {"Y", "luminance"}) {
    const std::filesystem::path path = folder.path() / "grey.exr";
    write_exr(path, Imf::ZIP_COMPRESSION, {name});
    EXPECT_EQ(read_radiance_image(path).pixels[40], Rgb(value_at(7, 1, 0)));
  }
  write_exr(folder.path() / "odd.exr", Imf::ZIP_COMPRESSION, {"U", "V"});
  EXPECT_THROW(read_radiance_image(folder.path() / "odd.exr"), ReadError);
}

TEST(RadianceImage, ReadsRadianceHdr) {
  const RadianceImage image = read_radiance_image(kSourceDir / "tests/import/data/sky.hdr");
  ASSERT_EQ(image.width, 4);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels[0], Rgb(1));
  EXPECT_EQ(image.pixels[1], Rgb(0.5f, 1, 255.0f / 128));
  EXPECT_EQ(image.pixels[2], Rgb(0));
  EXPECT_EQ(image.pixels[3], Rgb(128, 0, 0)) << "an exponent of 136 is 256 times the mantissa over 256";
}

TEST(RadianceImage, RefusesWhatIsNoPicture) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_radiance_image(folder.path() / "nowhere.hdr"), ReadError);
  EXPECT_THROW(read_radiance_image(folder.path()), ReadError);
  EXPECT_THROW(read_radiance_image(folder.write("text.hdr", "hello")), ReadError);
  write_exr(folder.path() / "whole.exr", Imf::ZIP_COMPRESSION, {"R", "G", "B"});
  const std::string bytes = read_all(folder.path() / "whole.exr");
  EXPECT_THROW(read_radiance_image(folder.write("cut.exr", bytes.substr(0, bytes.size() / 2))), ReadError);
}

TEST(RadianceImage, ReadsRealSkies) {
  const std::filesystem::path scenes = kSourceDir / "../shared/scenes";
  const struct {
    const char* file;
    int width, height;
  } rows[] = {{"hdri/studio_small_03_1k.hdr", 1024, 512}, {"ignis/textures/environment/constant.exr", 0, 0}};
  for (const auto& row : rows) {
    if (!std::filesystem::exists(scenes / row.file)) GTEST_SKIP() << "no " << row.file;
    const RadianceImage image = read_radiance_image(scenes / row.file);
    if (row.width > 0) {
      EXPECT_EQ(image.width, row.width);
      EXPECT_EQ(image.height, row.height);
    }
    double sum = 0;
    for (const Rgb& pixel : image.pixels) sum += static_cast<double>(pixel.g);
    EXPECT_GT(sum, 0);
  }
}

}  // namespace
}  // namespace heckbert::import
