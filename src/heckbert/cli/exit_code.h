#pragma once
// Exit codes, and the one border where exceptions become messages and codes.

#include <array>
#include <functional>
#include <stdexcept>
#include <string_view>

namespace heckbert::cli {

enum class ExitCode : int { Done = 0, No = 1, Usage = 2, BadInput = 3, Failed = 4, CannotWrite = 5, Interrupted = 130 };

struct ExitCodeFacts {
  ExitCode code;
  std::string_view meaning;
};

inline constexpr std::array<ExitCodeFacts, 7> kExitCodes{{
    {ExitCode::Done, "done, or the answer is yes"},
    {ExitCode::No, "the answer is no: a word does not match, a statement on grammars or algorithms does not hold"},
    {ExitCode::Usage, "the command line, or a HECKBERT_ variable, is not understood"},
    {ExitCode::BadInput, "an input (scene, record, expression, word, grammar, config file) is wrong or cannot be read"},
    {ExitCode::Failed, "failed while running"},
    {ExitCode::CannotWrite, "an output cannot be written"},
    {ExitCode::Interrupted, "interrupted; what was there is written, marked partial"},
}};

/// What was typed is no command of this tool.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something to run once the command line is understood.
using Run = std::function<ExitCode()>;

/// Runs, and turns any exception into a message on standard error and its code.
ExitCode guarded(const Run& run);

}  // namespace heckbert::cli
