#include <heckbert/cli/command_line.h>

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <heckbert/cli/commands/commands.h>
#include <heckbert/cli/help.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

/// The deepest command that was recognised: the one that an error is about.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost(*chosen.front());
}

/// "heckbert grammar show"
std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent == nullptr ? "" : full_name(*parent) + " ") + command.get_name();
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& candidates) {
  const std::string near = nearest(given, candidates);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

/// What is wrong with a word that no command took.
std::string unexpected(const std::string& word, const CLI::App& command) {
  if (word.starts_with('-')) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    return fmt::format("there is no flag '{}'{}", word, did_you_mean(word.substr(0, word.find('=')), flags));
  }
  const std::vector<std::string> commands = names_of(command.get_subcommands({}));
  if (commands.empty()) return fmt::format("'{}' is one argument too many", word);
  return fmt::format("there is no command '{}'{}", word, did_you_mean(word, commands));
}

/// CLI11's own words, but for the commonest mistake: "--spp: 1 required N missing".
std::string message_of(const CLI::ParseError& error) {
  const std::string text = error.what();
  const bool lacks_value = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && text.ends_with(" missing");
  return lacks_value ? text.substr(0, text.find(':')) + " needs a value" : text;
}

[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const std::vector<std::string> leftover = app.remaining(true);
  // Of several words left over, flags are the culprits: what follows an unknown flag may have been its value.
  const auto flag = std::find_if(leftover.begin(), leftover.end(), [](const auto& w) { return w.starts_with('-'); });
  std::string message = message_of(error);
  if (!leftover.empty())
    message = unexpected(flag != leftover.end() ? *flag : leftover.front(), command);
  else if (command.get_subcommands().empty() && command.get_require_subcommand_min() > 0)
    message = fmt::format("which command? One of {}", fmt::join(names_of(command.get_subcommands({})), ", "));
  throw UsageError(fmt::format("{}\nsee '{} --help'", message, full_name(command)));
}

}  // namespace

Run parse(int argc, const char* const* argv) {
  Run chosen;
  CLI::App app("Light paths by name: renders a scene once, then answers any question about its paths.", "heckbert");
  style_help(app);
  app.set_version_flag("--version", std::string("heckbert ") + HECKBERT_VERSION, "print the version");
  app.require_subcommand(1);
  for (const auto add : {add_render, add_coverage, add_query, add_classify, add_paths, add_report, add_match,
                         add_grammar, add_scene, add_merge, add_record_family, add_verify, add_why})
    add(app, chosen);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    const bool version = dynamic_cast<const CLI::CallForVersion*>(&asked) != nullptr;
    const std::string text = version ? std::string(asked.what()) + "\n" : app.help();
    return [text] {
      fmt::print("{}", text);
      return ExitCode::Done;
    };
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  return chosen;
}

}  // namespace heckbert::cli
