// docs/dialects.md: its tables are made from the table of dialects and by the writer. HECKBERT_UPDATE_DOCS=1 in the
// environment of this test writes them anew.

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/dialect.h>

namespace heckbert::taxonomy {
namespace {

constexpr const char* kFile = HECKBERT_SOURCE_DIR "/docs/dialects.md";

std::string code(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return "`" + escaped + "`";
}

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

struct Idea {
  const char* title;
  const char* expression;
};
constexpr Idea kIdeas[] = {
    {"everything", "L.*E"},
    {"the light itself", "LE"},
    {"direct diffuse", "LDE"},
    {"ray casting", "LD?E"},
    {"radiosity", "LD*E"},
    {"Whitted", "LD?S*E"},
    {"Whitted, every gloss a mirror", "LD?[GS]*E"},
    {"caustic", "LS+DE"},
    {"caustic, glossy casters too", "L[GS]+DE"},
    {"indirect diffuse", "L.+DE"},
    {"colour bleeding", "LDD+E"},
    {"through two glass walls", "L . StSt E"},
    {"seen through glass, glossy too", "L . [GtSt]+ E"},
    {"in a medium", "L V+ E"},
    {"sky light", "Le D* E"},
    {"exactly two bounces", "L .. E"},
    {"at most three diffuse bounces", "L D{0,3} E"},
};

std::string header(const char* first) {
  std::string line = std::string("| ") + first, rule = "|---";
  for (const DialectFacts& d : kDialects) {
    line += " | " + std::string(d.title);
    rule += "|---";
  }
  return line + " |\n" + rule + "|\n";
}

std::string facts_table() {
  std::string table = header("");
  for (const Row& row : kFacts) {
    table += std::string("| ") + row.title;
    for (const DialectFacts& d : kDialects) table += " | " + row.cell(d);
    table += " |\n";
  }
  return table;
}

std::string ideas_table() {
  std::string table = header("idea");
  for (const Idea& idea : kIdeas) {
    table += std::string("| ") + idea.title;
    for (const DialectFacts& d : kDialects) {
      const std::string text = translate(idea.expression, Dialect::Heckbert, d.dialect).writing.text;
      table += " | " + (text.empty() ? "–" : code(text));
    }
    table += " |\n";
  }
  return table;
}

// The text between "<!-- name -->" and "<!-- end -->" replaced.
std::string with_table(const std::string& page, const std::string& name, const std::string& table) {
  const std::string begin = "<!-- " + name + ", generated -->\n", end = "<!-- end -->";
  const std::size_t from = page.find(begin);
  const std::size_t to = from == std::string::npos ? from : page.find(end, from);
  if (to == std::string::npos) return "no place for the table '" + name + "'";
  return page.substr(0, from + begin.size()) + table + page.substr(to);
}

TEST(DialectsPage, ShowsTheTableOfDialects) {
  std::ifstream in(kFile);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::string expected = with_table(with_table(page, "facts", facts_table()), "ideas", ideas_table());
  if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) std::ofstream(kFile) << expected;
  EXPECT_EQ(page, expected) << "write it anew: HECKBERT_UPDATE_DOCS=1 taxonomy_unit_test";
}

}  // namespace
}  // namespace heckbert::taxonomy
