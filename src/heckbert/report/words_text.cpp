#include <heckbert/report/words_text.h>

#include <algorithm>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

const GroupByFacts& facts_of(GroupBy by) {
  return *std::find_if(kGroupings.begin(), kGroupings.end(), [by](const GroupByFacts& f) { return f.by == by; });
}

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

std::string words_text(const std::vector<WordEnergy>& words, const TextStyle& style, std::size_t most) {
  if (words.empty()) return "No light was recorded.\n";
  const std::size_t shown = shown_of(words.size(), most);
  const double largest = words.front().energy.mean;
  std::vector<TextRow> rows;
  for (std::size_t i = 0; i < shown; ++i)
    rows.push_back({.cells = {words[i].word, percent(words[i].share.mean), bracketed_percent(words[i].share),
                              aligned_number(words[i].energy.mean, largest), grouped(words[i].count)},
                    .bar = words[i].share.mean});
  return text_table({{"Word"},
                     {"Share", Align::Right},
                     {"Interval in %", Align::Right},
                     {"Energy", Align::Right},
                     {"Count", Align::Right}},
                    rows, style) +
         rest_line(words, shown, "word");
}

std::string groups_text(const std::vector<WordGroup>& groups, GroupBy by, const TextStyle& style, std::size_t most) {
  if (groups.empty()) return "No light was recorded.\n";
  const bool overlapping = by == GroupBy::Class || by == GroupBy::Algorithm;
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
  std::string text = text_table({{std::string(facts_of(by).title)},
                                 {"Share", Align::Right},
                                 {"Interval in %", Align::Right},
                                 {"Energy", Align::Right},
                                 {"Count", Align::Right},
                                 {"Words", Align::Right}},
                                rows, style);
  // Overlapping groups have no sum that would mean anything.
  if (!overlapping) text += rest_line(groups, shown, "group");
  return text;
}

std::string groups_json(const std::vector<WordGroup>& groups, GroupBy by, const record::RenderInfo& info,
                        const record::Tally& tally, const ClassifyOptions& options) {
  Json list = Json::array();
  for (const WordGroup& group : groups)
    list.push_back({{"name", group.name},
                    {"expression", group.expression},
                    {"energy", to_json(group.energy)},
                    {"share", to_json(group.share)},
                    {"count", group.count},
                    {"words", group.words}});
  Json document = document_of("heckbert.classify");
  document["render"] = to_json(info);
  document["tally"] = to_json(tally);
  document["glossy_rule"] = name_of(options.glossy_rule);
  document["confidence"] = options.confidence;
  document["by"] = facts_of(by).name;
  document["groups"] = std::move(list);
  return dump(document);
}

}  // namespace heckbert::report
