// grammar errors: the table of error codes, for people who read a code somewhere and want to know.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/commands/command.h>
#include <heckbert/cli/commands/grammar/questions.h>
#include <heckbert/cli/console.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>
#include <heckbert/taxonomy/error_codes.h>

namespace heckbert::cli {
namespace {

using taxonomy::ErrorFacts;

struct ErrorsOptions {
  std::vector<std::string> codes;  ///< none: all
  bool json = false;
  SettingFlags flags;
};

void declare(CLI::App& command, ErrorsOptions& options) {
  command.add_option("CODE", options.codes, "codes such as HB201 (default: all)");
  command.add_flag("--json", options.json, "print as JSON");
  add_settings(command, options.flags, {});
}

const ErrorFacts& error_called(const std::string& text) {
  if (const ErrorFacts* found = taxonomy::find_error(text)) return *found;
  std::vector<std::string> labels;
  for (const ErrorFacts& error : taxonomy::kErrors) labels.push_back(label(error.code));
  const std::string near = nearest(text, labels);
  throw UsageError(
      fmt::format("there is no error '{}'{}", text,
                  near.empty() ? "; 'heckbert grammar errors' lists all" : fmt::format("; did you mean '{}'?", near)));
}

/// A text that has the error, on one line; nothing where that would show nothing.
std::string sample_of(const ErrorFacts& error) {
  constexpr std::size_t kLongest = 60;
  const bool is_plain = std::all_of(error.sample.begin(), error.sample.end(),
                                    [](unsigned char c) { return c >= ' ' && c != 0x7F && c != 0xFF; });
  if (error.sample.empty() || !is_plain || error.sample.size() > kLongest) return {};
  return std::string(error.sample);
}

std::string text_of(const ErrorFacts& error, const report::TextStyle& style) {
  const std::string sample = sample_of(error);
  std::string text = report::bold(fmt::format("{}: {}", label(error.code), error.title), style) + "\n" +
                     report::wrap(error.remedy, style.width, 2);
  if (!text.ends_with('\n')) text += '\n';
  if (!sample.empty())
    text += fmt::format("  For example{}: {}\n",
                        error.read_as == "heckbert" ? "" : fmt::format(", as {}", error.read_as), sample);
  return text;
}

ExitCode run(const ErrorsOptions& options) {
  const Console console(resolve(options.flags));
  std::vector<ErrorFacts> asked;
  for (const std::string& code : options.codes) asked.push_back(error_called(code));
  const bool is_list = asked.empty();
  if (is_list) asked.assign(taxonomy::kErrors.begin(), taxonomy::kErrors.end());
  if (options.json) {
    report::Json json = report::document_of("heckbert.grammar_errors");
    json["errors"] = report::Json::array();
    for (const ErrorFacts& error : asked)
      json["errors"].push_back({{"code", label(error.code)},
                                {"title", error.title},
                                {"message", error.message},
                                {"remedy", error.remedy},
                                {"read_as", error.read_as},
                                {"sample", error.sample}});
    fmt::print("{}", report::dump(json));
  } else if (is_list) {
    std::vector<report::TextRow> rows;
    for (const ErrorFacts& error : asked) rows.push_back({{label(error.code), std::string(error.title)}});
    fmt::print("{}", report::text_table({{"Code"}, {"Error"}}, rows, console.table_style()));
  } else {
    const char* separator = "";
    for (const ErrorFacts& error : asked) {
      fmt::print("{}{}", separator, text_of(error, console.table_style()));
      separator = "\n";
    }
  }
  return ExitCode::Done;
}

}  // namespace

void add_grammar_errors(CLI::App& family, Run& chosen) {
  add_command<ErrorsOptions>(family, chosen, "errors", "What the code at the end of an error means, and what to do",
                             "  heckbert grammar errors HB403\n"
                             "  heckbert grammar errors\n",
                             declare, run);
}

}  // namespace heckbert::cli
