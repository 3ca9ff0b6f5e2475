#include <heckbert/report/verdict_json.h>
#include <heckbert/taxonomy/symbol_set.h>

#include <cmath>

namespace heckbert::report {
namespace {

Json json_of(const record::Window& pixels) {
  return {{"x0", pixels.x0}, {"y0", pixels.y0}, {"x1", pixels.x1}, {"y1", pixels.y1}};
}

/// Without the number of standard errors where there is no spread to count in.
void add(Json& json, const Comparison& comparison) {
  json["expected"] = to_json(comparison.expected);
  json["found"] = to_json(comparison.found);
  if (std::isfinite(comparison.standard_errors)) json["standard_errors"] = comparison.standard_errors;
  json["p_value"] = comparison.p_value;
}

Json json_of(const Sequence& sequence) {
  Json json = {{"ratios", Json::array()}, {"p_value", sequence.p_value}};
  for (const record::Estimate& ratio : sequence.ratios) json["ratios"].push_back(to_json(ratio));
  if (sequence.order) json["order"] = to_json(*sequence.order);
  return json;
}

Json json_of(const WordFinding& word) {
  Json json = {{"word", word.word},
               {"pooled", word.pooled},
               {"length", word.length},
               {"standing", facts(word.standing).name},
               {"witness", word.witness},
               {"expected_count", word.expected_count},
               {"found_count", word.found_count}};
  add(json, word.comparison);
  if (word.ratio) json["ratio"] = to_json(*word.ratio);
  if (word.sequence) json["sequence"] = json_of(*word.sequence);
  json["blocks_compared"] = word.blocks_compared;
  json["blocks_that_differ"] = word.blocks_that_differ;
  if (word.worst_block) {
    json["worst_block"] = {{"pixels", json_of(word.worst_block->pixels)}};
    add(json["worst_block"], word.worst_block->comparison);
    if (word.worst_block->sequence) json["worst_block"]["sequence"] = json_of(*word.worst_block->sequence);
  }
  if (word.brightest)
    json["brightest"] = {{"x", word.brightest->x}, {"y", word.brightest->y}, {"luminance", word.brightest->luminance}};
  if (word.samples_needed && std::isfinite(*word.samples_needed)) json["samples_needed"] = *word.samples_needed;
  return json;
}

Json json_of(const AlgorithmVerdict& verdict) {
  Json json = {{"algorithm", verdict.algorithm},
               {"title", verdict.title},
               {"grammar", verdict.grammar},
               {"light", taxonomy::name(verdict.light)},
               {"samples_per_pixel", verdict.samples_per_pixel},
               {"verdict", facts(verdict.ruling).name},
               {"expected", verdict.is_expected},
               {"shortest", verdict.shortest}};
  if (verdict.ratio) json["ratio"] = to_json(*verdict.ratio);
  if (!verdict.refined_by.empty()) {
    json["refined_by"] = verdict.refined_by;
    json["sizes"] = verdict.sizes;
  }
  if (verdict.samples_needed) json["samples_needed"] = *verdict.samples_needed;
  json["words"] = Json::array();
  for (const WordFinding& word : verdict.words) json["words"].push_back(json_of(word));
  return json;
}

}  // namespace

Json to_json(const Verification& verification) {
  const VerdictOptions& options = verification.options;
  Json json = {{"significance", options.significance},
               {"comparisons", verification.comparisons},
               {"confidence", options.confidence},
               {"error", options.error},
               {"budget", options.budget},
               {"verdicts", Json::array()}};
  for (const AlgorithmVerdict& verdict : verification.verdicts) json["verdicts"].push_back(json_of(verdict));
  return json;
}

}  // namespace heckbert::report
