#pragma once
// Coverage for programs: schema "heckbert.coverage" of docs/json.md.

#include <string>

#include <heckbert/report/coverage.h>
#include <heckbert/report/requirement.h>

namespace heckbert::report {

std::string coverage_json(const Coverage& coverage, const std::vector<Verdict>& verdicts = {});

}  // namespace heckbert::report
