#pragma once
// Progress of a render on standard error: a bar that is redrawn on a terminal, a line every ten per cent elsewhere.

#include <cstdint>

#include <heckbert/cli/console.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {

class ProgressDisplay {
 public:
  ProgressDisplay(ProgressStyle style, int samples_per_pixel);
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;
  ~ProgressDisplay() { clear(); }

  void show(const transport::Progress& progress);
  void clear();  ///< leaves the terminal's line empty for what comes next

 private:
  ProgressStyle style_;
  int samples_per_pixel_;
  int tenths_ = 0;  ///< printed so far
  bool drawn_ = false;
};

}  // namespace heckbert::cli
