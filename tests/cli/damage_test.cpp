// Ways to damage a record, or to fail at writing one. Each gives its message and its exit code and loses nothing: every
// file is afterwards as it was, and none is new.

#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using ::testing::HasSubstr;

const Arguments kRender{"render", "cornell", "--size", "16x16", "--spp", "4", "--quiet"};
const Arguments kPart1{"--part", "1/2", "--record", "part1"};
constexpr std::uint64_t kSmallDisk = 6000;  ///< bytes, less than a record takes

struct Damage {
  std::string claim;
  std::function<void()> damage;  ///< in a folder with part1, part2 (of 2), whole (means alone) and old
  Arguments arguments;
  int exit_code;
  std::vector<std::string> messages;  ///< each is part of standard error
  RunOptions options{};
};

void put(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Keeps the first part of a file, which has `share` of its bytes.
std::function<void()> torn(const char* file, double share) {
  return [=] { fs::resize_file(file, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(file)))); };
}

/// Exchanges the first place where the file has `text`.
std::function<void()> exchanged(const char* file, const std::string& text, const std::string& other) {
  return [=] {
    std::string bytes = read_bytes(file);
    const std::size_t at = bytes.find(text);
    ASSERT_NE(at, std::string::npos) << text;
    put(file, bytes.replace(at, text.size(), other));
  };
}

/// Says that the file is of another version of the layout, below 256.
std::function<void()> of_layout(const char* file, int version) {
  return [=] {
    const std::string attribute("heckbert.record\0int\0\4\0\0\0", 24);
    std::string bytes = read_bytes(file);
    const std::size_t at = bytes.find(attribute);
    ASSERT_NE(at, std::string::npos);
    bytes[at + attribute.size()] = static_cast<char>(version);
    put(file, bytes);
  };
}

/// Flips all bits of one byte, at a share of the file.
std::function<void()> flipped(const char* file, double share) {
  return [=] {
    std::string bytes = read_bytes(file);
    char& byte = bytes[static_cast<std::size_t>(share * static_cast<double>(bytes.size()))];
    byte = static_cast<char>(~byte);
    put(file, bytes);
  };
}

std::string text_stream(const std::string& rows) {
  return "heckbert-paths 1 text\nsize 4 3\nsamples 8\npaths\n" + rows;
}

