#include <heckbert/cli/scenes.h>

#include <fmt/format.h>

#include <heckbert/cli/files.h>

namespace heckbert::cli {

import::Imported load_scene(const std::string& name){
    if (name == "-") return import::read_json_scene(read_text(name), "standard input", ".");
return import::load_scene_or_builtin(name);
}  // namespace heckbert::cli

std::string account_lines(const std::vector<std::string>& sentences, std::string_view label) {
  std::string text;
  for (const std::string& sentence : sentences) text += fmt::format("  {:<12}{}\n", label, sentence);
  return text;
}

report::Json to_json(const import::Account& account) {
  return {{"understood", account.understood}, {"guessed", account.guessed}, {"ignored", account.ignored}};
}

}  // namespace heckbert::cli
