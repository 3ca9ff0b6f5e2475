#include <heckbert/cli/account.h>

#include <fmt/format.h>

namespace heckbert::cli {

std::string account_lines(const std::vector<std::string>& sentences, std::string_view label) {
  std::string text;
  for (const std::string& sentence : sentences) text += fmt::format("  {:<12}{}\n", label, sentence);
  return text;
}

report::Json to_json(const import::Account& account) {
  return {{"understood", account.understood}, {"guessed", account.guessed}, {"ignored", account.ignored}};
}

}  // namespace heckbert::cli
