#include <heckbert/cli/never.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/contradiction.h>

namespace heckbert::cli {
namespace {

using taxonomy::Conditions;
using taxonomy::GlossyRule;
using taxonomy::Grammar;

/// Why the language is empty, whatever the conditions.
std::optional<std::string> why_empty(const Grammar& grammar, GlossyRule rule) {
  if (!grammar.language.is_empty())
    return fmt::format("all its words have G, and --glossy {} reads that as another letter", report::name_of(rule));
  return taxonomy::why_empty(grammar.expression, grammar.dialect, taxonomy::builtin_grammars().names());
}

std::string text_of(const Grammar& grammar, GlossyRule rule, const Conditions& conditions, std::string_view place) {
  const taxonomy::Language language = taxonomy::apply(rule, grammar.language);
  auto reason = taxonomy::why_never(language, conditions);
  if (!reason) return {};
  if (language.is_empty()) {
    reason = why_empty(grammar, rule).value_or(*reason);
    place = "can never match";
  }
  return fmt::format("'{}' {}, because {}", grammar.name, place, *reason);
}

}  // namespace

std::string never_text(const Grammar& grammar, GlossyRule rule, const Conditions& conditions) {
  return text_of(grammar, rule, conditions, "can never match");
}

std::optional<Conditions> conditions_of(const record::Record& record) {
  if (record.words.empty()) return {};
  unsigned seen = 0;
  std::size_t longest = static_cast<std::size_t>(record.info.max_depth);
  for (const taxonomy::Word& word : record.words) {
    seen |= taxonomy::single(word.light) | taxonomy::single(word.eye);
    for (const taxonomy::Symbol event : word.events) seen |= taxonomy::single(event);
    longest = std::max(longest, word.length());
  }
  return Conditions{.lights = static_cast<taxonomy::SymbolSet>(seen & taxonomy::kLights),
                    .events = static_cast<taxonomy::SymbolSet>(seen & taxonomy::kEvents),
                    .eyes = static_cast<taxonomy::SymbolSet>(seen & taxonomy::kEyes),
                    .max_length = longest};
}

std::string never_in_record(const Grammar& grammar, GlossyRule rule, const std::optional<Conditions>& conditions) {
  if (!conditions) return never_text(grammar, rule);
  return text_of(grammar, rule, *conditions, "matches nothing in this record");
}

}  // namespace heckbert::cli
