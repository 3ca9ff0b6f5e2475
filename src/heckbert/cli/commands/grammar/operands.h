#pragma once
// What the questions about grammars have in common: the languages that were named, and what can occur at all.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <heckbert/cli/settings.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::cli {

/// A language as it was named, read by the glossy rule.
struct Operand {
  std::string text;
  taxonomy::Language language;
  taxonomy::Grammar grammar;  ///< what it was before the rule was applied
  taxonomy::GlossyRule rule = taxonomy::GlossyRule::Keep;
};

/// Errors: as find_grammars.
std::vector<Operand> operands(const std::vector<std::string>& texts, const Settings& settings);
Operand operand(const std::string& text, const Settings& settings);

/// --lights, --eye, --letters and --max-depth as they were given; empty: not given.
struct ConditionFlags {
  std::string lights, eye, letters, max_depth;
  bool any() const { return !(lights.empty() && eye.empty() && letters.empty() && max_depth.empty()); }
};

void add_conditions(CLI::App& command, ConditionFlags& flags);
/// Errors: UsageError.
taxonomy::Conditions conditions_of(const ConditionFlags& flags);
/// The items of --letters, one set each; all plain events when not given. Errors: UsageError, also for items that share
/// symbols.
std::vector<taxonomy::SymbolSet> letters_of(const ConditionFlags& flags);
/// {"lights": [...], "eyes": [...], "events": [...], "max_depth": n or -1}
report::Json to_json(const taxonomy::Conditions& conditions);

/// "'LSE' can never match, because ...", or empty when it can.
std::string never_text(const Operand& operand, const taxonomy::Conditions& conditions = {});

}  // namespace heckbert::cli
