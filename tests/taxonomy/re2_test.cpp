// RE2 as a second opinion on D and S: random expressions must match exactly the words that RE2 matches, read as native
// text, read as every dialect writes them, and written back by us.

#include <cstdio>
#include <random>

#include <gtest/gtest.h>
#include <re2/re2.h>

#include <heckbert/taxonomy/counting.h>
#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/dialect_letters.h>
#include <heckbert/taxonomy/enumeration.h>
#include <heckbert/taxonomy/simplest.h>

#include "oracle/random_regex.h"

namespace heckbert::taxonomy {
namespace {

constexpr std::size_t kExhaustive = 7;  // all words of so many scatterings; some longer ones beside them

std::vector<oracle::RegexPtr> random_expressions(std::size_t count, std::string_view letters) {
  std::mt19937_64 random(1990);
  std::vector<oracle::RegexPtr> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(oracle::random_regex(1 + i % 12, letters, [&] { return random(); }));
  return list;
}

/// Between the ends, from the light.
std::vector<std::string> middles() {
  std::vector<std::string> list = oracle::all_words(kExhaustive, "DS");
  std::mt19937_64 random(2010);
  for (std::size_t i = 0; i < 200; ++i) {
    // Runs of one letter pass expressions that coin tosses never would.
    std::string word;
    const std::size_t length = kExhaustive + 1 + random() % 25;
    for (char c = 'D'; word.size() < length; c = c == 'D' ? 'S' : 'D') word.append(1 + random() % 5, c);
    list.push_back(std::move(word));
  }
  return list;
}

Word word_of(std::string_view middle) {
  return parse_word("L" + std::string(middle) + "E");
}

std::string turned(const std::string& word) {
  return {word.rbegin(), word.rend()};
}

// RE2 refuses D+* where we read (D+)*, hence parentheses around every operand.
std::string whole(const oracle::Regex& regex, const char* begin, const char* end) {
  return std::string(begin) + "(" + oracle::print(regex, true) + ")" + end;
}

TEST(Re2, MatchesTheSameWordsAsNativeText) {
  std::size_t matching = 0;
  const auto words = middles();
  for (const auto& regex : random_expressions(1500, "DS")) {
    const RE2 other(whole(*regex, "L", "E"));
    ASSERT_TRUE(other.ok()) << other.error();
    // As a person writes it, and from either end.
    const std::string text = "L(" + oracle::print(*regex) + ")E";
    const Language language = compile(text), from_eye = compile("E(" + oracle::print(*regex) + ")L");
    for (const std::string& w : words) {
      const bool expected = RE2::FullMatch("L" + w + "E", other);
      matching += expected;
      ASSERT_EQ(language.contains(word_of(w)), expected) << text << " on L" << w << "E";
      ASSERT_EQ(from_eye.contains(word_of(turned(w))), expected) << text << " from the eye, on E" << w << "L";
    }
  }
  EXPECT_GT(matching, 50'000u);
  std::printf("%zu matches\n", matching);
}

TEST(Re2, CountsAsManyMembersOfEachLength) {
  for (const auto& regex : random_expressions(400, "DS")) {
    const RE2 other(oracle::print(*regex, true));
    std::vector<Natural> counts(kExhaustive + 1);
    for (const std::string& w : oracle::all_words(kExhaustive, "DS"))
      if (RE2::FullMatch(w, other)) counts[w.size()].add(Natural(1));
    const Language language =
        read_as(compile("La(" + oracle::print(*regex) + ")Ep"),
                std::vector<SymbolSet>{single(Symbol::La), with_letter('D'), with_letter('S'), single(Symbol::Ep)});
    ASSERT_EQ(count_words(language, kExhaustive), counts) << oracle::print(*regex);
  }
}

// Our text in RE2's letters; nothing when it has operators on whole paths, which RE2 lacks.
std::optional<std::string> in_re2(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&' || c == '-' || c == '!') return std::nullopt;
    if (c == 'X')
      out += "[DGS]";
    else if (c == 'N')
      out += "[DG]";
    else if (c == '.')
      out += "[DGSV]";
    else if (c != ' ')
      out += c;
  }
  return "(" + out + ")";  // a union of whole paths is one alternative
}

TEST(Re2, ReadsWhatWeWriteAsWhatItRead) {
  const auto words = middles();
  std::size_t compared = 0;
  for (const auto& regex : random_expressions(400, "DS")) {
    const RE2 before(whole(*regex, "L", "E"));
    const auto simplest = simplest_expression(compile(whole(*regex, "L", "E")));
    if (!simplest) continue;
    const auto pattern = in_re2(*simplest);
    if (!pattern) continue;
    const RE2 after(*pattern);
    ASSERT_TRUE(after.ok()) << *simplest << ": " << after.error();
    ++compared;
    for (const std::string& w : words)
      ASSERT_EQ(RE2::FullMatch("L" + w + "E", before), RE2::FullMatch("L" + w + "E", after))
          << oracle::print(*regex) << " became " << *simplest << ", on L" << w << "E";
  }
  EXPECT_GT(compared, 350u);
}

// Letters of the dialect that stand for diffuse and specular bounces.
std::string two_letters(const DialectFacts& dialect) {
  std::string letters;
  for (const char kind : {'D', 'S'})
    for (const KindLetter& k : dialect.kinds)
      if (k.kinds.find(kind) != std::string_view::npos) letters += k.letter;
  return letters;
}

bool is_repetition(const oracle::Regex& regex) {
  using Kind = oracle::Regex::Kind;
  return regex.left && regex.kind != Kind::Concat && regex.kind != Kind::Either;
}

bool may_write(const DialectFacts& dialect, const oracle::Regex& regex) {
  using Kind = oracle::Regex::Kind;
  if (!dialect.stacks_repetitions && is_repetition(regex) && is_repetition(*regex.left)) return false;
  if (regex.kind == Kind::Option && !dialect.has_optional) return false;
  if (regex.kind == Kind::Repeat) {
    const bool is_exact = regex.at_most == regex.at_least;
    if (is_exact ? !dialect.has_exact : regex.at_most ? !dialect.has_range : !dialect.has_open) return false;
  }
  return (!regex.left || may_write(dialect, *regex.left)) && (!regex.right || may_write(dialect, *regex.right));
}

TEST(Re2, MatchesTheSameWordsAsEveryDialect) {
  const auto words = middles();
  for (const DialectFacts& dialect : kDialects) {
    const std::string letters = two_letters(dialect);
    ASSERT_EQ(letters.size(), 2u) << dialect.name;
    const std::string eye(1, dialect.eyes[0]);
    std::size_t read = 0;
    for (const auto& regex : random_expressions(300, letters)) {
      if (!may_write(dialect, *regex)) continue;
      ++read;
      // Where '|' binds as it does in RE2, precedence is put to the test too.
      const std::string text = eye + "(" + oracle::print(*regex, dialect.bar_binds_tightest) + ")L";
      const Language language = read_expression(text, dialect.dialect).language;
      const Writing written = write_expression(language, dialect.dialect);
      ASSERT_EQ(written.refusal, "") << dialect.title << " " << text;
      const Language again = read_expression(written.text, dialect.dialect).language;
      const RE2 other(whole(*regex, eye.c_str(), "L"));
      for (const std::string& w : words) {
        std::string theirs;
        for (const char c : w) theirs += c == 'D' ? letters[0] : letters[1];
        const bool expected = RE2::FullMatch(eye + theirs + "L", other);
        ASSERT_EQ(language.contains(word_of(turned(w))), expected) << dialect.title << " " << text << " on " << theirs;
        ASSERT_EQ(again.contains(word_of(turned(w))), expected) << dialect.title << " " << written.text;
      }
    }
    EXPECT_GT(read, 50u) << dialect.title;
  }
}

}  // namespace
}  // namespace heckbert::taxonomy
