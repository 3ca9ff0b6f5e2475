// Help pages, answers as exit codes, and what happens to names that do not exist.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using ::testing::HasSubstr;

TEST(Help, EveryCommandHasExamplesAndJson) {
  for (std::vector<std::string> command : kCommands) {
    command.emplace_back("--help");
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << command.front();
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("\nUsage: heckbert " + command.front()));
    EXPECT_THAT(outcome.out, HasSubstr("\nExamples:\n  heckbert " + command.front()));
    EXPECT_THAT(outcome.out, HasSubstr("--json"));
  }
}

TEST(Help, OfTheToolNamesEveryCommandAndExitCode) {
  const std::string help = run({"--help"}).out;
  for (const auto& command : kCommands) EXPECT_THAT(help, HasSubstr("\n  " + command.front() + "  "));
  for (const char* code : {"0", "1", "2", "3", "4", "5", "130"})
    EXPECT_THAT(help, HasSubstr(std::string("\n  ") + code));
}

TEST(Version, IsPrinted) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  std::string version = read_bytes(HECKBERT_SOURCE_DIR "/VERSION");
  EXPECT_EQ(outcome.out, "heckbert " + version);
}

struct Answer {
  std::vector<std::string> arguments;
  int exit_code;
  std::string out;  ///< all of standard output
  std::string input{};
};

TEST(Answers, AreExitCodesAndWords) {
  const std::vector<Answer> answers{
      {{"match", "LD?S*E", "LDSE"}, 0, "yes LDSE\n"},
      {{"match", "LD?S*E", "LDSE", "LDDE"}, 1, "yes LDSE\nno  LDDE\n"},
      {{"match", "LD?S*E"}, 1, "yes LE\nno  LDDE\n", "LE LDDE\n"},
      {{"match", "LD?S*E", "-"}, 0, "yes LE\n", "LE"},
      {{"match", "ES*D?L", "ESDL"}, 0, "yes ESDL\n"},
      {{"match", "LD?S*E", "LDDE", "--explain"}, 1, "no  LDDE: after LD expected S or E, not D\n"},
      {{"match", "LDE", "LGE"}, 1, "no  LGE\n"},
      {{"match", "LDE", "LGE", "--glossy", "diffuse"}, 0, "yes LGE\n"},
      {{"match", "LDE", "LGE", "--glossy", "specular"}, 1, "no  LGE\n"},
      {{"match", "LSE", "LGE", "--glossy", "specular"}, 0, "yes LGE\n"},
      {{"match", "@whitted", "LDSE"}, 0, "yes LDSE\n"},
      {{"match", "whitted", "LDSE", "--color", "always"}, 0, "\033[32myes\033[0m LDSE\n"},
      {{"grammar", "equal", "L(D|S)*E", "L(D*S*)*E"}, 0, "yes\n"},
      {{"grammar", "equal", "LDE", "LSE"}, 1, "no\nLDE is in LDE but not in LSE\nLSE is in LSE but not in LDE\n"},
      {{"grammar", "equal", "LDE", "LSE", "--glossy", "keep", "--quiet"},
       1,
       "no\nLDE is in LDE but not in LSE\nLSE is in LSE but not in LDE\n"},
      {{"grammar", "subset", "ray-casting", "@whitted"}, 0, "yes\n"},
      {{"grammar", "subset", "@whitted", "ray-casting"}, 1, "no\nLSE is in @whitted but not in ray-casting\n"},
      {{"grammar", "subset", "LpDE", "LaDE"}, 1, "no\nLpDrEp is in LpDE but not in LaDE\n"},
  };
  for (const Answer& answer : answers) {
    const Outcome outcome = run(answer.arguments, {.input = answer.input});
    const std::string name = ::testing::PrintToString(answer.arguments);
    EXPECT_EQ(outcome.exit_code, answer.exit_code) << name << outcome.err;
    EXPECT_EQ(outcome.out, answer.out) << name;
    EXPECT_EQ(outcome.err, "") << name;
  }
}

TEST(Grammar, ReadsAFile) {
  const TemporaryFolder folder;
  const std::string mine = folder.write("mine.grammar",
                                        "kind: class\nname: mine\ntitle: Mine\norder: 1\nsource: this test\n"
                                        "expression: L (D|S)* E\n");
  EXPECT_EQ(run({"grammar", "equal", mine, "L(S|D)*E"}).out, "yes\n");
  const Outcome shown = run({"grammar", "show", mine});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("this test"));
  EXPECT_THAT(shown.out, HasSubstr("Captures    LE LDE LSE LDDE LDSE LSDE LSSE LDDDE  (area lights)"));
  EXPECT_THAT(shown.out, HasSubstr("Misses      LGE LDGE LGDE LGGE LGSE LSGE LDDGE LDGDE  (area lights)"));
}

TEST(Grammar, ShowsEveryBuiltInByItsName) {
  const std::string list = run({"grammar", "list"}).out;
  int shown = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HECKBERT_GRAMMAR_DIR)) {
    if (entry.path().extension() != ".grammar") continue;
    const std::string name = entry.path().stem();
    EXPECT_THAT(list, HasSubstr(name));
    EXPECT_THAT(run({"grammar", "show", name}).out, HasSubstr(" " + name + ")"));
    ++shown;
  }
  EXPECT_GE(shown, 38 + 8);
}

}  // namespace
}  // namespace heckbert::cli::testing
