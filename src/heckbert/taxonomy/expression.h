#pragma once
// Expressions to languages. The syntax is Heckbert's with textbook precedence:
//
//   union      a | b          loosest
//   sets       a & b,  a - b  left to right; whole expressions only
//   complement ! a            within the universe; whole expressions only
//   sequence   a b
//   repetition a* a+ a? a{n} a{n,} a{n,m}
//   atoms      L D G S V E and C for E; subscripts La Lp Ld Le, Dr Dt Gr Gt Sr St, Ep El
//              .  any event    X  D, G or S    N  D or G    [DG] one of    [^S] any event but
//              ( )    @name  a named class or algorithm, a whole expression
//   labels     D'wall' L'key' [DS]'ball'  only letters with this label   'wall'  any event with it, as .'wall'
//              [^'wall'] any event without it, unlabelled ones too   ''  the label of what has none   \' and \\ inside
//   blanks between tokens and comments from # to the end of the line are skipped
//
// A whole expression runs light -> eye (L ... E) or eye -> light (E ... L), told by its ends; each operand of | & - !
// is told separately. Two equal ends are an error.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <heckbert/taxonomy/language.h>

namespace heckbert::taxonomy {

/// What @name means; nothing for an unknown name.
struct Names {
  std::function<std::optional<Language>(std::string_view name)> find;
  std::vector<std::string> known;  ///< for suggestions
  /// Why a name that is known stands for no language, as a sentence; empty for other names.
  std::function<std::string(std::string_view name)> why_none;
};

/// Parses and compiles. `source` names the text in errors. The result is a subset of universe().
/// Errors: InputError with all errors of the text; LimitError naming the sub-expression that is too large
/// or takes too much work (work.h); no text of ten thousand characters takes more than some 60 ms.
Language compile(std::string_view text, const Names& names = {}, std::string_view source = "expression");

}  // namespace heckbert::taxonomy
