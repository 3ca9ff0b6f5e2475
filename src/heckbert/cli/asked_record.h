#pragma once
// What the commands that ask a record have in common: the argument that names it, the grammars it is asked for, and
// what is said about it before the answer.

#include <string>
#include <vector>

#include <heckbert/cli/console.h>
#include <heckbert/record/record.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

/// Adds the argument RECORD.
void add_record(CLI::App& command, std::string& name);

/// Adds --grammar, for the texts of find_to_cover().
void add_grammars(CLI::App& command, std::vector<std::string>& texts);

/// Tells the console what a record was rendered from and what is wrong with it.
void introduce(const record::Record& record, const Console& console);

}  // namespace heckbert::cli
