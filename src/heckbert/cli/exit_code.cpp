#include <heckbert/cli/exit_code.h>

#include <cstdio>
#include <exception>
#include <new>

#include <fmt/core.h>

#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

ExitCode fail(ExitCode code, std::string_view message) {
  fmt::print(stderr, "heckbert: error: {}\n", message);
  return code;
}

}  // namespace

ExitCode guarded(const Run& run) {
  try {
    const ExitCode code = run();
    // A full disk or a closed pipe behind standard output shows only when the last bytes are pushed out.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw WriteError("standard output: cannot be written");
    return code;
  } catch (const UsageError& error) {
    return fail(ExitCode::Usage, error.what());
  } catch (const InputError& error) {
    fmt::print(stderr, "{}", error.what());  // already file:line:column: error: ..., newline-terminated
    return ExitCode::BadInput;
  } catch (const ReadError& error) {
    return fail(ExitCode::BadInput, error.what());
  } catch (const WriteError& error) {
    return fail(ExitCode::CannotWrite, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Failed, "out of memory; try a smaller --size, or a --crop");
  } catch (const std::exception& error) {
    return fail(ExitCode::Failed, error.what());
  }
}

}  // namespace heckbert::cli
