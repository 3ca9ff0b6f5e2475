#include <heckbert/record/recorder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <thread>

#include <heckbert/taxonomy/word_literal.h>

#include "synthetic.h"

namespace heckbert::record {
namespace {

using namespace taxonomy::literals;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

RenderInfo small_info(int samples_per_pixel, Window window = {0, 0, 2, 1}) {
  return info_for(window, samples_per_pixel);
}

void add(PathSink& sink, const taxonomy::Word& word, Rgb value, Technique technique = Technique::Hit) {
  sink.add({node_of(sink.words(), word), value, technique});
}

Record record_of_one_tile(const RenderInfo& info, Tile tile) {
  Assembler assembler(info);
  assembler.submit(std::move(tile));
  return assembler.finish(false);
}

TEST(Batches, DealTheSamplesOutEvenlyAndInOrder) {
  for (int samples = 1; samples <= 200; ++samples) {
    SCOPED_TRACE(samples);
    std::array<int, kBatches> sizes{};
    int last = 0;
    for (int s = 0; s < samples; ++s) {
      const int batch = batch_of(s, samples);
      ASSERT_TRUE(batch == last || batch == last + 1);
      last = batch;
      ++sizes[static_cast<std::size_t>(batch)];
    }
    EXPECT_EQ(last + 1, batch_count(samples));
    EXPECT_EQ(sizes, batch_sizes(samples));
    const auto in_use = std::span(sizes).first(static_cast<std::size_t>(batch_count(samples)));
    EXPECT_LE(*std::max_element(in_use.begin(), in_use.end()) - *std::min_element(in_use.begin(), in_use.end()), 1);
  }
}

/// The slow twin: sums in maps, keyed by the words themselves.
struct Twin {
  struct Sum {
    RgbSum sum;
    std::uint32_t count = 0;
    void add(Rgb v) {
      sum += RgbSum(v);
      ++count;
    }
  };
  std::map<std::pair<int, int>, std::map<taxonomy::Word, Sum>> pixels;  // by (y, x)
  std::map<taxonomy::Word, std::array<Sum, kBatches>> batches;
  Tally tally;

