#pragma once
// A slow and simple twin of the expressions: trees of letters and sets of letters with six operators, printed as text,
// matched by backtracking. It knows nothing of automata, so that agreement with the library means something.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heckbert::oracle {

struct Regex;
using RegexPtr = std::shared_ptr<const Regex>;

struct Regex {
  enum class Kind { Letter, Concat, Either, Star, Plus, Option, Set, Repeat };
  Kind kind = Kind::Letter;
  char letter = 0;
  RegexPtr left = {};                    ///< the only child of Star, Plus, Option, Repeat
  RegexPtr right = {};                   ///< Concat and Either only
  std::string letters = {};              ///< Set only: any of these
  unsigned at_least = 0;                 ///< Repeat only
  std::optional<unsigned> at_most = {};  ///< Repeat only; nothing: any number
};

/// All trees of letters and the five operators from Concat to Option with exactly `nodes` nodes over these letters.
std::vector<RegexPtr> all_of_size(std::size_t nodes, std::string_view letters);

/// With as few parentheses as precedence allows; `everywhere` puts them around every operand.
std::string print(const Regex& regex, bool everywhere = false);

/// Whether the whole of `word` matches, by trying every way.
bool matches(const Regex& regex, std::string_view word);

/// All words over the letters up to this length, the empty word first.
std::vector<std::string> all_words(std::size_t max_length, std::string_view letters);

}  // namespace heckbert::oracle
