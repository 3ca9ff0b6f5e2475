#include <heckbert/report/json_parts.h>

namespace heckbert::report {

Json document_of(std::string_view schema) {
  return {{"schema", schema}, {"schema_version", kSchemaVersion}};
}

Json to_json(const record::Estimate& estimate) {
  return {{"mean", estimate.mean},
          {"standard_error", estimate.standard_error},
          {"lower", estimate.lower},
          {"upper", estimate.upper},
          {"known", estimate.known}};
}

Json to_json(const record::SampleRange& range) {
  return {{"seed", range.seed}, {"of", range.of}, {"first", range.first}, {"last", range.last - 1}};
}

Json to_json(const record::RenderInfo& info) {
  const record::Window& window = info.window;
  Json parts = Json::array();
  for (const record::SampleRange& part : record::samples_of(info)) parts.push_back(to_json(part));
  return {{"scene", info.scene},
          {"scene_hash", info.scene_hash},
          {"algorithm", info.algorithm},
          {"method", info.method},
          {"sampler", info.sampler},
          {"filter", info.filter},
          {"width", info.width},
          {"height", info.height},
          {"window", {{"x0", window.x0}, {"y0", window.y0}, {"x1", window.x1}, {"y1", window.y1}}},
          {"samples_per_pixel", info.samples_per_pixel},
          {"seed", info.seed},
          {"samples", parts},
          {"max_depth", info.max_depth},
          {"labels", info.labels},
          {"partial", info.partial},
          {"precision", record::kPrecisions[static_cast<std::size_t>(info.precision)].name},
          {"version", info.version},
          {"ignored", info.ignored}};
}

Json to_json(const record::RenderInfo& info, const record::Tally& tally) {
  Json json = Json::object();
  for (const record::TallyFacts& facts : record::kTallyFields) json[std::string(facts.name)] = tally.*facts.field;
  json["cut_off"] = to_json(record::cut_off(info, tally));
  return json;
}

Json to_json(const std::vector<WordEnergy>& words) {
  Json list = Json::array();
  for (const WordEnergy& word : words) {
    list.push_back({{"word", word.word},
                    {"energy", to_json(word.energy)},
                    {"share", to_json(word.share)},
                    {"count", word.count},
                    {"length", word.length}});
    if (word.samples_needed) list.back()["samples_needed"] = *word.samples_needed;
  }
  return list;
}

std::string_view name_of(taxonomy::GlossyRule rule) {
  for (const taxonomy::GlossyRuleFacts& facts : taxonomy::kGlossyRules)
    if (facts.rule == rule) return facts.name;
  return {};
}

std::string dump(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace heckbert::report
