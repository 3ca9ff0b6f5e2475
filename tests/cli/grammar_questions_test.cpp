// Questions about languages, as a user asks them: the answer, its exit code, and what goes to standard error.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/record/file.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using ::testing::HasSubstr;

struct Question {
  std::vector<std::string> arguments;  ///< after "grammar"
  int exit_code;
  std::string out;  ///< all of standard output
  std::string err{};
};

void expect(const std::vector<Question>& questions) {
  for (const Question& question : questions) {
    std::vector<std::string> command{"grammar"};
    command.insert(command.end(), question.arguments.begin(), question.arguments.end());
    const Outcome outcome = run(command);
    const std::string name = ::testing::PrintToString(question.arguments);
    EXPECT_EQ(outcome.exit_code, question.exit_code) << name << outcome.err;
    EXPECT_EQ(outcome.out, question.out) << name;
    EXPECT_EQ(outcome.err, question.err) << name;
  }
}

TEST(GrammarPartition, AnswersWithOverlapsAndTheGap) {
  expect({
      {{"disjoint", "LDE", "LSE"}, 0, "yes\n"},
      {{"disjoint", "LDE", "LSE", "L.E"}, 1, "no\nLDE is in both LDE and L.E\nLSE is in both LSE and L.E\n"},
      {{"disjoint", "LDE", "LGE", "--glossy", "diffuse"},
       0,
       "yes\n",
       "'LGE' can never match, because all its words have G, and --glossy diffuse reads that as another letter\n"},
      {{"partition", "emission", "@direct", "indirect"}, 0, "yes\n"},
      {{"partition", "LE", "LDE", "L.E"}, 1, "no\nLDE is in both LDE and L.E\nLDDE is in none\n"},
      {{"partition", "LE", "LDX*E", "L[^D].*E"}, 1, "no\nLDVE is in none\n"},
      {{"partition", "LE", "LDX*E", "L[^D].*E", "--letters", "D,G,S"}, 0, "yes\n"},
      {{"partition", "LDE", "LDDE", "--within", "radiosity", "--lights", "Lp", "--max-depth", "2"}, 0, "yes\n"},
      {{"partition", "LDE", "--within", "LDE & LSE"},
       0,
       "yes\n",
       "'LDE & LSE' can never match, because every path of 'LDE' has no event but D, and every path of 'LSE' has S\n"},
  });
}

TEST(GrammarWords, AreListedShortestFirst) {
  expect({
      {{"words", "LS+DE", "--plain", "--max-depth", "4"}, 0, "LSDE\nLSSDE\nLSSSDE\n"},
      {{"words", "LD*E", "--plain", "--count", "2"}, 0, "LE\nLDE\n", "there are more than 2\n"},
      {{"words", "LSDE", "--lights", "Lp", "--eye", "Ep", "--letters", "Dr,S"}, 0, "LpSrDrEp\nLpStDrEp\n"},
      {{"words", "LD{3}E", "--max-depth", "2"},
       0,
       "",
       "'LD{3}E' can never match, because the shortest of its words, LDDDE, has 3 scatterings, and the depth allows "
       "2\n"},
      {{"words", "LDE", "--letters", "Q"},
       2,
       "",
       "heckbert: error: --letters: 'Q' is none of D, Dr, Dt, G, Gr, Gt, S, Sr, St, V\n"},
  });
}

TEST(GrammarCount, HasATableAndAGeneratingFunction) {
  expect({
      {{"count", "L(S?D)*S*E", "--letters", "D,S", "--max-depth", "3"},
       0,
       "Scatterings  Words\n          0      1\n          1      2\n          2      4\n          3      7\n\n"
       "Generating function: 1 / (1 - 2 x + x^3)\n"},
      {{"count", "path-tracing", "--lights", "Lp", "--max-depth", "1"},
       0,
       "Scatterings  Words\n          0      0\n          1      4\n\nGenerating function: 4 x / (1 - 6 x)\n"},
      {{"count", "LDE", "--letters", "D,Dr"},
       2,
       "",
       "heckbert: error: --letters: two of 'D,Dr' stand for the same events\n"},
  });
}