  Twin(const MadeUpLight& light, const RenderInfo& info) {
    for (int y = info.window.y0; y < info.window.y1; ++y) {
      for (int x = info.window.x0; x < info.window.x1; ++x) {
        for (int s = 0; s < info.samples_per_pixel; ++s) {
          ++tally.samples;
          ++tally.absorbed;
          for (const Found& found : light.sample(x, y, s)) {
            pixels[{y, x}][found.word].add(found.value);
            batches[found.word][static_cast<std::size_t>(batch_of(s, info.samples_per_pixel))].add(found.value);
            ++(found.technique == Technique::Hit ? tally.hits : tally.next_events);
          }
        }
      }
    }
  }
};

TEST(Record, HoldsWhatASlowTwinHolds) {
  const RenderInfo info = info_for({5, 3, 24, 20}, 40);  // 40 samples: batches of one and of two
  const MadeUpLight light(1);
  const Twin twin(light, info);
  const Record record = record_of(light, info, 7);

  EXPECT_EQ(record.tally, twin.tally);
  ASSERT_EQ(record.words.size(), twin.batches.size());
  ASSERT_GT(record.words.size(), 40u);
  ASSERT_EQ(record.offsets.size(), info.window.pixel_count() + 1);

  std::size_t w = 0;
  for (const auto& [word, sums] : twin.batches) {
    EXPECT_EQ(record.words[w], word);
    std::uint64_t count = 0;
    for (const Twin::Sum& sum : sums) count += sum.count;
    EXPECT_EQ(record.counts[w], count);
    for (std::size_t b = 0; b < kBatches; ++b) {
      const double samples = batch_sizes(40)[b] * static_cast<double>(info.window.pixel_count());
      EXPECT_EQ(record.batch_means[w * kBatches + b], mean_of(sums[b].sum, samples));
    }
    ++w;
  }

  for (int y = info.window.y0; y < info.window.y1; ++y) {
    for (int x = info.window.x0; x < info.window.x1; ++x) {
      const auto found = twin.pixels.find({y, x});
      ASSERT_NE(found, twin.pixels.end());
      const std::span<const Entry> entries = record.pixel(x, y);
      ASSERT_EQ(entries.size(), found->second.size());
      auto entry = entries.begin();
      for (const auto& [word, sum] : found->second) {
        EXPECT_EQ(record.words[entry->word], word);
        EXPECT_EQ(entry->energy, mean_of(sum.sum, 40));
        EXPECT_EQ(entry->count, sum.count);
        ++entry;
      }
    }
  }
}

TEST(Splats, AreWhatTheirPixelsWouldHaveAdded) {
  const RenderInfo info = info_for({5, 3, 44, 30}, 40);
  const Window& window = info.window;
  TileRecorder adding(info), splatting(info);
  std::mt19937 random(5);
  for (const std::uint64_t seed : {6u, 7u}) {  // the second tile has nothing of the first
    SCOPED_TRACE(seed);
    const MadeUpLight light(seed);
    struct Splat {
      int x, y, sample;
      Found found;
    };
    std::vector<Splat> splats;
    adding.begin_tile(window);
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x)
        for (int sample = 0; sample < info.samples_per_pixel; ++sample) {
          adding.begin_sample(x, y, sample);
          for (const Found& found : light.sample(x, y, sample)) {
            if (is_black(found.value)) continue;
            add(adding, found.word, found.value, found.technique);
            splats.push_back({x, y, sample, found});
          }
        }
    const Tile added = adding.end_tile();
    ASSERT_GT(added.entries.size(), 10000u);

    std::shuffle(splats.begin(), splats.end(), random);
    splatting.begin_tile(window);
    for (const Splat& splat : splats) {
      splatting.begin_sample(window.x0, window.y0, splat.sample);  // wherever its own walk began
      splatting.splat(splat.x, splat.y,
                      {node_of(splatting.words(), splat.found.word), splat.found.value, splat.found.technique});
    }
    splatting.end_tile();
    splatting.sort_splats();
    const Tile splatted = splatting.end_splats();
    EXPECT_EQ(splatted.words, added.words);
    EXPECT_EQ(splatted.offsets, added.offsets);
    EXPECT_TRUE(splatted.entries == added.entries);
    EXPECT_TRUE(splatted.batch_sums == added.batch_sums);
  }
}

TEST(Record, DoesNotDependOnWhoTracedWhichTileAndWhen) {
  const RenderInfo info = info_for({5, 3, 44, 30}, 5);
  const MadeUpLight light(2);
  const Record expected = record_of(light, info);
  const std::vector<Window> windows = tiles_of(info.window, 8);
  ASSERT_GT(windows.size(), 15u);
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<std::size_t> order(windows.size());
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<TileRecorder> recorders(1 + random() % 4, TileRecorder(info));
    Assembler assembler(info);
    for (const std::size_t number : order)
      assembler.submit(light.tile(recorders[random() % recorders.size()], windows[number], 5));
    EXPECT_TRUE(assembler.finish(false) == expected);
  }
}

