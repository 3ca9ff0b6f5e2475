#include <heckbert/report/coverage_json.h>

#include <heckbert/report/json_parts.h>

namespace heckbert::report {

std::string coverage_json(const Coverage& coverage) {
  Json grammars = Json::array();
  for (const GrammarCoverage& grammar : coverage.grammars)
    grammars.push_back({{"name", grammar.name},
                        {"title", grammar.title},
                        {"source", grammar.source},
                        {"expression", grammar.expression},
                        {"expression_delta", grammar.expression_delta},
                        {"biases", grammar.biases},
                        {"variances", grammar.variances},
                        {"preconditions", grammar.preconditions},
                        {"share", to_json(grammar.share)},
                        {"captured_energy", to_json(grammar.captured_energy)},
                        {"top_captured", to_json(grammar.top_captured)},
                        {"top_missed", to_json(grammar.top_missed)}});
  Json document = document_of("heckbert.coverage");
  document["render"] = to_json(coverage.info);
  document["tally"] = to_json(coverage.tally);
  document["glossy_rule"] = name_of(coverage.glossy_rule);
  document["confidence"] = coverage.confidence;
  document["total"] = to_json(coverage.total);
  document["non_path"] = {{"ambient", coverage.ambient}, {"phantom", coverage.phantom}};
  document["grammars"] = std::move(grammars);
  document["left_out"] = Json::array();
  for (const LeftOut& grammar : coverage.left_out)
    document["left_out"].push_back({{"name", grammar.name}, {"title", grammar.title}, {"why", grammar.why}});
  document["words"] = to_json(coverage.words);
  return dump(document);
}

}  // namespace heckbert::report
