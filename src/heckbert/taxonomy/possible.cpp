#include <heckbert/taxonomy/possible.h>

namespace heckbert::taxonomy {

namespace {

Language letter(SymbolSet set) {
  return Language::of(set);
}

std::string scatterings(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " scattering" : " scatterings");
}

/// The plain letters outside `events` without which the language is empty: "S", "G and S".
std::string needed_letters(const Language& language, SymbolSet events) {
  std::string list;
  for (const char c : {'D', 'G', 'S', 'V'}) {
    const auto missing = static_cast<SymbolSet>(with_letter(c) & ~events);
    const auto rest = static_cast<SymbolSet>(kEvents & ~missing);
    if (missing == 0 || !(language & possible_words({.events = rest})).is_empty()) continue;
    list += (list.empty() ? "" : " and ") + describe(missing);
  }
  return list;
}

}  // namespace

Language possible_words(const Conditions& conditions) {
  std::optional<unsigned> most;
  if (conditions.max_length) most = static_cast<unsigned>(*conditions.max_length);
  return concat(concat(letter(conditions.lights), repeat(letter(conditions.events), 0, most)), letter(conditions.eyes));
}

std::optional<std::string> why_never(const Language& language, const Conditions& conditions) {
  // One condition after the other; the first that leaves nothing is the reason.
  Language left = language & Language::universe();
  if (left.is_empty()) return "it has no word at all";
  std::string among;  // which of its words a reason is about, once a condition has taken some away
  const auto narrow = [&](const Conditions& one) {
    Language narrower = left & possible_words(one);
    if (narrower.is_empty()) return false;
    if (narrower != left) among = " that are left";
    left = std::move(narrower);
    return true;
  };
  const auto ends = [&](SymbolSet role) {
    unsigned used = 0;
    for (const Symbol s : members(role)) {
      const SymbolSet only = single(s);
      const Conditions one = role == kLights ? Conditions{.lights = only} : Conditions{.eyes = only};
      if (!(left & possible_words(one)).is_empty()) used |= only;
    }
    return describe(static_cast<SymbolSet>(used));
  };
  if (!narrow({.lights = conditions.lights}))
    return "its words begin at " + ends(kLights) + ", and the only lights are " + describe(conditions.lights);
  if (!narrow({.eyes = conditions.eyes}))
    return "its words" + among + " end at " + ends(kEyes) + ", and the only eye is " + describe(conditions.eyes);
  if (!narrow({.events = conditions.events})) {
    const std::string needed = needed_letters(left, conditions.events);
    const std::string only =
        conditions.events == 0 ? "nothing scatters" : "the only events are " + describe(conditions.events);
    return "all its words" + among + " have " + (needed.empty() ? "some other event" : needed) + ", and " + only;
  }
  if (!narrow({.max_length = conditions.max_length})) {
    const auto shortest = left.shortest_word();
    return "the shortest of its words" + among + ", " + plain(*shortest) + ", has " + scatterings(shortest->length()) +
           ", and the depth allows " + std::to_string(*conditions.max_length);
  }
  return std::nullopt;
}

}  // namespace heckbert::taxonomy
