// render --memory: the same picture with a budget that its words do not fit into and without one.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <heckbert/record/file.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Memory : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(render({"--record", path("whole")}).exit_code, 0);
    // What is refused says how much the pixels take; the next MiB has room for some hundred words.
    const std::string refused = render({"--record", path("none"), "--memory", "1M"}).err;
    const std::size_t number = refused.find(" MiB before any word is kept");
    ASSERT_NE(number, std::string::npos) << refused;
    const std::string least = refused.substr(refused.rfind(' ', number - 1) + 1, number);
    folded_ = render({"--record", path("folded"), "--memory", std::to_string(std::stoi(least)) + "M", "--lpe",
                      "declared=L .{11} S E"});
    ASSERT_EQ(folded_.exit_code, 0) << folded_.err;
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return (*folder_ / name).string(); }
  static Outcome render(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "lecture", "--size", "48x48", "--spp", "32"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  static Json classes(const std::string& record, const std::vector<std::string>& expressions) {
    std::vector<std::string> arguments{"query", path(record), "--json"};
    arguments.insert(arguments.end(), expressions.begin(), expressions.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out)["classes"];
  }

  static TemporaryFolder* folder_;
  static Outcome folded_;
};

TemporaryFolder* Memory::folder_ = nullptr;
Outcome Memory::folded_;

double energy_of(const Json& item, const char* which) {
  return item["energy"][which].get<double>();
}

TEST_F(Memory, FoldsWordsAndSaysSo) {
  const record::Record whole = record::read_record_totals(path("whole"));
  const record::Record folded = record::read_record_totals(path("folded"));
  ASSERT_TRUE(folded.folding);
  EXPECT_LE(folded.folding->first, 342u);
  EXPECT_LT(folded.words.size(), whole.words.size());
  const std::string sentence = "words of more than " + std::to_string(folded.folding->longest) + " scatterings";
  EXPECT_THAT(folded_.err, HasSubstr(sentence));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"classify"}, {"coverage"}, {"query", "LDE"}}) {
    std::vector<std::string> arguments{command[0], path("folded")};
    arguments.insert(arguments.end(), command.begin() + 1, command.end());
    EXPECT_THAT(run(arguments).err, HasSubstr(sentence)) << command[0];
    arguments[1] = path("whole");
    EXPECT_THAT(run(arguments).err, Not(HasSubstr("scatterings were too many"))) << command[0];
  }
}

TEST_F(Memory, KeepsGrammarsAndDeclaredExpressionsExact) {
  const std::vector<std::string> asked{"@whitted",    "@radiosity",           "@caustic",
                                       "L .{11} S E", "!@whitted & @caustic", "LDSE"};
  const Json whole = classes("whole", asked), folded = classes("folded", asked);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_TRUE(folded[i]["exact"]) << asked[i];
    EXPECT_EQ(folded[i]["count"], whole[i]["count"]) << asked[i];
    EXPECT_NEAR(energy_of(folded[i], "mean"), energy_of(whole[i], "mean"), 1e-6 * energy_of(whole[i], "mean"))
        << asked[i];
    EXPECT_NEAR(energy_of(folded[i], "upper"), energy_of(whole[i], "upper"), 1e-4 * energy_of(whole[i], "upper"))
        << asked[i];
  }
}

TEST_F(Memory, AnswersOtherQuestionsBetweenBounds) {
  const std::vector<std::string> asked{"L .{9} E", "L D .{8,} E", "L (DS)+ DE", "L .* SSDSS .* E"};
  const Json whole = classes("whole", asked), folded = classes("folded", asked);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_TRUE(whole[i]["exact"]);
    EXPECT_FALSE(folded[i]["exact"]) << asked[i];
    EXPECT_LE(energy_of(folded[i], "mean"), 1.000001 * energy_of(whole[i], "mean")) << asked[i];
    EXPECT_GE(energy_of(folded[i], "upper"), energy_of(whole[i], "mean")) << asked[i];
  }
  const Outcome outcome = run({"query", path("folded"), "nine=L .{9} E", "-o", path("nine.exr")});
  EXPECT_THAT(outcome.out, HasSubstr("at least; the rest of the interval is folded words"));
  std::vector<std::string> names;
  for (const record::Layer& layer : record::read_layers(path("nine.exr"))) names.push_back(layer.name);
  EXPECT_THAT(names, ::testing::ElementsAre("nine", "nine_undecided"));
}

TEST_F(Memory, IsRefusedWhereItCannotBeKept) {
  struct Case {
    std::vector<std::string> more;
    const char* message;
  };
  for (const Case& refused : {Case{{"--exact"}, "mpirun keep sums for others to add to"},
                              {{"--part", "1/2"}, "mpirun keep sums for others to add to"},
                              {{"--checkpoint", "60"}, "mpirun keep sums for others to add to"},
                              {{"--algorithm", "light"}, "--memory: 'light' also walks from the light"}}) {
    std::vector<std::string> arguments{"--memory", "1G", "--record", path("none")};
    arguments.insert(arguments.end(), refused.more.begin(), refused.more.end());
    const Outcome outcome = render(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << refused.more[0];
    EXPECT_THAT(outcome.err, HasSubstr(refused.message)) << refused.more[0];
  }
  EXPECT_THAT(render({"--memory", "much", "--record", path("none")}).err, HasSubstr("'much' is no amount of memory"));
  EXPECT_FALSE(std::filesystem::exists(path("none")));
}

}  // namespace
}  // namespace heckbert::cli::testing
