#include <heckbert/taxonomy/language.h>

#include <algorithm>

#include <heckbert/taxonomy/label.h>
#include <heckbert/taxonomy/minimize.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

// A label whose columns are those of the others is not told apart from them. States stay numbered as they are: the
// columns that go led nowhere that the others did not lead to before.
void reduce(Alphabet& alphabet, std::vector<State>& states) {
  for (std::size_t i = alphabet.labels.size(); i-- > 0;) {
    const std::size_t first = Alphabet::column(Symbol{}, i + 1);
    const bool is_told_apart = std::any_of(states.begin(), states.end(), [first](const State& s) {
      const auto others = s.next.begin();
      return !std::equal(others, others + kLabelledSymbols, others + static_cast<std::ptrdiff_t>(first));
    });
    if (is_told_apart) continue;
    for (State& s : states) {
      const auto begin = s.next.begin() + static_cast<std::ptrdiff_t>(first);
      s.next.erase(begin, begin + kLabelledSymbols);
    }
    alphabet.labels.erase(alphabet.labels.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::vector<State> dead_states(std::size_t count, const Alphabet& alphabet, StateId dead) {
  return std::vector<State>(count, State{std::vector<StateId>(alphabet.size(), dead), false});
}

}  // namespace

std::vector<std::size_t> representative_columns(const Alphabet& alphabet, const State& state) {
  std::vector<std::size_t> classes{alphabet.class_of(kUnlabelled)};
  for (std::size_t c = 0; c < alphabet.class_count(); ++c)
    if (c != classes[0]) classes.push_back(c);
  std::vector<std::size_t> columns;
  for (const SymbolFacts& f : kSymbols) {
    const auto first = static_cast<std::ptrdiff_t>(columns.size());
    for (const std::size_t c : classes) {
      const std::size_t column = Alphabet::column(f.symbol, c);
      const bool is_new = std::none_of(columns.begin() + first, columns.end(),
                                       [&](std::size_t other) { return state.next[other] == state.next[column]; });
      if (is_new) columns.push_back(column);
    }
  }
  return columns;
}

Language::Language() : states_(dead_states(1, {}, 0)) {}

Language Language::from_automaton(const std::vector<State>& states, Alphabet alphabet) {
  Language language;
  language.states_ = minimize(states);
  language.alphabet_ = std::move(alphabet);
  reduce(language.alphabet_, language.states_);
  return language;
}

Language Language::epsilon() {
  std::vector<State> states = dead_states(2, {}, 1);
  states[0].accepting = true;
  return from_automaton(states);
}

Language Language::of(const LetterSet& one_of) {
  constexpr StateId kRead = 1, kDead = 2;
  Alphabet alphabet;
  for (const LetterSet::OfLabel& one : one_of.of_labels()) alphabet.labels.push_back(one.label);
  std::vector<State> states = dead_states(3, alphabet, kDead);
  for (std::size_t c = 0; c < alphabet.size(); ++c) {
    const std::size_t label_class = Alphabet::class_of_column(c);
    const SymbolSet in = label_class == 0 ? one_of.others() : one_of.of_labels()[label_class - 1].symbols;
    if (has(in, Alphabet::symbol(c))) states[0].next[c] = kRead;
  }
  states[kRead].accepting = true;
  return from_automaton(states, alphabet);
}

Language Language::of(const Word& word) {
  Alphabet alphabet{word.labels};
  std::sort(alphabet.labels.begin(), alphabet.labels.end());
  alphabet.labels.erase(std::unique(alphabet.labels.begin(), alphabet.labels.end()), alphabet.labels.end());
  const auto dead = static_cast<StateId>(word.events.size() + 3);
  std::vector<State> states = dead_states(dead + 1, alphabet, dead);
  StateId at = 0;
  const auto read = [&](Symbol s, std::string_view label) {
    // Without any label every class of labels is meant, and there is one.
    states[at].next[Alphabet::column(s, alphabet.class_of(label))] = at + 1;
    ++at;
  };
  read(word.light, word.label(0));
  for (std::size_t i = 0; i < word.events.size(); ++i) read(word.events[i], word.label(i + 1));
  read(word.eye, {});
  states[at].accepting = true;
  return from_automaton(states, alphabet);
}

const Language& Language::universe() {
  static const Language universe = concat(concat(of(kLights), repeat(of(kEvents), 0, std::nullopt)), of(kEyes));
  return universe;
}

bool Language::contains(const Word& word) const {
  if (alphabet_.labels.empty()) {
    StateId q = states_[0].next[index(word.light)];
    for (const Symbol s : word.events) q = states_[q].next[index(s)];
    return states_[states_[q].next[index(word.eye)]].accepting;
  }
  StateId q = states_[0].next[Alphabet::column(word.light, alphabet_.class_of(word.label(0)))];
  for (std::size_t i = 0; i < word.events.size(); ++i)
    q = states_[q].next[Alphabet::column(word.events[i], alphabet_.class_of(word.label(i + 1)))];
  return states_[states_[q].next[index(word.eye)]].accepting;
}

bool Language::contains(std::span<const Symbol> string) const {
  const std::size_t unlabelled = alphabet_.class_of({});
  StateId q = 0;
  for (const Symbol s : string) q = states_[q].next[Alphabet::column(s, unlabelled)];
  return states_[q].accepting;
}

bool Language::is_empty() const {
  return states_.size() == 1 && !states_[0].accepting;
}

// States are numbered in the order in which breadth-first search finds them, that is by the first among the shortest
// strings that lead there. So the lowest accepting state ends the string asked for, and the lowest state that leads to
// a state, by the first letter that does, is its predecessor on that string.
std::optional<std::vector<Letter>> Language::shortest() const {
  const auto accepting = std::find_if(states_.begin(), states_.end(), [](const State& s) { return s.accepting; });
  if (accepting == states_.end()) return std::nullopt;
  std::vector<Letter> string;
  for (auto at = static_cast<StateId>(accepting - states_.begin()); at != 0;) {
    for (StateId from = 0;; ++from) {
      const auto& next = states_[from].next;
      if (std::find(next.begin(), next.end(), at) == next.end()) continue;
      const std::vector<std::size_t> columns = representative_columns(alphabet_, states_[from]);
      const auto column = std::find_if(columns.begin(), columns.end(), [&](std::size_t c) { return next[c] == at; });
      string.push_back(alphabet_.letter(*column));
      at = from;
      break;
    }
  }
  std::reverse(string.begin(), string.end());
  return string;
}

std::optional<Word> Language::shortest_word() const {
  auto string = (*this & universe()).shortest();
  if (!string) return std::nullopt;
  return word_of(std::move(*string));
}

}  // namespace heckbert::taxonomy
