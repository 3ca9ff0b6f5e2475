#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/expression.h>

#include "synthetic.h"

namespace heckbert::record {
namespace {

using taxonomy::GlossyRule;
using taxonomy::Language;
using taxonomy::Symbol;

constexpr std::array kExpressions{"LDE", "L.*E", "LS+DE", "L(D|S)*E", "L[DG]S*E", "L.*V.*E", "LaX{3,}Ep"};

const Record& made_up_record() {
  static const Record record = record_of(MadeUpLight(11), info_for({3, 2, 35, 26}, 6));
  return record;
}

TEST(Image, OfALanguageIsTheSumOfItsWords) {
  const Record& record = made_up_record();
  std::size_t hits = 0;
  for (const char* expression : kExpressions) {
    SCOPED_TRACE(expression);
    const Language language = taxonomy::compile(expression);
    const Image image = image_of(record, members(record, language));
    ASSERT_EQ(image.window, record.info.window);
    for (int y = image.window.y0; y < image.window.y1; ++y) {
      for (int x = image.window.x0; x < image.window.x1; ++x) {
        double r = 0, g = 0, b = 0;
        for (const Entry& entry : record.pixel(x, y)) {
          if (!language.contains(record.words[entry.word])) continue;
          ++hits;
          r += static_cast<double>(entry.energy.r);
          g += static_cast<double>(entry.energy.g);
          b += static_cast<double>(entry.energy.b);
        }
        ASSERT_EQ(image.at(x, y), Rgb(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)));
      }
    }
  }
  EXPECT_GT(hits, 1000u);
}

/// Each image is rounded once to float, so the parts are off by half a unit in their own last place each and the whole
/// by half a unit in its own. Parts are no larger than the whole and all three are multiples of the parts' units, which
/// leaves one unit in the last place of the whole for the rounded sum.
void expect_within_one_ulp(float sum, float whole) {
  EXPECT_LE(sum, std::nextafter(whole, std::numeric_limits<float>::infinity()));
  EXPECT_GE(sum, std::nextafter(whole, -std::numeric_limits<float>::infinity()));
}

TEST(Members, OfManyLanguagesAreThoseOfEach) {
  const Record& record = made_up_record();
  std::vector<Language> languages;
  for (const char* expression : kExpressions) languages.push_back(taxonomy::compile(expression));
  for (const GlossyRule rule : {GlossyRule::Keep, GlossyRule::Diffuse, GlossyRule::Specular}) {
    const auto together = members(record, languages, rule);
    ASSERT_EQ(together.size(), languages.size());
    for (std::size_t i = 0; i < languages.size(); ++i)
      EXPECT_EQ(together[i], members(record, languages[i], rule)) << kExpressions[i];
  }
  EXPECT_TRUE(members(record, std::vector<Language>{}).empty());
}

TEST(Image, OfALanguageAndOfItsComplementAddUpToTheBeauty) {
  const Record& record = made_up_record();
  const Image whole = beauty(record);
  for (const char* expression : kExpressions) {
    SCOPED_TRACE(expression);
    const Language language = taxonomy::compile(expression);
    const Image inside = image_of(record, members(record, language));
    const Image outside = image_of(record, members(record, !language));
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
      const Rgb sum = inside.pixels[i] + outside.pixels[i];
      expect_within_one_ulp(sum.r, whole.pixels[i].r);
      expect_within_one_ulp(sum.g, whole.pixels[i].g);
      expect_within_one_ulp(sum.b, whole.pixels[i].b);
    }
  }
}

TEST(Image, OfAllWordsOneByOneAddsUpToTheBeauty) {
  const Record& record = made_up_record();
  std::vector<std::array<double, 3>> sums(record.info.window.pixel_count());
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    std::vector<bool> one(record.words.size());
    one[w] = true;
    const Image image = image_of(record, one);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i][0] += static_cast<double>(image.pixels[i].r);
      sums[i][1] += static_cast<double>(image.pixels[i].g);
      sums[i][2] += static_cast<double>(image.pixels[i].b);
    }
  }
  const Image whole = beauty(record);
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_EQ(whole.pixels[i],
              Rgb(static_cast<float>(sums[i][0]), static_cast<float>(sums[i][1]), static_cast<float>(sums[i][2])));
}

TEST(Members, ReadGlossyEventsByTheRule) {
  struct Case {
    GlossyRule rule;
    Symbol read_as;
  };
  const Record& record = made_up_record();
  for (const Case& c :
       {Case{GlossyRule::Keep, Symbol::Gr}, {GlossyRule::Diffuse, Symbol::Dr}, {GlossyRule::Specular, Symbol::Sr}}) {
    SCOPED_TRACE(static_cast<int>(c.rule));
    const Language language = taxonomy::compile("L(D|S)*DE");
    const std::vector<bool> chosen = members(record, language, c.rule);
    std::size_t count = 0;
    for (std::size_t w = 0; w < chosen.size(); ++w) {
      taxonomy::Word word = record.words[w];
      for (Symbol& event : word.events)
        if (taxonomy::facts(event).letter == 'G') event = c.read_as;
      EXPECT_EQ(chosen[w], language.contains(word)) << taxonomy::fine(record.words[w]);
      count += chosen[w] ? 1 : 0;
    }
    EXPECT_GT(count, 0u);
  }
}

}  // namespace
}  // namespace heckbert::record
