#pragma once
// "'LSE' can never match, because ...": said by every command whose answer is emptier than its user expects.

#include <string>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/possible.h>

namespace heckbert::cli {

/// Why no path of the grammar is possible under these conditions, once G is read by the rule; empty when one is.
std::string never_text(const taxonomy::Grammar& grammar, taxonomy::GlossyRule rule,
                       const taxonomy::Conditions& conditions = {});

/// As never_text for the lights, eyes and events that occur in a record, and for the depth it was rendered to.
std::string never_text(const taxonomy::Grammar& grammar, taxonomy::GlossyRule rule, const record::Record& record);

}  // namespace heckbert::cli
