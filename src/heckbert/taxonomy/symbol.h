#pragma once
// The letters. Everything the project says about a light path is said with these thirteen symbols: four kinds of
// light end, seven kinds of scattering event, two kinds of eye end. This is the finest alphabet (design decision 1);
// every coarser notation is a homomorphism of it. The facts about each symbol live in one table, kSymbols, from which
// parsers, printers, help texts and documentation derive.
//
// D, G, S after Heckbert 1990 ("Adaptive Radiosity Textures for Bidirectional Ray Tracing") and Jensen 2001, 2.6;
// S means a Dirac lobe and nothing else. r is reflection, t is transmission.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace heckbert::taxonomy {

enum class Symbol : std::uint8_t { La, Lp, Ld, Le, Dr, Dt, Gr, Gt, Sr, St, V, Ep, El };

enum class Role : std::uint8_t { Light, Event, Eye };

struct SymbolFacts {
  Symbol symbol;
  Role role;
  char letter;     ///< the plain letter: L, D, G, S, V or E
  char subscript;  ///< 'r', 'a', ...; 0 where the letter stands alone
  std::string_view meaning;
};

inline constexpr std::size_t kSymbolCount = 13;

inline constexpr std::array<SymbolFacts, kSymbolCount> kSymbols{{
    {Symbol::La, Role::Light, 'L', 'a', "area light"},
    {Symbol::Lp, Role::Light, 'L', 'p', "point or spot light"},
    {Symbol::Ld, Role::Light, 'L', 'd', "distant light"},
    {Symbol::Le, Role::Light, 'L', 'e', "environment light"},
    {Symbol::Dr, Role::Event, 'D', 'r', "diffuse reflection"},
    {Symbol::Dt, Role::Event, 'D', 't', "diffuse transmission"},
    {Symbol::Gr, Role::Event, 'G', 'r', "glossy reflection"},
    {Symbol::Gt, Role::Event, 'G', 't', "glossy transmission"},
    {Symbol::Sr, Role::Event, 'S', 'r', "specular (Dirac) reflection"},
    {Symbol::St, Role::Event, 'S', 't', "specular (Dirac) transmission"},
    {Symbol::V, Role::Event, 'V', 0, "scattering in a medium"},
    {Symbol::Ep, Role::Eye, 'E', 'p', "pinhole eye"},
    {Symbol::El, Role::Eye, 'E', 'l', "thin-lens eye"},
}};

constexpr std::size_t index(Symbol s) {
  return static_cast<std::size_t>(s);
}
constexpr const SymbolFacts& facts(Symbol s) {
  return kSymbols[index(s)];
}
constexpr bool is_light(Symbol s) {
  return facts(s).role == Role::Light;
}
constexpr bool is_event(Symbol s) {
  return facts(s).role == Role::Event;
}
constexpr bool is_eye(Symbol s) {
  return facts(s).role == Role::Eye;
}

/// The symbol written with this letter and subscript; without a subscript (0) the commonest one: La, Dr, Gr, Sr, Ep.
constexpr std::optional<Symbol> find_symbol(char letter, char subscript) {
  for (const SymbolFacts& f : kSymbols)
    if (f.letter == letter && (subscript == 0 || f.subscript == subscript)) return f.symbol;
  return std::nullopt;
}

static_assert([] {
  for (std::size_t i = 0; i < kSymbolCount; ++i)
    if (index(kSymbols[i].symbol) != i) return false;
  return true;
}());

}  // namespace heckbert::taxonomy
