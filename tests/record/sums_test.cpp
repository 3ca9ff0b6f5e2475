// Records that are added up: parts of a render and renders with other seeds, in any order and grouping.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include <heckbert/record/file.h>
#include <heckbert/record/statistics.h>
#include <heckbert/record/sums.h>
#include <heckbert/record/sums_stream.h>
#include <heckbert/taxonomy/error.h>

#include "synthetic.h"
#include "temporary_folder.h"

namespace heckbert::record {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr Window kWindow{2, 1, 13, 10};

RenderInfo whole_info(int samples, std::uint64_t seed = 1) {
  RenderInfo info = info_for(kWindow, samples);
  info.seed = seed;
  return info;
}

/// What a machine finds that takes the samples of one part of made-up light.
Sums part_of(const MadeUpLight& light, int samples, const Part& part, std::uint64_t seed = 1, int tile_size = 8) {
  Sums sums{whole_info(samples, seed), {}};
  const SampleRange range = samples_of(part, seed, samples);
  set_samples(sums.info, {range});
  TileRecorder recorder(sums.info);
  std::vector<Tile> tiles;
  for (const Window& window : tiles_of(kWindow, tile_size)) {
    recorder.begin_tile(window);
    for (int y = window.y0; y < window.y1; ++y)
      for (int x = window.x0; x < window.x1; ++x)
        for (int s = range.first; s < range.last; ++s) {
          light.send_sample(recorder, x, y, s);
          if (s % 5 == 0) recorder.add_non_path(NonPath::Ambient, {0.1f, 0.2f, 0.3f});
          if (s % 3 == 0) recorder.add_cut_off({0.3f, 0.1f, 0.7f});
        }
    tiles.push_back(recorder.end_tile());
  }
  sums.tile = added(kWindow, std::move(tiles));
  return sums;
}

/// Merges two at random until one is left: any order, any grouping.
Sums merged_at_random(std::vector<Sums> parts, std::mt19937& random) {
  while (parts.size() > 1) {
    std::shuffle(parts.begin(), parts.end(), random);
    Sums last = std::move(parts.back());
    parts.pop_back();
    parts.back() = merged(std::move(parts.back()), std::move(last));
  }
  return std::move(parts.front());
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const MergeError& error) {
    return error.what();
  }
  return "no error";
}

/// 1 to as many parts as samples; for each number three random orders and groupings, seed 5.
TEST(Merge, PartsAreTheWholeToTheLastBit) {
  const MadeUpLight light(51);
  std::mt19937 random(5);
  for (const int samples : {1, 7, 40}) {
    const Sums whole = part_of(light, samples, {});
    const Record record = record_of(whole);
    for (const int parts : {1, 2, 3, 7, 33, 40}) {
      if (parts > samples) continue;
      SCOPED_TRACE(testing::Message() << samples << " samples in " << parts << " parts");
      std::vector<Sums> all;
      for (int i = 1; i <= parts; ++i) all.push_back(part_of(light, samples, {i, parts}));
      for (int trial = 0; trial < (parts > 1 ? 3 : 1); ++trial) {
        const Sums sum = merged_at_random(all, random);
        ASSERT_TRUE(sum == whole);
        ASSERT_TRUE(record_of(sum) == record);
      }
    }
  }
}

TEST(Merge, WholeRendersAgreeWithTheRecorder) {
  const MadeUpLight light(52);
  Sums whole = part_of(light, 9, {}, 18446744073709551615u, 5);
  whole.tile.ambient.clear();
  whole.tile.tally.cut_off = whole.tile.tally.cut_off_squares = 0;
  EXPECT_TRUE(record_of(whole) == record_of(light, info_for(kWindow, 9)));
}

