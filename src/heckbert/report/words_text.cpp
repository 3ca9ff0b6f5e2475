#include <heckbert/report/words_text.h>

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

/// One line for what a table leaves out: how many, and their part of the energy.
template <typename Item>
std::string rest_line(const std::vector<Item>& items, std::size_t shown, const std::string& noun) {
  if (shown >= items.size()) return {};
  double share = 0;
  for (std::size_t i = shown; i < items.size(); ++i) share += items[i].share.mean;
  return fmt::format("and {} with {} of the energy\n", counted(items.size() - shown, "more " + noun), percent(share));
}

std::size_t shown_of(std::size_t size, std::size_t most) {
  return most == 0 ? size : std::min(most, size);
}

}  // namespace

std::string words_text(const std::vector<WordEnergy>& words, const TextStyle& style, std::size_t most,
                       bool with_samples) {
  if (words.empty()) return "No light was recorded.\n";
  const std::size_t shown = shown_of(words.size(), most);
  const double largest = words.front().energy.mean;
  std::vector<TextColumn> columns{{"Word"},
                                  {"Share", Align::Right},
                                  {"Interval in %", Align::Right},
                                  {"Energy", Align::Right},
                                  {"Count", Align::Right}};
  if (with_samples) columns.push_back({"Samples", Align::Right});
  std::vector<TextRow> rows;
  for (std::size_t i = 0; i < shown; ++i) {
    rows.push_back({.cells = {words[i].word, percent(words[i].share.mean), bracketed_percent(words[i].share),
                              aligned_number(words[i].energy.mean, largest), grouped(words[i].count)},
                    .bar = words[i].share.mean});
    if (with_samples) rows.back().cells.push_back(samples_text(words[i].samples_needed));
  }
  return text_table(columns, rows, style) + rest_line(words, shown, "word");
}

std::string spread_text(const Classification& classification) {
  const Spread& spread = *classification.spread;
  const std::string noun =
      classification.by == GroupBy::Word || classification.by == GroupBy::FineWord ? "word" : "group";
  std::string text =
      fmt::format("{} {} {} of the energy. Entropy {:.3f} bits", counted(spread.groups_to_reach, noun),
                  spread.groups_to_reach == 1 ? "has" : "have", level(spread.reach), spread.entropy.mean);
  if (spread.entropy.known) text += fmt::format(" ({:.3f} to {:.3f})", spread.entropy.lower, spread.entropy.upper);
  return text + fmt::format(": as much as {:.1f} {}s of equal energy.", spread.effective_groups, noun);
}

std::string classification_text(const Classification& classification, const TextStyle& style, std::size_t most) {
  const std::vector<WordGroup>& groups = classification.groups;
  std::string text;
  if (!classification.part.is_whole())
    text += wrap("All of this is about " + classification.part.description + ".", style.width) + '\n';
  if (groups.empty()) return text + "No light was recorded.\n";
  const std::size_t shown = shown_of(groups.size(), most);
  double largest = 0;
  for (const WordGroup& group : groups) largest = std::max(largest, group.energy.mean);
  std::vector<TextRow> rows;
  for (std::size_t i = 0; i < shown; ++i) {
    const WordGroup& group = groups[i];
    rows.push_back({.cells = {group.name, percent(group.share.mean), bracketed_percent(group.share),
                              aligned_number(group.energy.mean, largest), grouped(group.count), grouped(group.words)},
                    .bar = group.share.mean});
    if (!group.expression.empty()) rows.back().notes.push_back(group.expression);
  }
  text += text_table({{std::string(facts(classification.by).title)},
                      {"Share", Align::Right},
                      {"Interval in %", Align::Right},
                      {"Energy", Align::Right},
                      {"Count", Align::Right},
                      {"Words", Align::Right}},
                     rows, style);
  // Overlapping groups have no sum that would mean anything.
  if (facts(classification.by).is_partition) text += rest_line(groups, shown, "group");
  if (classification.spread) text += '\n' + wrap(spread_text(classification), style.width);
  return text;
}

std::string classification_json(const Classification& classification) {
  Json list = Json::array();
  for (const WordGroup& group : classification.groups)
    list.push_back({{"name", group.name},
                    {"expression", group.expression},
                    {"energy", to_json(group.energy)},
                    {"share", to_json(group.share)},
                    {"count", group.count},
                    {"words", group.words}});
  Json document = document_of("heckbert.classify");
  document["render"] = to_json(classification.info);
  document["tally"] = to_json(classification.info, classification.tally);
  document["glossy_rule"] = name_of(classification.glossy_rule);
  document["confidence"] = classification.confidence;
  document["part"] = classification.part.description;
  document["by"] = facts(classification.by).name;
  document["groups"] = std::move(list);
  if (const std::optional<Spread>& spread = classification.spread)
    document["spread"] = {{"entropy", to_json(spread->entropy)},
                          {"effective_groups", spread->effective_groups},
                          {"reach", spread->reach},
                          {"groups_to_reach", spread->groups_to_reach}};
  document["spectra"] = Json::object();
  for (const Spectrum& spectrum : classification.spectra) {
    Json shares = Json::array();
    for (const record::Estimate& share : spectrum.shares) shares.push_back(to_json(share));
    document["spectra"][std::string(spectrum.name)] = std::move(shares);
  }
  return dump(document);
}

}  // namespace heckbert::report
