#include <heckbert/taxonomy/strategies.h>

#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::taxonomy {

namespace {

constexpr SymbolSet kSpreadPlace = single(Symbol::La) | single(Symbol::Le) | single(Symbol::El);

/// Whether each letter of the extended word is spread out: the light's place and direction, the events, the eye's
/// direction and place.
std::vector<bool> spread(const Word& word) {
  std::vector<bool> letters{has(kSpreadPlace, word.light), true};
  for (const Symbol s : word.events) letters.push_back(facts(s).letter != 'S');
  letters.push_back(true);
  letters.push_back(has(kSpreadPlace, word.eye));
  return letters;
}

std::string_view name_of(std::size_t light_vertices, std::size_t length) {
  if (light_vertices == 0) return "hit the light";
  if (light_vertices == length + 2) return "hit the lens";
  if (length == 0) return "connect light and eye";
  if (light_vertices == 1) return "next event";
  return light_vertices == length + 1 ? "light tracing" : "connect";
}

}  // namespace

std::vector<Strategy> strategies(const Word& word) {
  const std::vector<bool> letters = spread(word);
  const std::size_t vertices = word.length() + 2;
  std::vector<Strategy> found;
  for (std::size_t s = 0; s <= vertices; ++s)
    if (letters[s] && letters[s + 1]) found.push_back({s, vertices - s, name_of(s, word.length())});
  return found;
}

}  // namespace heckbert::taxonomy