TEST(Record, IsTheSameForAnyNumberOfThreads) {
  const RenderInfo info = info_for({0, 0, 64, 48}, 4);
  const MadeUpLight light(4);
  const Record expected = record_of(light, info);
  const std::vector<Window> windows = tiles_of(info.window, 8);
  Assembler assembler(info);
  std::vector<std::thread> threads;
  constexpr std::size_t kThreads = 3;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      TileRecorder recorder(info);
      for (std::size_t i = t; i < windows.size(); i += kThreads) {
        const std::size_t number = windows.size() - 1 - i;
        assembler.submit(light.tile(recorder, windows[number], 4));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(assembler.finish(false) == expected);
}

/// The samples of a picture dealt out to three recorders, a tile each of the same pixels.
TEST(Tile, OfASampleIsAPartOfTheTileOfAll) {
  const RenderInfo info = info_for({5, 3, 24, 20}, 40);
  const MadeUpLight light(7);
  TileRecorder recorder(info);
  const Tile whole = light.tile(recorder, info.window, 40);
  std::map<std::pair<std::size_t, taxonomy::Word>, RgbSum> pixels;
  std::map<std::pair<taxonomy::Word, std::uint32_t>, RgbSum> batches;
  std::vector<std::uint32_t> samples(info.window.pixel_count());
  Tally tally;
  for (int part = 2; part >= 0; --part) {
    recorder.begin_tile(info.window);
    for (int y = info.window.y0; y < info.window.y1; ++y)
      for (int x = info.window.x0; x < info.window.x1; ++x)
        for (int s = part; s < 40; s += 3) light.send_sample(recorder, x, y, s);
    const Tile tile = recorder.end_tile();
    tally += tile.tally;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i] += tile.samples[i];
      for (std::size_t e = tile.offsets[i]; e < tile.offsets[i + 1]; ++e)
        pixels[{i, tile.words[tile.entries[e].word]}] += tile.entries[e].sum;
    }
    for (const BatchSum& sum : tile.batch_sums) batches[{tile.words[sum.word], sum.batch}] += sum.sum;
  }

  EXPECT_EQ(tally, whole.tally);
  EXPECT_EQ(samples, whole.samples);
  ASSERT_EQ(pixels.size(), whole.entries.size());
  ASSERT_EQ(batches.size(), whole.batch_sums.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t e = whole.offsets[i]; e < whole.offsets[i + 1]; ++e)
      EXPECT_EQ((pixels[{i, whole.words[whole.entries[e].word]}]), whole.entries[e].sum);
  for (const BatchSum& sum : whole.batch_sums) EXPECT_EQ((batches[{whole.words[sum.word], sum.batch}]), sum.sum);
}

TEST(Record, DoesNotDependOnTheOrderOfPixelsInATile) {
  const RenderInfo info = info_for({2, 1, 12, 9}, 3);
  const MadeUpLight light(5);
  TileRecorder recorder(info);
  recorder.begin_tile(info.window);
  for (int x = info.window.x1 - 1; x >= info.window.x0; --x)
    for (int y = info.window.y0; y < info.window.y1; ++y)
      for (int s = 0; s < 3; ++s) light.send_sample(recorder, x, y, s);
  const Record record = record_of_one_tile(info, recorder.end_tile());
  const Record expected = record_of(light, info, 100);
  EXPECT_EQ(record.words, expected.words);
  EXPECT_EQ(record.offsets, expected.offsets);
  EXPECT_EQ(record.entries, expected.entries);
}

