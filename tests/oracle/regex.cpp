#include "oracle/regex.h"

namespace heckbert::oracle {

namespace {

using Kind = Regex::Kind;

// How tightly the operator of a node holds its operands.
int precedence(Kind kind) {
  switch (kind) {
    case Kind::Either:
      return 0;
    case Kind::Concat:
      return 1;
    case Kind::Letter:
    case Kind::Set:
      return 3;
    default:
      return 2;
  }
}

std::string operand(const Regex& child, int least, bool everywhere) {
  const std::string text = print(child, everywhere);
  return everywhere || precedence(child.kind) < least ? "(" + text + ")" : text;
}

// Calls `go_on` with every end of a match of `regex` that begins at `at`, until it says true.
bool match(const Regex& regex, std::string_view word, std::size_t at, const std::function<bool(std::size_t)>& go_on) {
  switch (regex.kind) {
    case Kind::Letter:
      return at < word.size() && word[at] == regex.letter && go_on(at + 1);
    case Kind::Set:
      return at < word.size() && regex.letters.find(word[at]) != std::string::npos && go_on(at + 1);
    case Kind::Concat:
      return match(*regex.left, word, at, [&](std::size_t middle) { return match(*regex.right, word, middle, go_on); });
    case Kind::Either:
      return match(*regex.left, word, at, go_on) || match(*regex.right, word, at, go_on);
    case Kind::Option:
      return go_on(at) || match(*regex.left, word, at, go_on);
    case Kind::Star:
      // A round that reads nothing would go on for ever and finds nothing new.
      return go_on(at) ||
             match(*regex.left, word, at, [&](std::size_t end) { return end > at && match(regex, word, end, go_on); });
    case Kind::Plus: {
      const Regex star{Kind::Star, 0, regex.left, nullptr};
      return match(*regex.left, word, at, [&](std::size_t end) { return match(star, word, end, go_on); });
    }
    case Kind::Repeat: {
      if (regex.at_least == 0 && go_on(at)) return true;
      if (regex.at_most == 0u) return false;
      Regex rest = regex;
      if (rest.at_least > 0) --rest.at_least;
      if (rest.at_most) --*rest.at_most;
      // As for Star: once the rounds asked for are over, one that reads nothing finds nothing new.
      return match(*regex.left, word, at,
                   [&](std::size_t end) { return (end > at || regex.at_least > 0) && match(rest, word, end, go_on); });
    }
  }
  return false;
}

}  // namespace

std::vector<RegexPtr> all_of_size(std::size_t nodes, std::string_view letters) {
  std::vector<RegexPtr> all;
  const auto add = [&](Regex regex) { all.push_back(std::make_shared<const Regex>(std::move(regex))); };
  if (nodes == 1)
    for (const char letter : letters) add({Kind::Letter, letter, nullptr, nullptr});
  if (nodes >= 2)
    for (const RegexPtr& child : all_of_size(nodes - 1, letters))
      for (const Kind kind : {Kind::Star, Kind::Plus, Kind::Option}) add({kind, 0, child, nullptr});
  for (std::size_t left_nodes = 1; left_nodes + 1 < nodes; ++left_nodes)
    for (const RegexPtr& left : all_of_size(left_nodes, letters))
      for (const RegexPtr& right : all_of_size(nodes - 1 - left_nodes, letters))
        for (const Kind kind : {Kind::Concat, Kind::Either}) add({kind, 0, left, right});
  return all;
}

std::string print(const Regex& regex, bool everywhere) {
  switch (regex.kind) {
    case Kind::Letter:
      return std::string(1, regex.letter);
    case Kind::Concat:
      return operand(*regex.left, 1, everywhere) + operand(*regex.right, 1, everywhere);
    case Kind::Either:
      return operand(*regex.left, 0, everywhere) + "|" + operand(*regex.right, 0, everywhere);
    case Kind::Star:
      return operand(*regex.left, 2, everywhere) + "*";
    case Kind::Plus:
      return operand(*regex.left, 2, everywhere) + "+";
    case Kind::Option:
      return operand(*regex.left, 2, everywhere) + "?";
    case Kind::Set:
      return "[" + regex.letters + "]";
    case Kind::Repeat: {
      std::string count = std::to_string(regex.at_least);
      if (regex.at_most != regex.at_least) count += "," + (regex.at_most ? std::to_string(*regex.at_most) : "");
      return operand(*regex.left, 2, everywhere) + "{" + count + "}";
    }
  }
  return {};
}

bool matches(const Regex& regex, std::string_view word) {
  return match(regex, word, 0, [&](std::size_t end) { return end == word.size(); });
}

std::vector<std::string> all_words(std::size_t max_length, std::string_view letters) {
  std::vector<std::string> words{""};
  for (std::size_t begin = 0, length = 1; length <= max_length; ++length) {
    const std::size_t end = words.size();
    for (; begin < end; ++begin)
      for (const char letter : letters) words.push_back(words[begin] + letter);
  }
  return words;
}

}  // namespace heckbert::oracle
