#include <heckbert/taxonomy/language.h>

#include <algorithm>

#include <heckbert/taxonomy/minimize.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

Language::Language() : states_(1) {}

Language Language::from_automaton(const std::vector<State>& states) {
  Language language;
  language.states_ = minimize(states);
  return language;
}

Language Language::epsilon() {
  std::vector<State> states(2);
  states[0].accepting = true;
  states[0].next.fill(1);
  states[1].next.fill(1);
  return from_automaton(states);
}

Language Language::of(Symbol symbol) {
  return of(std::span(&symbol, 1));
}

Language Language::of(std::span<const Symbol> one_of) {
  constexpr StateId kRead = 1, kDead = 2;
  std::vector<State> states(3);
  for (State& s : states) s.next.fill(kDead);
  for (const Symbol s : one_of) states[0].next[index(s)] = kRead;
  states[kRead].accepting = true;
  return from_automaton(states);
}

Language Language::of(const Word& word) {
  const std::size_t letters = word.events.size() + 2;
  std::vector<State> states(letters + 2);
  const auto dead = static_cast<StateId>(letters + 1);
  for (State& s : states) s.next.fill(dead);
  StateId at = 0;
  const auto read = [&](Symbol s) {
    states[at].next[index(s)] = at + 1;
    ++at;
  };
  read(word.light);
  for (const Symbol s : word.events) read(s);
  read(word.eye);
  states[at].accepting = true;
  return from_automaton(states);
}

const Language& Language::universe() {
  static const Language universe =
      concat(concat(of(members(kLights)), repeat(of(members(kEvents)), 0, std::nullopt)), of(members(kEyes)));
  return universe;
}

bool Language::contains(const Word& word) const {
  StateId q = states_[0].next[index(word.light)];
  for (const Symbol s : word.events) q = states_[q].next[index(s)];
  return states_[states_[q].next[index(word.eye)]].accepting;
}

bool Language::contains(std::span<const Symbol> string) const {
  StateId q = 0;
  for (const Symbol s : string) q = states_[q].next[index(s)];
  return states_[q].accepting;
}

bool Language::is_empty() const {
  return states_.size() == 1 && !states_[0].accepting;
}

// States are numbered in the order in which breadth-first search finds them, that is by the first among the shortest
// strings that lead there. So the lowest accepting state ends the string asked for, and the lowest state that leads to
// a state, by the first symbol that does, is its predecessor on that string.
std::optional<std::vector<Symbol>> Language::shortest() const {
  const auto accepting = std::find_if(states_.begin(), states_.end(), [](const State& s) { return s.accepting; });
  if (accepting == states_.end()) return std::nullopt;
  std::vector<Symbol> string;
  for (auto at = static_cast<StateId>(accepting - states_.begin()); at != 0;) {
    for (StateId from = 0;; ++from) {
      const auto& next = states_[from].next;
      const auto symbol = std::find(next.begin(), next.end(), at);
      if (symbol == next.end()) continue;
      string.push_back(static_cast<Symbol>(symbol - next.begin()));
      at = from;
      break;
    }
  }
  std::reverse(string.begin(), string.end());
  return string;
}

std::optional<Word> Language::shortest_word() const {
  const auto string = (*this & universe()).shortest();
  if (!string) return std::nullopt;
  return Word{string->front(), {string->begin() + 1, string->end() - 1}, string->back()};
}

}  // namespace heckbert::taxonomy
