#include <heckbert/record/file.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompositeDeepScanLine.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <heckbert/record/record_spool.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/word_literal.h>

#include "synthetic.h"
#include "temporary_folder.h"

namespace heckbert::record {
namespace {

using namespace taxonomy::literals;

TEST(RecordFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  Record made_up = record_of(MadeUpLight(21), info_for({5, 3, 70, 90}, 7));
  made_up.info.scene = "Szene \"größer\".json";
  made_up.info.partial = true;
  made_up.info.labels = "object,light-group";
  for (std::size_t i = 0; i < kTallyFields.size(); ++i) made_up.tally.*kTallyFields[i].field = ~std::uint64_t{0} - i;

  Record with_non_path = record_of(MadeUpLight(22), info_for({0, 0, 4, 3}, 1));
  with_non_path.phantom.assign(12, {1, 2, 3});
  with_non_path.phantom[7] = {1e-40f, std::numeric_limits<float>::max(), 0.1f};
  Record with_both = with_non_path;
  with_both.ambient.assign(12, Rgb(0.3f));
  with_both.phantom[0] = Rgb(0);

  const Record empty = Assembler(info_for({2, 2, 5, 4}, 16)).finish(true);

  Record long_word = Assembler(info_for({0, 0, 1, 1}, 1)).finish(false);
  long_word.words = {"LDE"_word, {taxonomy::Symbol::La, std::vector(400, taxonomy::Symbol::St), taxonomy::Symbol::El}};
  long_word.entries = {{0, Rgb(1e-40f), 1}, {1, {0, 3e38f, 1}, 4294967295u}};
  long_word.offsets = {0, 2};
  long_word.counts = {1, 4294967295u};
  long_word.batch_means.resize(std::size_t{2} * kBatches, Rgb(0.1f));

  const std::vector<std::pair<const char*, const Record*>> cases{{"made up", &made_up},
                                                                 {"phantom", &with_non_path},
                                                                 {"phantom and ambient", &with_both},
                                                                 {"empty", &empty},
                                                                 {"long word", &long_word}};
  for (const auto& [name, record] : cases) {
    SCOPED_TRACE(name);
    write_record(*record, folder / "r.exr");
    const Record read = read_record(folder / "r.exr");
    EXPECT_EQ(read.info, record->info);
    EXPECT_EQ(read.tally, record->tally);
    EXPECT_EQ(read.words, record->words);
    EXPECT_TRUE(read == *record);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"r.exr"});
}

TEST(RecordFile, OfHalfPrecisionHasEveryEnergyRoundedOnce) {
  const TemporaryFolder folder;
  Record record = record_of(MadeUpLight(27), info_for({5, 3, 40, 30}, 7));
  record.entries[3].energy = {65504, 65505, 1e9f};
  record.entries[5].energy = {1e-9f, 0, 2e-8f};
  record.info.precision = Precision::Half;
  write_record(record, folder / "r.exr");

  const Record read = read_record(folder / "r.exr");
  Record expected = record;
  expected.tally.half_clamped = 1;
  expected.tally.half_vanished = 1;
  const auto rounded = [](float energy) { return static_cast<float>(half(std::min(energy, 65504.0f))); };
  for (Entry& entry : expected.entries)
    entry.energy = {rounded(entry.energy.r), rounded(entry.energy.g), rounded(entry.energy.b)};
  EXPECT_EQ(read.entries, expected.entries);
  EXPECT_TRUE(read == expected);
  EXPECT_EQ(read.entries[3].energy, Rgb(65504));
  EXPECT_EQ(read.entries[5].energy, Rgb(0));

  write_record(read, folder / "again.exr");
  EXPECT_TRUE(bytes_of(folder / "again.exr") == bytes_of(folder / "r.exr")) << "rounded twice is rounded once";
}

TEST(RecordFile, TellsTheTotalsWithoutThePixels) {
  const TemporaryFolder folder;
  Record record = record_of(MadeUpLight(28), info_for({5, 3, 25, 20}, 9));
  record.ambient.assign(record.info.window.pixel_count(), Rgb(1));
  write_record(record, folder / "r.exr");
  const Record totals = read_record_totals(folder / "r.exr");
  record.entries.clear();
  record.offsets.clear();
  record.ambient.clear();
  EXPECT_TRUE(totals == record);
}

TEST(RecordFile, ShowsItsRows) {
  const TemporaryFolder folder;
  Record record = record_of(MadeUpLight(31), info_for({5, 3, 25, 50}, 9));
  record.ambient.assign(record.info.window.pixel_count(), Rgb(1));
  write_record(record, folder / "r.exr");
  const RecordFile file(folder / "r.exr");
  EXPECT_TRUE(file.whole() == record);
  Record totals = record;
  totals.entries.clear();
  totals.offsets.clear();
  EXPECT_TRUE(file.totals() == totals);

  std::vector<std::vector<Entry>> pixels(record.info.window.pixel_count());
  std::vector<int> seen(static_cast<std::size_t>(record.info.window.height()));
  file.visit_rows([&](const PixelRow& row) {
    ++seen[static_cast<std::size_t>(row.y - record.info.window.y0)];
    for (std::size_t i = 0; i < row.pixel_count(); ++i)
      pixels[row.first_pixel + i].assign(row.pixel(i).begin(), row.pixel(i).end());
  });
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto expected =
        std::span(record.entries).subspan(record.offsets[i], record.offsets[i + 1] - record.offsets[i]);
    EXPECT_TRUE(std::ranges::equal(pixels[i], expected)) << i;
  }
  const std::vector<std::vector<bool>> sets{std::vector<bool>(record.words.size(), true)};
  EXPECT_EQ(images_of(file.totals(), rows_of(file), sets).front().pixels, beauty(record).pixels);
}

