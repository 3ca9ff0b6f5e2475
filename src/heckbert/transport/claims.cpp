#include <heckbert/transport/claims.h>

#include <algorithm>
#include <array>

#include <heckbert/taxonomy/grammar.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

const taxonomy::Grammar& grammar_of(std::string_view name) {
  return *taxonomy::builtin_grammars().find(name);
}

/// The words that are in the language when each V is read as another event.
taxonomy::Language reading_particles_as(Symbol event, const taxonomy::Language& language) {
  std::array<Symbol, taxonomy::kSymbolCount> read{};
  for (const taxonomy::SymbolFacts& facts : taxonomy::kSymbols)
    read[taxonomy::index(facts.symbol)] = facts.symbol == Symbol::V ? event : facts.symbol;
  return taxonomy::inverse_image(language, read);
}

}  // namespace

taxonomy::Language claimed_by(const AlgorithmFacts& algorithm) {
  const taxonomy::Grammar& grammar = grammar_of(algorithm.grammar);
  if (!has_language(grammar)) return {};
  if (algorithm.joins_in_media.empty()) return grammar.language;
  return reading_particles_as(Symbol::Dr, grammar_of(algorithm.joins_in_media).language) |
         reading_particles_as(Symbol::Sr, grammar.language);
}

bool has_technique(const AlgorithmFacts& algorithm, const taxonomy::Word& word, std::size_t light_vertices) {
  const bool is_in_media = std::ranges::find(word.events, Symbol::V) != word.events.end();
  return !(is_in_media && algorithm.joins_in_media.empty()) && has_technique(algorithm.reach, word, light_vertices);
}

}  // namespace heckbert::transport
