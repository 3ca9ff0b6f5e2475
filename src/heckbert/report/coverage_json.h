#pragma once
// Coverage for programs: schema "heckbert.coverage" of docs/json.md.

#include <string>

#include <heckbert/report/coverage.h>

namespace heckbert::report {

std::string coverage_json(const Coverage& coverage);

}  // namespace heckbert::report