TEST(RecordFile, ThatIsDamagedIsFoundOutWhileItShowsItsRows) {
  const TemporaryFolder folder;
  write_record(record_of(MadeUpLight(32), info_for({0, 0, 20, 40}, 3)), folder / "r.exr");
  std::string bytes = bytes_of(folder / "r.exr");
  for (std::size_t i = 0; i < 64; ++i) bytes[bytes.size() / 2 + i] ^= 0x55;
  put_bytes(folder / "r.exr", bytes);
  const auto visit = [&] { RecordFile(folder / "r.exr").visit_rows([](const PixelRow&) {}); };
  EXPECT_THROW(visit(), ReadError);
}

TEST(RecordSpool, WritesWhatTheAssembledRecordWouldBe) {
  const TemporaryFolder folder;
  for (const Precision precision : {Precision::Half, Precision::Float}) {
    RenderInfo info = info_for({5, 3, 30, 60}, 3);
    info.precision = precision;
    const MadeUpLight light(29);
    TileRecorder recorder(info);
    std::vector<Tile> tiles;
    for (const Window& window : tiles_of(info.window, 16)) {
      tiles.push_back(light.tile(recorder, window, info.samples_per_pixel));
      if (tiles.size() % 3 == 0) tiles.back().ambient.assign(window.pixel_count(), RgbSum({1, 2, 3}));
    }
    tiles.erase(tiles.begin() + 4);  // of an interrupted render
    std::shuffle(tiles.begin(), tiles.end(), std::mt19937(29));

    RecordSpool spool(info, folder / "r.exr");
    Assembler assembler(info);
    for (const Tile& tile : tiles) {
      spool.submit(tile);
      assembler.submit(tile);
    }
    Sums expected{info, added(info.window, tiles)};
    expected.info.partial = true;
    const SumsStream sums = spool.stream();
    EXPECT_TRUE(collected(sums) == expected);
    write_sums(sums, folder / "spooled.exr");
    write_sums(expected, folder / "assembled.exr");
    EXPECT_TRUE(bytes_of(folder / "spooled.exr") == bytes_of(folder / "assembled.exr"));
    EXPECT_TRUE(read_sums(folder / "spooled.exr").tile == expected.tile);
    Record totals = totals_of(sums, precision);
    write_record(totals, sums, folder / "spooled.exr");
    write_record(assembler.finish(true), folder / "assembled.exr");
    EXPECT_TRUE(bytes_of(folder / "spooled.exr") == bytes_of(folder / "assembled.exr"));
    EXPECT_FALSE(totals.ambient.empty());
    totals.ambient.clear();
    EXPECT_TRUE(totals == read_record_totals(folder / "spooled.exr"));
  }
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("spooled.exr", "assembled.exr"));
}

