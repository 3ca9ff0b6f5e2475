#include <heckbert/report/facts.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/record/statistics.h>
#include <heckbert/report/numbers.h>

namespace heckbert::report {
namespace {

std::string picture_size(const record::RenderInfo& info) {
  std::string text = fmt::format("{} x {} pixels", info.width, info.height);
  const record::Window& window = info.window;
  if (window != record::Window{0, 0, info.width, info.height})
    text += fmt::format(", of which x {} to {} and y {} to {} were rendered", window.x0, window.x1 - 1, window.y0,
                        window.y1 - 1);
  return text;
}

std::string cut_off_text(const record::RenderInfo& info, const record::Tally& tally) {
  if (!info.knows_cut_off) return "not estimated";
  if (tally.depth_limited == 0) return "nothing: no walk reached the depth limit";
  const record::Estimate lost = record::cut_off(info, tally);
  return fmt::format("{} of mean luminance at the depth limit (estimated, {} to {})", number(lost.mean),
                     number(lost.lower), number(lost.upper));
}

std::string rejected(const record::Tally& tally) {
  if (tally.rejected_not_finite + tally.rejected_negative == 0) return "none";
  return fmt::format("{} not finite, {} negative", grouped(tally.rejected_not_finite),
                     grouped(tally.rejected_negative));
}

std::string rounding(const record::Tally& tally) {
  if (tally.clamped + tally.vanished == 0) return "none";
  return fmt::format("{} brighter than {:g} were added as that, {} too faint to add", grouped(tally.clamped),
                     record::kMostLight, grouped(tally.vanished));
}

std::string precision(const record::RenderInfo& info, const record::Tally& tally) {
  const record::PrecisionFacts& facts = record::kPrecisions[static_cast<std::size_t>(info.precision)];
  std::string text = fmt::format("{} in pixels ({}); sums over the picture are exact", facts.name, facts.meaning);
  if (tally.half_clamped + tally.half_vanished > 0)
    text += fmt::format("; {} energies were too bright for that and {} too faint", grouped(tally.half_clamped),
                        grouped(tally.half_vanished));
  return text;
}

std::string found(const record::Tally& tally) {
  std::string text = fmt::format("{} by hitting a light, {} by next-event estimation", grouped(tally.hits),
                                 grouped(tally.next_events));
  if (tally.connections > 0) text += fmt::format(", {} by connecting walks", grouped(tally.connections));
  if (tally.merges > 0) text += fmt::format(", {} by merging walks", grouped(tally.merges));
  return text;
}

std::string samples_taken(const record::RenderInfo& info, const record::Tally& tally) {
  // Adaptive sampling repeats them where they are needed.
  const bool is_even = tally.samples <= static_cast<std::uint64_t>(info.samples_per_pixel) * info.window.pixel_count();
  return fmt::format("{}{} per pixel, {} in all", is_even ? "" : "at least ", info.samples_per_pixel,
                     grouped(tally.samples));
}

}  // namespace

std::vector<Fact> facts(const record::RenderInfo& info, const record::Tally& tally) {
  return {
      {"Scene", info.scene},
      {"Algorithm", info.algorithm},
      {"Picture", picture_size(info)},
      {"Samples", samples_taken(info, tally)},
      {"Seed", info.parts.empty() ? std::to_string(info.seed) : samples_text(info)},
      {"Depth", fmt::format("at most {} scatterings per path", info.max_depth)},
      {"Labels", info.labels.empty() ? "none" : info.labels},
      {"Paths found", found(tally)},
      {"Walks ended",
       fmt::format("{} escaped ({} where there is no environment), {} absorbed, {} at the depth limit, {} by roulette",
                   grouped(tally.escaped), grouped(tally.escaped_unlit), grouped(tally.absorbed),
                   grouped(tally.depth_limited), grouped(tally.roulette))},
      {"Cut off", cut_off_text(info, tally)},
      {"Rejected", rejected(tally)},
      {"Out of range", rounding(tally)},
      {"Precision", precision(info, tally)},
      {"Version", "heckbert " + info.version},
  };
}

std::string termination(const record::RenderInfo& info, const record::Tally& tally, double luminance) {
  if (!info.knows_cut_off)
    return fmt::format("What is beyond the depth limit of {} was not estimated: it is in no number here.",
                       info.max_depth);
  if (tally.depth_limited == 0) return {};
  const record::Estimate lost = record::cut_off(info, tally);
  return fmt::format("The depth limit of {} cut off {} walks and with them {} of all light (estimated: {} of {}).",
                     info.max_depth, grouped(tally.depth_limited),
                     percent(lost.mean > 0 ? lost.mean / (luminance + lost.mean) : 0), number(lost.mean),
                     number(luminance + lost.mean));
}

std::vector<std::string> warnings(const record::RenderInfo& info, const record::Tally& tally) {
  std::vector<std::string> found;
  if (info.partial) {
    const double all = static_cast<double>(info.window.pixel_count()) * info.samples_per_pixel;
    found.push_back(fmt::format(
        "The render was interrupted when {} of its samples were taken: pixels that lack theirs are black, and "
        "all numbers are about the picture as it is.",
        percent(static_cast<double>(tally.samples) / all)));
  }
  if (tally.rejected_not_finite + tally.rejected_negative > 0)
    found.push_back(fmt::format("Contributions were left out because they were no light: {}.", rejected(tally)));
  if (tally.clamped > 0) found.push_back(fmt::format("Contributions were out of range: {}.", rounding(tally)));
  if (tally.half_clamped > 0)
    found.push_back(
        fmt::format("{} energies of pixels are too bright for half precision and were cut to 65504 in the "
                    "record; --record-precision float keeps them.",
                    grouped(tally.half_clamped)));
  if (!info.has_batches)
    found.push_back("The paths were imported as sums: how much they scatter is not known, and no interval is given.");
  else if (record::batches_in_use(info) < 2)
    found.push_back("Samples of one batch alone give no confidence intervals; render with two or more per pixel.");
  return found;
}

std::string folding(const record::Record& record) {
  if (!record.folding) return {};
  std::vector<bool> folded(record.words.size());
  std::fill(folded.begin() + static_cast<std::ptrdiff_t>(record.folding->first), folded.end(), true);
  const std::vector<bool> all(record.words.size(), true);
  return fmt::format(
      "words of more than {} scatterings were too many for the memory: they are folded into {} classes, {} of the "
      "energy, each "
      "under its first word; the built-in grammars and what was declared (glossy bounces: {}) stay exact, other "
      "questions are answered between bounds",
      record.folding->longest, grouped(record.words.size() - record.folding->first),
      percent(record::share(record, folded, all).mean),
      taxonomy::kGlossyRules[static_cast<std::size_t>(record.info.glossy)].name);
}

std::string samples_text(const record::RenderInfo& info) {
  if (info.parts.empty()) return fmt::format("seed {}", info.seed);
  std::vector<std::string> ranges;
  for (const record::SampleRange& range : info.parts) ranges.push_back(record::to_text(range));
  return fmt::format("{}", fmt::join(ranges, "; "));
}

std::string summary(const record::RenderInfo& info) {
  return fmt::format("{}, {}, {}, {} samples per pixel, {}, heckbert {}", info.scene, info.algorithm,
                     picture_size(info), info.samples_per_pixel, samples_text(info), info.version);
}

std::string describe(taxonomy::GlossyRule rule) {
  for (const taxonomy::GlossyRuleFacts& facts : taxonomy::kGlossyRules)
    if (facts.rule == rule) return fmt::format("{}: {}", facts.name, facts.meaning);
  return {};
}

}  // namespace heckbert::report
