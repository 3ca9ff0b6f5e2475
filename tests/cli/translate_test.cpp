// heckbert grammar translate, and --dialect of every command that takes expressions

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/record/file.h>

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

TEST(DialectFlag, SaysHowExpressionsAreRead) {
  EXPECT_EQ(run({"match", "CD|SL", "LDE", "LSE", "--dialect", "osl"}).out, "yes LDE\nyes LSE\n");
  EXPECT_EQ(run({"grammar", "equal", "CSL", "C<.S>L", "--dialect", "arnold"}).out, "yes\n");
  EXPECT_EQ(run({"match", "CSL", "LGE"}, {.environment = {{"HECKBERT_DIALECT", "arnold"}}}).out, "yes LGE\n");
  EXPECT_THAT(run({"grammar", "show", "CGO", "--dialect", "karma"}).out, HasSubstr("LSE"));
  EXPECT_EQ(run({"grammar", "subset", "whitted", "C.*[LOB]", "--dialect", "osl"}).out, "yes\n") << "names stay names";
}

TEST(DialectFlag, KeepsErrorsAndWarnings) {
  EXPECT_THAT(run({"match", "CD?L", "LDE", "--dialect", "osl"}).err, HasSubstr("did you mean 'CD{0,1}L'?"));
  const Outcome outcome = run({"match", "CD|SL", "LDE", "--dialect", "iray"});
  EXPECT_EQ(outcome.out, "no  LDE\n");
  EXPECT_THAT(outcome.err, HasSubstr("warning: CD|SL: no path matches this in Iray"));
  EXPECT_EQ(run({"match", "CDL", "LDE", "--dialect", "ols"}).exit_code, 2);
}

TEST(DialectFlag, ReadsTheLayersOfARender) {
  const TemporaryFolder folder;
  const std::string record = (folder / "a.paths.exr").string();
  const Outcome rendered = run({"render", "lecture", "--record", record, "--size", "16x16", "--spp", "4", "--lpe",
                                "diffuse=C<RD>[LOB]", "--dialect", "osl"});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  const std::string there = (folder / "there.exr").string(), here = (folder / "here.exr").string();
  ASSERT_EQ(run({"query", record, "C<RD>[LOB]", "-o", there, "--dialect", "osl"}).exit_code, 0);
  ASSERT_EQ(run({"query", record, "L Dr E", "-o", here}).exit_code, 0);
  EXPECT_EQ(record::read_layers(there).at(0).image.pixels, record::read_layers(here).at(0).image.pixels);
}

TEST(Translate, SuggestsADialect) {
  const Outcome outcome = run({"grammar", "translate", "LDE", "--to", "arnlod"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("arnold"));
}

}  // namespace
}  // namespace heckbert::cli::testing
