// The whole of the coverage table for one record, as a person sees it. After a wanted change, look at the new text in
// the failure message and copy it to the golden file.

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <heckbert/report/coverage_text.h>

#include "report/sample_record.h"

namespace heckbert::report {
namespace {

TEST(CoverageText, LooksLikeTheGoldenFile) {
  std::ifstream file(HECKBERT_SOURCE_DIR "/tests/report/coverage.golden.txt");
  ASSERT_TRUE(file) << "the golden file is missing";
  std::stringstream golden;
  golden << file.rdbuf();
  const Coverage data = coverage(test::lecture_like_record(32, 32), test::four_grammars());
  EXPECT_EQ(coverage_text(data, {.width = 88}, 6), golden.str());
}

}  // namespace
}  // namespace heckbert::report
