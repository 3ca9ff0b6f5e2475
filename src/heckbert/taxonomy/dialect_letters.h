#pragma once
// What the letters of a dialect stand for, derived from the table of dialects.

#include <optional>
#include <string_view>

#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

/// Everything a path can have, ends included.
inline constexpr SymbolSet kAllSymbols = kLights | kEvents | kEyes;

/// The symbols with one of these letters.
SymbolSet with_letters(std::string_view letters);
/// Events with this subscript: 'r' all reflections, 't' all transmissions.
SymbolSet with_mode(char subscript);

SymbolSet symbols_of(const KindLetter& kind);
SymbolSet symbols_of(const LightLetter& light);

/// What '.' stands for.
SymbolSet any_of(const DialectFacts& dialect);
/// The scattering letter c; nothing when the dialect has none.
std::optional<SymbolSet> kind_of(const DialectFacts& dialect, char c);
/// The event type c, one of R T V and the letters of the ends; nothing for another.
std::optional<SymbolSet> type_of(const DialectFacts& dialect, char c);

}  // namespace heckbert::taxonomy
