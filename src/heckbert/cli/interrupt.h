#pragma once
// Ctrl-C while rendering: the first asks the render to stop, so that what is there can be written; a second one quits
// at once.

#include <atomic>

namespace heckbert::cli {

/// From its construction until the end of its life, SIGINT and SIGTERM set stop(). One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  const std::atomic<bool>& stop() const;
};

}  // namespace heckbert::cli
