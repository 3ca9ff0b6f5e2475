#pragma once
// From argv to something to run. CLI11 does the parsing; what it says is turned into our exit codes, and unknown names
// into suggestions.

#include <heckbert/cli/exit_code.h>

namespace heckbert::cli {

/// The command that argv asks for; for --help and --version, one that prints. Errors: UsageError.
Run parse(int argc, const char* const* argv);

}  // namespace heckbert::cli
