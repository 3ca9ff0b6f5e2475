// docs/expressions.md: its tables of syntax are what the parser does, and the same ideas in every dialect are what the
// writer writes. HECKBERT_UPDATE_DOCS=1 in the environment of this test writes those anew.

#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/taxonomy/grammar.h>

#include "taxonomy/markdown.h"

namespace heckbert::taxonomy {
namespace {

using markdown::code;
using markdown::table;
using markdown::text_of_code;

const std::filesystem::path kPage = HECKBERT_SOURCE_DIR "/docs/expressions.md";

Language read(std::string_view text) {
  return compile(text, builtin_grammars().names());
}

TEST(ExpressionsPage, TablesOfSyntaxMatchTheParser) {
  std::size_t rows = 0;
  for (const char* first : {"letter", "operator", "label"})
    for (const auto& row :
         table(kPage, std::string("| ") + first + " | meaning | example | matches | does not match |")) {
      ASSERT_EQ(row.size(), 5u) << row[0];
      const Language language = read(text_of_code(row[2]));
      EXPECT_TRUE(language.contains(parse_word(text_of_code(row[3])))) << row[0];
      EXPECT_FALSE(language.contains(parse_word(text_of_code(row[4])))) << row[0];
      ++rows;
    }
  EXPECT_EQ(rows, 35u);
}

TEST(ExpressionsPage, TableOfPrecedenceMatchesTheParser) {
  for (const auto& row : table(kPage, "| written | reads as |")) {
    if (row[1].empty())
      EXPECT_THROW(read(text_of_code(row[0])), InputError) << row[0];
    else
      EXPECT_EQ(read(text_of_code(row[0])), read(text_of_code(row[1]))) << row[0];
  }
}

TEST(ExpressionsPage, WhatIsNotHereIsRefusedAndWhatStandsInsteadIsNot) {
  for (const auto& row : table(kPage, "| not here | such as | because | instead |")) {
    ASSERT_EQ(row.size(), 4u) << row[0];
    EXPECT_THROW(read(text_of_code(row[1])), InputError) << row[0];
    EXPECT_FALSE(read(text_of_code(row[3])).is_empty()) << row[0];
  }
}

// ---- the same idea in every dialect
// ----------------------------------------------------------------------------------

struct Idea {
  const char* title;
  const char* expression;
};
constexpr Idea kIdeas[] = {
    {"everything", "L.*E"},
    {"the light itself", "LE"},
    {"direct diffuse", "LDE"},
    {"indirect diffuse", "L.+DE"},
    {"colour bleeding", "LDD+E"},
    {"ray casting", "LD?E"},
    {"radiosity", "LD*E"},
    {"Whitted", "LD?S*E"},
    {"Whitted, every gloss a mirror", "LD?[GS]*E"},
    {"caustic", "LS+DE"},
    {"caustic, glossy casters too", "L[GS]+DE"},
    {"no specular bounce", "L[^S]*E"},
    {"no mirror, no gloss", "L[DV]*E"},
    {"exactly two bounces", "L..E"},
    {"at most three bounces", "L.{0,3}E"},
    {"at most three diffuse bounces", "LD{0,3}E"},
    {"seen through glass, glossy too", "L.*[GtSt]E"},
    {"through two glass walls", "L.StStE"},
    {"in a medium", "LV+E"},
    {"sky light", "LeD*E"},
    {"one light group", "L'key'.*E"},
    {"touches an object", "L.*'teapot'.*E"},
    {"all but the caustics", "!L[GS]+DE"},
};

// What each dialect makes of an idea, proven by reading it back.
Writing written(const Idea& idea, Dialect dialect) {
  const Translation t = translate(idea.expression, Dialect::Heckbert, dialect);
  EXPECT_NE(t.writing.text.empty(), t.writing.refusal.empty()) << idea.expression;
  EXPECT_TRUE(t.writing.text.empty() || read_expression(t.writing.text, dialect).language == read(idea.expression))
      << t.writing.text;
  return t.writing;
}

std::string ideas() {
  std::string text = "| idea", rule = "|---";
  for (const DialectFacts& d : kDialects) {
    text += " | " + std::string(d.title);
    rule += "|---";
  }
  text += " |\n" + rule + "|\n";
  for (const Idea& idea : kIdeas) {
    text += std::string("| ") + idea.title;
    for (const DialectFacts& d : kDialects) {
      const Writing writing = written(idea, d.dialect);
      text += " | " + (writing.text.empty() ? "–" : code(writing.text));
    }
    text += " |\n";
  }
  return text;
}

std::string refusals() {
  std::string text;
  for (const Idea& idea : kIdeas)
    for (const DialectFacts& d : kDialects)
      if (const Writing writing = written(idea, d.dialect); writing.text.empty())
        text += std::string("- ") + idea.title + ", in " + std::string(d.title) + ": " + writing.refusal + ".\n";
  return text;
}

TEST(ExpressionsPage, ShowsTheSameIdeasInEveryDialect) {
  std::string page = markdown::with_generated(markdown::file_text(kPage), "ideas", ideas());
  page = markdown::with_generated(page, "refusals", refusals());
  markdown::expect_page(kPage, page, "taxonomy_unit_test");
}

}  // namespace
}  // namespace heckbert::taxonomy
