#pragma once
// The commands. Each has a file of its own with a plain struct of options, a function that declares them, and a
// function that runs them; here is only how they are added to the tool.

#include <heckbert/cli/exit_code.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

// Each adds one subcommand to `app`; when that is the one asked for, `chosen` is set to run it.
void add_render(CLI::App& app, Run& chosen);
void add_coverage(CLI::App& app, Run& chosen);
void add_query(CLI::App& app, Run& chosen);
void add_classify(CLI::App& app, Run& chosen);
void add_paths(CLI::App& app, Run& chosen);
void add_report(CLI::App& app, Run& chosen);
void add_match(CLI::App& app, Run& chosen);
void add_grammar(CLI::App& app, Run& chosen);
void add_scene(CLI::App& app, Run& chosen);
void add_verify(CLI::App& app, Run& chosen);
void add_why(CLI::App& app, Run& chosen);
void add_merge(CLI::App& app, Run& chosen);
void add_record_family(CLI::App& app, Run& chosen);

}  // namespace heckbert::cli
