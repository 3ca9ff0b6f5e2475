#pragma once
// What a script demands of a record: that an algorithm captures at least some share of the light. It holds when the
// lower end of the share's interval reaches it, so that noise does not decide.

#include <string>
#include <vector>

#include <heckbert/report/coverage.h>

namespace heckbert::report {

struct Requirement {
  std::string text;     ///< as given: "whitted>=0.95"
  std::string grammar;  ///< its name in the coverage
  double least = 0;     ///< share
};

struct Verdict {
  Requirement requirement;
  bool holds = false;
  record::Estimate share;
  std::vector<std::string> missed;  ///< words, by energy, most first: what stands in the way; none when it holds
};

/// In the order of the requirements. Errors: std::out_of_range for a grammar that the coverage lacks.
std::vector<Verdict> judge(const Coverage& coverage, const std::vector<Requirement>& requirements);

/// "whitted>=0.95 does not hold: ... captures 62.6 %, surely no more than ...; it misses LDDE 16.6 %, ...".
std::string sentence(const Verdict& verdict, const Coverage& coverage);

}  // namespace heckbert::report
