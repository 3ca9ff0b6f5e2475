#pragma once
// Sets of symbols, one bit each: what a letter of an expression stands for, and what could have come next in a word.

#include <cstdint>
#include <string>
#include <vector>

#include <heckbert/taxonomy/symbol.h>

namespace heckbert::taxonomy {

/// Bit index(s) is set when s is a member.
using SymbolSet = std::uint16_t;

constexpr SymbolSet single(Symbol s) {
  return static_cast<SymbolSet>(1u << index(s));
}
constexpr bool has(SymbolSet set, Symbol s) {
  return (set & single(s)) != 0;
}

/// All symbols for which `is_member(facts)` holds.
template <class Predicate>
constexpr SymbolSet symbols_where(Predicate is_member) {
  unsigned set = 0;
  for (const SymbolFacts& f : kSymbols)
    if (is_member(f)) set |= single(f.symbol);
  return static_cast<SymbolSet>(set);
}

constexpr SymbolSet with_role(Role role) {
  return symbols_where([role](const SymbolFacts& f) { return f.role == role; });
}
constexpr SymbolSet with_letter(char letter) {
  return symbols_where([letter](const SymbolFacts& f) { return f.letter == letter; });
}

inline constexpr SymbolSet kLights = with_role(Role::Light);
inline constexpr SymbolSet kEvents = with_role(Role::Event);
inline constexpr SymbolSet kEyes = with_role(Role::Eye);

/// The members in the order of Symbol.
std::vector<Symbol> members(SymbolSet set);

/// "Sr", "V": the symbol as it is written.
std::string name(Symbol s);

/// The letters of the set, "D", "Sr", "La": one whose every subscript is in the set goes without.
std::vector<std::string> names_of(SymbolSet set);

/// The set as an expression writes it, in as few characters as it can: "S", "X", "[DV]", "[^S]", "[LaLe]". The set is
/// not empty.
std::string write(SymbolSet set);

/// "D, Sr or E" for people: letters whose every subscript is in the set are named without one.
std::string describe(SymbolSet set);

}  // namespace heckbert::taxonomy
