#include <heckbert/cli/record_precision.h>

#include <CLI/CLI.hpp>

#include <heckbert/cli/choice.h>

namespace heckbert::cli {

namespace {
constexpr const char* kName = "--record-precision";
}

void add_precision(CLI::App& command, std::string& text) {
  text = record::kPrecisions.front().name;
  command.add_option(kName, text, "of energies in pixels (default: half; with sums: float)")
      ->type_name(alternatives(record::kPrecisions));
}

record::Precision precision_of(const std::string& text) {
  return choose_flag(kName, text, record::kPrecisions).precision;
}

}  // namespace heckbert::cli
