#include <heckbert/report/diagnosis_text.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/symbol_set.h>

namespace heckbert::report {
namespace {

/// "next event (1,3): 1 234 paths, 92 % of it".
std::string describe(const StrategyUse& use, const Cause& cause, bool has_measured) {
  std::string text =
      fmt::format("{} ({},{})", use.strategy.name, use.strategy.light_vertices, use.strategy.eye_vertices);
  if (!use.is_had) return text + ": not one of its techniques";
  if (!use.measured && !cause.is_claimed) return text + ": a technique of its kind, but it builds no such path";
  if (!use.measured) return text + (has_measured ? ": has it, and found nothing by it" : ": has it");
  const MeasuredTechnique& measured = *use.measured;
  text += fmt::format(": {}, {} of the word", counted(measured.count, "path"),
                      percent(cause.energy.mean > 0 ? measured.mean / cause.energy.mean : 0));
  if (measured.mean > 0) text += fmt::format(" +- {}", percent(measured.standard_error / cause.energy.mean));
  return text;
}

std::vector<std::string> notes(const Cause& cause, bool has_measured) {
  std::vector<std::string> lines;
  if (cause.strategies.empty()) lines.emplace_back("no strategy can join such a path from this light to this eye");
  for (const StrategyUse& use : cause.strategies) lines.push_back(describe(use, cause, has_measured));
  lines.push_back(cause.finders.empty() ? std::string("nobody else claims it")
                                        : fmt::format("claimed by {}", fmt::join(cause.finders, ", ")));
  return lines;
}

std::string table(const Diagnosis& diagnosis, bool is_claimed, const TextStyle& style, std::size_t most) {
  std::vector<TextRow> rows;
  std::size_t count = 0;
  for (const Cause& cause : diagnosis.causes) {
    if (cause.is_claimed != is_claimed || ++count > most) continue;
    rows.push_back(
        {.cells = {cause.word, taxonomy::name(cause.light), percent(cause.share),
                   fmt::format("{},{}", cause.brightest.x, cause.brightest.y), samples_text(cause.samples_needed)},
         .notes = notes(cause, diagnosis.has_measured),
         .bar = cause.share});
  }
  if (rows.empty()) return {};
  std::string text = text_table({{is_claimed ? "Found too rarely" : "Cannot be found"},
                                 {"Light"},
                                 {"Share", Align::Right},
                                 {"Brightest", Align::Right},
                                 {"Samples", Align::Right}},
                                rows, style);
  if (count > most) text += fmt::format("... and {} more\n", counted(count - most, "word"));
  return "\n" + text;
}

std::string seconds_text(const std::optional<double>& seconds) {
  if (!seconds) return "-";
  return *seconds < 0.1 ? fmt::format("{:.2g} s", *seconds) : fmt::format("{:.1f} s", *seconds);
}

std::string candidates_table(const Diagnosis& diagnosis, const TextStyle& style) {
  const bool measured = std::any_of(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [](const Candidate& candidate) { return candidate.seconds.has_value(); });
  if (!measured) return {};
  std::vector<TextRow> rows;
  for (const Candidate& candidate : diagnosis.candidates)
    rows.push_back({.cells = {candidate.algorithm, percent(candidate.share), seconds_text(candidate.seconds),
                              candidate.is_minimal ? "yes" : "-"},
                    .bar = candidate.share});
  std::string text =
      "\n" +
      text_table({{"Algorithm"}, {"Claims", Align::Right}, {"Time to error", Align::Right}, {"Minimal"}}, rows, style);
  const auto enough = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                   [](const Candidate& c) { return c.share >= kSufficient && c.seconds; });
  text += wrap(enough == diagnosis.candidates.end()
                   ? fmt::format("No algorithm here claims {} of the energy.", percent(kSufficient))
                   : fmt::format("The cheapest that claims {} of the energy: {}, {}.", percent(kSufficient),
                                 enough->algorithm, seconds_text(enough->seconds)),
               style.width);
  return text;
}

}  // namespace

std::string diagnosis_text(const Diagnosis& diagnosis, const TextStyle& style, std::size_t most) {
  std::string text =
      wrap(fmt::format("{} ({}): of all energy that is known, {} it cannot find, and {} takes it more than {} samples "
                       "per pixel for an error of {}.",
                       diagnosis.algorithm, diagnosis.title, percent(diagnosis.unreachable), percent(diagnosis.rare),
                       grouped(static_cast<std::uint64_t>(diagnosis.options.budget)), percent(diagnosis.options.error)),
           style.width);
  return text + table(diagnosis, false, style, most) + table(diagnosis, true, style, most) +
         candidates_table(diagnosis, style);
}

Json to_json(const Diagnosis& diagnosis) {
  Json json = {{"algorithm", diagnosis.algorithm},           {"title", diagnosis.title},
               {"error", diagnosis.options.error},           {"budget", diagnosis.options.budget},
               {"confidence", diagnosis.options.confidence}, {"total", diagnosis.total},
               {"unreachable", diagnosis.unreachable},       {"rare", diagnosis.rare}};
  json["words"] = Json::array();
  for (const Cause& cause : diagnosis.causes) {
    Json word = {{"word", cause.word},
                 {"light", taxonomy::name(cause.light)},
                 {"length", cause.length},
                 {"claimed", cause.is_claimed},
                 {"energy", to_json(cause.energy)},
                 {"share", cause.share},
                 {"witness", cause.witness},
                 {"brightest", {{"x", cause.brightest.x}, {"y", cause.brightest.y}}},
                 {"found_count", cause.found_count}};
    if (cause.samples_needed) word["samples_needed"] = *cause.samples_needed;
    word["strategies"] = Json::array();
    for (const StrategyUse& use : cause.strategies) {
      word["strategies"].push_back({{"name", use.strategy.name},
                                    {"light_vertices", use.strategy.light_vertices},
                                    {"eye_vertices", use.strategy.eye_vertices},
                                    {"had", use.is_had}});
      if (use.measured)
        word["strategies"].back()["measured"] = {{"count", use.measured->count},
                                                 {"mean", use.measured->mean},
                                                 {"standard_error", use.measured->standard_error}};
    }
    word["finders"] = cause.finders;
    json["words"].push_back(std::move(word));
  }
  json["candidates"] = Json::array();
  for (const Candidate& candidate : diagnosis.candidates) {
    json["candidates"].push_back(
        {{"algorithm", candidate.algorithm}, {"share", candidate.share}, {"minimal", candidate.is_minimal}});
    if (candidate.seconds) json["candidates"].back()["seconds"] = *candidate.seconds;
  }
  return json;
}

}  // namespace heckbert::report
