// Files that are not what they should be, and places where none can be written.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <functional>
#include <limits>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/file.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/word_literal.h>

#include "synthetic.h"
#include "temporary_folder.h"

namespace heckbert::record {
namespace {

namespace fs = std::filesystem;
using namespace taxonomy::literals;
using testing::AllOf;
using testing::HasSubstr;

Record good_record() {
  return record_of(MadeUpLight(31), info_for({2, 1, 14, 9}, 3));
}

template <class Error>
std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string read_message(const fs::path& path) {
  return message_of<ReadError>([&] { read_record(path); });
}

TEST(ReadRecord, NamesWhatAnUnreadableFileIsInstead) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "folder.exr");
  put_bytes(folder / "empty.exr", "");
  put_bytes(folder / "text.exr", "{ \"this\": \"is a scene\" }\n");
  const RenderInfo info = info_for({0, 0, 2, 2}, 1);
  write_layers({{"", {info.window, std::vector<Rgb>(4)}, {}}}, info, folder / "flat.exr");
  const std::vector<std::pair<const char*, const char*>> cases{
      {"missing.exr", "No such file or directory"},
      {"folder.exr", "Is a directory"},
      {"empty.exr", "not an OpenEXR file"},
      {"text.exr", "not an OpenEXR file"},
      {"flat.exr", "this is a flat EXR; expected a record"},
  };
  for (const auto& [name, reason] : cases)
    EXPECT_THAT(read_message(folder / name),
                AllOf(HasSubstr("cannot read '" + (folder / name).string() + "': "), HasSubstr(reason)));
}

