#include <heckbert/cli/asked_part.h>

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/languages.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/label.h>

namespace heckbert::cli {
namespace {

std::string describe(const record::Window& w) {
  if (w.pixel_count() == 1) return fmt::format("pixel {}, {}", w.x0, w.y0);
  return fmt::format("pixels {} to {}, {} to {}", w.x0, w.x1 - 1, w.y0, w.y1 - 1);
}

record::Window region_of(const std::string& text, const record::Record& record) {
  const record::Window window = value_of_flag("--region", [&] { return parse_window(text); });
  const record::Window& all = record.info.window;
  if (window.x0 < all.x0 || window.y0 < all.y0 || window.x1 > all.x1 || window.y1 > all.y1)
    throw UsageError(fmt::format("--region: '{}' reaches beyond the record, which has {}", text, describe(all)));
  return window;
}

/// The words of a part, narrowed to a language.
void narrow(report::Part& part, const record::Record& record, const taxonomy::Language& language,
            taxonomy::GlossyRule rule, const std::string& description) {
  std::vector<bool> chosen = record::members(record, language, rule);
  if (part.words)
    std::transform(chosen.begin(), chosen.end(), part.words->begin(), chosen.begin(), std::logical_and<>());
  part.words = std::move(chosen);
  part.description += (part.description.empty() ? "" : "; ") + description;
}

void require_labels(const record::Record& record, std::initializer_list<const char*> kinds, const char* flag) {
  const std::vector<std::string> recorded = split(record.info.labels, ',');
  for (const char* kind : kinds)
    if (std::find(recorded.begin(), recorded.end(), kind) != recorded.end()) return;
  throw UsageError(fmt::format("{}: this record has no such labels; render it with --labels {}", flag, *kinds.begin()));
}

}  // namespace

void add_part(CLI::App& command, PartFlags& flags) {
  command.add_option("--region", flags.region, "only these pixels, X1 and Y1 excluded")->type_name("X0,Y0,X1,Y1");
  command.add_option("--pixel", flags.pixel, "only this pixel")->type_name("X,Y")->excludes("--region");
  command.add_option("--of", flags.of, "only these words: expression, @name or .grammar file")->type_name("EXPR");
  command.add_option("--object", flags.object, "only what is seen on this object (or material, as recorded)")
      ->type_name("LABEL");
  command.add_option("--light-group", flags.light_group, "only what comes from this group of lights")
      ->type_name("LABEL");
}

bool has_pixels(const PartFlags& flags) {
  return !flags.region.empty() || !flags.pixel.empty();
}

record::Window pixel_of(const std::string& flag, const std::string& text, const record::Record& record) {
  return value_of_flag(flag, [&] { return parse_pixel(text, record.info.window); });
}

report::Part part_of(const PartFlags& flags, const record::Record& record, const Settings& settings) {
  report::Part part;
  if (!flags.region.empty()) part.pixels = region_of(flags.region, record);
  if (!flags.pixel.empty()) part.pixels = pixel_of("--pixel", flags.pixel, record);
  if (part.pixels) part.description = describe(*part.pixels);
  if (!flags.of.empty())
    narrow(part, record, find_grammar(flags.of, "--of", settings).language, settings.glossy,
           "the words of " + flags.of);
  const auto narrow_to = [&](const std::string& expression, const std::string& description) {
    narrow(part, record, taxonomy::compile(expression), taxonomy::GlossyRule::Keep, description);
  };
  if (!flags.object.empty()) {
    require_labels(record, {"object", "material"}, "--object");
    const std::string label = taxonomy::write_label(flags.object);
    narrow_to("L .* " + label + " E", "what is seen on " + label);
  }
  if (!flags.light_group.empty()) {
    require_labels(record, {"light-group"}, "--light-group");
    const std::string label = taxonomy::write_label(flags.light_group);
    narrow_to("L" + label + " .* E", "the light of " + label);
  }
  return part;
}

}  // namespace heckbert::cli
