// heckbert grammar translate

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using ::testing::HasSubstr;

TEST(Translate, WritesTheOtherDialectOnStandardOutputAlone) {
  const Outcome outcome = run({"grammar", "translate", "LD?S*E", "--to", "osl"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "CS*D{0,1}[LOB]\n");
  EXPECT_EQ(outcome.err, "");
}

TEST(Translate, TakesNamesOfGrammars) {
  const Outcome outcome = run({"grammar", "translate", "@caustic", "--to", "osl"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(run({"grammar", "translate", outcome.out.substr(0, outcome.out.size() - 1), "--from", "osl"}).exit_code, 0);
}

TEST(Translate, WarnsOfTextThatMeansSomethingElse) {
  const Outcome outcome = run({"grammar", "translate", "CD|SL", "--from", "osl", "--to", "vray"});
  EXPECT_EQ(outcome.out, "C(D|S)L\n");
  EXPECT_EQ(outcome.err, "warning: the same text means something else in V-Ray: LDE is in it under OSL only\n");
}

TEST(Translate, SaysWhatCannotBeSaidAndExitsWithNo) {
  const Outcome outcome = run({"grammar", "translate", "LSE", "--to", "karma"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out,
            "cannot be said in Karma: LaSrEp is in it and LaGrEp is not, and Karma cannot tell Gr from Sr\n");
}

TEST(Translate, RepairsABrokenExpression) {
  const Outcome outcome = run({"grammar", "translate", "C<RD+>L", "--from", "arnold"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'C<RD>+L'?"));
}

TEST(Translate, SuggestsADialect) {
  const Outcome outcome = run({"grammar", "translate", "LDE", "--to", "arnlod"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("arnold"));
}

}  // namespace
}  // namespace heckbert::cli::testing
