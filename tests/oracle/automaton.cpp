#include "oracle/automaton.h"

#include <deque>
#include <map>
#include <set>
#include <utility>

#include <heckbert/taxonomy/symbol.h>

namespace heckbert::oracle {

namespace {

using taxonomy::kSymbolCount;
using taxonomy::kSymbols;
using taxonomy::State;
using taxonomy::StateId;
using Kind = Regex::Kind;

using Positions = std::set<std::size_t>;

// Position automaton (Glushkov 1961): the letters of the expression are its states.
struct Glushkov {
  std::vector<char> letters;
  std::vector<Positions> follow;

  struct Part {
    bool may_be_empty = false;
    Positions first, last;
  };

  std::size_t add(char letter) {
    letters.push_back(letter);
    follow.emplace_back();
    return letters.size() - 1;
  }
  void link(const Positions& from, const Positions& to) {
    for (const std::size_t p : from) follow[p].insert(to.begin(), to.end());
  }
  static Positions both(Positions a, const Positions& b) {
    a.insert(b.begin(), b.end());
    return a;
  }
  Part concat(const Part& a, const Part& b) {
    link(a.last, b.first);
    return {a.may_be_empty && b.may_be_empty, a.may_be_empty ? both(a.first, b.first) : a.first,
            b.may_be_empty ? both(a.last, b.last) : b.last};
  }
  static Part either(const Part& a, const Part& b) {
    return {a.may_be_empty || b.may_be_empty, both(a.first, b.first), both(a.last, b.last)};
  }
  Part letter(char c) {
    const std::size_t p = add(c);
    return {false, {p}, {p}};
  }
  // Every round has positions of its own.
  Part repeated(const Regex& regex, unsigned at_least, std::optional<unsigned> at_most) {
    Part all{true, {}, {}};
    const unsigned rounds = at_most ? *at_most : at_least + 1;
    for (unsigned i = 0; i < rounds; ++i) {
      Part round = read(regex);
      if (!at_most && i + 1 == rounds) link(round.last, round.first);
      round.may_be_empty = round.may_be_empty || i >= at_least;
      all = concat(all, round);
    }
    return all;
  }
  Part read(const Regex& regex) {
    switch (regex.kind) {
      case Kind::Letter:
        return letter(regex.letter);
      case Kind::Concat: {
        const Part left = read(*regex.left);
        return concat(left, read(*regex.right));
      }
      case Kind::Either: {
        const Part a = read(*regex.left), b = read(*regex.right);
        return either(a, b);
      }
      case Kind::Set: {
        Part any = letter(regex.letters.front());
        for (const char c : regex.letters.substr(1)) any = either(any, letter(c));
        return any;
      }
      case Kind::Repeat:
        return repeated(*regex.left, regex.at_least, regex.at_most);
      default:
        break;
    }
    Part part = read(*regex.left);
    if (regex.kind != Kind::Option) link(part.last, part.first);
    if (regex.kind != Kind::Plus) part.may_be_empty = true;
    return part;
  }
};

}  // namespace

std::vector<State> automaton_of(const Regex& regex) {
  Glushkov g;
  const auto light = g.letter('L');
  const auto inside = g.read(regex);
  const auto whole = g.concat(g.concat(light, inside), g.letter('E'));
  const std::size_t eye = *whole.last.begin();

  // A subset is the positions that may be read next, and whether the word may end here.
  using Subset = std::pair<Positions, bool>;
  std::map<Subset, StateId> number;
  std::deque<Subset> waiting;
  const auto enter = [&](const Subset& subset) {
    const auto [at, is_new] = number.try_emplace(subset, static_cast<StateId>(number.size()));
    if (is_new) waiting.push_back(subset);
    return at->second;
  };
  std::vector<State> states;
  enter({whole.first, false});
  for (; !waiting.empty(); waiting.pop_front()) {
    const Subset subset = waiting.front();
    State state{std::vector<StateId>(kSymbolCount), subset.second};
    for (const taxonomy::SymbolFacts& f : kSymbols) {
      Subset next;
      for (const std::size_t p : subset.first)
        if (g.letters[p] == f.letter) {
          next.first.insert(g.follow[p].begin(), g.follow[p].end());
          next.second = next.second || p == eye;
        }
      state.next[taxonomy::index(f.symbol)] = enter(next);
    }
    states.push_back(state);
  }
  return states;
}

std::vector<State> minimize_by_table(const std::vector<State>& states) {
  const std::size_t n = states.size();
  std::vector<std::vector<bool>> differ(n, std::vector<bool>(n));
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t q = 0; q < n; ++q) differ[p][q] = states[p].accepting != states[q].accepting;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = 0; q < n; ++q)
        for (std::size_t s = 0; s < states[p].next.size() && !differ[p][q]; ++s)
          if (differ[states[p].next[s]][states[q].next[s]]) differ[p][q] = changed = true;
  }
  // Each state is represented by the first that it equals; walking from the start numbers the representatives.
  std::vector<std::size_t> representative(n);
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t q = 0;
    while (differ[p][q]) ++q;
    representative[p] = q;
  }
  std::vector<std::size_t> order{representative[0]};
  std::map<std::size_t, StateId> number{{representative[0], 0}};
  std::vector<State> minimal;
  for (std::size_t i = 0; i < order.size(); ++i) {
    State state = states[order[i]];
    for (StateId& to : state.next) {
      const auto [at, is_new] = number.try_emplace(representative[to], static_cast<StateId>(order.size()));
      if (is_new) order.push_back(representative[to]);
      to = at->second;
    }
    minimal.push_back(state);
  }
  return minimal;
}

namespace {

// The determinised reversal; breadth-first in the order of Symbol.
std::vector<State> reversal(const std::vector<State>& states) {
  using Subset = std::set<StateId>;
  std::map<Subset, StateId> number;
  std::vector<Subset> order;
  const auto enter = [&](const Subset& subset) {
    const auto [at, is_new] = number.try_emplace(subset, static_cast<StateId>(order.size()));
    if (is_new) order.push_back(subset);
    return at->second;
  };
  Subset accepting;
  for (StateId q = 0; q < states.size(); ++q)
    if (states[q].accepting) accepting.insert(q);
  enter(accepting);
  std::vector<State> reversed;
  for (std::size_t i = 0; i < order.size(); ++i) {
    State state{std::vector<StateId>(states[0].next.size()), order[i].contains(0)};
    for (std::size_t s = 0; s < state.next.size(); ++s) {
      Subset before;
      for (StateId q = 0; q < states.size(); ++q)
        if (order[i].contains(states[q].next[s])) before.insert(q);
      state.next[s] = enter(before);
    }
    reversed.push_back(state);
  }
  return reversed;
}

}  // namespace

std::vector<State> minimize_by_reversal(const std::vector<State>& states) {
  return reversal(reversal(states));
}

}  // namespace heckbert::oracle
