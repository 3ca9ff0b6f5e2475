#pragma once
// Grammars for people and programs: `grammar list` and `grammar show`.

#include <string>

#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/grammar.h>

namespace heckbert::report {

/// The teaching set, further algorithms, what has no language, classes: each grammar on one line with its name, its row
/// in the table of algorithms and what it captures.
std::string grammar_list_text(const taxonomy::GrammarLibrary& library, const TextStyle& style = {});
/// Schema "heckbert.grammars".
std::string grammar_list_json(const taxonomy::GrammarLibrary& library);

/// One grammar with all that its file says, the size of its automaton and its shortest word.
std::string grammar_text(const taxonomy::Grammar& grammar, const TextStyle& style = {});

}  // namespace heckbert::report
