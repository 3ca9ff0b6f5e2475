#pragma once
// How help pages look.

#include <string>

namespace CLI {
class App;
}

namespace heckbert::cli {

/// Gives the tool, and the subcommands added afterwards, help pages without CLI11's type names and REQUIRED marks.
void style_help(CLI::App& app);

/// Adds a command that has commands, such as 'grammar'.
CLI::App* add_family(CLI::App& parent, const std::string& name, const std::string& summary);

}  // namespace heckbert::cli
