#include <heckbert/taxonomy/identification.h>

#include <algorithm>
#include <array>

#include <heckbert/taxonomy/explain.h>
#include <heckbert/taxonomy/live.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::taxonomy {

namespace {

struct Candidate {
  const Grammar* grammar;
  LightForm form;
  Language language;
};

// Of two forms that are the same language, the first is enough.
std::vector<Candidate> candidates(const GrammarLibrary& library) {
  std::vector<Candidate> all;
  for (const Grammar& grammar : library.grammars) {
    std::vector<Candidate> forms;
    for (const LightForm form : {LightForm::AsWritten, LightForm::Hit, LightForm::Delta}) {
      Candidate candidate{&grammar, form, in_form(grammar, form)};
      const bool is_new = std::none_of(forms.begin(), forms.end(),
                                       [&](const Candidate& c) { return c.language == candidate.language; });
      if (is_new && !candidate.language.is_empty()) forms.push_back(std::move(candidate));
    }
    std::move(forms.begin(), forms.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<Match> equal_within(const Language& language, SymbolSet within, const std::vector<Candidate>& known) {
  const Language possible = possible_words({.lights = static_cast<SymbolSet>(within & kLights),
                                            .events = static_cast<SymbolSet>(within & kEvents),
                                            .eyes = static_cast<SymbolSet>(within & kEyes)});
  std::vector<Match> found;
  for (const Candidate& c : known) {
    const bool is_listed =
        std::any_of(found.begin(), found.end(), [&](const Match& m) { return m.grammar == c.grammar; });
    if (!is_listed && (c.language & possible) == language) found.push_back({c.grammar, c.form, within});
  }
  return found;
}

constexpr std::array<std::string_view, 3> kFormNames{"", "with lights that can be hit",
                                                     "with lights that cannot be hit"};

}  // namespace

Language in_form(const Grammar& grammar, LightForm form) {
  if (form == LightForm::AsWritten) return grammar.language;
  std::array<Symbol, kSymbolCount> h{};
  for (const SymbolFacts& f : kSymbols) h[index(f.symbol)] = f.symbol;
  for (const Symbol s : members(kLights)) h[index(s)] = form == LightForm::Hit ? Symbol::La : Symbol::Lp;
  return inverse_image(grammar.language, h);
}

Identification identify(const Language& language, const GrammarLibrary& library) {
  Identification result;
  if (language.is_empty()) return result;
  const std::vector<Candidate> known = candidates(library);
  const SymbolSet used = symbols_of(language);

  // From the closest kind of equality to the loosest.
  for (const SymbolSet within :
       {static_cast<SymbolSet>(kLights | kEvents | kEyes), static_cast<SymbolSet>((used & ~kEvents) | kEvents), used}) {
    // A few letters leave almost nothing of most grammars; equality there would say nothing.
    if ((within & kEvents) == 0) break;
    result.same = equal_within(language, within, known);
    if (!result.same.empty()) break;
  }
  for (Match& m : result.same)
    if (m.within == (kLights | kEvents | kEyes)) m.within = 0;
  if (!result.same.empty()) return result;

  const auto nearest = [&](bool above) {
    std::vector<Neighbour> list;
    std::vector<const Candidate*> related;
    for (const Candidate& c : known)
      if (above ? language.is_subset_of(c.language) : c.language.is_subset_of(language)) related.push_back(&c);
    for (const Candidate* c : related) {
      const bool is_nearest = std::none_of(related.begin(), related.end(), [&](const Candidate* other) {
        if (other->language == c->language) return other < c;
        return above ? other->language.is_subset_of(c->language) : c->language.is_subset_of(other->language);
      });
      if (!is_nearest) continue;
      const auto witness = above ? witness_outside(c->language, language) : witness_outside(language, c->language);
      list.push_back({c->grammar, c->form, *witness});
    }
    return list;
  };
  result.containing = nearest(true);
  result.contained = nearest(false);
  return result;
}

std::string_view describe(LightForm form) {
  return kFormNames[static_cast<std::size_t>(form)];
}

std::string describe(const Match& match) {
  std::string text = match.grammar->title;
  const auto add = [&](std::string_view piece) { text += ", " + std::string(piece); };
  if (match.form != LightForm::AsWritten) add(describe(match.form));
  if (match.within == 0) return text;
  for (const SymbolSet role : {kLights, kEyes, kEvents}) {
    const auto kept = static_cast<SymbolSet>(match.within & role);
    if (kept != role) add("of " + describe(kept) + " only");
  }
  return text;
}

}  // namespace heckbert::taxonomy
