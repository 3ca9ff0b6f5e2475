#include <heckbert/cli/interrupt.h>

#include <csignal>

#include <unistd.h>

#include <heckbert/cli/exit_code.h>

namespace heckbert::cli {
namespace {

// A signal handler can reach nothing but globals.
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void on_signal(int /*signal*/) {
  if (stop_requested.exchange(true)) _exit(static_cast<int>(ExitCode::Interrupted));
}

}  // namespace

InterruptGuard::InterruptGuard() {
  stop_requested = false;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& InterruptGuard::stop() const {
  return stop_requested;
}

}  // namespace heckbert::cli
