#include <heckbert/report/contact_sheet.h>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <heckbert/report/caption.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using test::four_grammars;
using test::lecture_like_record;

Picture blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
}

std::size_t inked(const Picture& picture) {
  return static_cast<std::size_t>(std::count_if(picture.rgb.begin(), picture.rgb.end(), [](int b) { return b != 0; }));
}

TEST(Caption, EveryPrintableLetterLooksDifferent) {
  std::set<std::vector<std::uint8_t>> shapes;
  for (char c = 32; c < 127; ++c) {
    Picture picture = blank(40, 40);
    draw_caption(picture, 4, 4, std::string(1, c), {255, 255, 255});
    EXPECT_EQ(inked(picture) == 0, c == ' ') << c;
    shapes.insert(picture.rgb);
  }
  EXPECT_EQ(shapes.size(), 95u);
}

TEST(Caption, LeavesOutWhatFallsOutside) {
  Picture picture = blank(10, 10);
  draw_caption(picture, -5, -5, "LSDE and more than fits", {255, 255, 255});
  EXPECT_GT(inked(picture), 0u);
  Picture outside = blank(10, 10);
  draw_caption(outside, 20, 20, "LSDE", {255, 255, 255});
  EXPECT_EQ(inked(outside), 0u);
}

TEST(Caption, DrawsLettersBeyondAscii) {
  Picture umlaut = blank(40, 40), plain = blank(40, 40);
  draw_caption(umlaut, 4, 4, "\u00fc", {255, 255, 255});
  draw_caption(plain, 4, 4, "u", {255, 255, 255});
  EXPECT_GT(inked(umlaut), inked(plain)) << "the dots are there";
}

TEST(Caption, FitsInItsColumnsAndItsHeight) {
  const int width = 200;
  Picture picture = blank(width + 60, kCaptionHeight + 40);
  draw_caption(picture, 0, 0, std::string(caption_columns(width), 'g'), {255, 255, 255});
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (x >= width + 1 || y >= kCaptionHeight) {
        ASSERT_EQ(picture.rgb[static_cast<std::size_t>(3 * (y * picture.width + x))], 0) << x << ", " << y;
      }
  EXPECT_GT(inked(picture), 0u);
}

/// The pixels of a rectangle of the sheet.
std::vector<std::uint8_t> pixels_at(const Picture& sheet, int x, int y, int width, int height) {
  std::vector<std::uint8_t> pixels;
  for (int row = y; row < y + height; ++row) {
    const auto from = sheet.rgb.begin() + 3 * (std::ptrdiff_t{row} * sheet.width + x);
    pixels.insert(pixels.end(), from, from + std::ptrdiff_t{3} * width);
  }
  return pixels;
}

/// Where a picture stands in the sheet, wherever the layout puts it; each place is named by its upper left corner.
std::vector<std::pair<int, int>> places_of(const Picture& sheet, const Picture& picture) {
  std::vector<std::pair<int, int>> places;
  for (int y = 0; y + picture.height <= sheet.height; ++y)
    for (int x = 0; x + picture.width <= sheet.width; ++x)
      if (pixels_at(sheet, x, y, picture.width, 1) ==
              std::vector(picture.rgb.begin(), picture.rgb.begin() + std::ptrdiff_t{3} * picture.width) &&
          pixels_at(sheet, x, y, picture.width, picture.height) == picture.rgb)
        places.emplace_back(x, y);
  return places;
}

TEST(ContactSheet, ShowsEveryPartAtTheExposureOfThePicture) {
  const record::Record record = lecture_like_record(32, 24);
  const Coverage coverage = report::coverage(record, four_grammars());
  const Picture sheet = contact_sheet(record, coverage, {.picture_width = 32});
  const float exposure = auto_exposure(record::beauty(record));

  const auto picture = places_of(sheet, to_srgb(record::beauty(record), exposure));
  EXPECT_EQ(picture.size(), 2u) << "the picture, and the same captured by global illumination";
  int above = picture.at(0).second;
  for (std::size_t i = 0; i + 1 < coverage.grammars.size(); ++i) {
    std::vector<bool> missed = coverage.grammars[i].captured;
    missed.flip();
    const auto left = places_of(sheet, to_srgb(image_of(record, coverage.grammars[i].captured), exposure));
    const auto right = places_of(sheet, to_srgb(image_of(record, missed), exposure));
    ASSERT_EQ(left.size(), 1u) << coverage.grammars[i].name;
    ASSERT_EQ(right.size(), 1u) << coverage.grammars[i].name;
    EXPECT_EQ(left[0].second, right[0].second) << "side by side";
    EXPECT_LT(left[0].first, right[0].first) << "captured on the left";
    EXPECT_GT(left[0].second, above) << "one row below the other";
    above = left[0].second;
  }
}

TEST(ContactSheet, TakesAnExposure) {
  const record::Record record = lecture_like_record(16, 16);
  const Picture sheet =
      contact_sheet(record, coverage(record, four_grammars()), {.exposure = 0.25f, .picture_width = 16});
  EXPECT_EQ(places_of(sheet, to_srgb(record::beauty(record), 0.25f)).size(), 2u);
}

TEST(ContactSheet, EnlargesSmallAndShrinksLargePictures) {
  const auto sheet_width = [](int width, int picture_width) {
    const record::Record record = lecture_like_record(width, 4);
    return contact_sheet(record, coverage(record, {}), {.picture_width = picture_width}).width;
  };
  EXPECT_EQ(sheet_width(10, 40), sheet_width(40, 40)) << "times four";
  EXPECT_EQ(sheet_width(120, 40), sheet_width(40, 40)) << "a third";
  EXPECT_EQ(sheet_width(100, 40) - sheet_width(40, 40), 2 * (34 - 40)) << "a third, rounded up";
}

TEST(ContactSheet, WorksWithoutLight) {
  for (const record::Record& record :
       {test::sample_record(4, 4, {}), test::sample_record(4, 4, {{.word = "LE", .batches = {0, 0}}})}) {
    const Picture sheet = contact_sheet(record, coverage(record, four_grammars()));
    EXPECT_EQ(sheet.rgb.size(), 3u * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
    EXPECT_GT(sheet.height, 4 * 512);
  }
}

}  // namespace
}  // namespace heckbert::report