/// Tiles of random windows, some with samples and some of splats, in a random order; with 0 as the least that is added
/// up, that happens again and again. Three seeds.
TEST(RecordSpool, AddsUpTilesThatOverlap) {
  const TemporaryFolder folder;
  RenderInfo info = info_for({2, 1, 42, 31}, 4);
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    std::vector<Tile> tiles;
    for (int t = 0; t < 60; ++t) {
      const int x = info.window.x0 + below(30), y = info.window.y0 + below(20);
      const MadeUpLight light(seed * 100 + static_cast<unsigned>(t % 7));
      TileRecorder recorder(info);
      tiles.push_back(light.tile(recorder, {x, y, x + 1 + below(10), y + 1 + below(10)}, 1));
      if (t % 5 == 0) tiles.back().samples.assign(tiles.back().window.pixel_count(), 0);
      if (t % 4 == 0) tiles.back().phantom.assign(tiles.back().window.pixel_count(), RgbSum({1, 2, 3}));
    }
    Sums expected{info, added(info.window, tiles)};
    expected.info.partial = true;
    for (const std::uint64_t least_added_up : {std::uint64_t{0}, RecordSpool::kLeastAddedUp}) {
      std::shuffle(tiles.begin(), tiles.end(), random);
      RecordSpool spool(info, folder / "r.exr", {}, least_added_up);
      for (const Tile& tile : tiles) spool.submit(tile);
      EXPECT_TRUE(collected(spool.stream()) == expected) << seed << ' ' << least_added_up;
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(RecordSpool, SaysWhereItCannotKeepAnything) {
  const TemporaryFolder folder;
  EXPECT_THROW(RecordSpool(info_for({0, 0, 8, 8}, 1), folder / "missing/r.exr"), WriteError);
}

TEST(RecordFile, IsTheSameBytesForTheSameRecord) {
  const TemporaryFolder folder;
  const Record record = record_of(MadeUpLight(23), info_for({0, 0, 40, 30}, 2));
  write_record(record, folder / "a.exr");
  write_record(record, folder / "b.exr");
  EXPECT_TRUE(bytes_of(folder / "a.exr") == bytes_of(folder / "b.exr"));
}

TEST(RecordFile, TellsItsWordsToAnyReader) {
  const TemporaryFolder folder;
  const Record record = record_of(MadeUpLight(24), info_for({0, 0, 8, 8}, 2));
  write_record(record, folder / "r.exr");
  const Imf::DeepScanLineInputFile file((folder / "r.exr").c_str());
  EXPECT_THAT(Imf::comments(file.header()), testing::HasSubstr("id is the number of the word in heckbert.words"));
  const Imf::IDManifest manifest(Imf::idManifest(file.header()));
  const auto& group = manifest[manifest.find("id")];
  const auto& repeated = file.header().typedAttribute<Imf::StringVectorAttribute>("heckbert.words").value();
  ASSERT_EQ(group.size(), record.words.size());
  ASSERT_EQ(repeated.size(), record.words.size());
  for (std::size_t w = 0; w < record.words.size(); ++w) {
    EXPECT_EQ(group.find(w).text(), std::vector<std::string>{taxonomy::fine(record.words[w])});
    EXPECT_EQ(repeated[w], taxonomy::fine(record.words[w]));
  }
}

TEST(RecordFile, FlattensToTheBeautyInAnyReader) {
  const TemporaryFolder folder;
  const Window window{5, 3, 30, 20};
  const Record record = record_of(MadeUpLight(25), info_for(window, 9));
  write_record(record, folder / "r.exr");

  Imf::DeepScanLineInputFile file((folder / "r.exr").c_str());
  Imf::CompositeDeepScanLine compositor;
  compositor.addSource(&file);
  std::vector<Rgb> flat(window.pixel_count());
  const Imath::Box2i box({window.x0, window.y0}, {window.x1 - 1, window.y1 - 1});
  Imf::FrameBuffer frame;
  frame.insert("R", Imf::Slice::Make(Imf::FLOAT, &flat[0].r, box, sizeof(Rgb)));
  frame.insert("G", Imf::Slice::Make(Imf::FLOAT, &flat[0].g, box, sizeof(Rgb)));
  frame.insert("B", Imf::Slice::Make(Imf::FLOAT, &flat[0].b, box, sizeof(Rgb)));
  compositor.setFrameBuffer(frame);
  compositor.readPixels(window.y0, window.y1 - 1);

  const Image expected = beauty(record);
  std::size_t lit = 0;
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      const Rgb sum = flat[static_cast<std::size_t>((y - window.y0) * window.width() + x - window.x0)];
      const Rgb whole = expected.at(x, y);
      // The compositor adds n floats one by one: n roundings of at most half a unit each.
      const float slack = static_cast<float>(record.pixel(x, y).size()) * std::numeric_limits<float>::epsilon();
      EXPECT_NEAR(sum.r, whole.r, slack * whole.r);
      EXPECT_NEAR(sum.g, whole.g, slack * whole.g);
      EXPECT_NEAR(sum.b, whole.b, slack * whole.b);
      lit += is_black(whole) ? 0 : 1;
    }
  }
  EXPECT_GT(lit, window.pixel_count() / 2);
}

