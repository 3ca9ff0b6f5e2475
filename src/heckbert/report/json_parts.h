#pragma once
// The pieces that the JSON documents of this layer share. docs/json.md documents every key; a test compares.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include <heckbert/record/record.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/coverage.h>
#include <heckbert/taxonomy/glossy_rule.h>

namespace heckbert::report {

using Json = nlohmann::ordered_json;  ///< keys in the order they were written, so that the text is stable

/// Version of every schema of this layer; goes up when a key changes its meaning or disappears.
inline constexpr int kSchemaVersion = 1;

Json document_of(std::string_view schema);  ///< {"schema": ..., "schema_version": ...}
Json to_json(const record::Estimate& estimate);
/// `last` is the last sample itself, not the one behind it.
Json to_json(const record::SampleRange& range);
Json to_json(const record::RenderInfo& info);
Json to_json(const record::RenderInfo& info, const record::Tally& tally);
Json to_json(const std::vector<WordEnergy>& words);
std::string_view name_of(taxonomy::GlossyRule rule);

/// Indented by two, ending in a newline. Bytes that are not UTF-8 (file names) become U+FFFD.
std::string dump(const Json& document);

}  // namespace heckbert::report
