// Records whose words were too many. Light is made up of multiples of 1/16 below 4 and every pixel has 4 samples, so
// all sums and means are exact in float and half: what a folded record calls exact must equal, bit for bit, what the
// unfolded one says, and the truth must lie between the bounds of the rest.
#include <heckbert/record/folding.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <heckbert/record/file.h>
#include <heckbert/record/record_spool.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/expression.h>

#include "synthetic.h"
#include "temporary_folder.h"

namespace heckbert::record {
namespace {

using taxonomy::compile;
using taxonomy::GlossyRule;
using taxonomy::Language;

constexpr int kSamples = 4;

Tile dyadic_tile(const MadeUpLight& light, const RenderInfo& info, const Window& window) {
  TileRecorder recorder(info);
  recorder.begin_tile(window);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      for (int s = 0; s < kSamples; ++s) {
        recorder.begin_sample(x, y, s);
        for (const Found& f : light.sample(x, y, s)) {
          const auto rounded = [](float value) { return std::floor(16 * value) / 16; };
          recorder.add({node_of(recorder.words(), f.word),
                        {rounded(f.value.r), rounded(f.value.g), rounded(100 * f.value.b)},
                        f.technique});
        }
      }
  return recorder.end_tile();
}

class Folding : public testing::Test {
 protected:
  Folding() {
    info.precision = Precision::Half;
    for (const Window& window : tiles_of(info.window, 8)) tiles.push_back(dyadic_tile(light, info, window));
    for (const char* expression : {"L D* E", "L D? S* E", "L .* S E", "L (D|S)* E", "Le .* E"})
      exact.push_back(compile(expression));
  }

  Record written(const std::optional<FoldRule>& rule, const std::vector<Tile>& in_this_order) {
    RecordSpool spool(info, folder / "r.exr", rule);
    for (const Tile& tile : in_this_order) spool.submit(tile);
    const SumsStream sums = spool.stream();
    write_record(totals_of(sums, info.precision), sums, folder / "r.exr");
    return read_record(folder / "r.exr");
  }
  Record folded(std::size_t most_words) { return written(FoldRule{most_words, exact}, tiles); }

