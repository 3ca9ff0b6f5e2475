#pragma once
// Random expressions for rapidcheck, written as text, and their languages put together by the operations alone.

#include <algorithm>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/simplest.h>
#include <heckbert/taxonomy/symbol_set.h>

#include "oracle/random_regex.h"

namespace heckbert::taxonomy {

/// One letter of a random expression: how the text writes it, and what it stands for.
struct RandomLetter {
  char code;
  std::string_view text;
  LetterSet set;
};

inline const std::vector<RandomLetter>& random_letters() {
  static const std::vector<RandomLetter> letters{
      {'D', "D", with_letter('D')},
      {'G', "G", with_letter('G')},
      {'S', "S", with_letter('S')},
      {'V', "V", with_letter('V')},
      {'d', "Dr", single(Symbol::Dr)},
      {'s', "St", single(Symbol::St)},
      {'a', "D'a'", LetterSet::labelled(with_letter('D'), "a")},
      {'b', ".'b'", LetterSet::labelled(kEvents, "b")},
      {'u', "S''", LetterSet::labelled(with_letter('S'), "")},
  };
  return letters;
}

inline const RandomLetter& random_letter(char code) {
  return *std::find_if(random_letters().begin(), random_letters().end(),
                       [code](const RandomLetter& l) { return l.code == code; });
}

/// Most letters drawn have no label, and labels are few, so that equal ones meet.
inline constexpr std::string_view kRandomLetters = "DDGSSVdsabu";

inline std::string text_of(const oracle::Regex& regex) {
  std::string text;
  for (const char c : oracle::print(regex)) {
    const auto letter = std::find_if(random_letters().begin(), random_letters().end(),
                                     [c](const RandomLetter& l) { return l.code == c; });
    text += letter == random_letters().end() ? std::string(1, c) : std::string(letter->text);
  }
  return text;
}

/// By union, product and repetition, without any reading of text.
inline Language language_of(const oracle::Regex& regex) {
  using Kind = oracle::Regex::Kind;
  const auto operand = [](const oracle::RegexPtr& child) { return language_of(*child); };
  switch (regex.kind) {
    case Kind::Letter:
      return Language::of(random_letter(regex.letter).set);
    case Kind::Set: {
      LetterSet any;
      for (const char c : regex.letters) any |= random_letter(c).set;
      return Language::of(any);
    }
    case Kind::Concat:
      return concat(operand(regex.left), operand(regex.right));
    case Kind::Either:
      return operand(regex.left) | operand(regex.right);
    case Kind::Star:
      return repeat(operand(regex.left), 0, std::nullopt);
    case Kind::Plus:
      return repeat(operand(regex.left), 1, std::nullopt);
    case Kind::Option:
      return repeat(operand(regex.left), 0, 1);
    case Kind::Repeat:
      return repeat(operand(regex.left), regex.at_least, regex.at_most);
  }
  return {};
}

/// An expression over events, without ends.
struct Events {
  oracle::RegexPtr tree;
  std::string text() const { return text_of(*tree); }
  Language language() const { return language_of(*tree); }
};

/// An expression of whole paths.
struct Paths {
  std::string light = "L";
  oracle::RegexPtr tree;
  std::string eye = "E";
  bool from_eye = false;
  std::string text() const {
    return from_eye ? eye + "(" + text_of(*tree) + ")" + light : light + "(" + text_of(*tree) + ")" + eye;
  }
  Language language() const { return compile(text()); }
};

inline void showValue(const Events& e, std::ostream& out) {
  out << e.text();
}
inline void showValue(const Paths& p, std::ostream& out) {
  out << p.text();
}
inline void showValue(const Language& language, std::ostream& out) {
  const Language words = language & Language::universe();
  out << (words.is_empty() ? "no word" : simplest_expression(words).value_or("a long expression"));
  if (words != language) out << " and strings that are no words";
}

}  // namespace heckbert::taxonomy

namespace rc {

template <>
struct Arbitrary<heckbert::taxonomy::Events> {
  static Gen<heckbert::taxonomy::Events> arbitrary() {
    using heckbert::taxonomy::Events;
    return [](const Random& seed, int size) {
      Random random = seed;
      const heckbert::oracle::Bits bits = [&] { return random.next(); };
      const std::size_t nodes = 1 + bits() % (2 + static_cast<std::size_t>(size) / 15);
      return shrinkable::shrinkRecur(
          Events{heckbert::oracle::random_regex(nodes, heckbert::taxonomy::kRandomLetters, bits)},
          [](const Events& events) {
            std::vector<Events> list;
            for (auto& tree : heckbert::oracle::smaller(events.tree)) list.push_back({std::move(tree)});
            return seq::fromContainer(std::move(list));
          });
    };
  }
};

template <>
struct Arbitrary<heckbert::taxonomy::Paths> {
  static Gen<heckbert::taxonomy::Paths> arbitrary() {
    using heckbert::taxonomy::Events;
    using heckbert::taxonomy::Paths;
    const auto ends = [](const char* usual, std::vector<std::string> others) {
      return gen::weightedOneOf<std::string>({{2, gen::just(std::string(usual))}, {1, gen::elementOf(others)}});
    };
    return gen::map(gen::tuple(ends("L", {"La", "Lp", "[LaLe]", "L'key'"}), gen::arbitrary<Events>(),
                               ends("E", {"Ep", "El"}), gen::arbitrary<bool>()),
                    [](const std::tuple<std::string, Events, std::string, bool>& parts) {
                      const auto& [light, events, eye, from_eye] = parts;
                      return Paths{light, events.tree, eye, from_eye};
                    });
  }
};

}  // namespace rc
