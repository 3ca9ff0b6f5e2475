#pragma once
// A verification as JSON: schema "heckbert.verify", documented in docs/json.md.

#include <heckbert/report/json_parts.h>
#include <heckbert/report/verdict.h>

namespace heckbert::report {

/// Keys "significance" to "verdicts"; who ran the algorithms adds what was rendered.
Json to_json(const Verification& verification);

}  // namespace heckbert::report