std::vector<Damage> damages() {
  const auto nothing = [] {};
  const Arguments merge{"merge", "part1", "part2", "-o", "old"};
  const Arguments import{"record", "import", "stream", "-o", "old"};
  const auto resume = [](const Arguments& changes) {
    Arguments all = kRender;
    all.insert(all.end(), {"--record", "old", "--resume", "part1"});
    all.insert(all.end(), changes.begin(), changes.end());
    return all;
  };
  const auto writes_old = [](const Arguments& settings) {
    Arguments all = kRender;
    all.insert(all.end(), settings.begin(), settings.end());
    return all;
  };
  return {
      // What is read is not what it was.
      {"torn in the middle", torn("part1", 0.5), merge, 3, {"cannot read 'part1': "}},
      {"torn in the header", torn("part1", 0.02), merge, 3, {"cannot read 'part1': "}},
      {"torn before the last byte", torn("part1", 0.9999), merge, 3, {"cannot read 'part1': "}},
      {"empty", torn("part1", 0), {"classify", "part1"}, 3, {"this is not an OpenEXR file"}},
      {"a byte flipped among the paths", flipped("part1", 0.3), merge, 3, {"cannot read 'part1': "}},
      {"a byte flipped among the sums", flipped("part1", 0.6), merge, 3, {"cannot read 'part1': "}},
      {"a byte flipped at the end", flipped("part1", 0.999), merge, 3, {"cannot read 'part1': "}},
      {"another manifest", exchanged("part1", "idManifest", "idManifesT"), merge, 3, {"the id manifest is missing"}},
      {"no record", exchanged("part1", "heckbert.record", "heckbert.recorD"), merge, 3, {"a deep EXR of another kind"}},
      {"a part of the file renamed", exchanged("part1", "sums", "sumS"), merge, 3, {"means and no sums"}},
      {"a record without sums", nothing, {"merge", "part1", "whole", "-o", "old"}, 3, {"'whole'", "means and no sums"}},
      {"a text", [] { put("part1", "P6 2 2 255"); }, {"query", "part1", "LE"}, 3, {"this is not an OpenEXR file"}},
      {"a folder", [] { fs::remove("part1"), fs::create_directory("part1"); }, merge, 3, {"Is a directory"}},
      {"nothing there", [] { fs::remove("part1"); }, merge, 3, {"No such file or directory"}},
      {"no right to read",
       [] { fs::permissions("part1", fs::perms::none); },
       merge,
       3,
       {"Permission denied"},
       {.as_nobody = true}},

      // Records that do not belong together.
      {"two versions",
       exchanged("part1", HECKBERT_VERSION, "9.9.9"),
       merge,
       3,
       {"cannot merge 'part1' and 'part2': the tool version differs: '9.9.9' and '" HECKBERT_VERSION "'"}},
      {"another layout", of_layout("part1", 99), merge, 3, {"layout version 99"}},
      {"the same part twice",
       nothing,
       {"merge", "part1", "part1", "-o", "old"},
       3,
       {"both have samples 0 to 1 of 4, seed 1"}},
      {"parts of two scenes",
       nothing,
       {"merge", "part1", "foreign", "-o", "old"},
       3,
       {"the scene differs: 'cornell, contents "}},
      {"resume with another scene",
       nothing,
       {"render", "lecture", "--size", "16x16", "--spp", "4", "--part", "1/2", "--record", "old", "--resume", "part1"},
       3,
       {"cannot resume 'part1' with these settings: the scene differs"}},
      {"resume with another depth",
       nothing,
       resume({"--part", "1/2", "--max-depth", "3"}),
       3,
       {"the depth differs: '32' and '3'"}},
      {"resume another part",
       nothing,
       resume({"--part", "2/2"}),
       3,
       {"the samples differ: 'samples 0 to 1 of 4, seed 1' and 'samples 2 to 3 of 4, seed 1'"}},
      {"resume with another seed", nothing, resume({"--part", "1/2", "--seed", "7"}), 3, {"the samples differ"}},
      {"resume what is torn", torn("part1", 0.7), resume({"--part", "1/2"}), 3, {"cannot read 'part1'"}},
      {"resume what has a byte flipped among the sums",
       flipped("part1", 0.6),
       resume({"--part", "1/2"}),
       3,
       {"cannot read 'part1'"}},

      // Streams.
      {"a torn stream of text",
       [] { put("stream", text_stream("0 0 LDE 1 1 1 1\n")); },
       import,
       3,
       {"stream:6:1: error: the stream is torn"}},
      {"a torn stream of bytes",
       [] { put("stream", "heckbert-paths 1 binary\nsize 4 3\nsamples 8\npaths\n123"); },
       import,
       3,
       {"cannot read 'stream': byte 49: the stream is torn"}},
      {"a wrong row",
       [] { put("stream", text_stream("0 0 LDE 1 1 1 1\n9 0 LDE 1 1 1 1\nend\n")); },
       import,
       3,
       {"stream:6:1: error: expected a column", "\n  ^\n"}},

      // What is written finds no place.
      {"a full disk under a render",
       nothing,
       writes_old({"--record", "old"}),
       5,
       {"cannot write 'old': "},
       {.largest_file = kSmallDisk}},
      {"a full disk under a merge", nothing, merge, 5, {"cannot write 'old': "}, {.largest_file = kSmallDisk}},
      {"a full disk under an import",
       [] { put("stream", text_stream("0 0 LDE 1 1 1 1\nend\n")); },
       import,
       5,
       {"cannot write 'old': "},
       {.largest_file = 500}},
      {"a full standard output",
       nothing,
       {"merge", "part1", "part2", "-o", "-"},
       5,
       {"standard output"},
       {.full_output = true}},
      {"no right to write",
       [] {
         fs::permissions(
             ".", fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
       },
       merge,
       5,
       {"old: cannot write into .: Permission denied"},
       {.as_nobody = true}},
      {"a folder in the place", nothing, {"merge", "part1", "part2", "-o", "folder"}, 5, {"folder: is a folder"}},
      {"no folder for it",
       nothing,
       {"merge", "part1", "part2", "-o", "missing/old"},
       5,
       {"there is no folder missing"}},
      {"a device in the place",
       nothing,
       {"merge", "part1", "part2", "-o", "/dev/null"},
       5,
       {"/dev/null: is there and is no file"}},
  };
}

/// Every file and what it holds; a folder holds nothing.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    all[fs::relative(entry.path(), folder)] = entry.is_regular_file() ? read_bytes(entry.path()) : "";
  return all;
}

