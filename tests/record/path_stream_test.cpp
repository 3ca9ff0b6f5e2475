// Path streams: what is read from them, in both encodings, and what is said about those that are wrong.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <sstream>

#include <heckbert/record/path_stream.h>
#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/word_literal.h>

namespace heckbert::record {
namespace {

using namespace taxonomy::literals;
using testing::ElementsAre;
using testing::HasSubstr;

Record read(const std::string& bytes) {
  std::istringstream stream(bytes);
  return read_path_stream(stream, "s");
}

template <class Error>
std::string message_of(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string text_with(const std::string& header, const std::string& rows) {
  return "heckbert-paths 1 text\nsize 4 3\nsamples 8\n" + header + "paths\n" + rows + "end\n";
}

std::string bytes_of(std::uint32_t value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string told(const std::string& word) {
  return bytes_of(0xffffffffu) + bytes_of(static_cast<std::uint32_t>(word.size())) + word;
}

std::string row(std::uint32_t x, std::uint32_t y, std::uint32_t word, Rgb sum, std::uint32_t count) {
  const auto bits = [](float value) { return bytes_of(std::bit_cast<std::uint32_t>(value)); };
  return bytes_of(x) + bytes_of(y) + bytes_of(word) + bits(sum.r) + bits(sum.g) + bits(sum.b) + bytes_of(count);
}

const std::string kBinaryHeader = "heckbert-paths 1 binary\nsize 4 3\nsamples 8\npaths\n";
const std::string kEnd = bytes_of(0xfffffffeu);

TEST(PathStream, TellsWhatWasRendered) {
  const Record record = read(
      "heckbert-paths 1 text\n"
      "# whatever\n"
      "\n"
      "scene a room, evening\n"
      "algorithm bidirectional, by vertex\n"
      "size 40 30\n"
      "crop 4 5 8 9\n"
      "samples 8\n"
      "seed 18446744073709551615\n"
      "depth 7\n"
      "paths\n"
      "end\n");
  EXPECT_EQ(record.info.scene, "a room, evening");
  EXPECT_EQ(record.info.algorithm, "bidirectional, by vertex");
  EXPECT_EQ(record.info.width, 40);
  EXPECT_EQ(record.info.height, 30);
  EXPECT_EQ(record.info.window, (Window{4, 5, 8, 9}));
  EXPECT_EQ(record.info.samples_per_pixel, 8);
  EXPECT_EQ(record.info.seed, 18446744073709551615u);
  EXPECT_EQ(record.info.max_depth, 7);
  EXPECT_EQ(record.tally.samples, 8u * 16u);
  EXPECT_TRUE(record.words.empty());
}

TEST(PathStream, AddsUpRowsOfAPixelAndWord) {
  const Record record = read(text_with("",
                                       "2 1 LDSE 4 2 1 3\n"
                                       "0 0 LE 8 8 8 8\n"
                                       "2\t1  ESDL 4 6 7 2\n"
                                       "2 1 LDE 0.5 0.25 0 1\n"));
  EXPECT_THAT(record.words, ElementsAre("LE"_word, "LDE"_word, "LDSE"_word));
  EXPECT_THAT(record.pixel(0, 0), ElementsAre(Entry{0, Rgb(1), 8}));
  EXPECT_THAT(record.pixel(2, 1), ElementsAre(Entry{1, {0.0625f, 0.03125f, 0}, 1}, Entry{2, Rgb(1), 5}));
  EXPECT_EQ(record.entries.size(), 3u);
  EXPECT_EQ(record.info.algorithm, "imported");
  EXPECT_EQ(record.info.max_depth, 2) << "of the longest word";
}

TEST(PathStream, IsTheSameInAnyOrderAndInBothEncodings) {
  const Record text = read(text_with("", "3 2 LDE 1 2 3 4\n0 1 LdV'fog'El 5 6 7 8\n3 2 LE 1 1 1 1\n"));
  EXPECT_EQ(read(text_with("", "3 2 LE 1 1 1 1\n0 1 LdV'fog'El 5 6 7 8\n3 2 LDE 1 2 3 4\n")), text);
  EXPECT_EQ(read(kBinaryHeader + told("LDE") + row(3, 2, 0, {1, 2, 3}, 4) + told("LdV'fog'El") + told("LE") +
                 row(3, 2, 2, Rgb(1), 1) + row(0, 1, 1, {5, 6, 7}, 8) + kEnd),
            text);
}

TEST(PathStream, EndsOfWordsWithoutKindsAreTheHeaders) {
  const Record record = read(text_with("light Le\neye El\n",
                                       "0 0 LDE 1 1 1 1\n"
                                       "0 0 ESL 1 1 1 1\n"
                                       "0 0 L'a sky'E 1 1 1 1\n"
                                       "0 0 LaVE 1 1 1 1\n"
                                       "0 0 LGEp 1 1 1 1\n"));
  EXPECT_THAT(record.words,
              ElementsAre(taxonomy::parse_word("Le'a sky'El"), "LaVEl"_word, "LeDEl"_word, "LeGEp"_word, "LeSEl"_word));
}

TEST(PathStream, LettersWithinLabelsAreNoEnds) {
  const Record record = read(text_with("light Le\n", "0 0 La'wall''LE'Dr'a''E'E 1 1 1 1\n0 0 L'a''b'E 1 1 1 1\n"));
  EXPECT_THAT(record.words, ::testing::UnorderedElementsAre(taxonomy::parse_word("La'wall''LE'Dr'a''E'E"),
                                                            taxonomy::parse_word("Le'a''b'E")));
}

TEST(PathStream, HasNoIntervals) {
  const Record record = read(text_with("", "0 0 LDE 4 4 4 1\n1 0 LE 4 4 4 1\n"));
  EXPECT_FALSE(record.info.has_batches);
  const std::vector<bool> first{true, false}, all{true, true};
  EXPECT_FALSE(energy(record, first).known);
  EXPECT_NEAR(energy(record, all).mean, 8.0 / (8 * 12), 1e-7);
  EXPECT_FALSE(share(record, first, all).known);
  EXPECT_NEAR(share(record, first, all).mean, 0.5, 1e-6);
}

TEST(PathStream, CountsWhatIsNoLight) {
  const Record record = read(text_with("", "0 0 LDE nan 1 1 2\n0 0 LDE 1 inf 1 3\n0 0 LE -1 1 1 4\n0 0 LSE 1 1 1 1\n"));
  EXPECT_THAT(record.words, ElementsAre("LSE"_word));
  EXPECT_EQ(record.tally.rejected_not_finite, 5u);
  EXPECT_EQ(record.tally.rejected_negative, 4u);
}

/// One row per path, of few words: memory stays that of the words, and nothing is lost. 200 000 rows.
TEST(PathStream, AddsUpWhileItReads) {
  std::string rows;
  for (int i = 0; i < 200'000; ++i) rows += i % 2 == 0 ? "1 1 LE 1 1 1 1\n" : "1 1 LDE 2 2 2 1\n";
  const Record record = read(text_with("", rows));
  EXPECT_THAT(record.pixel(1, 1), ElementsAre(Entry{0, Rgb(12500), 100'000}, Entry{1, Rgb(25000), 100'000}));
}

TEST(PathStream, RefusesTextWithPlaceAndCaret) {
  struct Case {
    std::string stream;
    std::vector<std::string> messages;
  };
  const std::vector<Case> cases{
      {"", {"s:1:1: error: the stream is empty; expected 'heckbert-paths 1 text'"}},
      {"P6 2 2 255\n", {"s:1:1: error: this is no path stream; expected 'heckbert-paths 1 text' or"}},
      {"heckbert-paths 2 text\n", {"s:1:1: error: this is no path stream"}},
      {"heckbert-paths 1 text\nsize 4 3\nsampels 8\npaths\nend\n",
       {"s:3:1: error: a header has no 'sampels'", "  sampels 8\n  ^^^^^^^\n", "did you mean 'samples'?",
        "the header lacks 'samples N'"}},
      {"heckbert-paths 1 text\nsize 4 3\n", {"s:3:1: error: the stream ends within its header", "lacks 'samples N'"}},
      {"heckbert-paths 1 text\nsize 4\nsize 4 3\nsamples 0\npaths\nend\n",
       {"s:2:1: error: expected 'size WIDTH HEIGHT'", "s:3:1: error: 'size' is told twice",
        "s:4:9: error: expected a whole number from 1 to 1073741824"}},
      {text_with("light Ep\n", ""), {"s:4:7: error: expected one of La|Lp|Ld|Le"}},
      {text_with("crop 0 0 5 3\n", ""), {"the crop reaches beyond the picture of 4x3"}},
      {text_with("crop 2 0 2 3\n", ""), {"s:4:1: error: the crop is empty"}},
      {text_with("", "0 0 LDE 1 1 1\n"), {"s:5:1: error: expected 'X Y WORD R G B COUNT'"}},
      {text_with("", "0 0 LDE 1 1 1 1\n4 0 LDE 1 1 1 1\n"),
       {"s:6:1: error: expected a column of the rendered pixels, 0 to 3\n  4 0 LDE 1 1 1 1\n  ^\n"}},
      {text_with("", "0 0 LDXE 1 1 1 1\n0 -1 LDE 1 one 1 0\n"),
       {"s:5:7: error: ", "  0 0 LDXE 1 1 1 1\n        ^\n", "s:6:3: error: expected a row",
        "s:6:12: error: expected a number", "s:6:18: error: expected the number of paths, 1 to 2147483647"}},
      {text_with("", "0 0 D\xc3\xa9L 1 1 1 1\n"), {"s:5:6: error: "}},
      {"heckbert-paths 1 text\nsize 4 3\nsamples 8\npaths\n0 0 LDE 1 1 1 1\n",
       {"s:6:1: error: the stream is torn: it stops without the line 'end'"}},
  };
  for (const Case& c : cases)
    for (const std::string& message : c.messages) EXPECT_THAT(message_of<InputError>(c.stream), HasSubstr(message));
}

TEST(PathStream, StopsAfterTwentyErrors) {
  std::string rows;
  for (int i = 0; i < 1000; ++i) rows += "0 0 LXE 1 1 1 1\n";
  const std::string message = message_of<InputError>(text_with("", rows));
  EXPECT_THAT(message, HasSubstr("s:24:6: error: "));
  EXPECT_THAT(message, Not(HasSubstr("s:25:6: error: ")));
  EXPECT_THAT(message, HasSubstr("reading stopped here"));
}

TEST(PathStream, RefusesBinaryWithTheByte) {
  const std::size_t begin = kBinaryHeader.size();
  const auto at = [&](std::size_t offset) { return "cannot read 's': byte " + std::to_string(begin + offset) + ": "; };
  const std::string word = told("LDE");
  const std::size_t behind = word.size();
  const std::vector<std::pair<std::string, std::string>> cases{
      {word + row(4, 0, 0, Rgb(1), 1) + kEnd, at(behind) + "the column 4; expected 0 to 3"},
      {word + row(0, 3, 0, Rgb(1), 1) + kEnd, at(behind + 4) + "the row 3; expected 0 to 2"},
      {word + row(0, 0, 1, Rgb(1), 1) + kEnd, at(behind + 8) + "the word number 1; expected one of the 1 that"},
      {word + row(0, 0, 0, Rgb(1), 0) + kEnd, at(behind + 24) + "the number of paths 0; expected 1 to"},
      {told("LDXE") + kEnd, at(10) + "in the word 'LDXE': "},
      {bytes_of(0xffffffffu) + bytes_of(0x7fffffffu), at(4) + "a word of 2147483647 bytes; expected at most"},
      {word + row(0, 0, 0, Rgb(1), 1), at(behind + 28) + "the stream is torn"},
      {word + row(0, 0, 0, Rgb(1), 1).substr(0, 13), at(behind + 12) + "the stream is torn"},
      {"", at(0) + "the stream is torn"},
  };
  for (const auto& [body, message] : cases)
    EXPECT_THAT(message_of<ReadError>(kBinaryHeader + body), HasSubstr(message));
}

TEST(PathStream, ThePageHasEveryLineOfTheHeader) {
  std::ifstream file(HECKBERT_SOURCE_DIR "/docs/path-stream.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const PathStreamKey& key : kPathStreamKeys) {
    std::string value;
    for (const char c : key.value) value += c == '|' ? "\\|" : std::string(1, c);
    EXPECT_THAT(page, HasSubstr("| `" + std::string(key.name) + " " + value + "` | " +
                                (key.is_required ? "yes" : "no") + " | " + std::string(key.meaning) + " |\n"));
  }
  const std::size_t begin = page.find("heckbert-paths 1 text\n");
  EXPECT_EQ(read(page.substr(begin, page.find("```", begin) - begin)).entries.size(), 3u) << "its example is right";
}

}  // namespace
}  // namespace heckbert::record
