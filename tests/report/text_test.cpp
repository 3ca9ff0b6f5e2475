// Tables for the terminal: numbers, alignment, widths.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <heckbert/report/classify.h>
#include <heckbert/report/coverage_text.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/grammar_text.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/text_table.h>
#include <heckbert/report/words_text.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

TEST(Numbers, ArePrintedForPeople) {
  const std::vector<std::pair<double, std::string>> shares{{0, "0.00 %"},        {1, "100.00 %"},  {0.62134, "62.13 %"},
                                                           {4e-5, "< 0.01 %"},   {6e-5, "0.01 %"}, {-1e-9, "0.00 %"},
                                                           {0.99999, "100.00 %"}};
  for (const auto& [share, text] : shares) EXPECT_EQ(percent(share), text);
  const std::vector<std::pair<std::uint64_t, std::string>> counts{
      {0, "0"}, {999, "999"}, {1000, "1 000"}, {123456, "123 456"}, {1234567, "1 234 567"}};
  for (const auto& [count, text] : counts) EXPECT_EQ(grouped(count), text);
  EXPECT_EQ(percent_interval({.mean = 0.5, .lower = 0.25, .upper = 0.7512}), "25.00 to 75.12 %");
  EXPECT_EQ(bracketed_percent({.mean = 0.5, .lower = 0.25, .upper = 0.7512}), "[25.00, 75.12]");
  EXPECT_EQ(percent_interval({.known = false}), "unknown");
  EXPECT_EQ(bracketed_percent({.known = false}), "-");
  EXPECT_EQ(counted(1, "word"), "1 word");
  EXPECT_EQ(counted(1200, "word"), "1 200 words");
  EXPECT_EQ(number(0.123456), "0.1235");
  EXPECT_EQ(aligned_number(0.0123456, 0.5), "0.0123");
  EXPECT_EQ(aligned_number(12.3456, 1234), "12");
  EXPECT_EQ(aligned_number(0, 0), "0");
  EXPECT_EQ(level(0.95), "95 %");
  EXPECT_EQ(level(0.999), "99.9 %");
}

TEST(DisplayWidth, CountsWhatTheEyeSees) {
  const std::vector<std::pair<std::string, std::size_t>> texts{{"", 0}, {"LSDE", 4}, {"Küche", 5}, {"光路", 4}};
  for (const auto& [text, width] : texts) EXPECT_EQ(display_width(text), width) << text;
}

TEST(Cut, KeepsWithinTheWidth) {
  EXPECT_EQ(cut("Küche", 5), "Küche");
  EXPECT_EQ(cut("Küchenlampe", 6), "Küc...");
  EXPECT_EQ(cut("Küche", 2), "..");
}

TEST(Wrap, BreaksAtBlanks) {
  EXPECT_EQ(wrap("one two  three four", 9), "one two\nthree\nfour\n");
  EXPECT_EQ(wrap("one two", 6, 2), "  one\n  two\n");
  EXPECT_EQ(wrap("", 10), "");
}

TEST(TextTable, AlignsUtf8ByWhatTheEyeSees) {
  const std::string text = text_table({{"Name"}, {"Share", Align::Right}},
                                      {{.cells = {"Küche", "1"}}, {.cells = {"Bathroom", "10.5"}}}, {.width = 40});
  EXPECT_EQ(text,
            "Name      Share\n"
            "Küche         1\n"
            "Bathroom   10.5\n");
}

TEST(TextTable, CutsTheFirstColumnWhenItMust) {
  const std::string text =
      text_table({{"Name"}, {"Share", Align::Right}}, {{.cells = {"A very long name", "10.5"}}}, {.width = 18});
  EXPECT_EQ(text,
            "Name         Share\n"
            "A very l...   10.5\n");
}

