#pragma once
// The questions of `heckbert grammar`, one file each. Every question takes names, @names, .grammar files and
// expressions, answers as text or with --json, and ends with exit code 1 and a witness word when the answer is no.

#include <heckbert/cli/exit_code.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

// Each adds one command to the family `heckbert grammar`; when that is the one asked for, `chosen` is set to run it.
void add_grammar_list(CLI::App& family, Run& chosen);
void add_grammar_show(CLI::App& family, Run& chosen);
void add_grammar_equal(CLI::App& family, Run& chosen);
void add_grammar_subset(CLI::App& family, Run& chosen);
void add_grammar_translate(CLI::App& family, Run& chosen);
void add_grammar_disjoint(CLI::App& family, Run& chosen);
void add_grammar_partition(CLI::App& family, Run& chosen);
void add_grammar_words(CLI::App& family, Run& chosen);
void add_grammar_count(CLI::App& family, Run& chosen);
void add_grammar_identify(CLI::App& family, Run& chosen);
void add_grammar_explain(CLI::App& family, Run& chosen);
void add_grammar_dot(CLI::App& family, Run& chosen);
void add_grammar_minimize(CLI::App& family, Run& chosen);
void add_grammar_strategies(CLI::App& family, Run& chosen);
void add_grammar_lattice(CLI::App& family, Run& chosen);
void add_grammar_phases(CLI::App& family, Run& chosen);
void add_grammar_errors(CLI::App& family, Run& chosen);

}  // namespace heckbert::cli
