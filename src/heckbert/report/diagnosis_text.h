#pragma once
// A diagnosis for the terminal, as JSON (schema "heckbert.why", documented in docs/json.md), and its candidates as a
// plot.

#include <cstddef>
#include <string>

#include <heckbert/report/diagnosis.h>
#include <heckbert/report/json_parts.h>
#include <heckbert/report/text_table.h>

namespace heckbert::report {

/// At most `most` words that cannot be found, and as many that are too rare.
std::string diagnosis_text(const Diagnosis& diagnosis, const TextStyle& style = {}, std::size_t most = 8);

/// Keys "algorithm" to "candidates"; who ran the algorithms adds what was rendered.
Json to_json(const Diagnosis& diagnosis);

/// Captured share over measured time, an SVG document.
std::string candidates_svg(const Diagnosis& diagnosis);

}  // namespace heckbert::report
