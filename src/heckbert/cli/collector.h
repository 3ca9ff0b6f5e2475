#pragma once
// What a render has found so far, and its checkpoints: the record as it stands, marked partial, written in place of the
// last one every so many seconds. Whatever happens to the program, the last checkpoint can be read, and resumed.

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include <heckbert/record/sums.h>

namespace heckbert::cli {

class Collector {
 public:
  using Write = std::function<void(const record::Sums&)>;

  /// `begun` is what was there before; without `seconds` there are no checkpoints. `write` keeps one.
  Collector(record::Sums begun, std::optional<double> seconds, Write write);

  /// Called by one thread at a time.
  void take(record::Tile tile);
  /// All of it. Call once, at the end.
  record::Sums finish();

 private:
  using Clock = std::chrono::steady_clock;

  void add_up();

  record::Sums sums_;
  std::vector<record::Tile> tiles_;  ///< not yet in sums_
  std::size_t pixels_waiting_ = 0;   ///< of all of these
  std::optional<Clock::duration> interval_;
  Write write_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace heckbert::cli