TEST(Merge, OtherSeedsAreMoreSamples) {
  const Sums a = part_of(MadeUpLight(53), 40, {}, 1), b = part_of(MadeUpLight(54), 20, {}, 2);
  const Sums both = merged(a, b);
  EXPECT_EQ(both.info.samples_per_pixel, 60);
  EXPECT_THAT(both.info.parts, ElementsAre(SampleRange{1, 40, 0, 40}, SampleRange{2, 20, 0, 20}));
  EXPECT_TRUE(both == merged(b, a));
  EXPECT_FALSE(both.info.partial);

  const Record ra = record_of(a), rb = record_of(b), rboth = record_of(both);
  const auto all = [](const Record& r) { return std::vector<bool>(r.words.size(), true); };
  // Weighted by the numbers of samples; the batches hold what the pixels hold.
  EXPECT_NEAR(energy(rboth, all(rboth)).mean, (40 * energy(ra, all(ra)).mean + 20 * energy(rb, all(rb)).mean) / 60,
              1e-6);
  const Image image = beauty(rboth);
  double sum = 0;
  for (const Rgb& pixel : image.pixels) sum += static_cast<double>(luminance(pixel));
  EXPECT_NEAR(energy(rboth, all(rboth)).mean, sum / static_cast<double>(image.pixels.size()), 1e-5);
  EXPECT_EQ(batches_in_use(rboth.info), 32) << "20 of them have samples of both";
}

TEST(Merge, RefusesTheSameSamplesTwice) {
  const MadeUpLight light(55);
  const auto part = [&](int number, int of) { return part_of(light, 12, {number, of}); };
  EXPECT_EQ(refusal([&] { merged(part(2, 3), part(2, 3)); }), "both have samples 4 to 7 of 12, seed 1");
  EXPECT_EQ(refusal([&] { merged(part(1, 1), part(3, 3)); }), "both have samples 8 to 11 of 12, seed 1");
  EXPECT_EQ(refusal([&] { merged(part(1, 2), part(1, 3)); }), "both have samples 0 to 3 of 12, seed 1");
  EXPECT_EQ(refusal([&] { merged(merged(part(1, 4), part(3, 4)), part(2, 3)); }),
            "both have samples 6 to 7 of 12, seed 1");
}

TEST(Merge, DoubtsTheSameSeed) {
  EXPECT_EQ(doubt_of(whole_info(8, 1), whole_info(8, 2)), "");
  EXPECT_EQ(doubt_of(whole_info(8, 1), whole_info(8, 1)), "") << "refused anyway";
  EXPECT_THAT(doubt_of(whole_info(8, 1), whole_info(9, 1)),
              HasSubstr("samples 0 to 7 of 8, seed 1 and samples 0 to 8 of 9, seed 1: with the same seed"));
}

TEST(Merge, RefusesWhatDoesNotBelongTogether) {
  const std::vector<std::pair<std::function<void(RenderInfo&)>, const char*>> changes{
      {[](RenderInfo& i) { i.scene_hash = "00"; }, "the scene differs: 'made-up' and 'made-up, contents 00'"},
      {[](RenderInfo& i) { i.algorithm = "whitted"; }, "the algorithm differs: 'path' and 'whitted'"},
      {[](RenderInfo& i) { i.width = 99; }, "the size differs: '16x12' and '99x12'"},
      {[](RenderInfo& i) { i.window.x0 = 3; }, "the crop differs: '2,1,13,10' and '3,1,13,10'"},
      {[](RenderInfo& i) { i.max_depth = 3; }, "the depth differs: '12' and '3'"},
      {[](RenderInfo& i) { i.sampler = "random"; }, "the sampler differs: '' and 'random'"},
      {[](RenderInfo& i) { i.filter = "tent 1"; }, "the filter differs: '' and 'tent 1'"},
      {[](RenderInfo& i) { i.labels = "object"; }, "the label rule differs: '' and 'object'"},
      {[](RenderInfo& i) { i.version = "9"; }, "the tool version differs: '0.1' and '9'"},
      {[](RenderInfo& i) { i.has_batches = false; },
       "the source differs: 'a render of this tool' and 'an import without batches'"},
  };
  for (const auto& [change, message] : changes) {
    RenderInfo other = whole_info(4, 2);
    change(other);
    EXPECT_THAT(refusal([&, &o = other] { check_alike(whole_info(4), o); }), HasSubstr(message));
  }
  RenderInfo elsewhere = whole_info(4, 2);
  elsewhere.scene = "another path to it";
  EXPECT_EQ(refusal([&] { check_alike(whole_info(4), elsewhere); }),
            "the scene differs: 'made-up' and 'another path to it'");
  RenderInfo here = whole_info(4);
  here.scene_hash = elsewhere.scene_hash = "0123456789abcdef";
  EXPECT_EQ(refusal([&] { check_alike(here, elsewhere); }), "no error") << "the contents count, not the name";
}