TEST(ReadRecord, RefusesATornFile) {
  const TemporaryFolder folder;
  write_record(good_record(), folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  ASSERT_GT(whole.size(), 10'000u);
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 8) {
    SCOPED_TRACE(size);
    put_bytes(folder / "torn.exr", whole.substr(0, size));
    EXPECT_THAT(read_message(folder / "torn.exr"), HasSubstr("cannot read"));
  }
  put_bytes(folder / "torn.exr", whole.substr(0, whole.size() - 1));
  EXPECT_THAT(read_message(folder / "torn.exr"), HasSubstr("cannot read"));
}

// OpenEXR would allocate what an attribute promises; in both headers of a file of two parts.
TEST(ReadRecord, RefusesAnAttributeThatReachesBeyondTheFile) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  Record record = good_record();
  record.ambient.assign(record.info.window.pixel_count(), Rgb(1));
  write_record(record, folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  const std::string type = "type\0string\0"s;
  for (const std::size_t at : {whole.find(type), whole.rfind(type)}) {
    std::string damaged = whole;
    damaged.replace(at + type.size(), 4, "\xF0\xFF\xFF\x7F");
    put_bytes(folder / "damaged.exr", damaged);
    EXPECT_THAT(read_message(folder / "damaged.exr"), HasSubstr("its header ends inside the attribute 'type'"));
  }
  EXPECT_NE(whole.find(type), whole.rfind(type));
}

// OpenEXR reads four bytes of an int whatever its size, and what then follows is taken for the next attribute; and it
// would allocate what a text within a list of texts promises.
TEST(ReadRecord, RefusesSizesThatDoNotFitTheTypeOfAnAttribute) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  write_record(good_record(), folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  struct Case {
    std::string attribute;
    std::size_t behind;  // where the bytes go
    std::string bytes;
  };
  for (const auto& [attribute, behind, bytes] :
       {Case{"heckbert.max_depth\0int\0"s, 0, "\x08\0\0\0"s},
        Case{"heckbert.words\0stringvector\0"s, 4, "\xF0\xFF\xFF\x7F"s}, Case{"channels\0chlist\0"s, 4, "\0"s}}) {
    const std::size_t at = whole.find(attribute);
    ASSERT_NE(at, std::string::npos) << attribute;
    std::string damaged = whole;
    damaged.replace(at + attribute.size() + behind, bytes.size(), bytes);
    put_bytes(folder / "damaged.exr", damaged);
    const std::string name(attribute.c_str());
    EXPECT_THAT(read_message(folder / "damaged.exr"), HasSubstr("sizes do not fit in the attribute '" + name + "'"));
  }
}

// OpenEXR allocates for every line and column before it looks whether the file has any.
TEST(ReadRecord, RefusesMorePixelsThanTheFileHasRoomFor) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  write_record(good_record(), folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  const std::string attribute = "dataWindow\0box2i\0"s;
  const std::size_t corners = whole.find(attribute) + attribute.size() + 4;
  for (const std::size_t last : {corners + 8, corners + 12})
    for (const std::string& bytes : {"\x01\0\x20\x26"s, "\xFE\xFF\xFF\xFF"s}) {
      std::string damaged = whole;
      damaged.replace(last, 4, bytes);
      put_bytes(folder / "damaged.exr", damaged);
      EXPECT_THAT(read_message(folder / "damaged.exr"), HasSubstr("sizes do not fit in the attribute 'dataWindow'"));
    }
}

// What fuzzing starts from must not be refused for its layout alone.
TEST(ReadRecord, ReadsTheCorpusOfItsFuzzTarget) {
  for (const char* name : {"ambient", "exact", "float", "half", "labelled", "part"})
    EXPECT_GT(read_record(fs::path(HECKBERT_SOURCE_DIR) / "tests/fuzz/corpus/record" / name).words.size(), 0u) << name;
}

/// Whatever bytes are damaged, reading ends in an error or in a record. 600 files, two bytes replaced in each, seed 32.
TEST(ReadRecord, SurvivesDamagedBytes) {
  const TemporaryFolder folder;
  Record record = good_record();
  record.ambient.assign(record.info.window.pixel_count(), Rgb(1));
  write_record(record, folder / "whole.exr");
  const std::string whole = bytes_of(folder / "whole.exr");
  const std::size_t header_end = whole.find("deepscanline") + 2000;
  std::mt19937 random(32);
  int refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::string damaged = whole;
    for (int i = 0; i < 2; ++i)
      damaged[random() % (trial % 2 == 0 ? header_end : whole.size())] = static_cast<char>(random());
    put_bytes(folder / "damaged.exr", damaged);
    try {
      read_record(folder / "damaged.exr");
    } catch (const ReadError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(ReadRecord, ChecksWhatTheFileClaims) {
  const TemporaryFolder folder;
  const auto swap_words = [](Record& r) { std::swap(r.words[0], r.words[1]); };
  const std::vector<std::pair<std::function<void(Record&)>, const char*>> cases{
      {[](Record& r) { r.entries[5].word = 4'000'000; }, "a pixel has an id that the id manifest lacks"},
      {[](Record& r) { r.words.pop_back(), r.counts.pop_back(), r.batch_means.resize(r.words.size() * kBatches); },
       "a pixel has an id that the id manifest lacks"},
      {[](Record& r) { std::swap(r.entries[0].word, r.entries[1].word); }, "ids are not ascending"},
      {[](Record& r) { r.entries[1].word = r.entries[0].word; }, "ids are not ascending"},
      {[](Record& r) { r.entries[3].energy.g = -1; }, "negative or not finite"},
      {[](Record& r) { r.entries[3].energy.b = std::numeric_limits<float>::quiet_NaN(); }, "negative or not finite"},
      {[](Record& r) { r.entries[3].count = 0; }, "a word without contributions"},
      {[](Record& r) {
         r.words.push_back({taxonomy::Symbol::Le, std::vector(20, taxonomy::Symbol::V)}), r.counts.push_back(1),
             r.batch_means.resize(r.words.size() * kBatches);
       },
       "the id manifest has a word that no pixel has"},
      {swap_words, "the words of the id manifest are not sorted"},
      {[](Record& r) { r.words[1] = r.words[0]; }, "the words of the id manifest are not sorted"},
      {[](Record& r) { r.words[0].light = taxonomy::Symbol::Dr; }, "which is not a word"},
      {[](Record& r) { ++r.counts[2]; }, "the counts of the words are not those of their pixels"},
      {[](Record& r) { r.counts[2] = 0; }, "the part 'words' has a word without contributions"},
      {[](Record& r) { r.batch_means[1].r = std::numeric_limits<float>::infinity(); },
       "the part 'words' has an energy that is negative or not finite"},
      {[](Record& r) { r.info.samples_per_pixel = 0; }, "samples per pixel is not positive"},
      {[](Record& r) { r.info.width = 5; }, "the data window reaches beyond the picture"},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [spoil, reason] = cases[i];
    SCOPED_TRACE(i);
    Record record = good_record();
    ASSERT_GT(record.offsets[1], 1u) << "the first pixel has words to confuse";
    spoil(record);
    write_record(record, folder / "r.exr");
    EXPECT_THAT(read_message(folder / "r.exr"), AllOf(HasSubstr("r.exr"), HasSubstr(reason)));
  }
}

/// Made anew, because Header::erase of OpenEXR 3.1 leaks the attribute.
Imf::Header without(const Imf::Header& header, const std::string& name) {
  Imf::Header rest(header.displayWindow(), header.dataWindow());
  for (auto i = header.begin(); i != header.end(); ++i)
    if (name != i.name()) rest.insert(i.name(), i.attribute());
  return rest;
}

/// Copies a good record's header to an empty deep image of its own, changed by `change`; writes `lines` of its lines.
void write_deep(const fs::path& from, const fs::path& to, const std::function<void(Imf::Header&)>& change, int lines) {
  Imf::Header header = Imf::DeepScanLineInputFile(from.c_str()).header();
  change(header);
  Imf::DeepScanLineOutputFile file(to.c_str(), header);
  const unsigned no_samples = 0;
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(
      Imf::Slice(Imf::UINT, const_cast<char*>(reinterpret_cast<const char*>(&no_samples)), 0, 0));
  char* nothing = nullptr;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
    frame.insert(i.name(), Imf::DeepSlice(i.channel().type, reinterpret_cast<char*>(&nothing), 0, 0, 0));
  file.setFrameBuffer(frame);
  file.writePixels(lines);
}

TEST(ReadRecord, ChecksTheHeader) {
  const TemporaryFolder folder;
  const Record empty = Assembler(info_for({0, 0, 6, 5}, 1)).finish(false);
  write_record(empty, folder / "good.exr");
  using Header = Imf::Header;
  const std::vector<std::pair<std::function<void(Header&)>, const char*>> cases{
      {[](Header& h) { h = without(h, "heckbert.record"); }, "a deep EXR of another kind; expected a record"},
      {[](Header& h) { h.insert("heckbert.record", Imf::IntAttribute(99)); }, "layout version 99; expected a record"},
      {[](Header& h) { h = without(h, "idManifest"); }, "the id manifest is missing"},
      {[](Header& h) { Imf::addIDManifest(h, Imf::IDManifest()); }, "does not tell about the channel 'id'"},
      {[](Header& h) {
         Imf::IDManifest manifest;
         manifest.add("id").setComponent("word");
         manifest[0].insert(3, "LaDrEp");
         Imf::addIDManifest(h, manifest);
       },
       "does not number the words 0, 1, 2"},
      {[](Header& h) {
         Imf::IDManifest manifest;
         manifest.add("id").setComponent("word");
         manifest[0].insert(0, "LDE");
         Imf::addIDManifest(h, manifest);
       },
       "'LDE' without subscripts"},
      {[](Header& h) { h.insert("heckbert.precision", Imf::StringAttribute("quarter")); },
       "'heckbert.precision' is 'quarter'"},
      {[](Header& h) { h = without(h, "heckbert.tally.roulette"); }, "'heckbert.tally.roulette' is missing"},
      {[](Header& h) { h.insert("heckbert.tally.hits", Imf::StringAttribute("12x")); }, "'12x', not a whole number"},
      {[](Header& h) { h.insert("heckbert.seed", Imf::StringAttribute("-1")); }, "'-1', not a whole number"},
      {[](Header& h) { h = without(h, "heckbert.scene"), h.insert("heckbert.scene", Imf::IntAttribute(1)); },
       "'heckbert.scene' is missing or of another type"},
      {[](Header& h) { h.channels().insert("count", Imf::Channel(Imf::FLOAT)); },
       "the channel 'count' is missing or of another type"},
      {[](Header& h) { h.compression() = Imf::RLE_COMPRESSION; }, "the part 'paths' is not packed as ZIPS"},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [change, reason] = cases[i];
    SCOPED_TRACE(i);
    write_deep(folder / "good.exr", folder / "changed.exr", change, 5);
    EXPECT_THAT(read_message(folder / "changed.exr"), HasSubstr(reason));
  }
  write_deep(
      folder / "good.exr", folder / "unchanged.exr", [](Header&) {}, 5);
  EXPECT_TRUE(read_record(folder / "unchanged.exr") == empty) << "the cases above fail for their own reasons";
  write_deep(
      folder / "good.exr", folder / "half.exr", [](Header&) {}, 2);
  EXPECT_THAT(read_message(folder / "half.exr"), HasSubstr("scan lines are missing"));
}

TEST(ReadLayers, NamesWhatAnUnreadableFileIsInstead) {
  const TemporaryFolder folder;
  write_record(good_record(), folder / "deep.exr");
  put_bytes(folder / "text.exr", "P6 2 2 255");
  {
    Imf::Header header(2, 1);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    const std::array<float, 2> pixels{};
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), header.dataWindow()));
    Imf::OutputFile file((folder / "grey.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  const std::vector<std::pair<const char*, const char*>> cases{
      {"missing.exr", "No such file or directory"},
      {"text.exr", "not an OpenEXR file"},
      {"deep.exr", "this is a deep EXR; expected a flat one"},
      {"grey.exr", "no layer with channels R, G and B"},
  };
  for (const auto& [name, reason] : cases)
    EXPECT_THAT(message_of<ReadError>([&, file = name] { read_layers(folder / file); }),
                AllOf(HasSubstr("cannot read '" + (folder / name).string() + "': "), HasSubstr(reason)));
}

/// Everything that writes, so that each case below is tried on all.
const std::vector<std::pair<const char*, std::function<void(const fs::path&)>>>& writers() {
  static const std::vector<std::pair<const char*, std::function<void(const fs::path&)>>> all{
      {"write_record", [](const fs::path& path) { write_record(good_record(), path); }},
      {"write_layers",
       [](const fs::path& path) {
         const Record record = record_of(MadeUpLight(33), info_for({0, 0, 40, 40}, 1));
         write_layers({{"", beauty(record), {}}}, record.info, path);
       }},
      {"write_file", [](const fs::path& path) { write_file(std::string(20'000, 'x'), path); }},
  };
  return all;
}

TEST(Writing, FailsWithTheReasonAndLeavesNothing) {
  for (const auto& [name, write] : writers()) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    fs::create_directory(folder / "folder");
    put_bytes(folder / "file", "old");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const std::vector<std::pair<const char*, const char*>> cases{
        {"missing/r.exr", "No such file or directory"},
        {"file/r.exr", "Not a directory"},
        {"folder", "Is a directory"},
        {"new/", "Is a directory"},
        {"pipe", "exists and is not a regular file"},
    };
    for (const auto& [target, reason] : cases)
      EXPECT_THAT(message_of<WriteError>([&, act = write, to = target] { act(folder / to); }),
                  AllOf(HasSubstr("cannot write '" + (folder / target).string() + "'"), HasSubstr(reason)));
    EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("folder", "file", "pipe"));
    EXPECT_TRUE(fs::is_empty(folder / "folder"));
    EXPECT_EQ(bytes_of(folder / "file"), "old");
  }
}

/// A disk that is full after some bytes, by way of the limit on the size of a file.
TEST(Writing, OnAFullDiskKeepsTheOldFile) {
  for (const auto& [name, write] : writers()) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    put_bytes(folder / "r.exr", "old");
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = message_of<WriteError>([&, act = write] { act(folder / "r.exr"); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_THAT(message, AllOf(HasSubstr("cannot write"), HasSubstr("File too large")));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"r.exr"});
    EXPECT_EQ(bytes_of(folder / "r.exr"), "old");
  }
}

TEST(Writing, ReplacesTheFileALinkPointsTo) {
  const TemporaryFolder folder;
  put_bytes(folder / "file", "old");
  fs::create_symlink(folder / "file", folder / "link");
  write_file("new", folder / "link");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(folder / "file"), "new");
}

TEST(AtomicFile, IsNotThereUntilCommitted) {
  const TemporaryFolder folder;
  {
    const AtomicFile file(folder / "r");
    put_bytes(file.temporary(), "half");
    EXPECT_FALSE(fs::exists(folder / "r"));
    EXPECT_EQ(folder.names().size(), 1u);
  }
  EXPECT_TRUE(folder.names().empty());
  AtomicFile file(folder / "r");
  put_bytes(file.temporary(), "whole");
  file.commit();
  EXPECT_EQ(bytes_of(folder / "r"), "whole");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"r"});
}

}  // namespace
}  // namespace heckbert::record
