#include <heckbert/cli/layers.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <heckbert/cli/never.h>
#include <heckbert/report/cryptomatte.h>
#include <heckbert/report/energies.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/simplest.h>

namespace heckbert::cli {

namespace {

/// A short expression of the language, in Heckbert's notation; empty when none is known.
std::string canonical(const ClassOfRecord& item) {
  return taxonomy::simplest_expression(item.grammar.language).value_or("");
}

/// By language: words of the record that it has.
std::vector<std::size_t> word_counts(const record::Outcomes& outcomes, std::size_t languages) {
  std::vector<std::size_t> of_outcome(outcomes.members.size()), counts(languages);
  for (const std::uint32_t outcome : outcomes.of_word) ++of_outcome[outcome];
  for (std::size_t outcome = 0; outcome < of_outcome.size(); ++outcome)
    for (std::size_t language = 0; language < languages; ++language)
      if (outcomes.members[outcome][language]) counts[language] += of_outcome[outcome];
  return counts;
}

/// Takes what a folded record does not know of a class out of it.
void set_undecided(const record::Record& record, const report::Energies& energies, taxonomy::GlossyRule rule,
                   ClassOfRecord& item, report::GroupEnergy& group) {
  report::Members members = report::members_of(record, item.grammar.language, rule);
  if (members.is_exact()) return;
  group = energies.of_members(members);
  item.members = std::move(members.certain);
  item.undecided = std::move(members.undecided);
  item.words = static_cast<std::size_t>(std::count(item.members.begin(), item.members.end(), true));
}

}  // namespace

std::vector<ClassOfRecord> classes_of(const record::Record& record, const std::vector<taxonomy::Grammar>& grammars,
                                      taxonomy::GlossyRule rule, double confidence) {
  std::vector<taxonomy::Language> languages;
  for (const taxonomy::Grammar& grammar : grammars) languages.push_back(grammar.language);
  const record::Outcomes outcomes = record::outcomes(record, languages, rule);
  std::vector<std::vector<bool>> members = record::sets_of(outcomes, languages.size());
  const report::Energies energies(record, confidence);
  const std::vector<report::GroupEnergy> groups = energies.of_outcomes(outcomes, languages.size());
  const std::vector<std::size_t> words = word_counts(outcomes, languages.size());
  const std::optional<taxonomy::Conditions> conditions = conditions_of(record);
  std::vector<ClassOfRecord> classes;
  for (std::size_t i = 0; i < grammars.size(); ++i) {
    ClassOfRecord item;
    item.grammar = grammars[i];
    item.members = std::move(members[i]);
    report::GroupEnergy group = groups[i];
    item.words = words[i];
    if (record.folding) set_undecided(record, energies, rule, item, group);
    item.energy = group.energy;
    item.share = group.share;
    item.count = group.count;
    if (item.words == 0 && item.undecided.empty()) item.never = never_in_record(item.grammar, rule, conditions);
    classes.push_back(std::move(item));
  }
  return classes;
}

std::vector<record::Image> images_of(const record::Record& record, const record::Rows& rows,
                                     const std::vector<ClassOfRecord>& classes) {
  std::vector<std::vector<bool>> sets;
  sets.reserve(classes.size() + 1);
  for (const ClassOfRecord& item : classes) sets.push_back(item.members);
  sets.emplace_back(record.words.size(), true);
  return record::images_of(record, rows, sets);
}

std::vector<record::Layer> layers_of(std::span<const record::Image> images, const std::vector<ClassOfRecord>& classes,
                                     taxonomy::GlossyRule rule, bool first_unnamed) {
  std::vector<record::Layer> layers;
  std::vector<std::string> taken;
  for (const ClassOfRecord& item : classes) {
    record::Layer layer;
    layer.image = images[layers.size()];
    if (!layers.empty() || !first_unnamed) layer.name = record::layer_name(item.grammar.name, taken);
    taken.push_back(layer.name);
    layer.attributes["name"] = item.grammar.name;
    layer.attributes["expression"] = item.grammar.expression;
    if (!item.grammar.expression_delta.empty()) layer.attributes["expression_delta"] = item.grammar.expression_delta;
    layer.attributes["dialect"] = std::string(taxonomy::facts(item.grammar.dialect).name);
    if (const std::string text = canonical(item); !text.empty()) layer.attributes["canonical"] = text;
    layer.attributes["glossy"] = std::string(report::name_of(rule));
    layers.push_back(std::move(layer));
  }
  return layers;
}

void add_undecided_layers(const record::Record& record, const record::Rows& rows,
                          const std::vector<ClassOfRecord>& classes, std::vector<record::Layer>& layers) {
  std::vector<std::vector<bool>> sets;
  for (const ClassOfRecord& item : classes)
    if (!item.undecided.empty()) sets.push_back(item.undecided);
  if (sets.empty()) return;
  std::vector<record::Image> images = record::images_of(record, rows, sets);
  std::vector<std::string> taken;
  for (const record::Layer& layer : layers) taken.push_back(layer.name);
  auto image = images.begin();
  for (const ClassOfRecord& item : classes) {
    if (item.undecided.empty()) continue;
    taken.push_back(record::layer_name(item.grammar.name + "_undecided", taken));
    layers.push_back(
        {taken.back(), std::move(*image++), {{"note", "folded words that may be in '" + item.grammar.name + "'"}}});
  }
}

std::vector<std::string> renamed(const std::vector<record::Layer>& layers) {
  std::vector<std::string> sentences;
  for (const record::Layer& layer : layers) {
    const auto name = layer.attributes.find("name");
    if (name == layer.attributes.end() || layer.name.empty() || name->second == layer.name) continue;
    sentences.push_back(fmt::format("the layer of '{}' is called {}", name->second, layer.name));
  }
  return sentences;
}

record::Attachment cryptomatte_of(const record::Record& record, const record::Rows& rows,
                                  const std::vector<ClassOfRecord>& classes) {
  if (classes.empty()) return report::cryptomatte(record.info.window, rows, report::classes_by_word(record));
  std::vector<std::string> names;
  std::vector<std::vector<bool>> members;
  for (const ClassOfRecord& item : classes) {
    names.push_back(item.grammar.name);
    members.push_back(item.members);
  }
  return report::cryptomatte(record.info.window, rows, report::classes_by_set(std::move(names), members));
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
    if (!item.undecided.empty()) rows.back().notes.emplace_back(report::kAtLeast);
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
                    {"canonical", canonical(item)},
                    {"never", item.never},
                    {"energy", report::to_json(item.energy)},
                    {"share", report::to_json(item.share)},
                    {"exact", item.undecided.empty()},
                    {"words", item.words},
                    {"count", item.count}});
  return list;
}

}  // namespace heckbert::cli
