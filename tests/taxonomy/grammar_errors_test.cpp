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
  const Malformed cases[] = {
      {"kind: class", "kind: klass", {{1, 7, "expected 'algorithm' or 'class'", "did you mean 'class'?"}}},
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
      {"L S+ E", "L S+ E\nexpression-delta: L E", {{7, 1, "a class has one expression", ""}}},
      {"expression: L S+ E", "expression: # nothing\n", {{6, 1, "the key 'expression' has no value", ""}}},
      {"title: Lights in mirrors\norder: 5",
       "titles: x\norder: y",
       {{0, 0, "'title' is missing", ""}, {3, 1, "unknown key 'titles'", "'title'"}, {4, 8, "a whole number", ""}}},
  };
  for (const Malformed& m : cases) {
    const std::string text = replaced(std::string(kGood), m.from, m.to);
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
