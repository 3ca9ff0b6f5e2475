#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/help.h>

namespace heckbert::cli {

void add_grammar(CLI::App& app, Run& chosen) {
  CLI::App* family = add_family(app, "grammar", "What algorithms capture, as languages: list, show, compare");
  for (const auto add : {add_grammar_list, add_grammar_show, add_grammar_equal, add_grammar_subset})
    add(*family, chosen);
}

}  // namespace heckbert::cli
