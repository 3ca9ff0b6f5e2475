#include <heckbert/report/coverage_json.h>

#include <heckbert/report/json_parts.h>

namespace heckbert::report {

std::string coverage_json(const Coverage& coverage, const std::vector<Verdict>& verdicts) {
  Json grammars = Json::array();
  for (const GrammarCoverage& grammar : coverage.grammars) {
    grammars.push_back({{"name", grammar.name},
                        {"title", grammar.title},
                        {"source", grammar.source},
                        {"expression", grammar.expression},
                        {"expression_delta", grammar.expression_delta},
                        {"biases", grammar.biases},
                        {"variances", grammar.variances},
                        {"preconditions", grammar.preconditions},
                        {"exact", grammar.is_exact},
                        {"share", to_json(grammar.share)},
                        {"captured_energy", to_json(grammar.captured_energy)},
                        {"practical_share", grammar.practical_share},
                        {"top_captured", to_json(grammar.top_captured)},
                        {"top_missed", to_json(grammar.top_missed)}});
    if (const std::optional<WorstPixel>& worst = grammar.worst_pixel)
      grammars.back()["worst_pixel"] = {{"x", worst->x}, {"y", worst->y}, {"share", worst->share}};
  }
  Json document = document_of("heckbert.coverage");
  document["render"] = to_json(coverage.info);
  document["tally"] = to_json(coverage.info, coverage.tally);
  document["glossy_rule"] = name_of(coverage.glossy_rule);
  document["confidence"] = coverage.confidence;
  document["part"] = coverage.part.description;
  document["error"] = coverage.error;
  document["budget"] = coverage.budget;
  document["total"] = to_json(coverage.total);
  document["non_path"] = {{"ambient", coverage.ambient}, {"phantom", coverage.phantom}};
  document["grammars"] = std::move(grammars);
  document["left_out"] = Json::array();
  for (const LeftOut& grammar : coverage.left_out)
    document["left_out"].push_back({{"name", grammar.name}, {"title", grammar.title}, {"why", grammar.why}});
  document["words"] = to_json(coverage.words);
  document["requirements"] = Json::array();
  for (const Verdict& verdict : verdicts)
    document["requirements"].push_back({{"text", verdict.requirement.text},
                                        {"grammar", verdict.requirement.grammar},
                                        {"least", verdict.requirement.least},
                                        {"holds", verdict.holds},
                                        {"share", to_json(verdict.share)},
                                        {"missed", verdict.missed}});
  return dump(document);
}

}  // namespace heckbert::report
