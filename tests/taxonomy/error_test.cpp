#include <gtest/gtest.h>

#include <heckbert/taxonomy/error.h>

namespace heckbert {
namespace {

TEST(Diagnostic, ShowsPlaceExcerptCaretsAndSuggestion) {
  const Diagnostic d = diagnose("a.txt", "first\n\tbad word here\nlast", 7, 3, "no such thing", "did you mean 'bed'?");
  EXPECT_EQ(d.line, 2u);
  EXPECT_EQ(d.column, 2u);
  EXPECT_EQ(d.length, 3u);
  EXPECT_EQ(format(d),
            "a.txt:2:2: error: no such thing\n"
            "  \tbad word here\n"
            "  \t^^^\n"
            "  did you mean 'bed'?\n");
}

TEST(Diagnostic, ColumnsCountCharactersNotBytes) {
  const std::string text = "L\xC3\xA9\xE2\x88\x97X";  // L, e acute, an asterisk operator, X
  const Diagnostic d = diagnose("x", text, 3, 3, "m");
  EXPECT_EQ(d.column, 3u);
  EXPECT_EQ(d.length, 1u);
  EXPECT_EQ(format(d), "x:1:3: error: m\n  " + text + "\n    ^\n");
}

TEST(Diagnostic, StaysInsideItsLineAndItsText) {
  EXPECT_EQ(diagnose("x", "ab\r\ncd", 1, 100, "m").length, 1u);
  EXPECT_EQ(diagnose("x", "ab\r\ncd", 1, 100, "m").excerpt, "ab");
  EXPECT_EQ(diagnose("x", "ab\n", 3, 1, "m").line, 2u);
  EXPECT_EQ(diagnose("x", "ab", 99, 9, "m").column, 3u);
  EXPECT_EQ(diagnose("x", "", 0, 0, "m").column, 1u);
}

TEST(Diagnostic, WithoutALineNamesTheSourceOnly) {
  Diagnostic d;
  d.source = "scene.json";
  d.message = "no camera";
  d.pointer = "/camera";
  EXPECT_EQ(format(d), "scene.json: error: no camera (at /camera)\n");
}

TEST(Diagnostic, CutsLongLinesAndHidesControlCharacters) {
  const std::string text = std::string(500, 'a') + "!" + std::string(500, 'b');
  const std::string shown = format(diagnose("x", text, 500, 1, "m"));
  EXPECT_LT(shown.size(), 400u);
  const std::size_t excerpt = shown.find('\n') + 1, carets = shown.find('\n', excerpt) + 1;
  EXPECT_EQ(shown.find('!') - excerpt, shown.find('^') - carets);
  EXPECT_EQ(format(diagnose("x", "a\x1B[2Jb\xFF", 0, 1, "m")), "x:1:1: error: m\n  a?[2Jb?\n  ^\n");
}

TEST(InputError, CarriesAllDiagnostics) {
  const InputError e(std::vector{diagnose("x", "ab", 0, 1, "one"), diagnose("x", "ab", 1, 1, "two")});
  EXPECT_EQ(e.diagnostics().size(), 2u);
  EXPECT_STREQ(e.what(), "x:1:1: error: one\n  ab\n  ^\nx:1:2: error: two\n  ab\n   ^\n");
}

TEST(Nearest, FindsWhatWasMeantAndNothingElse) {
  const std::vector<std::string> words{"whitted", "radiosity", "ray-casting", "x", "spp"};
  struct Case {
    const char* given;
    const char* expected;
  };
  const Case cases[] = {{"whited", "whitted"},
                        {"WHITTED", "whitted"},
                        {"radoisity", "radiosity"},
                        {"ray_cast", ""},
                        {"ray_casting", "ray-casting"},
                        {"y", ""},
                        {"ssp", "spp"},
                        {"photon", ""},
                        {"", ""}};
  for (const Case& c : cases) EXPECT_EQ(nearest(c.given, words), c.expected) << c.given;
  EXPECT_EQ(nearest("a", {}), "");
}

}  // namespace
}  // namespace heckbert
