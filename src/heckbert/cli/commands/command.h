#pragma once
// How a command is put together: a plain struct of options, a function that declares them as flags and arguments, and a
// function that runs with what was given.

#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include <heckbert/cli/choice.h>
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

/// Adds a flag that takes a whole number. Errors while parsing: UsageError.
inline void add_count(CLI::App& command, const std::string& flag, std::size_t& count, const std::string& help) {
  constexpr std::uint64_t kMost = 1'000'000'000;
  const auto read = [flag, &count](const std::string& text) {
    count = value_of_flag(flag, [&] { return whole_number(text, 0, kMost); });
  };
  command.add_option_function<std::string>(flag, read, help)->type_name("N");
}

}  // namespace heckbert::cli