TEST(Record, HasTheBatchMeansOfAnExampleByHand) {
  // Two pixels, 64 samples: batches of two. Word A: 1 in sample 0 and 3 in sample 1 of the left pixel, 8 in sample 63
  // of the right one. Word B: black, found in sample 2.
  const RenderInfo info = small_info(64);
  TileRecorder recorder(info);
  recorder.begin_tile(info.window);
  for (int x = 0; x < 2; ++x) {
    for (int s = 0; s < 64; ++s) {
      recorder.begin_sample(x, 0, s);
      if (x == 0 && s == 0) add(recorder, "LDE"_word, Rgb(1));
      if (x == 0 && s == 1) add(recorder, "LDE"_word, {3, 0, 0});
      if (x == 0 && s == 2) add(recorder, "LSE"_word, Rgb(0));
      if (x == 1 && s == 63) add(recorder, "LDE"_word, Rgb(8));
    }
  }
  const Record record = record_of_one_tile(info, recorder.end_tile());

  ASSERT_EQ(record.words, (std::vector{"LDE"_word, "LSE"_word}));
  std::vector<Rgb> expected(std::size_t{2} * kBatches);
  expected[0] = {1, 0.25f, 0.25f};  // (1 + 3) / 2 samples / 2 pixels
  expected[kBatches - 1] = Rgb(2);  // 8 / 2 / 2
  EXPECT_EQ(record.batch_means, expected);
  EXPECT_EQ(record.offsets, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(record.entries, (std::vector<Entry>{{0, {4.0f / 64, 1.0f / 64, 1.0f / 64}, 2},
                                                {1, Rgb(0), 1},  // a word is present when it was found, however dark
                                                {0, Rgb(8.0f / 64), 1}}));
}

TEST(Record, MakesEachSampleABatchWhenThereAreFew) {
  const RenderInfo info = small_info(2, {0, 0, 1, 1});
  TileRecorder recorder(info);
  recorder.begin_tile(info.window);
  for (int s = 0; s < 2; ++s) {
    recorder.begin_sample(0, 0, s);
    add(recorder, "LE"_word, Rgb(static_cast<float>(s + 1)));
  }
  const Record record = record_of_one_tile(info, recorder.end_tile());
  std::vector<Rgb> expected(kBatches);
  expected[0] = Rgb(1);
  expected[1] = Rgb(2);
  EXPECT_EQ(record.batch_means, expected);
  EXPECT_EQ(record.entries, (std::vector<Entry>{{0, Rgb(1.5f), 2}}));
}

TEST(Record, CountsWhatItRejectsAndAddsNoneOfIt) {
  struct Case {
    Rgb value;
    bool accepted;
    std::uint64_t not_finite, negative;
  };
  const std::vector<Case> cases{
      {{kNan, 1, 1}, false, 1, 0},      {{1, kInfinity, 1}, false, 1, 0}, {{1, 1, -kInfinity}, false, 1, 0},
      {{1, -1e-30f, 1}, false, 0, 1},   {{-1, kNan, 1}, false, 1, 0},     {{-0.0f, 0, 0}, true, 0, 0},
      {{1e-44f, 3e38f, 1}, true, 0, 0},
  };  // what is too bright or too faint to add as it is: the next test
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const Case& c = cases[i];
    const RenderInfo info = small_info(1);
    TileRecorder recorder(info);
    recorder.begin_tile(info.window);
    recorder.begin_sample(0, 0, 0);
    add(recorder, "LDE"_word, c.value);
    recorder.begin_sample(1, 0, 0);
    recorder.add_non_path(NonPath::Ambient, c.value);
    const Record record = record_of_one_tile(info, recorder.end_tile());
    EXPECT_EQ(record.words.size(), c.accepted ? 1u : 0u);
    EXPECT_EQ(record.entries.size(), c.accepted ? 1u : 0u);
    EXPECT_EQ(record.ambient.empty(), !c.accepted);
    EXPECT_EQ(record.tally.hits, c.accepted ? 1u : 0u);
    EXPECT_EQ(record.tally.rejected_not_finite, 2 * c.not_finite);
    EXPECT_EQ(record.tally.rejected_negative, 2 * c.negative);
  }
}

TEST(Record, CountsWhatItCannotAddAsItIs) {
  struct Case {
    Rgb value, energy;
    std::uint64_t clamped, vanished;
  };
  constexpr float kFaintest = 0x1p-57f;  // rounds up to a quantum
  const std::vector<Case> cases{
      {{kMostLight, 1, 0}, {kMostLight, 1, 0}, 0, 0},
      {{3e38f, 1, 0x1p32f}, {kMostLight, 1, kMostLight}, 1, 0},
      {{1e-44f, 0, 0}, Rgb(0), 0, 1},
      {{1e-44f, 1, 0}, {0, 1, 0}, 0, 0},
      {{0, kFaintest, 0}, {0, 0x1p-56f, 0}, 0, 0},
      {Rgb(0), Rgb(0), 0, 0},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    const Case& c = cases[i];
    const RenderInfo info = small_info(1, {0, 0, 1, 1});
    TileRecorder recorder(info);
    recorder.begin_tile(info.window);
    recorder.begin_sample(0, 0, 0);
    add(recorder, "LDE"_word, c.value);
    const Record record = record_of_one_tile(info, recorder.end_tile());
    EXPECT_EQ(record.entries, (std::vector<Entry>{{0, c.energy, 1}}));
    EXPECT_EQ(record.tally.clamped, c.clamped);
    EXPECT_EQ(record.tally.vanished, c.vanished);
  }
}

