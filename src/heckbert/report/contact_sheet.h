#pragma once
// All of a coverage in one picture: the render and its facts, then a row per algorithm with what it captures on the
// left and what it misses on the right, all at one exposure.

#include <optional>

#include <heckbert/record/record.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/picture.h>

namespace heckbert::report {

struct ContactSheetOptions {
  std::optional<float> exposure{};  ///< else auto_exposure() of the beauty
  int picture_width = 512;          ///< of each picture, at most; small ones are enlarged by whole factors
};

/// `coverage` must come from `record`. Time: one image of the record per picture.
Picture contact_sheet(const record::Record& record, const Coverage& coverage, const ContactSheetOptions& options = {});

}  // namespace heckbert::report
