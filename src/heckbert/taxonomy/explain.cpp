#include <heckbert/taxonomy/explain.h>

#include <heckbert/taxonomy/live.h>

namespace heckbert::taxonomy {

namespace {

std::vector<Symbol> letters_of(const Word& word) {
  std::vector<Symbol> letters;
  letters.push_back(word.light);
  for (const Symbol s : word.events) letters.push_back(s);
  letters.push_back(word.eye);
  return letters;
}

}  // namespace

std::vector<Step> trace(const Language& language, const Word& word) {
  std::vector<Step> steps;
  StateId q = 0;
  for (const Symbol s : letters_of(word)) {
    const StateId next = language.states()[q].next[index(s)];
    steps.push_back({q, going_on(language, q), s, next});
    if (is_dead(language, next)) {
      steps.back().to.reset();
      break;
    }
    q = next;
  }
  return steps;
}

Explanation explain(const Language& language, const Word& word) {
  const std::vector<Step> steps = trace(language, word);
  const Step& last = steps.back();
  if (!last.to) return {false, steps.size() - 1, last.letter, last.expected};
  return {language.states()[*last.to].accepting, steps.size(), std::nullopt, 0};
}

std::string describe(const Explanation& explanation, const Word& word) {
  if (explanation.matches) return plain(word) + " matches";
  if (!explanation.culprit || explanation.expected == 0) return plain(word) + ": no word matches at all";
  const std::vector<Symbol> letters = letters_of(word);
  // Where the plain letter is among the expected ones, only the subscript tells what is wrong.
  bool is_subscript_at_fault = false;
  for (const Symbol s : members(explanation.expected))
    is_subscript_at_fault = is_subscript_at_fault || facts(s).letter == facts(*explanation.culprit).letter;
  std::string text = is_subscript_at_fault ? fine(word) : plain(word);
  text += explanation.letters_read == 0 ? ": at the beginning" : ": after ";
  for (std::size_t i = 0; i < explanation.letters_read; ++i) text += facts(letters[i]).letter;
  text += " expected " + describe(explanation.expected) + ", not ";
  if (is_subscript_at_fault)
    text += name(*explanation.culprit);
  else
    text += facts(*explanation.culprit).letter;
  return text;
}

std::optional<Word> witness_outside(const Language& a, const Language& b) {
  return (a - b).shortest_word();
}

}  // namespace heckbert::taxonomy
