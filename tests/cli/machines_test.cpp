// A render in pieces: parts on several machines, an interrupted one and its rest, processes of mpirun. In the end
// always the same bytes as of one render by one process.

#include <csignal>
#include <filesystem>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/record/file.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using ::testing::HasSubstr;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A small scene with glass, so that words abound.
Arguments render_with(int samples) {
  return {"render", "lecture", "--size", "40x40", "--spp", fmt::format("{}", samples)};
}
const Arguments kRender = render_with(12);

void expect_done(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// The bytes of one uninterrupted render with these settings.
std::string whole_bytes(const TemporaryFolder& folder, const Arguments& render) {
  expect_done(run(render + Arguments{"--record", (folder / "whole").string()}));
  return read_bytes(folder / "whole");
}

TEST(Parts, MergeToTheBytesOfTheWhole) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  for (const std::string sampler : {"sobol", "random"}) {
    const Arguments render = kRender + Arguments{"--sampler", sampler};
    const std::string whole = whole_bytes(folder, render);
    for (int i = 1; i <= 3; ++i)
      expect_done(run(render + Arguments{"--part", fmt::format("{}/3", i), "--threads", fmt::format("{}", i),
                                         "--record", path(fmt::format("p{}", i))}));
    expect_done(run({"merge", path("p3"), path("p1"), path("p2"), "-o", path("all")}));
    EXPECT_TRUE(read_bytes(folder / "all") == whole) << sampler;

    const Outcome some = run({"merge", path("p1"), path("p3"), "-o", path("some")});
    EXPECT_THAT(some.err, HasSubstr("still missing: samples 4 to 7 of 12, seed 1"));
    expect_done(run({"merge", path("p2"), path("some"), "-o", path("all")}));
    EXPECT_TRUE(read_bytes(folder / "all") == whole) << sampler << ", in another grouping";
    expect_done(run({"classify", path("some")}));
  }
}

TEST(Parts, OfOtherSeedsAreMoreSamples) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  expect_done(run(kRender + Arguments{"--seed", "1", "--exact", "--record", path("a")}));
  expect_done(run(kRender + Arguments{"--seed", "2", "--exact", "--record", path("b")}));
  expect_done(run(render_with(5) + Arguments{"--seed", "1", "--exact", "--record", path("c")}));
  expect_done(run({"merge", path("a"), path("b"), "-o", path("ab")}));
  expect_done(run({"merge", path("b"), path("a"), "-o", path("ba")}));
  EXPECT_TRUE(read_bytes(folder / "ab") == read_bytes(folder / "ba"));
  EXPECT_EQ(record::read_record(folder / "ab").info.samples_per_pixel, 24);
  EXPECT_THAT(run({"merge", path("a"), path("c"), "-o", path("ac")}).err,
              HasSubstr("with the same seed, some of them may be the same"));
}

/// Ends the program with `signal` while it renders, some milliseconds after a checkpoint, resumes it, and so on, with
/// another number of threads each time, until it is done.
void interrupt_and_resume(int signal, int exit_code) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const Arguments render{"render", "lecture", "--size", "96x64", "--spp", "32"};
  const std::string whole = whole_bytes(folder, render);
  const Arguments kept = render + Arguments{"--record", out, "--checkpoint", "0.001", "--verbose", "--no-preview"};
  int interruptions = 0;
  std::mt19937 random(7);
  const auto some_time = [&] { return std::chrono::milliseconds(random() % 30); };
  Outcome outcome = run_and_signal(kept + Arguments{"--threads", "1"}, signal, "checkpoint: ", some_time());
  for (; outcome.exit_code != 0 && interruptions < 3; ++interruptions) {
    EXPECT_EQ(outcome.signal != 0 ? 0 : outcome.exit_code, exit_code) << outcome.err;
    ASSERT_TRUE(record::read_record(out).info.partial);
    const Arguments resume{"--resume", out, "--threads", fmt::format("{}", interruptions + 2)};
    outcome =
        interruptions < 2 ? run_and_signal(kept + resume, signal, "checkpoint: ", some_time()) : run(kept + resume);
  }
  EXPECT_GT(interruptions, 0) << "the program was too fast for this test";
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(read_bytes(out) == whole);
}

TEST(Interruption, SigtermAndResumeGiveTheSameBytes) {
  interrupt_and_resume(SIGTERM, 130);
}

TEST(Interruption, Kill9LeavesTheLastCheckpoint) {
  interrupt_and_resume(SIGKILL, 0);
}

TEST(Interruption, ResumingWhatIsWholeChangesNothing) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  expect_done(run(kRender + Arguments{"--record", path("a"), "--exact"}));
  expect_done(run(kRender + Arguments{"--record", path("b"), "--exact", "--resume", path("a")}));
  EXPECT_TRUE(read_bytes(folder / "a") == read_bytes(folder / "b"));
}

