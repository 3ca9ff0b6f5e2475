#include <heckbert/cli/help.h>

#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <heckbert/cli/exit_code.h>

namespace heckbert::cli {
namespace {

class HelpFormatter final : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(32);
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_description(const CLI::App* app) const override { return app->get_description() + "\n\n"; }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    return CLI::detail::find_and_replace(text, "\n\n\n", "\n\n");  // CLI11 doubles some blank lines
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool many = option->get_positional() && option->get_expected_max() == CLI::detail::expected_max_vector_size;
    const bool named = option->get_positional();
    return (named || option->get_type_name().empty() ? "" : " " + option->get_type_name()) + (many ? " ..." : "");
  }
};

std::string exit_codes() {
  std::string text = "Exit codes:\n";
  for (const ExitCodeFacts& facts : kExitCodes)
    text += fmt::format("  {:<4} {}\n", static_cast<int>(facts.code), facts.meaning);
  return text;
}

constexpr const char* kEachCommand = "Each command has a page of its own: add --help\n";

}  // namespace

CLI::App* add_family(CLI::App& parent, const std::string& name, const std::string& summary) {
  CLI::App* family = parent.add_subcommand(name, summary);
  family->group("Commands")->require_subcommand(1)->footer(kEachCommand);
  return family;
}

void style_help(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_help_ptr()->description("print this help");
  app.footer(std::string(kEachCommand) +
             "Results go to standard output, all else to standard error; '-' is a file name for either stream.\n"
             "Settings may also come from variables, HECKBERT_SPP=64, or from a --config file, spp = 64.\n\n" +
             exit_codes());
}

}  // namespace heckbert::cli
