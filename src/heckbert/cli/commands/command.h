#pragma once
// How a command is put together: a plain struct of options, a function that declares them as flags and arguments, and a
// function that runs with what was given.

#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include <heckbert/cli/exit_code.h>

namespace heckbert::cli {

/// Adds `name` to `parent`. When the command line asks for it, `chosen` will run `run` with the options given.
template <class Options>
void add_command(CLI::App& parent, Run& chosen, const std::string& name, const std::string& summary,
                 const std::string& examples, void (*declare)(CLI::App&, Options&), ExitCode (*run)(const Options&)) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand(name, summary);
  declare(*command, *options);
  command->group("Commands")->footer("Examples:\n" + examples);
  command->callback([&chosen, options, run] { chosen = [options, run] { return run(*options); }; });
}

}  // namespace heckbert::cli