TEST(LayerFile, GivesBackEveryLayerBitForBit) {
  const TemporaryFolder folder;
  const Record record = record_of(MadeUpLight(26), info_for({5, 3, 70, 60}, 3));
  std::vector<Layer> layers{{"", beauty(record), {{"expression", "L.*E"}}}};
  for (std::size_t w = 0; w < 4; ++w) {
    std::vector<bool> one(record.words.size());
    one[w] = true;
    layers.push_back({"word_" + std::to_string(w), image_of(record, one), {{"energy", "0.5"}, {"words", "1"}}});
  }
  layers[2].image.pixels[0] = {1e-42f, std::numeric_limits<float>::max(), -0.0f};
  write_layers(layers, record.info, folder / "l.exr");

  const std::vector<Layer> read = read_layers(folder / "l.exr");
  ASSERT_EQ(read.size(), layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ(read[i].name, layers[i].name);
    EXPECT_EQ(read[i].attributes, layers[i].attributes);
    EXPECT_EQ(read[i].image.window, layers[i].image.window);
    EXPECT_EQ(read[i].image.pixels, layers[i].image.pixels);
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"l.exr"});
}

TEST(LayerFile, IsAnOrdinaryPictureToAnyReader) {
  const TemporaryFolder folder;
  const RenderInfo info = info_for({1, 1, 3, 2}, 1);
  write_layers({{"", {info.window, {{1, 2, 3}, {4, 5, 6}}}, {}}, {"caustic", {info.window, {Rgb(7), Rgb(8)}}, {}}},
               info, folder / "l.exr");
  Imf::InputFile file((folder / "l.exr").c_str());
  std::vector<std::string> channels;
  for (auto i = file.header().channels().begin(); i != file.header().channels().end(); ++i)
    channels.push_back(i.name());
  EXPECT_EQ(channels, (std::vector<std::string>{"B", "G", "R", "caustic.B", "caustic.G", "caustic.R"}));
  std::array<float, 2> green{}, caustic{};
  Imf::FrameBuffer frame;
  frame.insert("G", Imf::Slice::Make(Imf::FLOAT, green.data(), file.header().dataWindow()));
  frame.insert("caustic.B", Imf::Slice::Make(Imf::FLOAT, caustic.data(), file.header().dataWindow()));
  file.setFrameBuffer(frame);
  file.readPixels(1, 1);
  EXPECT_EQ(green, (std::array<float, 2>{2, 5}));
  EXPECT_EQ(caustic, (std::array<float, 2>{7, 8}));
}

TEST(LayerName, IsLegalAndNotTaken) {
  struct Case {
    std::string text;
    std::vector<std::string> taken;
    std::string name;
  };
  const std::vector<Case> cases{
      {"caustic", {}, "caustic"},
      {"LS+DE", {}, "LS_DE"},
      {"LS*DE", {"LS_DE"}, "LS_DE_2"},
      {"a.b", {"a_b", "a_b_2"}, "a_b_3"},
      {"2nd bounce", {}, "_2nd_bounce"},
      {"", {}, "_"},
      {"g\xc3\xa9n\xc3\xa9ral", {}, "g__n__ral"},
      {"Caustic", {"caustic"}, "Caustic_2"},  // file systems of compositors do not tell them apart
      {"depth", {}, "depth_2"},               // Nuke has a layer of that name
      {std::string(80, 'D'), {}, std::string(60, 'D')},
      {std::string(80, 'D'), {std::string(60, 'D')}, std::string(58, 'D') + "_2"},
  };
  for (const Case& c : cases) EXPECT_EQ(layer_name(c.text, c.taken), c.name);
}

}  // namespace
}  // namespace heckbert::record
