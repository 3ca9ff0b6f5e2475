// Ctrl-C: what is there is written, marked partial.

#include <csignal>

#include <gtest/gtest.h>

#include <heckbert/record/file.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

TEST(Interrupt, LeavesAPartialRecordThatCanBeRead) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_and_signal({"render", "cornell", "-o", (folder / "a.exr").string(), "--record",
                                            (folder / "a.paths.exr").string(), "--size", "256x256", "--spp", "20000"},
                                           signal, "20000 samples per pixel");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.listing(), (std::vector<std::string>{"a.exr", "a.paths.exr", "a.png"}));
    const record::Record record = record::read_record(folder / "a.paths.exr");
    EXPECT_TRUE(record.info.partial);
    EXPECT_LT(record.tally.samples, 256u * 256u * 20000u);
    EXPECT_EQ(run({"classify", (folder / "a.paths.exr").string()}).exit_code, 0);
  }
}

}  // namespace
}  // namespace heckbert::cli::testing