TEST(TextTable, DrawsBarsWhereThereIsRoom) {
  const std::vector<TextRow> rows{{.cells = {"a"}, .notes = {}, .bar = 0.5},
                                  {.cells = {"b"}, .notes = {}, .bar = 1.0 / 16}};
  EXPECT_EQ(text_table({{"X"}}, rows, {.width = 11}), "X\na  ████\nb  ▌\n");
  EXPECT_EQ(text_table({{"X"}}, rows, {.width = 8}), "X\na\nb\n");
}

TEST(TextTable, ColoursOnlyWhenAsked) {
  const std::vector<TextRow> rows{{.cells = {"a"}, .notes = {"note"}}};
  EXPECT_EQ(text_table({{"X"}}, rows, {}), "X\na\n  note\n");
  EXPECT_EQ(text_table({{"X"}}, rows, {.colour = true}), "\x1b[1mX\x1b[0m\na\n\x1b[2m  note\x1b[0m\n");
}

TEST(CoverageText, FitsTheTerminal) {
  const Coverage data = coverage(test::lecture_like_record(8, 8), test::four_grammars());
  for (std::size_t width = 60; width <= 160; ++width)
    for (const std::string& line : lines(coverage_text(data, {.width = width})))
      EXPECT_LE(display_width(line), width) << line;
}

TEST(CoverageText, NamesEveryGrammarTheRuleAndTheRender) {
  const Coverage data = coverage(test::lecture_like_record(8, 8), test::four_grammars());
  const std::string text = coverage_text(data, {.width = 100});
  for (const GrammarCoverage& grammar : data.grammars) {
    EXPECT_THAT(text, HasSubstr(grammar.title));
    EXPECT_THAT(text, HasSubstr(grammar.expression));
    EXPECT_THAT(text, HasSubstr(bracketed_percent(grammar.share)));
  }
  EXPECT_THAT(text, HasSubstr("LDS*E")) << "the expression for lights that cannot be hit";
  EXPECT_THAT(text, HasSubstr("misses nothing"));
  for (const char* fact : {"sample", "path", "8 x 8", "16 samples per pixel", "seed 7", "heckbert 0.0.0", "keep"})
    EXPECT_THAT(text, HasSubstr(fact));
}

TEST(CoverageText, NamesLightThatNoPathCarriesWhereThereIsAny) {
  record::Record record = test::lecture_like_record(4, 4);
  EXPECT_THAT(coverage_text(coverage(record, {})), Not(HasSubstr("ambient")));
  record.ambient.assign(16, Rgb(0.25f));
  EXPECT_THAT(coverage_text(coverage(record, {})), HasSubstr("ambient term 0.25, phantom mirror 0"));
}

TEST(CoverageText, SaysWhatIsLeftOutAndWhy) {
  const record::Record record = test::lecture_like_record(4, 4);
  EXPECT_THAT(coverage_text(coverage(record, test::four_grammars())), Not(HasSubstr("Left out")));
  const Coverage data = coverage(record, {test::proxy()});
  EXPECT_TRUE(data.grammars.empty());
  EXPECT_THAT(coverage_text(data), HasSubstr("Left out:\n  'occlusion' is a proxy and has no language: it lights"));
}

TEST(CoverageText, WarnsOfAnInterruptedRender) {
  record::Record record = test::lecture_like_record(4, 4);
  EXPECT_THAT(coverage_text(coverage(record, {})), Not(HasSubstr("Warning")));
  record.info.partial = true;
  record.tally.samples = static_cast<std::uint64_t>(16 * record.info.samples_per_pixel / 4);
  EXPECT_THAT(coverage_text(coverage(record, {})),
              HasSubstr("Warning: The render was interrupted when 25.00 % of its samples were taken"));
}

TEST(Facts, SayWhichPartOfACroppedPictureWasRendered) {
  record::Record record = test::lecture_like_record(8, 6);
  EXPECT_THAT(summary(record.info), HasSubstr("8 x 6 pixels, 16"));
  record.info.window = {2, 1, 6, 5};
  EXPECT_THAT(summary(record.info), HasSubstr("8 x 6 pixels, of which x 2 to 5 and y 1 to 4 were rendered"));
}

