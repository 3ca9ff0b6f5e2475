#include <heckbert/cli/asked_record.h>

#include <CLI/CLI.hpp>

#include <heckbert/report/facts.h>

namespace heckbert::cli {

void add_record(CLI::App& command, std::string& name) {
  command.add_option("RECORD", name, "a record written by 'heckbert render --record'")->required();
}

void add_grammars(CLI::App& command, std::vector<std::string>& texts) {
  command.add_option("--grammar", texts, "name, .grammar file, expression or 'all' (default: the teaching set)")
      ->type_name("GRAMMAR")
      ->allow_extra_args(false);
}

void introduce(const record::Record& record, const Console& console) {
  console.detail(report::summary(record.info));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  console.note(report::folding(record));
}

}  // namespace heckbert::cli
