#include <heckbert/cli/layers.h>

#include <string>
#include <utility>

#include <fmt/format.h>

#include <heckbert/cli/never.h>
#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/simplest.h>

namespace heckbert::cli {

std::vector<ClassOfRecord> classes_of(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                                      taxonomy::GlossyRule rule, double confidence) {
  const std::vector<bool> all(record.words.size(), true);
  std::vector<ClassOfRecord> classes;
  for (const taxonomy::Grammar& grammar : grammars) {
    ClassOfRecord item;
    item.grammar = grammar;
    item.canonical = taxonomy::simplest_expression(grammar.language).value_or("");
    item.never = never_text(grammar, rule, record);
    item.members = record::members(record, grammar.language, rule);
    item.energy = record::energy(record, item.members, confidence);
    item.share = record::share(record, item.members, all, confidence);
    for (const bool member : item.members) item.words += member ? 1 : 0;
    for (const record::Entry& entry : record.entries)
      if (item.members[entry.word]) item.count += entry.count;
    classes.push_back(std::move(item));
  }
  return classes;
}

std::vector<record::Layer> layers_of(const record::Record& record, const std::vector<ClassOfRecord>& classes,
                                     taxonomy::GlossyRule rule, bool first_unnamed) {
  std::vector<record::Layer> layers;
  std::vector<std::string> taken;
  for (const ClassOfRecord& item : classes) {
    record::Layer layer;
    layer.image = record::image_of(record, item.members);
    if (!layers.empty() || !first_unnamed) layer.name = record::layer_name(item.grammar.name, taken);
    taken.push_back(layer.name);
    layer.attributes["expression"] = item.grammar.expression;
    if (!item.grammar.expression_delta.empty()) layer.attributes["expression_delta"] = item.grammar.expression_delta;
    layer.attributes["dialect"] = std::string(taxonomy::facts(item.grammar.dialect).name);
    if (!item.canonical.empty()) layer.attributes["canonical"] = item.canonical;
    layer.attributes["glossy"] = std::string(report::name_of(rule));
    layers.push_back(std::move(layer));
  }
  return layers;
}

void add_non_path_layers(const record::Record& record, std::vector<record::Layer>& layers) {
  const auto add = [&](const std::string& name, const std::vector<Rgb>& pixels) {
    if (pixels.empty()) return;
    std::vector<std::string> taken;
    for (const record::Layer& layer : layers) taken.push_back(layer.name);
    layers.push_back({record::layer_name(name, taken),
                      {record.info.window, pixels},
                      {{"note", "no light path; not part of the picture"}}});
  };
  add("ambient", record.ambient);
  add("phantom", record.phantom);
}

std::string describe(const ClassOfRecord& item) {
  const bool named = item.grammar.name != item.grammar.expression;
  return fmt::format("{}{}: {} of the energy, {}", named ? item.grammar.name + " = " : "", item.grammar.expression,
                     report::percent(item.share.mean), report::percent_interval(item.share));
}

std::string classes_text(const std::vector<ClassOfRecord>& classes, const report::TextStyle& style) {
  using report::Align;
  std::vector<report::TextRow> rows;
  for (const ClassOfRecord& item : classes) {
    rows.push_back(
        {.cells = {item.grammar.name, report::percent(item.share.mean), report::bracketed_percent(item.share),
                   report::number(item.energy.mean), report::grouped(item.count), report::grouped(item.words)},
         .bar = item.share.mean});
    if (item.grammar.name != item.grammar.expression) rows.back().notes.push_back(item.grammar.expression);
  }
  return report::text_table({{"Class"},
                             {"Share", Align::Right},
                             {"Interval in %", Align::Right},
                             {"Energy", Align::Right},
                             {"Count", Align::Right},
                             {"Words", Align::Right}},
                            rows, style);
}

report::Json to_json(const std::vector<ClassOfRecord>& classes) {
  report::Json list = report::Json::array();
  for (const ClassOfRecord& item : classes)
    list.push_back({{"name", item.grammar.name},
                    {"expression", item.grammar.expression},
                    {"dialect", taxonomy::facts(item.grammar.dialect).name},
                    {"canonical", item.canonical},
                    {"never", item.never},
                    {"energy", report::to_json(item.energy)},
                    {"share", report::to_json(item.share)},
                    {"words", item.words},
                    {"count", item.count}});
  return list;
}

}  // namespace heckbert::cli
