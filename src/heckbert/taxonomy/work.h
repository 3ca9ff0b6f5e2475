#pragma once
// How much work a question about languages may take. Automata grow exponentially with innocent-looking expressions, so
// every operation counts its steps and stops with a LimitError; and since an expression of ten thousand characters asks
// for thousands of operations, what is bounded is their sum. Steps are counted, not seconds, so that what is refused on
// one machine is refused on all. The operators of languages have no room for one more argument: the limit that applies
// is the innermost one that the calling thread holds.
//
//   const WorkLimit limit(kCompileSteps);
//   ... any number of operations, which together take at most that many steps or throw ...

#include <cstddef>
#include <limits>

#include <heckbert/taxonomy/error.h>

namespace heckbert::taxonomy {

/// Steps that compiling one expression may take, some 20 ns each: looking up a move, entering a state into a set.
inline constexpr std::size_t kCompileSteps = 3'000'000;
/// Steps that one operation may take where no limit is held.
inline constexpr std::size_t kOperationSteps = 10'000'000;

/// For counting alone: the limits around it hold.
inline constexpr std::size_t kUnlimitedSteps = std::numeric_limits<std::size_t>::max();

/// The steps are used up, rather than an automaton too large.
class WorkError : public LimitError {
  using LimitError::LimitError;
};

class WorkLimit {
 public:
  /// Never more than what the limit around it has left.
  explicit WorkLimit(std::size_t steps);
  ~WorkLimit();  ///< what was spent counts for the limit around it
  WorkLimit(const WorkLimit&) = delete;
  WorkLimit& operator=(const WorkLimit&) = delete;

  /// Errors: WorkError when that is more than what is left.
  void spend(std::size_t steps) {
    if (steps > limit_ - spent_) refuse();
    spent_ += steps;
  }
  std::size_t spent() const { return spent_; }

 private:
  [[noreturn]] void refuse();

  WorkLimit* around_;
  std::size_t limit_;
  std::size_t named_;  ///< the limit that binds, as its holder stated it
  std::size_t spent_ = 0;
};

}  // namespace heckbert::taxonomy