TEST(WordsText, CutsAndSaysWhatIsLeft) {
  const Coverage data = coverage(test::lecture_like_record(8, 8), {});
  double rest = 0;
  for (std::size_t i = 2; i < data.words.size(); ++i) rest += data.words[i].share.mean;
  const auto cut_table = lines(words_text(data.words, {}, 2));
  ASSERT_EQ(cut_table.size(), 4u);
  EXPECT_EQ(cut_table[3], "and 10 more words with " + percent(rest) + " of the energy");
  EXPECT_EQ(lines(words_text(data.words)).size(), 1 + data.words.size());
  EXPECT_EQ(words_text({}), "No light was recorded.\n");
}

TEST(GroupsText, ShowsExpressionsOfClassesAndNoSumOfThem) {
  taxonomy::GrammarLibrary library;
  library.grammars = test::four_grammars();
  const record::Record record = test::lecture_like_record(4, 4);
  const std::string text = classification_text(classify(record, GroupBy::Algorithm, library), {}, 2);
  EXPECT_THAT(text, HasSubstr("ray-casting"));
  EXPECT_THAT(text, HasSubstr("  LD?E\n"));
  EXPECT_THAT(text, Not(HasSubstr("more group")));
  EXPECT_THAT(classification_text(classify(record, GroupBy::Length, library), {}, 2),
              HasSubstr("and 2 more groups with "));
}

TEST(GrammarText, ShowsAllThatTheFileSays) {
  taxonomy::Grammar grammar = test::four_grammars()[1];
  grammar.notes = "a note";
  grammar.expression_delta = "LD+E";
  const std::string text = grammar_text(grammar);
  for (const std::string& piece :
       {grammar.title, grammar.name, grammar.expression, grammar.expression_delta, grammar.source, grammar.biases[0],
        grammar.variances[0], grammar.preconditions[0], grammar.notes, std::string("LE")})
    EXPECT_THAT(text, HasSubstr(piece));
  EXPECT_THAT(text, Not(HasSubstr("Number")));
  grammar.number = 8;
  EXPECT_THAT(grammar_text(grammar), HasSubstr("Number      8\n"));
}

TEST(GrammarText, OfAProxySaysThatItHasNoLanguage) {
  const std::string text = grammar_text(test::proxy());
  EXPECT_THAT(text, HasSubstr("Occlusion (proxy occlusion)\n"));
  EXPECT_THAT(text, HasSubstr("is a proxy and has no language"));
  for (const char* label : {"Expression", "Automaton", "Shortest"}) EXPECT_THAT(text, Not(HasSubstr(label)));
}

TEST(GrammarListText, HasSectionsAndALineForEveryGrammar) {
  taxonomy::GrammarLibrary library;
  library.grammars = test::four_grammars();
  library.grammars[0].kind = taxonomy::GrammarKind::Class;
  library.grammars[1].is_core = true;
  library.grammars[2].number = 6;
  library.grammars[3].expression = "none";
  library.grammars.push_back(test::proxy());
  EXPECT_EQ(grammar_list_text(library),
            "Algorithm            No.  Captures\n"
            "radiosity                 LD*E\n"
            "\n"
            "Further algorithm    No.  Captures\n"
            "lecture                6  LD?S*E\n"
            "global-illumination       L(D|G|S|V)*E  (lights that cannot be hit)\n"
            "\n"
            "No language          No.  Is a\n"
            "occlusion                 proxy\n"
            "\n"
            "Class                No.  Contains\n"
            "ray-casting               LD?E\n");
  EXPECT_EQ(grammar_list_text({}), "No grammars.\n");
}

TEST(GrammarListText, OfAllThatIsShippedFitsTheTerminal) {
  for (std::size_t width = 60; width <= 120; width += 20)
    for (const std::string& line : lines(grammar_list_text(taxonomy::builtin_grammars(), {.width = width})))
      EXPECT_LE(display_width(line), width) << line;
}

}  // namespace
}  // namespace heckbert::report
