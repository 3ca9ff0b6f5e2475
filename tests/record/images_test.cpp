#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <heckbert/record/record.h>
#include <heckbert/record/tile_pictures.h>
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

/// Partitions of all words: each word is in exactly one class.
const std::vector<std::vector<const char*>> kPartitions{
    {"L.*E"},
    {"LE", "L.+E"},
    {"LE", "L.E", "L..E", "L.{3}E", "L.{4,}E"},
    {"L(.*[^S])?E", "L.*SE"},
    {"La.*E", "Lp.*E", "Ld.*E", "Le.*E"},
    {"L[DGS]*E", "L.*V.*E"},
    {"L.*S.*E&L.*D.*E", "L.*S.*E-L.*D.*E", "L.*D.*E-L.*S.*E", "!(L.*[SD].*E)"},
};

/// For each word of a list, the class of the partition that has it.
std::vector<std::size_t> class_of_words(const std::vector<const char*>& partition,
                                        const std::vector<taxonomy::Word>& words) {
  std::vector<std::size_t> classes;
  for (const taxonomy::Word& word : words) {
    std::size_t found = 0;
    for (std::size_t c = 0; c < partition.size(); ++c)
      if (taxonomy::compile(partition[c]).contains(word)) {
        classes.push_back(c);
        ++found;
      }
    EXPECT_EQ(found, 1u) << taxonomy::fine(word) << " and a partition that begins with " << partition[0];
  }
  return classes;
}

/// As sums, before anything is divided or rounded, classes add up as whole numbers.
TEST(Sums, OfTheClassesOfAPartitionAddUpToTheBeautyExactly) {
  const RenderInfo info = info_for({3, 2, 35, 26}, 6);
  TileRecorder recorder(info);
  const Tile tile = MadeUpLight(11).tile(recorder, info.window, 6);
  for (const auto& partition : kPartitions) {
    const std::vector<std::size_t> class_of = class_of_words(partition, tile.words);
    for (std::size_t i = 0; i < info.window.pixel_count(); ++i) {
      std::vector<RgbSum> classes(partition.size());
      RgbSum whole, total;
      for (std::size_t e = tile.offsets[i]; e < tile.offsets[i + 1]; ++e) {
        classes[class_of[tile.entries[e].word]] += tile.entries[e].sum;
        whole += tile.entries[e].sum;
      }
      for (auto c = classes.rbegin(); c != classes.rend(); ++c) total += *c;
      ASSERT_EQ(total, whole);
    }
  }
}

/// As pictures each class and the beauty are rounded once to float, by half a unit in the last place, and are exact but
/// for that: no other error is in their sum.
TEST(Image, OfEachClassOfAPartitionErrsByItsOwnRoundingAlone) {
  const Record& record = made_up_record();
  const Image whole = beauty(record);
  const auto half_a_unit = [](float value) {
    return 0.5 * static_cast<double>(std::nextafter(value, std::numeric_limits<float>::infinity()) - value);
  };
  for (const auto& partition : kPartitions) {
    const std::vector<std::size_t> class_of = class_of_words(partition, record.words);
    std::vector<std::vector<bool>> sets(partition.size(), std::vector<bool>(record.words.size()));
    for (std::size_t w = 0; w < class_of.size(); ++w) sets[class_of[w]][w] = true;
    const std::vector<Image> images = images_of(record, sets);
    for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
      for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        double sum = 0, slack = half_a_unit(whole.pixels[i].*channel);
        for (const Image& image : images) {
          sum += static_cast<double>(image.pixels[i].*channel);
          slack += half_a_unit(image.pixels[i].*channel);
        }
        ASSERT_LE(std::abs(sum - static_cast<double>(whole.pixels[i].*channel)), slack);
      }
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

TEST(Image, OfManySetsAtOnceAndTileByTileIsThatOfEach) {
  const RenderInfo info = info_for({3, 2, 35, 26}, 6);
  const Record& record = made_up_record();
  std::vector<Language> languages;
  std::vector<std::vector<bool>> sets;
  for (const char* expression : kExpressions) {
    languages.push_back(taxonomy::compile(expression));
    sets.push_back(members(record, languages.back(), GlossyRule::Diffuse));
  }
  TilePictures pictures(info, languages, GlossyRule::Diffuse);
  TileRecorder recorder(info);
  for (const Window& window : tiles_of(info.window, 8)) pictures.add(MadeUpLight(11).tile(recorder, window, 6));
  const std::vector<Image> images = images_of(record, sets);
  ASSERT_EQ(images.size(), sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    EXPECT_EQ(images[i].pixels, image_of(record, sets[i]).pixels);
    EXPECT_EQ(pictures.classes()[i].pixels, images[i].pixels);
  }
  EXPECT_EQ(pictures.beauty().pixels, beauty(record).pixels);
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