/// An interrupted render and the rest of it are the whole, wherever it was interrupted. 20 places.
TEST(Completed, IsTheWholeWhereverItWasInterrupted) {
  const MadeUpLight light(56);
  const RenderInfo info = whole_info(6);
  const auto record_pixels = [&](std::size_t first, std::size_t last) {
    TileRecorder recorder(info);
    std::vector<Tile> tiles;
    for (const Window& window : tiles_of(kWindow, 4)) {
      recorder.begin_tile(window);
      for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) {
          const auto pixel = static_cast<std::size_t>((y - kWindow.y0) * kWindow.width() + x - kWindow.x0);
          for (int s = 0; pixel >= first && pixel < last && s < 6; ++s) light.send_sample(recorder, x, y, s);
        }
      tiles.push_back(recorder.end_tile());
    }
    Sums sums{info, added(kWindow, std::move(tiles))};
    sums.info.partial = is_partial(info, sums.tile);
    return sums;
  };
  const std::size_t all = kWindow.pixel_count();
  const Sums whole = record_pixels(0, all);
  EXPECT_FALSE(whole.info.partial);
  EXPECT_TRUE(record_of(whole) == record_of(light, info));
  for (std::size_t trial = 0; trial < 20; ++trial) {
    const std::size_t pixel = trial * all / 20;
    const Sums begun = record_pixels(0, pixel), rest = record_pixels(pixel, all);
    EXPECT_TRUE(begun.info.partial);
    EXPECT_TRUE(collected(completed(stream_of(begun), stream_of(rest))) == whole);
  }
}

/// In a render from the light that was stopped, pixels have splats and no samples yet: their sums wait, and the record
/// can be read, by pixel too.
TEST(SumsFile, KeepsWhatIsSplattedOntoPixelsWithoutSamples) {
  const TemporaryFolder folder;
  Sums sums = part_of(MadeUpLight(61), 5, {});
  for (std::size_t pixel = 0; pixel < 40; ++pixel) sums.tile.samples[pixel] = 0;
  sums.info.partial = true;
  write_sums(sums, folder / "s.exr");
  EXPECT_TRUE(read_sums(folder / "s.exr") == sums);
  const Record record = read_record(folder / "s.exr");
  EXPECT_TRUE(record == record_of(sums));
  EXPECT_FALSE(record.pixel(kWindow.x0, kWindow.y0).empty());
  EXPECT_EQ(beauty(record).at(kWindow.x0, kWindow.y0), Rgb());
}

TEST(SumsFile, IsReadBackAndIsARecordToo) {
  const TemporaryFolder folder;
  const MadeUpLight light(57);
  Sums empty{whole_info(3), added(kWindow, {})};
  empty.info.partial = true;
  for (const Sums& sums : {part_of(light, 40, {}), part_of(light, 40, {2, 3}), part_of(light, 1, {}), empty}) {
    write_sums(sums, folder / "s.exr");
    EXPECT_TRUE(read_sums(folder / "s.exr") == sums);
    EXPECT_TRUE(read_record(folder / "s.exr") == record_of(sums));
  }
}

TEST(SumsFile, MeansAreNoSums) {
  const TemporaryFolder folder;
  write_record(record_of(MadeUpLight(58), whole_info(3)), folder / "r.exr");
  try {
    read_sums(folder / "r.exr");
    FAIL() << "nothing was thrown";
  } catch (const ReadError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("r.exr"), HasSubstr("this record has means and no sums")));
  }
}