/// Splats wait in files and in threads, and go where other samples were before. A picture is made of the sums, after
/// the end, where that of a render in one go is made of tiles.
TEST(Interruption, OfWalksFromTheLightGivesTheSameBytesToo) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  for (const std::string algorithm : {"bidirectional", "path"}) {
    const Arguments render{"render", "lecture",     "--size",  "64x48",       "--spp",
                           "64",     "--algorithm", algorithm, "--no-preview"};
    expect_done(run(render + Arguments{"--record", path("whole"), "-o", path("whole.exr"), "--threads", "1"}));
    const Arguments kept = render + Arguments{"--record", path("out"), "-o", path("out.exr")};
    const Outcome outcome = run_and_signal(kept + Arguments{"--threads", "2"}, SIGTERM, "64 samples per pixel",
                                           std::chrono::milliseconds(100));
    EXPECT_EQ(outcome.exit_code, 130) << "the program was too fast for this test\n" << outcome.err;
    ASSERT_TRUE(record::read_record(path("out")).info.partial);
    expect_done(run(kept + Arguments{"--threads", "3", "--resume", path("out"), "--checkpoint", "0.001"}));
    EXPECT_TRUE(read_bytes(folder / "out") == read_bytes(folder / "whole")) << algorithm;
    EXPECT_TRUE(read_bytes(folder / "out.exr") == read_bytes(folder / "whole.exr")) << algorithm;
  }
}

// ---- mpirun ---------------------------------------------------------------------------------------------------------

/// The tool as `ranks` processes of mpirun. With `wrapper`, each is started by this shell script as "$@".
Outcome run_ranks(int ranks, const Arguments& arguments, const std::string& wrapper = {}) {
  RunOptions options;
  // What OpenMPI leaks is its own; an address sanitizer would end every rank with it.
  options.launcher = {
      HECKBERT_MPIRUN,         "--allow-run-as-root", "--oversubscribe", "-x", "ASAN_OPTIONS=detect_leaks=0", "-n",
      fmt::format("{}", ranks)};
  if (!wrapper.empty()) options.launcher = options.launcher + Arguments{"/bin/sh", "-c", wrapper, "sh"};
  return run(arguments, options);
}

class Mpi : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::string(HECKBERT_MPIRUN).empty())
      GTEST_SKIP() << "built without MPI (libopenmpi-dev): mpirun is NOT tested";
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  TemporaryFolder folder;
};

TEST_F(Mpi, AnyNumberOfRanksGivesTheSameBytes) {
  const std::string whole = whole_bytes(folder, kRender);
  for (const int ranks : {1, 2, 3}) {
    const Outcome outcome =
        run_ranks(ranks, kRender + Arguments{"--record", path("out"), "-o", path("out.exr"), "--threads", "1"});
    expect_done(outcome);
    EXPECT_TRUE(read_bytes(folder / "out") == whole) << ranks << " ranks";
    EXPECT_EQ(folder.listing(), (Arguments{"out", "out.exr", "out.png", "whole"})) << "no part is left";
  }
}

TEST_F(Mpi, ARankThatDiesLosesItsPartAlone) {
  const Arguments render{"render", "lecture", "--size", "96x64", "--spp", "48", "--threads", "1"};
  const std::string whole = whole_bytes(folder, render);
  // Rank 1 is killed as soon as its first checkpoint is there.
  const std::string killer = fmt::format(
      "\"$@\" & pid=$!; if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then while [ ! -e {}.part-2-of-2 ]; do sleep 0.01; done; "
      "kill -9 $pid; fi; wait $pid",
      path("out"));
  const Arguments kept = render + Arguments{"--record", path("out"), "--checkpoint", "0.001"};
  EXPECT_NE(run_ranks(2, kept, killer).exit_code, 0);
  ASSERT_TRUE(fs::exists(folder / "out.part-1-of-2") && fs::exists(folder / "out.part-2-of-2"));
  EXPECT_FALSE(fs::exists(folder / "out"));
  const Outcome rest = run({"merge", path("out.part-1-of-2"), path("out.part-2-of-2"), "-o", path("rest")});
  expect_done(rest);
  EXPECT_TRUE(record::read_record(folder / "rest").info.partial) << rest.err;

  expect_done(run_ranks(2, kept + Arguments{"--resume", path("out")}));
  EXPECT_TRUE(read_bytes(folder / "out") == whole) << "the job that goes on from the parts";
}

TEST_F(Mpi, WhatRanksCannotShareIsRefused) {
  EXPECT_THAT(run_ranks(2, kRender + Arguments{"--record", path("out"), "--part", "1/2"}).err,
              HasSubstr("the processes of mpirun are the parts already"));
  EXPECT_THAT(run_ranks(2, {"render", "lecture", "--size", "8x8", "--spp", "1", "--record", path("out")}).err,
              HasSubstr("1 samples per pixel cannot be shared out into 2 parts"));
  const Outcome adaptive = run_ranks(2, kRender + Arguments{"--record", path("out"), "--adaptive"});
  EXPECT_THAT(adaptive.err, HasSubstr("--adaptive plans the samples of one render as a whole"));
  EXPECT_EQ(adaptive.exit_code, 2);
  EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace heckbert::cli::testing
