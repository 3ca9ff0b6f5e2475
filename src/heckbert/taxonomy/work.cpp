#include <heckbert/taxonomy/work.h>

#include <algorithm>
#include <string>

namespace heckbert::taxonomy {

namespace {

thread_local WorkLimit* innermost = nullptr;

}  // namespace

WorkLimit::WorkLimit(std::size_t steps) : around_(innermost), limit_(steps), named_(steps) {
  if (around_ != nullptr) {
    const std::size_t left = around_->limit_ - around_->spent_;
    if (left < limit_) named_ = around_->named_;
    limit_ = std::min(limit_, left);
  }
  innermost = this;
}

WorkLimit::~WorkLimit() {
  innermost = around_;
  if (around_ != nullptr) around_->spent_ += spent_;
}

// What is refused is not done; but nothing else gets done either.
void WorkLimit::refuse() {
  spent_ = limit_;
  throw WorkError("building the automaton takes more than " + std::to_string(named_) + " steps");
}

}  // namespace heckbert::taxonomy