TEST(SumsStream, OfSeveralFilesIsMergedToTheBytesOfSumsInMemory) {
  const TemporaryFolder folder;
  const MadeUpLight light(60);
  std::vector<Sums> parts{part_of(light, 40, {}, 2)};
  for (int number = 1; number <= 4; ++number) parts.push_back(part_of(light, 40, {number, 4}));
  std::vector<SumsStream> streams;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto path = folder / (std::to_string(i) + ".exr");
    write_sums(parts[i], path);
    streams.push_back(open_sums(path));
  }
  std::mt19937 random(60);
  std::shuffle(streams.begin(), streams.end(), random);
  const SumsStream stream = merged(std::move(streams));
  Sums sums = merged_at_random(std::move(parts), random);
  EXPECT_TRUE(collected(stream) == sums);
  write_sums(stream, folder / "streamed.exr");
  write_sums(sums, folder / "held.exr");
  EXPECT_TRUE(bytes_of(folder / "streamed.exr") == bytes_of(folder / "held.exr"));
  for (const Precision precision : {Precision::Half, Precision::Float}) {
    sums.info.precision = precision;
    write_record(totals_of(stream, precision), stream, folder / "streamed.exr");
    write_record(record_of(sums), folder / "held.exr");
    EXPECT_TRUE(bytes_of(folder / "streamed.exr") == bytes_of(folder / "held.exr"));
  }
  EXPECT_THROW(merged({open_sums(folder / "1.exr"), open_sums(folder / "1.exr")}), MergeError);
}

/// Whatever bytes are damaged, reading ends in an error or in a record. 200 files, two bytes replaced in each, seed 6.
TEST(SumsFile, SurvivesDamagedBytes) {
  const TemporaryFolder folder;
  write_sums(part_of(MadeUpLight(59), 5, {}), folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  std::mt19937 random(6);
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::string damaged = whole;
    for (int i = 0; i < 2; ++i) damaged[random() % whole.size()] = static_cast<char>(random());
    put_bytes(folder / "damaged.exr", damaged);
    try {
      read_sums(folder / "damaged.exr");
    } catch (const ReadError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 150) << "means and sums must fit";
}

TEST(AddedCounts, DoNotWrapAround) {
  EXPECT_EQ(added_counts(0xfffffffeu, 1), 0xffffffffu);
  EXPECT_THROW(added_counts(0xffffffffu, 1), std::overflow_error);
}

TEST(Parts, ShareOutAllSamplesAndKeepBatchesWhole) {
  for (const int samples : {1, 2, 31, 32, 33, 64, 100, 1000})
    for (int of = 1; of <= std::min(samples, 70); ++of) {
      std::vector<SampleRange> all;
      for (int i = 1; i <= of; ++i) {
        const SampleRange range = samples_of({i, of}, 3, samples);
        EXPECT_GE(range.count(), samples / of);
        EXPECT_LE(range.count(), samples / of + 1);
        const bool begins_a_batch = range.first == first_of_batch(batch_of(range.first, samples), samples);
        EXPECT_TRUE(begins_a_batch || samples < kBatches || kBatches % of != 0) << samples << ' ' << i << '/' << of;
        all = united(all, {range});
      }
      EXPECT_THAT(all, ElementsAre(SampleRange{3, samples, 0, samples}));
    }
}

TEST(Parts, KnowWhatIsMissing) {
  EXPECT_THAT(missing_of({{1, 8, 0, 8}, {2, 4, 0, 4}}), ElementsAre());
  EXPECT_THAT(
      missing_of({{1, 8, 2, 3}, {1, 8, 5, 8}, {2, 4, 0, 3}, {2, 5, 1, 5}}),
      ElementsAre(SampleRange{1, 8, 0, 2}, SampleRange{1, 8, 3, 5}, SampleRange{2, 4, 3, 4}, SampleRange{2, 5, 0, 1}));
}

TEST(Parts, HaveTheBatchesOfTheWhole) {
  for (const int samples : {5, 40, 64}) {
    RenderInfo info;
    std::array<int, kBatches> sum{};
    for (int i = 1; i <= 5; ++i) {
      set_samples(info, {samples_of({i, 5}, 1, samples)});
      const auto sizes = batch_sizes(info);
      EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), 0), info.samples_per_pixel);
      for (std::size_t b = 0; b < kBatches; ++b) sum[b] += sizes[b];
    }
    EXPECT_EQ(sum, batch_sizes(samples));
  }
  RenderInfo imported;
  imported.samples_per_pixel = 64;
  imported.has_batches = false;
  EXPECT_EQ(batches_in_use(imported), 1);
}

}  // namespace
}  // namespace heckbert::record
