#include <heckbert/taxonomy/explain.h>

#include <heckbert/taxonomy/live.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

std::vector<Step> trace(const Language& language, const Word& word) {
  std::vector<Step> steps;
  StateId q = 0;
  for (const Letter& letter : letters_of(word)) {
    const StateId next = language.states()[q].next[language.alphabet().column(letter)];
    steps.push_back({q, going_on(language, q), letter, next});
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
  return {language.states()[*last.to].accepting, steps.size(), std::nullopt, {}};
}

std::string describe(const Explanation& explanation, const Word& word) {
  if (explanation.matches) return plain(word) + " matches";
  if (!explanation.culprit || explanation.expected.is_empty()) return plain(word) + ": no word matches at all";
  const std::vector<Letter> letters = letters_of(word);
  const Letter& culprit = *explanation.culprit;
  const SymbolSet expected = explanation.expected.symbols();
  // Where the plain letter is among the expected ones, only the subscript or the label tells what is wrong.
  const bool is_detail_at_fault = (expected & with_letter(facts(culprit.symbol).letter)) != 0;
  std::string text = is_detail_at_fault ? fine(word) : plain(word);
  text += explanation.letters_read == 0 ? ": at the beginning" : ": after ";
  for (std::size_t i = 0; i < explanation.letters_read; ++i) text += facts(letters[i].symbol).letter;
  text += " expected " + describe(explanation.expected) + ", not ";
  if (is_detail_at_fault)
    text += name(culprit);
  else
    text += facts(culprit.symbol).letter;
  if (has(expected, culprit.symbol) && culprit.label.empty()) text += " without a label";
  return text;
}

std::optional<Word> witness_outside(const Language& a, const Language& b) {
  return (a - b).shortest_word();
}

}  // namespace heckbert::taxonomy
