// Every expression of up to four nodes in every dialect, over the letters that the dialect has: read as a backtracking
// matcher understands it, and written so that it reads as the same language again.

#include <cstdio>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/dialect_letters.h>

#include "oracle/regex.h"

namespace heckbert::taxonomy {
namespace {

std::string letters_of(const DialectFacts& dialect) {
  std::string letters = "V";
  for (const KindLetter& kind : dialect.kinds)
    if (!kind.kinds.empty()) letters += kind.letter;
  return letters;
}

bool has_option(const oracle::Regex& regex) {
  return regex.kind == oracle::Regex::Kind::Option || (regex.left && has_option(*regex.left)) ||
         (regex.right && has_option(*regex.right));
}

struct Expression {
  std::string text;  ///< between an eye and every light
  oracle::RegexPtr regex;
};

// With parentheses around every operand, so that precedence does not matter; '?' as the dialect writes it.
std::vector<Expression> expressions_of(const DialectFacts& dialect) {
  std::vector<Expression> all;
  const bool from_eye = dialect.orientation == Orientation::CameraFirst;
  const std::string eye(1, dialect.eyes[0]), lights = from_eye ? "[LOB]" : "L";
  for (std::size_t nodes = 1; nodes <= 4; ++nodes)
    for (const auto& regex : oracle::all_of_size(nodes, letters_of(dialect))) {
      if (has_option(*regex) && !dialect.has_optional && !dialect.has_range) continue;
      std::string text;
      for (const char c : oracle::print(*regex, true))
        text += c == '?' && !dialect.has_optional ? "{0,1}" : std::string(1, c);
      all.push_back({eye + "(" + text + ")" + (dialect.dialect == Dialect::RenderMan ? "[LO]" : lights), regex});
    }
  return all;
}

// Words of our symbols whose every event is one of a letter's, and the word in the dialect's letters, from the eye.
struct Sample {
  Word word;
  std::string letters;
};

std::vector<Sample> samples_of(const DialectFacts& dialect) {
  std::vector<Sample> samples;
  std::size_t turn = 0;
  for (const std::string& letters : oracle::all_words(4, letters_of(dialect))) {
    Sample sample{{static_cast<Symbol>(turn % 4), {}, turn % 3 == 0 ? Symbol::El : Symbol::Ep}, letters};
    for (const char c : letters) {
      const auto choices = members(c == 'V' ? with_letter('V') : *kind_of(dialect, c));
      sample.word.events.insert(sample.word.events.begin(), choices[turn++ % choices.size()]);
    }
    ++turn;
    samples.push_back(std::move(sample));
  }
  return samples;
}

TEST(EveryDialect, ReadsWhatABacktrackingMatcherMatches) {
  std::size_t read = 0, matching = 0;
  for (const DialectFacts& dialect : kDialects) {
    const auto samples = samples_of(dialect);
    for (const Expression& e : expressions_of(dialect)) {
      const Language language = read_expression(e.text, dialect.dialect).language;
      ++read;
      for (const Sample& s : samples) {
        const bool expected = oracle::matches(*e.regex, s.letters);
        matching += expected;
        ASSERT_EQ(language.contains(s.word), expected) << dialect.title << " " << e.text << " on " << fine(s.word);
      }
    }
  }
  EXPECT_GT(read, 1500u);
  std::printf("%zu expressions, %zu matches\n", read, matching);
}

TEST(EveryDialect, WritesWhatItReadsBack) {
  for (const DialectFacts& dialect : kDialects)
    for (const Expression& e : expressions_of(dialect)) {
      const Language language = read_expression(e.text, dialect.dialect).language;
      const Writing w = write_expression(language, dialect.dialect);
      ASSERT_EQ(w.refusal, "") << dialect.title << " " << e.text;
      ASSERT_EQ(read_expression(w.text, dialect.dialect).language, language) << dialect.title << " " << w.text;
    }
}

TEST(EveryDialect, IsWrittenInEveryOtherThatHasItsLetters) {
  std::size_t written = 0;
  for (const DialectFacts& from : kDialects) {
    const auto expressions = expressions_of(from);
    for (const DialectFacts& to : kDialects)
      for (std::size_t i = 0; i < expressions.size(); i += 3) {
        const Translation t = translate(expressions[i].text, from.dialect, to.dialect);
        ASSERT_NE(t.writing.text.empty(), t.writing.refusal.empty());
        if (t.writing.text.empty()) continue;
        ++written;
        ASSERT_EQ(read_expression(t.writing.text, to.dialect).language, t.reading.language)
            << from.title << " " << expressions[i].text << " in " << to.title << " " << t.writing.text;
      }
  }
  EXPECT_GT(written, 3000u);
}

}  // namespace
}  // namespace heckbert::taxonomy
