#include <tuple>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {
namespace {

constexpr std::string_view kGood =
    "kind: class\n"
    "name: mirrors\n"
    "title: Lights in mirrors\n"
    "order: 5\n"
    "source: ours\n"
    "expression: L S+ E\n";

struct Expected {
  std::size_t line, column;
  const char* message;
  const char* suggestion;
};

struct Malformed {
  const char* from;  ///< what is replaced in kGood
  const char* to;
  std::vector<Expected> errors;
};

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

void expect_errors(std::string_view good, const std::vector<Malformed>& cases) {
  for (const Malformed& m : cases) {
    const std::string text = replaced(std::string(good), m.from, m.to);
    try {
      parse_grammar(text, "f.grammar", builtin_grammars());
      ADD_FAILURE() << "accepted:\n" << text;
    } catch (const InputError& e) {
      ASSERT_EQ(e.diagnostics().size(), m.errors.size()) << text << e.what();
      for (std::size_t i = 0; i < m.errors.size(); ++i) {
        const Diagnostic& d = e.diagnostics()[i];
        EXPECT_EQ(std::tuple(d.line, d.column), std::tuple(m.errors[i].line, m.errors[i].column)) << e.what();
        EXPECT_NE(d.message.find(m.errors[i].message), std::string::npos) << e.what();
        EXPECT_NE(d.suggestion.find(m.errors[i].suggestion), std::string::npos) << e.what();
        EXPECT_EQ(d.source, "f.grammar");
      }
    }
  }
}

TEST(GrammarFile, GoodOneIsRead) {
  const Grammar g = parse_grammar(kGood, "mirrors.grammar", builtin_grammars());
  EXPECT_EQ(g.kind, GrammarKind::Class);
  EXPECT_EQ(g.name, "mirrors");
  EXPECT_EQ(g.title, "Lights in mirrors");
  EXPECT_EQ(g.order, 5);
  EXPECT_EQ(g.source, "ours");
  EXPECT_EQ(g.expression, "L S+ E");
  EXPECT_EQ(g.language, compile("LS+E"));
}

TEST(GrammarFile, EachExpressionAnswersForItsOwnLights) {
  const std::string text =
      replaced(replaced(std::string(kGood), "class", "algorithm"), "L S+ E", "L S E | LpVE\nexpression-delta: L D E");
  EXPECT_EQ(parse_grammar(text, "f.grammar", {}).language, compile("[LaLe]SE | [LpLd]DE"));
}

TEST(GrammarFile, ValuesGoOnInIndentedLinesAndCommentsAreSkipped) {
  const Grammar g = parse_grammar(
      "# what follows\r\nkind: algorithm\r\nname: a\r\ntitle: one\r\n  two\r\n\r\n  # between\r\n\tthree: "
      "four\r\norder: -3\r\n"
      "source: s # 11\r\nexpression: L (D # diffuse\r\n  |S) E\r\nexpression-delta: none\r\nbias: x\r\nbias: y\r\n",
      "a.grammar", {});
  EXPECT_EQ(g.title, "one two three: four");
  EXPECT_EQ(g.source, "s # 11");
  EXPECT_EQ(g.expression, "L (D |S) E");
  EXPECT_EQ(g.order, -3);
  EXPECT_EQ(g.language, compile("[LaLe][DS]E"));
  EXPECT_EQ(g.expression_delta, "none");
  EXPECT_EQ(g.biases, (std::vector<std::string>{"x", "y"}));
}

TEST(GrammarFile, ErrorsAreAllFoundAtTheirPlace) {
  expect_errors(
      kGood,
      {
          {"kind: class",
           "kind: klass",
           {{1, 7, "expected 'algorithm' or 'transformer' or 'proxy' or 'predicate' or 'class'",
             "did you mean 'class'?"}}},
          {"kind: class\n", "", {{0, 0, "the key 'kind' is missing", ""}}},
          {"kind: class", "kind: algorithm", {{0, 0, "'expression-delta' is missing", ""}}},
          {"title:",
           "titel:",
           {{0, 0, "the key 'title' is missing", ""}, {3, 1, "unknown key 'titel'", "did you mean 'title'?"}}},
          {"order: 5",
           "colour: 5",
           {{0, 0, "'order' is missing", ""}, {4, 1, "unknown key 'colour'", "keys are kind, name"}}},
          {"order: 5", "order: five", {{4, 8, "expected a whole number", ""}}},
          {"source: ours", "source:", {{5, 1, "the key 'source' has no value", ""}}},
          {"source: ours", "source: ours\nsource: theirs", {{6, 1, "a second 'source'", ""}}},
          {"source: ours", "source: ours\nmore of it", {{6, 1, "expected 'key: value'", "indented"}}},
          {"kind: class", "  kind: class", {{0, 0, "'kind' is missing", ""}, {1, 3, "continues nothing", ""}}},
          {"name: mirrors", "name: My Mirrors", {{2, 7, "small letters, digits and '-'", ""}}},
          {"name: mirrors", "name: none", {{2, 7, "is not 'none'", ""}}},
          {"name: mirrors", "name: whitted", {{2, 7, "the name 'whitted' is taken", ""}}},
          {"L S+ E", "L S+", {{6, 13, "no eye end E", "did you mean 'L S+ E'?"}}},
          {"L S+ E", "L (S\n   | s) E", {{7, 6, "'s' is no letter", "'S'"}}},
          {"L S+ E", "@mirror", {{6, 13, "no class or algorithm is called 'mirror'", ""}}},
          {"L S+ E", "@causti", {{6, 13, "no class or algorithm is called 'causti'", "did you mean '@caustic'?"}}},
          {"L S+ E",
           "L S+ E\nexpression-delta: L E",
           {{7, 1, "'expression-delta' does not belong to kind class", "one expression is enough"}}},
          {"expression: L S+ E", "expression: # nothing\n", {{6, 1, "the key 'expression' has no value", ""}}},
          {"title: Lights in mirrors\norder: 5",
           "titles: x\norder: y",
           {{0, 0, "'title' is missing", ""}, {3, 1, "unknown key 'titles'", "'title'"}, {4, 8, "a whole number", ""}}},
      });
}

constexpr std::string_view kAlgorithm =
    "kind: algorithm\n"
    "name: hits\n"
    "title: Chance hits\n"
    "order: 5\n"
    "source: ours\n"
    "expression: L X* E\n"
    "expression-delta: none\n"
    "number: 39\n"
    "core: no\n"
    "bias: b\n"
    "variance: v\n"
    "variance: w\n"
    "precondition: p\n";

constexpr std::string_view kTransformer =
    "kind: transformer\n"
    "name: mutations\n"
    "title: Mutations\n"
    "order: 5\n"
    "source: ours\n"
    "host: path-tracing\n";

TEST(GrammarFile, OfAnAlgorithmHasNumberCautionsAndItsPlaceInTheTeachingSet) {
  const Grammar g = parse_grammar(kAlgorithm, "f.grammar", {});
  EXPECT_EQ(g.number, 39);
  EXPECT_FALSE(g.is_core);
  EXPECT_EQ(g.biases, std::vector<std::string>{"b"});
  EXPECT_EQ(g.variances, (std::vector<std::string>{"v", "w"}));
  EXPECT_EQ(g.preconditions, std::vector<std::string>{"p"});
  EXPECT_TRUE(has_language(g));
  EXPECT_EQ(why_no_language(g), "");
  EXPECT_TRUE(parse_grammar(replaced(std::string(kAlgorithm), "core: no", "core: yes"), "f.grammar", {}).is_core);

  const Grammar bare = parse_grammar(kGood, "f.grammar", {});
  EXPECT_EQ(bare.number, std::nullopt);
  EXPECT_FALSE(bare.is_core);

  const Grammar delta = parse_grammar(
      replaced(replaced(std::string(kAlgorithm), "L X* E", "none"), "delta: none", "delta: L N E"), "f.grammar", {});
  EXPECT_EQ(delta.language, compile("[LpLd]NE"));
}

TEST(GrammarFile, FormsByEyeAreWrittenInTheExpression) {
  const std::string text = replaced(std::string(kAlgorithm), "delta: none", "delta: L X* El | L X* N Ep");
  EXPECT_EQ(parse_grammar(text, "f.grammar", {}).language, compile("[LaLe]X*E | [LpLd]X*El | [LpLd]X*NEp"));
}

TEST(GrammarFile, OfWhatHasNoLanguageIsReadAndNeverUsedAsOne) {
  GrammarLibrary library = builtin_grammars();
  library.grammars.push_back(parse_grammar(kTransformer, "f.grammar", library));
  const Grammar& g = library.grammars.back();
  EXPECT_EQ(g.kind, GrammarKind::Transformer);
  EXPECT_EQ(g.host, "path-tracing");
  EXPECT_FALSE(has_language(g));
  EXPECT_TRUE(g.language.is_empty());
  EXPECT_EQ(why_no_language(g),
            "'mutations' is a transformer and has no language: it changes how its host finds paths, and captures what "
            "its host captures; its host is '@path-tracing'");

  struct Case {
    const char* text;
    std::size_t column;
    const char* message;
  };
  const Case cases[] = {{"@mutations", 1, "'mutations' is a transformer and has no language"},
                        {"LDE | @ambient-occlusion", 7, "'ambient-occlusion' is a proxy and has no language"},
                        {"!@screen-space-reflections", 2, "is a predicate and has no language"},
                        {"@mutation", 1, "no class or algorithm is called 'mutation'"}};
  for (const Case& c : cases) {
    try {
      compile(c.text, library.names());
      ADD_FAILURE() << "accepted: " << c.text;
    } catch (const InputError& e) {
      ASSERT_EQ(e.diagnostics().size(), 1u) << e.what();
      EXPECT_EQ(e.diagnostics()[0].column, c.column) << e.what();
      EXPECT_NE(e.diagnostics()[0].message.find(c.message), std::string::npos) << e.what();
      EXPECT_EQ(e.diagnostics()[0].suggestion.find("@mutations"), std::string::npos) << e.what();
    }
  }
  const std::string uses = replaced(std::string(kGood), "L S+ E", "@path-guiding");
  EXPECT_THROW(parse_grammar(uses, "f.grammar", library), InputError);
}

TEST(GrammarFile, ErrorsOfAlgorithmsAreFoundAtTheirPlace) {
  expect_errors(
      kAlgorithm,
      {{"number: 39", "number: many", {{8, 9, "expected a whole number, from 1", ""}}},
       {"number: 39", "number: 0", {{8, 9, "expected a whole number, from 1", ""}}},
       {"number: 39", "number: 3x", {{8, 9, "expected a whole number", ""}}},
       {"number: 39", "number:", {{8, 1, "the key 'number' has no value", ""}}},
       {"number: 39", "number: 39\nnumber: 40", {{9, 1, "a second 'number'", ""}}},
       {"core: no", "core: maybe", {{9, 7, "expected 'yes' or 'no'", ""}}},
       {"core: no", "cor: no", {{9, 1, "unknown key 'cor'", "did you mean 'core'?"}}},
       {"variance: w", "variances: w", {{12, 1, "unknown key 'variances'", "did you mean 'variance'?"}}},
       {"variance: w", "variance:", {{12, 1, "the key 'variance' has no value", ""}}},
       {"precondition: p", "precondition:", {{13, 1, "the key 'precondition' has no value", ""}}},
       {"bias: b", "bias: # none", {{10, 1, "the key 'bias' has no value", ""}}},
       {"core: no", "host: path-tracing", {{9, 1, "'host' does not belong to kind algorithm", "only a transformer"}}},
       {"L X* E", "none", {{7, 19, "both expressions are 'none'", "a 'transformer' or a 'proxy'"}}},
       {"kind: algorithm",
        "kind: class",
        {{7, 1, "'expression-delta' does not belong to kind class", ""},
         {8, 1, "'number' does not belong to kind class", "rows of the table are algorithms"},
         {9, 1, "'core' does not belong to kind class", "algorithms only"}}},
       {"kind: algorithm",
        "kind: proxy",
        {{6, 1, "'expression' does not belong to kind proxy", "say in 'notes'"},
         {7, 1, "'expression-delta' does not belong to kind proxy", ""},
         {9, 1, "'core' does not belong to kind proxy", ""}}}});
}

TEST(GrammarFile, ErrorsOfTransformersAreFoundAtTheirPlace) {
  expect_errors(kTransformer,
                {{"host: path-tracing\n", "", {{0, 0, "the key 'host' is missing", ""}}},
                 {"host: path-tracing", "host:", {{6, 1, "the key 'host' has no value", ""}}},
                 {"host: path-tracing",
                  "host: path-tracin",
                  {{6, 7, "no algorithm is called 'path-tracin'", "did you mean 'path-tracing'?"}}},
                 {"host: path-tracing", "host: caustic", {{6, 7, "no algorithm is called 'caustic'", ""}}},
                 {"host: path-tracing", "host: metropolis", {{6, 7, "no algorithm is called 'metropolis'", ""}}}});
}

TEST(GrammarFile, TooLargeExpressionNamesTheFileAndTheLine) {
  try {
    parse_grammar(replaced(std::string(kGood), "L S+ E", "L S* D S{40} E | L(D|S)*D(D|S){30}E"), "f.grammar", {});
    ADD_FAILURE() << "accepted";
  } catch (const LimitError& e) {
    EXPECT_EQ(std::string(e.what()).find("f.grammar:6:31: error: '(D|S)*D(D|S){30}' is too large"), 0u) << e.what();
  }
}

TEST(GrammarFiles, AreReadInAnyOrderAndReportTheErrorsOfAll) {
  const std::string later = replaced(replaced(std::string(kGood), "mirrors", "later"), "order: 5", "order: 6");
  const std::string uses = replaced(later, "L S+ E", "@mirrors - LSE");
  const GrammarText good[] = {{"later.grammar", uses}, {"mirrors.grammar", kGood}};
  const GrammarLibrary library = read_grammars(good);
  ASSERT_EQ(library.grammars.size(), 2u);
  EXPECT_EQ(library.grammars[0].name, "mirrors");
  EXPECT_EQ(library.grammars[1].language, compile("LSS+E"));

  const std::string wrong = replaced(std::string(kGood), "L S+ E", "L S+");
  const std::string unordered = replaced(later, "order: 6", "order: x");
  const GrammarText bad[] = {{"b.grammar", unordered}, {"a.grammar", wrong}, {"c.grammar", kGood}};
  try {
    read_grammars(bad);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& e) {
    ASSERT_EQ(e.diagnostics().size(), 3u) << e.what();
    EXPECT_EQ(e.diagnostics()[0].source, "a.grammar");
    EXPECT_EQ(e.diagnostics()[1].source, "b.grammar");
    EXPECT_NE(e.diagnostics()[2].message.find("is taken"), std::string::npos);
  }
}

}  // namespace
}  // namespace heckbert::taxonomy
