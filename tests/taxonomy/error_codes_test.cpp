// The table of errors against the readers: every sample has its error and no other. docs/errors.md is made from the
// table and from what the samples print; HECKBERT_UPDATE_DOCS=1 in the environment of this test writes it anew.

#include <heckbert/taxonomy/error_codes.h>

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/word.h>

#include "taxonomy/markdown.h"

namespace heckbert::taxonomy {
namespace {

struct Outcome {
  std::set<std::string> codes;
  std::string printed;
};

Outcome outcome_of(const std::vector<Diagnostic>& diagnostics) {
  Outcome outcome;
  for (const Diagnostic& d : diagnostics) {
    outcome.codes.insert(d.code);
    outcome.printed += format(d);
  }
  return outcome;
}

// What is found wrong with a text: errors, or else warnings. A LimitError has its code in its text only.
Outcome read(std::string_view text, std::string_view read_as) {
  try {
    if (read_as == kReadAsWord) return parse_word(text), Outcome{};
    if (read_as == kReadAsGrammar) return parse_grammar(text, "x.grammar", builtin_grammars()), Outcome{};
    const auto dialect = std::find_if(kDialects.begin(), kDialects.end(),
                                      [=](const DialectFacts& facts) { return facts.name == read_as; });
    if (dialect == kDialects.end()) return {{}, "no dialect " + std::string(read_as)};
    return outcome_of(read_expression(text, dialect->dialect, builtin_grammars().names()).warnings);
  } catch (const InputError& error) {
    return outcome_of(error.diagnostics());
  } catch (const LimitError& error) {
    const std::string message = error.what();
    const std::size_t begin = message.find("[HB"), end = message.find(']', begin);
    if (begin == std::string::npos) return {{}, message};
    return {{message.substr(begin + 1, end - begin - 1)}, message + "\n"};
  }
}

TEST(ErrorCodes, EverySampleHasItsErrorAndNoOther) {
  for (const ErrorFacts& facts : kErrors) {
    const Outcome outcome = read(facts.sample, facts.read_as);
    EXPECT_EQ(outcome.codes, std::set{label(facts.code)}) << facts.sample << "\n" << outcome.printed;
  }
}

TEST(ErrorCodes, AreFoundByTheirLabel) {
  for (const ErrorFacts& facts : kErrors) EXPECT_EQ(find_error(label(facts.code)), &facts);
  EXPECT_EQ(find_error("hb101"), &kErrors[0]);
  EXPECT_EQ(find_error("101"), &kErrors[0]);
  for (const char* none : {"", "HB", "HB1", "HB101x", "HB999", "xHB101"}) EXPECT_EQ(find_error(none), nullptr) << none;
}

TEST(ErrorCodes, MessagesAreTheTablesWithTheirPlacesFilledIn) {
  EXPECT_EQ(message_of(ErrorCode::UnknownLetter, {"'Q'", "D or S"}), "unknown letter 'Q'; expected D or S");
  EXPECT_EQ(message_of(ErrorCode::EmptyParentheses), "empty parentheses; expected a piece of a path");
  EXPECT_EQ(message_of(ErrorCode::MalformedCount), "a count is written {n}, {n,} or {n,m} with numbers n and m");
  const Diagnostic d = diagnose(ErrorCode::UnknownKey, "x", "ab", 1, 1, {"'b'"}, "leave it");
  EXPECT_EQ(format(d), "x:1:2: error: unknown key 'b' [HB503]\n  ab\n   ^\n  leave it\n");
  EXPECT_EQ(warning_text(d), "unknown key 'b'; leave it [HB503]");
}

// ---- docs/errors.md ------------------------------------------------------------------------------------------------

constexpr const char* kGroups[] = {
    "", "Letters", "Brackets and counts", "Operators and names", "Ends of a path", "Grammar files", "Warnings"};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '*' ? "\\*" : std::string(1, c);
  return result;
}

std::string page() {
  std::string text =
      "# Errors\n\n"
      "What can be wrong with an expression, a word or a grammar file. Each error has a code, printed at the end of "
      "its\n"
      "line, that stays the same from version to version; `heckbert grammar errors HB201` says in a terminal what "
      "this\n"
      "page says. Below each stands what the tool prints for a text with that error. All errors of a text are "
      "reported,\n"
      "not the first only.\n\n"
      "Made from the table of the program; a test compares.\n";
  unsigned group = 0;
  for (const ErrorFacts& facts : kErrors) {
    if (static_cast<unsigned>(facts.code) / 100 != group) {
      group = static_cast<unsigned>(facts.code) / 100;
      text += std::string("\n## ") + kGroups[group] + "\n";
    }
    std::string printed = read(facts.sample, facts.read_as).printed;
    if (group == 6) printed.replace(printed.find("error:"), 6, "warning:");
    const bool is_dialect = facts.read_as != kReadAsWord && facts.read_as != kReadAsGrammar;
    const std::string as = is_dialect && facts.read_as != "heckbert" ? " As `" + std::string(facts.read_as) + "`:" : "";
    text += "\n### " + label(facts.code) + ": " + escaped(facts.title) + "\n\n" + escaped(facts.remedy) + as +
            "\n\n```text\n" + printed + "```\n";
  }
  return text;
}

TEST(ErrorsPage, IsWhatTheTableSays) {
  markdown::expect_page(HECKBERT_SOURCE_DIR "/docs/errors.md", page(), "taxonomy_unit_test");
}

}  // namespace
}  // namespace heckbert::taxonomy