TEST(GrammarIdentify, NamesTheGrammarOrItsNeighbours) {
  expect({
      {{"identify", "LNS*E"}, 0, "Whitted's recursive ray tracing, with lights that cannot be hit (whitted)\n"},
      {{"identify", "LD?S?E"},
       1,
       "no known grammar\n"
       "part of The lecture's recursive ray tracer, with lights that can be hit (lecture), which also has LSSE\n"
       "more than Visible emitters, with lights that can be hit (emitter-visibility), which lacks LDE\n"},
  });
}

TEST(GrammarExplain, WalksStateByState) {
  expect({
      {{"explain", "LD?S*E", "LSDE"},
       1,
       "State  Expected   Letter  Goes to\n"
       "0      L          La      1\n"
       "1      D, S or E  Sr      3\n"
       "3      S or E     Dr      nowhere\n\n"
       "LSDE: after LS expected S or E, not D\n"},
      {{"explain", "whitted", "LE"},
       0,
       "State  Expected      Letter  Goes to\n"
       "0      L             La      1\n"
       "1      D, G, S or E  Ep      5\n\n"
       "LE matches\n"},
  });
}

TEST(GrammarDot, IsADigraph) {
  const Outcome outcome = run({"grammar", "dot", "LDE"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("digraph {\n  label=\"LDE\";"));
  EXPECT_THAT(outcome.out, HasSubstr("[label=\"D\"];"));
}

TEST(GrammarMinimize, PrintsAnExpression) {
  expect({
      {{"minimize", "LDE | LSE | LGE"}, 0, "L X E\n"},
      {{"minimize", "whitted"}, 0, "L N S* E | [LaLe] S* E\n"},
      {{"minimize", "LGE", "--glossy", "specular"},
       0,
       "L E - L E\n",
       "'LGE' can never match, because all its words have G, and --glossy specular reads that as another letter\n"},
  });
}

TEST(GrammarStrategies, AreListedForEveryKindOfEnds) {
  expect({
      {{"strategies", "LSDSE"},
       0,
       "Strategies for LSDSE         Light  Eye  Count\n"
       "hit the light                La     Ep       1\n"
       "hit the light, hit the lens  La     El       2\n"
       "none                         Lp     Ep       0\n"
       "hit the lens                 Lp     El       1\n"
       "none                         Ld     Ep       0\n"
       "hit the lens                 Ld     El       1\n"
       "hit the light                Le     Ep       1\n"
       "hit the light, hit the lens  Le     El       2\n"},
      {{"strategies", "LE", "LDE", "LSSE", "LDSDE"},
       0,
       "Strategies for  La Ep  La El  Lp Ep  Lp El  Ld Ep  Ld El  Le Ep  Le El\n"
       "LE                  2      3      1      2      1      2      2      3\n"
       "LDE                 3      4      2      3      2      3      3      4\n"
       "LSSE                1      2      0      1      0      1      1      2\n"
       "LDSDE               3      4      2      3      2      3      3      4\n"},
  });
}

TEST(GrammarLattice, IsTextDotOrSvg) {
  expect({
      {{"lattice", "LD*E", "LD?E", "L(D|S)*E", "LE | LDE"},
       0,
       "All of           is in     which also has\n"
       "LD?E = LE | LDE  LD*E      LDDE\n"
       "LD*E             L(D|S)*E  LSE\n"
       "L(D|S)*E\n"},
      {{"lattice", "LDE", "L.E", "--dot"},
       0,
       "digraph {\n  rankdir=BT;\n  node [shape=box];\n  0 [label=\"LDE\"];\n  1 [label=\"L.E\"];\n"
       "  0 -> 1 [label=\"LGE\"];\n}\n"},
      {{"lattice", "--dot", "--svg"}, 2, "", "heckbert: error: one of --dot, --svg and --json, please\n"},
  });
  const Outcome svg = run({"grammar", "lattice", "--svg", "--lights", "La"});
  EXPECT_EQ(svg.exit_code, 0);
  EXPECT_THAT(svg.out, ::testing::StartsWith("<svg xmlns="));
  EXPECT_THAT(svg.out, ::testing::EndsWith("</svg>\n"));
  EXPECT_THAT(svg.out, HasSubstr(">LSE</text>"));
}

TEST(Match, SaysWhenNothingCanEverMatch) {
  const Outcome outcome = run({"match", "LDE & LSE", "LDE"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "no  LDE\n");
  EXPECT_EQ(
      outcome.err,
      "'LDE & LSE' can never match, because every path of 'LDE' has no event but D, and every path of 'LSE' has S\n");
}

TEST(GrammarPhases, AreShownForNamesFilesAndOtherDialects) {
  const Outcome named = run({"grammar", "phases", "whitted"});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_THAT(named.out, HasSubstr("L N? S* E, for lights that a ray can hit, La and Le\n\nTree\nsequence\n  L\n"));
  EXPECT_THAT(named.out, HasSubstr("L N S* E, for lights that no ray can hit, Lp and Ld\n"));
  EXPECT_EQ(run({"grammar", "phases", "@whitted"}).out, named.out);
  const TemporaryFolder folder;
  const std::string file = folder.write("x.grammar",
                                        "kind: class\nname: x\ntitle: x\norder: 1\nsource: ours\n"
                                        "expression: L D* E\n");
  EXPECT_THAT(run({"grammar", "phases", file}).out, HasSubstr("Letters of L D* E, and which may follow\n"));
  const Outcome osl = run({"grammar", "phases", "CD|SO", "--dialect", "osl"});
  EXPECT_EQ(osl.exit_code, 0) << osl.err;
  EXPECT_THAT(osl.out, HasSubstr("Minimal: 4 states\n0 -La-> 1\n1 -[DS]-> 3\n3 -E-> 4\n4 accepts\n"));
  EXPECT_EQ(run({"grammar", "phases", "metropolis"}).exit_code, 3);
}

TEST(GrammarErrors, AreExplainedByTheirCode) {
  const Outcome one = run({"grammar", "errors", "hb210"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(one.out,
            "HB210: repetition that the dialect lacks\n"
            "  Not every renderer has '?' and counts. grammar translate writes such an expression out.\n"
            "  For example, as osl: CD?L\n");
  const Outcome all = run({"grammar", "errors"});
  EXPECT_THAT(all.out, HasSubstr("HB101"));
  EXPECT_THAT(all.out, HasSubstr("HB603"));
  EXPECT_THAT(run({"match", "CD?L", "LDE", "--dialect", "osl"}).err, HasSubstr("error: OSL has no '?' [HB210]\n"));
  const Outcome none = run({"grammar", "errors", "HB10"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("there is no error 'HB10'; did you mean 'HB101'?"));
}

TEST(Query, SaysWhyNothingInTheRecordMatches) {
  const TemporaryFolder folder;
  const std::string record = (folder / "a.paths.exr").string(), picture = (folder / "a.exr").string();
  ASSERT_EQ(
      run({"render", "lecture", "--size", "16x16", "--spp", "4", "--max-depth", "3", "--record", record}).exit_code, 0);
  struct Case {
    const char* expression;
    const char* said;
  };
  for (const Case& c :
       {Case{"LVE",
             "'LVE' matches nothing in this record, because all its words that are left have V, and the "
             "only events are "},
        Case{"LeDE",
             "'LeDE' matches nothing in this record, because its words begin at Le, and the only "
             "lights are "},
        Case{"LD{5}E", "the shortest of its words that are left, LDDDDDE, has 5 scatterings, and the depth allows 3\n"},
        Case{"LDE & LSE", "'LDE & LSE' can never match, because every path of 'LDE' has no event but D"}}) {
    const Outcome outcome = run({"query", record, c.expression, "-o", picture});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(c.said));
  }
  const Outcome osl = run({"query", record, "CD[LOB]", "--dialect", "osl", "-o", picture});
  EXPECT_EQ(osl.err, "");
  const std::map<std::string, std::string> attributes = record::read_layers(picture).at(0).attributes;
  EXPECT_EQ(attributes.at("expression"), "CD[LOB]");
  EXPECT_EQ(attributes.at("dialect"), "osl");
  EXPECT_EQ(attributes.at("canonical"), "L D E");
  EXPECT_EQ(attributes.at("glossy"), "keep");
}

}  // namespace
}  // namespace heckbert::cli::testing
