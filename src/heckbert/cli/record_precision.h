#pragma once
// --record-precision, of the commands that write records.

#include <string>

#include <heckbert/record/record.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

/// Adds the option with its default.
void add_precision(CLI::App& command, std::string& text);

/// Errors: UsageError.
record::Precision precision_of(const std::string& text);

}  // namespace heckbert::cli
