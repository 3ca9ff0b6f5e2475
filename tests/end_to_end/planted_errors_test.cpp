// Verification is put to the test itself: errors are planted in the path tracer, and found in the right words; without
// one, alarm is raised as seldom as is said. At a quarter of the default picture; planted_errors_long_test.cpp has the
// whole of it.

#include <gtest/gtest.h>

#include "end_to_end/planted_errors.h"

namespace heckbert::cli {
namespace {

TEST(PlantedErrors, AreFoundInTheRightWords) {
  expect_planted_errors_are_found(
      prepared(room_of_everything(), {.width = 64, .height = 64, .samples_per_pixel = 64, .max_depth = 8}));
}

TEST(PlantedErrors, ThatAreNotThereAreNotFound) {
  // By the binomial distribution, 12 verifications at 5 % raise at most 3 alarms with a probability of 99.7 %.
  const int alarms = false_alarms(12, {.width = 32, .height = 32, .samples_per_pixel = 32, .max_depth = 6}, 0.05);
  EXPECT_LE(alarms, 3);
}

}  // namespace
}  // namespace heckbert::cli