class DamagedRecord : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    records = std::make_unique<TemporaryFolder>();
    const RunOptions there{.folder = records->path()};
    const auto make = [&](Arguments arguments, const Arguments& more) {
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Outcome outcome = run(arguments, there);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    make(kRender, kPart1);
    make(kRender, {"--part", "2/2", "--record", "part2"});
    make(kRender, {"--record", "whole"});
    make({"render", "lecture", "--size", "16x16", "--spp", "4", "--part", "2/2", "--record", "foreign"}, {});
    fs::create_directory(*records / "folder");
    records->write("old", "what was there before");
  }
  static void TearDownTestSuite() { records.reset(); }

  static std::unique_ptr<TemporaryFolder> records;
};
std::unique_ptr<TemporaryFolder> DamagedRecord::records;

/// Whether this machine lets a user without rights start the program at all.
bool nobody_can_run() {
  return run({"--version"}, {.as_nobody = true}).exit_code == 0;
}

TEST_F(DamagedRecord, GivesMessageAndExitCodeAndLosesNothing) {
  const bool has_nobody = nobody_can_run();
  const std::vector<Damage> all = damages();
  EXPECT_GE(all.size(), 20u);
  for (const Damage& damage : all) {
    SCOPED_TRACE(damage.claim);
    if (damage.options.as_nobody && !has_nobody) {
      std::cout << "NOT tested, because nobody cannot run the program: " << damage.claim << "\n";
      continue;
    }
    const TemporaryFolder folder;
    fs::copy(records->path(), folder.path(), fs::copy_options::recursive);
    fs::permissions(folder.path(), fs::perms::all);
    const fs::path here = fs::current_path();
    fs::current_path(folder.path());
    damage.damage();
    fs::current_path(here);
    const auto before = contents(folder.path());
    RunOptions options = damage.options;
    options.folder = folder.path();
    const Outcome outcome = run(damage.arguments, options);
    EXPECT_EQ(outcome.exit_code, damage.exit_code) << outcome.err;
    EXPECT_EQ(outcome.signal, 0);
    for (const std::string& message : damage.messages) EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_TRUE(contents(folder.path()) == before) << "a file was changed, lost or left behind";
    fs::permissions(folder.path(), fs::perms::all);
  }
}

/// The same with a disk that is really full, where this machine lets us mount one.
TEST_F(DamagedRecord, OnAFullDiskTheOldFileStays) {
  const TemporaryFolder folder;
  const fs::path disk = folder / "disk";
  fs::create_directory(disk);
  if (mount("heckbert", disk.c_str(), "tmpfs", 0, "size=8k") != 0)
    GTEST_SKIP() << "no tmpfs can be mounted here: a full disk is tested by RLIMIT_FSIZE alone";
  put(disk / "old", "what was there before");
  const Outcome outcome =
      run({"merge", (*records / "part1").string(), (*records / "part2").string(), "-o", (disk / "old").string()});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("cannot write"));
  EXPECT_EQ(contents(disk), (std::map<std::string, std::string>{{"old", "what was there before"}}));
  umount(disk.c_str());
}

/// A checkpoint that finds no place is told, and the render goes on. Here a record has many rows and little in them, so
/// that what is kept while tracing finds its place.
TEST_F(DamagedRecord, ACheckpointOnAFullDiskDoesNotEndTheRender) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"render", "cornell", "--size", "4x4096", "--max-depth", "0", "--spp", "4", "-o", "-",
                               "--record", "r", "--checkpoint", "0.0001"},
                              {.folder = folder.path(), .largest_file = 200'000});
  EXPECT_THAT(outcome.err, HasSubstr("warning: no checkpoint: cannot write 'r'"));
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace heckbert::cli::testing
