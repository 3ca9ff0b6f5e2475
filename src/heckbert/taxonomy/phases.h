#pragma once
// An expression on its way to an automaton, for people who want to see it happen: the tree that the text is, the
// automaton with one state per letter of the text (Glushkov 1961), the deterministic one whose states are sets of those
// (subset construction), and the minimal one. The engine itself composes minimal automata and never builds the middle
// two; both ways give the same language.

#include <string>
#include <string_view>
#include <vector>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::taxonomy {

/// Letters that may be shown one by one, counts written out.
inline constexpr std::size_t kMostPositions = 200;

/// A part of an expression without names and operators on whole paths.
struct PartPhases {
  std::string expression;     ///< as written
  std::string positions;      ///< "1 L -> 2 3" a line: letters, and which may follow
  std::string subsets;        ///< "{2 3} -D-> {4}" a line
  std::size_t deterministic;  ///< number of these sets, the empty one not counted
};

/// One expression. Grammars of algorithms have two, one for lights that a ray can hit and one for those that it cannot.
struct FormPhases {
  std::string expression;  ///< as written
  std::string lights;      ///< which of the two, for people; empty when there is one for all lights
  std::string tree;        ///< one node a line, indented
  std::vector<PartPhases> parts;
};

struct Phases {
  std::vector<FormPhases> forms;
  std::string minimal;  ///< "1 -D-> 2" a line, of the whole language; states accept where marked
  std::size_t states = 0;
};

/// Of an expression. Letters of another dialect are shown as ours; of the strings that its parts match, those count
/// that are whole paths. Errors: as read_expression(), and LimitError beyond kMostPositions.
Phases phases(std::string_view text, Dialect dialect = Dialect::Heckbert, const Names& names = {},
              std::string_view source = "expression");

/// Of a grammar that has a language. Errors: LimitError.
Phases phases(const Grammar& grammar);

}  // namespace heckbert::taxonomy
