#pragma once
// "'LSE' can never match, because ...": said by every command whose answer is emptier than its user expects.

#include <optional>
#include <string>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::cli {

/// Why no path of the grammar is possible under these conditions, once G is read by the rule; empty when one is.
std::string never_text(const taxonomy::Grammar& grammar, taxonomy::GlossyRule rule,
                       const taxonomy::Conditions& conditions = {});

/// The lights, eyes and events that occur in a record, and the depth it was rendered to; nothing of one without words.
/// O(words).
std::optional<taxonomy::Conditions> conditions_of(const record::Record& record);
/// As never_text for a record of these conditions.
std::string never_in_record(const taxonomy::Grammar& grammar, taxonomy::GlossyRule rule,
                            const std::optional<taxonomy::Conditions>& conditions);

}  // namespace heckbert::cli
