// docs/dialects.md: its table is made from the table of dialects. HECKBERT_UPDATE_DOCS=1 in the environment of this
// test writes it anew.

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/dialect.h>

#include "taxonomy/markdown.h"

namespace heckbert::taxonomy {
namespace {

using markdown::code;

std::string yes_or_no(bool yes) {
  return yes ? "yes" : "no";
}

std::string scatterings(const DialectFacts& d) {
  std::string text;
  for (const KindLetter& kind : d.kinds)
    if (kind.letter != 0)
      text += (text.empty() ? "" : ", ") + code(std::string(1, kind.letter)) + " " +
              (kind.kinds.empty() ? "nothing" : std::string(kind.kinds));
  return text;
}

std::string lights(const DialectFacts& d) {
  std::string text;
  for (const LightLetter& light : d.lights) {
    if (light.text.empty()) continue;
    text += (text.empty() ? "" : ", ") + code(light.text);
    for (const char subscript : light.subscripts) text += std::string(" L") + subscript;
  }
  return text;
}

std::string counts(const DialectFacts& d) {
  std::string text;
  if (d.has_exact) text += " `{n}`";
  if (d.has_open) text += " `{n,}`";
  if (d.has_range) text += " `{n,m}`";
  return text.empty() ? "no" : text.substr(1);
}

std::string blanks(const DialectFacts& d) {
  return d.blanks == Blanks::Refused ? "refused" : d.blanks == Blanks::AtEnds ? "at both ends" : "ignored";
}

struct Row {
  const char* title;
  std::function<std::string(const DialectFacts&)> cell;
};

const std::vector<Row> kFacts{
    {"name for `--from` and `--to`", [](const DialectFacts& d) { return code(d.name); }},
    {"direction",
     [](const DialectFacts& d) { return d.orientation == Orientation::Either ? "either" : "from the camera"; }},
    {"eye", [](const DialectFacts& d) { return code(d.eyes); }},
    {"scatterings, in our letters", scatterings},
    {"lights, in our letters", lights},
    {"`CD\\|SL` is", [](const DialectFacts& d) { return code(d.bar_binds_tightest ? "C(D|S)L" : "(CD)|(SL)"); }},
    {"`.` and `[^..]` match the ends", [](const DialectFacts& d) { return yes_or_no(d.dot_matches_ends); }},
    {"`<RD>`", [](const DialectFacts& d) { return d.has_groups ? "yes" : "`Dr`"; }},
    {"`?`", [](const DialectFacts& d) { return yes_or_no(d.has_optional); }},
    {"counts", counts},
    {"`D+*`", [](const DialectFacts& d) { return d.stacks_repetitions ? "yes" : "`(D+)*`"; }},
    {"complement, `&`, `-` of whole expressions",
     [](const DialectFacts& d) {
       return !d.has_whole_operators ? "no" : d.dialect == Dialect::Heckbert ? "`!` `&` `-`" : "`^` `&` `-`";
     }},
    {"blanks", blanks},
    {"prefixes", [](const DialectFacts& d) { return d.prefixes.empty() ? "none" : code(d.prefixes); }},
};

std::string header() {
  std::string line = "| ", rule = "|---";
  for (const DialectFacts& d : kDialects) {
    line += " | " + std::string(d.title);
    rule += "|---";
  }
  return line + " |\n" + rule + "|\n";
}

std::string facts_table() {
  std::string table = header();
  for (const Row& row : kFacts) {
    table += std::string("| ") + row.title;
    for (const DialectFacts& d : kDialects) table += " | " + row.cell(d);
    table += " |\n";
  }
  return table;
}

TEST(DialectsPage, ShowsTheTableOfDialects) {
  const std::filesystem::path page = HECKBERT_SOURCE_DIR "/docs/dialects.md";
  markdown::expect_page(page, markdown::with_generated(markdown::file_text(page), "facts", facts_table()),
                        "taxonomy_unit_test");
}

}  // namespace
}  // namespace heckbert::taxonomy
