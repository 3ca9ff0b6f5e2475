// Results on standard output, everything else on standard error; bars on terminals only.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Streams : public ::testing::Test {
 protected:
  std::vector<std::string> render(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"render", "lecture", "--size", "32x32",    "--spp",
                                       "4",      "-o",      out_,     "--record", record_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  TemporaryFolder folder_;
  std::string out_ = (folder_ / "a.exr").string();
  std::string record_ = (folder_ / "a.paths.exr").string();
};

TEST_F(Streams, RenderTellsOnStandardErrorOnly) {
  const Outcome outcome = run(render());
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  for (const char* part :
       {"8 understood, 0 guessed, 0 ignored", "32x32 pixels, 4 samples per pixel", "Mrays/s", "words found", "wrote "})
    EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_THAT(outcome.err, Not(HasSubstr("glass")));
  EXPECT_THAT(run(render({"--verbose"})).err, HasSubstr("\"glass\""));
  EXPECT_EQ(run(render({"--quiet"})).err, "");
}

TEST_F(Streams, ProgressIsABarOnATerminalAndNothingInAPipe) {
  EXPECT_THAT(run(render()).err, Not(HasSubstr("\r")));
  EXPECT_THAT(run(render({"--progress", "always"})).err, HasSubstr("100 %  4.0/4 spp"));
  const std::string terminal = run_on_terminal(render());
  EXPECT_THAT(terminal, HasSubstr("\r[##############################] 100 %  4.0/4 spp"));
  EXPECT_THAT(run_on_terminal(render({"--progress", "never"})), Not(HasSubstr("[###")));
  EXPECT_THAT(run_on_terminal(render({"--quiet"})), Not(HasSubstr("[###")));
}

TEST_F(Streams, ColoursAppearOnATerminalOnly) {
  EXPECT_THAT(run({"match", "LDE", "LDE"}).out, Not(HasSubstr("\033")));
  EXPECT_THAT(run_on_terminal({"match", "LDE", "LDE"}), HasSubstr("\033[32myes"));
  EXPECT_THAT(run_on_terminal({"match", "LDE", "LDE", "--color", "never"}), Not(HasSubstr("\033")));
}

TEST_F(Streams, JsonIsAllThatGoesToStandardOutput) {
  ASSERT_EQ(run(render()).exit_code, 0);
  const std::vector<std::vector<std::string>> commands{
      render({"--json", "--lpe", "LDE"}),
      {"coverage", record_, "--json"},
      {"query", record_, "LDE", "--json"},
      {"classify", record_, "--json"},
      {"report", record_, "-o", (folder_ / "a.html").string(), "--json"},
      {"match", "LDE", "LSE", "--json"},
      {"grammar", "list", "--json"},
      {"grammar", "show", "whitted", "LDE", "--json"},
      {"grammar", "equal", "LDE", "LSE", "--json"},
      {"grammar", "subset", "LDE", "LSE", "--json"},
      {"scene", "list", "--json"},
      {"scene", "check", "lecture", "--json"}};
  for (const auto& command : commands) {
    const Outcome outcome = run(command);
    const nlohmann::json document = nlohmann::json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(document.is_discarded()) << command[0] << outcome.out << outcome.err;
    EXPECT_THAT(document.value("schema", ""), ::testing::StartsWith("heckbert."));
  }
}

TEST_F(Streams, ASceneComesFromStandardInput) {
  const std::string scene = read_bytes(HECKBERT_SOURCE_DIR "/scenes/lecture.json");
  const Outcome piped = run({"scene", "check", "-"}, {.input = scene});
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_THAT(piped.out, HasSubstr("\"glass\""));
  const Outcome torn = run({"scene", "check", "-"}, {.input = scene.substr(0, scene.size() / 2)});
  EXPECT_EQ(torn.exit_code, 3);
  EXPECT_THAT(torn.err, HasSubstr("standard input:"));
}

TEST_F(Streams, ReportPrintsThePathOfThePage) {
  ASSERT_EQ(run(render()).exit_code, 0);
  const std::string page = (folder_ / "a.html").string();
  const Outcome outcome = run({"report", record_, "-o", page, "--sheet", (folder_ / "sheet.png").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, page + "\n");
  EXPECT_THAT(read_bytes(page), HasSubstr("</html>"));
  EXPECT_EQ(read_bytes(folder_ / "sheet.png").substr(0, 4), "\x89PNG");
}

TEST_F(Streams, CoverageTellsOfTheGrammarsAskedFor) {
  ASSERT_EQ(run(render()).exit_code, 0);
  const Outcome all = run({"coverage", record_});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  for (const char* title : {"Ray casting", "Radiosity", "Whitted", "Global illumination"})
    EXPECT_THAT(all.out, HasSubstr(title));
  const Outcome some = run({"coverage", record_, "--grammar", "whitted", "--grammar", "LS.*E", "--json"});
  const auto grammars = nlohmann::json::parse(some.out)["grammars"];
  ASSERT_EQ(grammars.size(), 2u);
  EXPECT_EQ(grammars[0]["name"], "whitted");
  EXPECT_EQ(grammars[1]["expression"], "LS.*E");
  EXPECT_GT(grammars[1]["share"]["mean"].get<double>(), 0.01);
}

TEST_F(Streams, TheTeachingSetIsShownUnlessAllAreAskedFor) {
  ASSERT_EQ(run(render()).exit_code, 0);
  const auto coverage = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"coverage", record_, "--json"});
    return nlohmann::json::parse(run(more).out);
  };
  const auto core = coverage({}), all = coverage({"--grammar", "all", "--grammar", "LS.*E"});
  ASSERT_EQ(core["grammars"].size(), 7u);
  EXPECT_EQ(core["grammars"][0]["name"], "ray-casting");
  EXPECT_EQ(core["grammars"][6]["name"], "global-illumination");
  EXPECT_TRUE(core["left_out"].empty());
  ASSERT_EQ(all["grammars"].size(), 31u + 1);
  EXPECT_EQ(all["left_out"].size(), 7u);
  EXPECT_EQ(all["grammars"][31]["expression"], "LS.*E");
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(all["grammars"][i], core["grammars"][i]);

  const Outcome text = run({"coverage", record_, "--grammar", "all"});
  EXPECT_THAT(text.out, HasSubstr("'ambient-occlusion' is a proxy and has no language"));
  EXPECT_EQ(nlohmann::json::parse(run({"classify", record_, "--by", "algorithm", "--json"}).out)["groups"].size(), 7u);

  const std::string page = (folder_ / "a.html").string();
  ASSERT_EQ(run({"report", record_, "-o", page, "--grammar", "photon-mapping"}).exit_code, 0);
  EXPECT_THAT(read_bytes(page), HasSubstr("id=\"algorithm-photon-mapping\""));
  EXPECT_THAT(read_bytes(page), ::testing::Not(HasSubstr("id=\"algorithm-whitted\"")));
}

TEST_F(Streams, AFullDiskBehindStandardOutputIsAnError) {
  const Outcome outcome = run({"grammar", "list"}, {.full_output = true});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace heckbert::cli::testing
