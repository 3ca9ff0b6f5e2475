#pragma once
// Which known algorithm or class is this? An expression is compared with every grammar of a library as it stands, as it
// is for lights that a ray can hit, as it is for lights that it cannot, and within the lights, eyes and letters that
// the expression has: most published disagreements about a grammar are differences of these.

#include <string>
#include <vector>

#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

/// Which of a grammar's two languages, taken for every kind of light.
enum class LightForm : std::uint8_t { AsWritten, Hit, Delta };

/// The grammar's language in one form. Hit and Delta read every light as La or Lp.
Language in_form(const Grammar& grammar, LightForm form);

struct Match {
  const Grammar* grammar = nullptr;
  LightForm form = LightForm::AsWritten;
  SymbolSet within = 0;  ///< the only ends and events looked at; 0: all
};

struct Neighbour {
  const Grammar* grammar = nullptr;
  LightForm form = LightForm::AsWritten;
  Word witness;  ///< the shortest word that one has and the other lacks
};

struct Identification {
  std::vector<Match> same;            ///< the closest kind of equality that any grammar has, all that have it
  std::vector<Neighbour> containing;  ///< smallest known languages that contain it, when nothing is the same
  std::vector<Neighbour> contained;   ///< largest known languages within it, likewise
};

/// Refers to the grammars of the library, which must outlive it.
Identification identify(const Language& language, const GrammarLibrary& library);

/// "Whitted's recursive ray tracing, with lights that cannot be hit, of D and S only".
std::string describe(const Match& match);
std::string_view describe(LightForm form);  ///< "", "with lights that can be hit", ...

}  // namespace heckbert::taxonomy