TEST(Record, KeepsLightThatNoPathCarriesApart) {
  const RenderInfo info = small_info(2);
  TileRecorder recorder(info);
  recorder.begin_tile(info.window);
  recorder.begin_sample(1, 0, 0);
  recorder.add_non_path(NonPath::Phantom, {1, 2, 3});
  recorder.begin_sample(1, 0, 1);
  recorder.add_non_path(NonPath::Phantom, {3, 2, 1});
  const Record record = record_of_one_tile(info, recorder.end_tile());
  EXPECT_EQ(record.phantom, (std::vector<Rgb>{Rgb(0), Rgb(2)}));
  EXPECT_TRUE(record.ambient.empty());
  EXPECT_TRUE(record.entries.empty());
  EXPECT_EQ(beauty(record).pixels, (std::vector<Rgb>{Rgb(0), Rgb(0)}));
}

TEST(Record, TalliesTechniquesAndEnds) {
  const RenderInfo info = small_info(1);
  TileRecorder recorder(info);
  recorder.begin_tile(info.window);
  recorder.begin_sample(0, 0, 0);
  add(recorder, "LDE"_word, Rgb(1), Technique::Hit);
  for (int i = 0; i < 2; ++i) add(recorder, "LDE"_word, Rgb(1), Technique::NextEvent);
  const std::vector<std::pair<PathEnd, int>> ends{
      {PathEnd::Escaped, 1}, {PathEnd::Absorbed, 2}, {PathEnd::DepthLimit, 3}, {PathEnd::Roulette, 4}};
  for (const auto& [end, times] : ends)
    for (int i = 0; i < times; ++i) recorder.end_path(end);
  const Record record = record_of_one_tile(info, recorder.end_tile());
  const Tally expected{
      .samples = 1, .hits = 1, .next_events = 2, .escaped = 1, .absorbed = 2, .depth_limited = 3, .roulette = 4};
  EXPECT_EQ(record.tally, expected);
}

TEST(Record, LeavesPixelsOfMissingTilesEmpty) {
  const RenderInfo info = info_for({5, 3, 30, 20}, 2);
  const MadeUpLight light(6);
  const std::vector<Window> windows = tiles_of(info.window, 8);
  TileRecorder recorder(info);
  Assembler assembler(info);
  for (std::size_t number = 0; number < windows.size(); ++number)
    if (number % 3 != 1) assembler.submit(light.tile(recorder, windows[number], 2));
  const Record partial = assembler.finish(true);
  const Record whole = record_of(light, info);
  EXPECT_TRUE(partial.info.partial);
  for (std::size_t number = 0; number < windows.size(); ++number) {
    const Window& window = windows[number];
    for (int y = window.y0; y < window.y1; ++y) {
      for (int x = window.x0; x < window.x1; ++x) {
        const auto is_same = [&](const Entry& a, const Entry& b) {
          return a.energy == b.energy && a.count == b.count && partial.words[a.word] == whole.words[b.word];
        };
        const auto found = partial.pixel(x, y), expected = whole.pixel(x, y);
        if (number % 3 == 1)
          EXPECT_TRUE(found.empty());
        else
          EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), is_same));
      }
    }
  }
}

TEST(Record, OfNothingIsEmptyButWellFormed) {
  const RenderInfo info = small_info(1);
  const Record record = Assembler(info).finish(true);
  EXPECT_TRUE(record.words.empty());
  EXPECT_EQ(record.offsets, (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_EQ(beauty(record).pixels, (std::vector<Rgb>(2)));
}

TEST(Assembler, RefusesTilesThatBreakItsContract) {
  const RenderInfo info = info_for({0, 0, 8, 8}, 1);
  const auto tile = [&](const Window& window) {
    TileRecorder recorder(info);
    recorder.begin_tile(window);
    return recorder.end_tile();
  };
  Assembler assembler(info);
  assembler.submit(tile({0, 0, 4, 4}));
  EXPECT_THROW(assembler.submit(tile({4, 4, 9, 8})), std::logic_error) << "outside";
  Tile unsorted = tile({4, 4, 8, 8});
  unsorted.words = {"LSE"_word, "LDE"_word};
  EXPECT_THROW(assembler.submit(unsorted), std::logic_error) << "words not sorted";
  assembler.submit(tile({3, 2, 5, 5}));
  EXPECT_THROW(assembler.finish(false), std::logic_error) << "overlaps";
}

}  // namespace
}  // namespace heckbert::record
