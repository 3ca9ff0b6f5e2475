#include <fmt/format.h>

#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/grammar_text.h>

namespace heckbert::cli {
namespace {

struct ListOptions {
  bool json = false;
  SettingFlags flags;
};

void declare_list(CLI::App& command, ListOptions& options) {
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

ExitCode run_list(const ListOptions& options) {
  const Console console(resolve(options.flags));
  const taxonomy::GrammarLibrary& library = taxonomy::builtin_grammars();
  fmt::print("{}", options.json ? report::grammar_list_json(library)
                                : report::grammar_list_text(library, console.table_style()));
  return ExitCode::Done;
}

}  // namespace

void add_grammar_list(CLI::App& family, Run& chosen) {
  add_command<ListOptions>(family, chosen, "list", "The built-in algorithms and classes", "  heckbert grammar list\n",
                           declare_list, run_list);
}

}  // namespace heckbert::cli