  const MadeUpLight light{41, 300};
  RenderInfo info = info_for({0, 0, 30, 20}, kSamples);
  std::vector<Tile> tiles;
  std::vector<Language> exact;
  const TemporaryFolder folder;
};

std::vector<bool> without(std::vector<bool> words, const std::vector<bool>& others) {
  for (std::size_t w = 0; w < words.size(); ++w) words[w] = words[w] && !others[w];
  return words;
}

std::uint64_t count_of(const Record& record, const std::vector<bool>& chosen) {
  std::uint64_t count = 0;
  for (std::size_t w = 0; w < chosen.size(); ++w) count += chosen[w] ? record.counts[w] : 0;
  return count;
}

bool is_at_most(Rgb a, Rgb b) {
  return a.r <= b.r && a.g <= b.g && a.b <= b.b;
}

TEST_F(Folding, KeepsNoMoreWordsThanItMay) {
  const Record whole = written({}, tiles);
  ASSERT_GT(whole.words.size(), 200u);
  EXPECT_FALSE(whole.folding);
  for (const std::size_t most : {10u, 50u, 150u}) {
    SCOPED_TRACE(most);
    const Record record = folded(most);
    ASSERT_TRUE(record.folding);
    EXPECT_LE(record.folding->first, most);
    EXPECT_EQ(record.folding->exact, exact);
    EXPECT_TRUE(std::is_sorted(record.words.begin(), record.words.end()));
    EXPECT_LE(record.words.size() - record.folding->first, 32u) << "at most a class per set of five languages";
    const auto longer = [&](const taxonomy::Word& word) {
      return word.length() > static_cast<std::size_t>(record.folding->longest);
    };
    EXPECT_EQ(record.folding->first, static_cast<std::size_t>(std::ranges::count_if(whole.words, std::not_fn(longer))))
        << "every word that is short enough is there";
    EXPECT_TRUE(std::all_of(record.words.begin() + static_cast<std::ptrdiff_t>(record.folding->first),
                            record.words.end(), longer));
  }
  EXPECT_FALSE(folded(whole.words.size()).folding) << "what fits is left alone";
}

TEST_F(Folding, LeavesThePictureAndTheBatchesAsTheyAre) {
  const Record whole = written({}, tiles), record = folded(40);
  const std::vector<bool> all_whole(whole.words.size(), true), all(record.words.size(), true);
  EXPECT_EQ(beauty(record).pixels, beauty(whole).pixels);
  EXPECT_EQ(count_of(record, all), count_of(whole, all_whole));
  EXPECT_LT(record.entries.size(), whole.entries.size());
}

TEST_F(Folding, IsExactForWhatWasDeclaredAndAllThatIsMadeOfIt) {
  const Record whole = written({}, tiles), record = folded(40);
  std::vector<Language> asked = exact;
  for (const Language& a : exact)
    for (const Language& b : exact) asked.insert(asked.end(), {a & b, a | b, a - b, !a});
  for (std::size_t i = 0; i < asked.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_THAT(undecided(record, asked[i]), testing::Each(false));
    EXPECT_EQ(image_of(record, members(record, asked[i])).pixels, image_of(whole, members(whole, asked[i])).pixels);
    EXPECT_EQ(count_of(record, members(record, asked[i])), count_of(whole, members(whole, asked[i])));
  }
}

// 400 expressions made at random, under every rule for G; the number of comparisons says itself how many were
// undecided.
TEST_F(Folding, HoldsTheTruthBetweenItsBounds) {
  const Record whole = written({}, tiles), record = folded(40);
  std::mt19937 random(42);
  const std::vector<std::string> pieces{"D", "S", "G", "V", ".", "(D|S)", "X*", "D+", ".{3}", "[^S]*", ".*", "St?"};
  int decided = 0, narrowed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string expression = "L";
    for (auto n = random() % 5; n > 0; --n) expression += " " + pieces[random() % pieces.size()];
    expression += " E";
    SCOPED_TRACE(expression);
    const Language asked = compile(expression);
    const GlossyRule rule = taxonomy::kGlossyRules[random() % taxonomy::kGlossyRules.size()].rule;
    const std::vector<bool> open = undecided(record, asked, rule);
    const std::vector<bool> certain = without(members(record, asked, rule), open);
    std::vector<bool> possible = certain;
    std::transform(certain.begin(), certain.end(), open.begin(), possible.begin(), std::logical_or<>());
    const Image truth = image_of(whole, members(whole, asked, rule));
    const Image least = image_of(record, certain), most = image_of(record, possible);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
      ASSERT_TRUE(is_at_most(least.pixels[i], truth.pixels[i]) && is_at_most(truth.pixels[i], most.pixels[i])) << i;
    }
    decided += least.pixels == most.pixels ? 1 : 0;
    narrowed += count_of(record, certain) > 0 && least.pixels != most.pixels ? 1 : 0;

    // An expression and all else are a partition: certain, certain and undecided are the picture.
    EXPECT_EQ(undecided(record, !asked, rule), open);
    const std::vector<bool> rest = without(members(record, !asked, rule), open);
    const std::vector<Image> parts = images_of(record, {certain, rest, open});
    const Image whole_picture = beauty(record);
    for (std::size_t i = 0; i < whole_picture.pixels.size(); ++i)
      ASSERT_EQ(parts[0].pixels[i] + parts[1].pixels[i] + parts[2].pixels[i], whole_picture.pixels[i]) << i;
  }
  EXPECT_GT(decided, 50) << "short words are kept";
  EXPECT_GT(narrowed, 50);
}

TEST_F(Folding, IsTheSameBytesInWhateverOrderTilesCome) {
  folded(40);
  const std::string bytes = bytes_of(folder / "r.exr");
  std::mt19937 random(43);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<Tile> shuffled = tiles;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    written(FoldRule{40, exact}, shuffled);
    EXPECT_TRUE(bytes_of(folder / "r.exr") == bytes);
  }
}

TEST_F(Folding, IsCheckedWhenRead) {
  Record record = folded(40);
  const auto refused = [&](int longest, std::size_t first) {
    record.folding->longest = longest;
    record.folding->first = first;
    write_record(record, folder / "r.exr");
    try {
      read_record(folder / "r.exr");
    } catch (const ReadError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto [longest, first] = std::pair(record.folding->longest, record.folding->first);
  EXPECT_EQ(refused(longest, first), "no error");
  for (const auto& [wrong_longest, wrong_first] :
       {std::pair(longest + 1, first), {longest - 1, first}, {-1, first}, {longest, first + 1}, {longest, first - 1}})
    EXPECT_THAT(refused(wrong_longest, wrong_first), testing::HasSubstr("folded words does not fit the words"));
}

}  // namespace
}  // namespace heckbert::record
