#include <CLI/CLI.hpp>

#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/help.h>

namespace heckbert::cli {

void add_grammar(CLI::App& app, Run& chosen) {
  CLI::App* family = add_family(app, "grammar", "What algorithms capture, as languages, and questions about them");
  for (const auto add :
       {add_grammar_list, add_grammar_show, add_grammar_equal, add_grammar_subset, add_grammar_translate,
        add_grammar_disjoint, add_grammar_partition, add_grammar_words, add_grammar_count, add_grammar_identify,
        add_grammar_explain, add_grammar_dot, add_grammar_minimize, add_grammar_strategies, add_grammar_lattice,
        add_grammar_phases, add_grammar_errors})
    add(*family, chosen);
}

}  // namespace heckbert::cli
