#include <heckbert/cli/settings.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/config_file.h>
#include <heckbert/cli/exit_code.h>
#include <heckbert/cli/files.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/filter.h>
#include <heckbert/transport/method_options.h>
#include <heckbert/transport/render.h>

namespace heckbert::cli {
namespace {

constexpr int kMaxThreads = 1'024;
constexpr int kMaxDepth = 1'000;

struct WhenFacts {
  When when;
  std::string_view name;
};
constexpr std::array<WhenFacts, 3> kWhens{{{When::Auto, "auto"}, {When::Always, "always"}, {When::Never, "never"}}};

int whole(const std::string& text, int low, int high) {
  return static_cast<int>(whole_number(text, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high)));
}

Size parse_size(const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() != 2) throw BadValue(fmt::format("'{}' is no size; expected WIDTHxHEIGHT, such as 640x480", text));
  return {whole(parts[0], 1, kMaxSize), whole(parts[1], 1, kMaxSize)};
}

record::Part parse_part(const std::string& text) {
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() != 2) throw BadValue(fmt::format("'{}' is no part; expected I/N, such as 3/8", text));
  const int of = whole(parts[1], 1, kMaxSamples);
  return {whole(parts[0], 1, of), of};
}

std::uint64_t parse_bytes(const std::string& text) {
  constexpr std::string_view kUnits = "KMGT";
  const std::size_t unit = text.empty() ? std::string_view::npos : kUnits.find(text.back());
  if (unit == std::string_view::npos)
    throw BadValue(
        fmt::format("'{}' is no amount of memory; expected a number and one of K, M, G, T, as in 512M", text));
  constexpr double kMost = 1 << 20;
  return static_cast<std::uint64_t>(
      std::ldexp(number_between(text.substr(0, text.size() - 1), 0, kMost), 10 * (static_cast<int>(unit) + 1)));
}

bool parse_switch(const std::string& text) {
  for (const std::string_view yes : {"1", "true", "yes", "on"})
    if (text == yes) return true;
  for (const std::string_view no : {"0", "false", "no", "off"})
    if (text == no) return false;
  throw BadValue(fmt::format("'{}' is neither true nor false", text));
}

/// One setting: --name, HECKBERT_NAME, and name = in a config file.
struct Setting {
  std::string name;
  std::string value;  ///< placeholder in help texts; empty for a switch
  Scope scope;
  std::string rival;  ///< the setting that it excludes
  std::string help;
  void (*store)(Settings&, const std::string&);  ///< errors: BadValue
};

const std::vector<Setting>& all_settings() {
  static const std::vector<Setting> settings = [] {
    const transport::RenderSettings fallback;
    return std::vector<Setting>{
        {"spp", "N", Scope::Tracing, "time",
         fmt::format("samples per pixel (default: the scene's, else {})", fallback.samples_per_pixel),
         [](Settings& s, const std::string& t) { s.samples_per_pixel = whole(t, 1, kMaxSamples); }},
        {"time", "SECONDS", Scope::Rendering, "spp", "take as many samples per pixel as fit into this time",
         [](Settings& s, const std::string& t) { s.seconds = number_between(t, 0, 1e7); }},
        {"seed", "N", Scope::Tracing, "",
         fmt::format("seed of the random numbers (default: the scene's, else {})", fallback.seed),
         [](Settings& s, const std::string& t) {
           s.seed = whole_number(t, 0, std::numeric_limits<std::uint64_t>::max());
         }},
        {"part", "I/N", Scope::Rendering, "", "trace the I-th of N parts of the samples; see 'heckbert merge'",
         [](Settings& s, const std::string& t) { s.part = parse_part(t); }},
        {"checkpoint", "SECONDS", Scope::Rendering, "", "write what is there to the --record file every so often",
         [](Settings& s, const std::string& t) { s.checkpoint = number_between(t, 0, 1e7); }},
        {"memory", "SIZE", Scope::Rendering, "", "keep to this much memory, such as 2G, by folding long words",
         [](Settings& s, const std::string& t) { s.memory = parse_bytes(t); }},
        {"threads", "N", Scope::Tracing, "", "threads to trace with; 0 for all cores (default); changes no pixel",
         [](Settings& s, const std::string& t) { s.threads = whole(t, 0, kMaxThreads); }},
        {"size", "WxH", Scope::Tracing, "",
         fmt::format("size in pixels (default: the scene's, else {}x{})", fallback.width, fallback.height),
         [](Settings& s, const std::string& t) { s.size = parse_size(t); }},
        {"crop", "X0,Y0,X1,Y1", Scope::Rendering, "", "render only these pixels, X1 and Y1 excluded",
         [](Settings& s, const std::string& t) { s.crop = parse_window(t); }},
        {"max-depth", "N", Scope::Tracing, "",
         fmt::format("most scatterings per path (default: the scene's, else {})", fallback.max_depth),
         [](Settings& s, const std::string& t) { s.max_depth = whole(t, 0, kMaxDepth); }},
        {"filter", alternatives(transport::kFilters), Scope::Tracing, "",
         fmt::format("pixel filter (default: the scene's, else {})", transport::kFilters.front().name),
         [](Settings& s, const std::string& t) {
           const transport::FilterFacts& filter = choose(t, transport::kFilters);
           s.filter = {filter.kind, filter.radius};
         }},
        {"sampler", alternatives(transport::kSamplers), Scope::Tracing, "",
         fmt::format("where random numbers come from (default: {})", transport::kSamplers.front().name),
         [](Settings& s, const std::string& t) { s.sampler = choose(t, transport::kSamplers).kind; }},
        {"labels", alternatives(transport::kLabelKinds) + "[,..]", Scope::Rendering, "",
         "write into words what events happened on, and the groups of lights",
         [](Settings& s, const std::string& t) { s.labels = parse_labels(t); }},
        {"method", "NAME=VALUE[,..]", Scope::Tracing, "", "what an algorithm leaves open: see 'heckbert render --help'",
         [](Settings& s, const std::string& t) { s.method = parse_method(t); }},
        {"progress", alternatives(kWhens), Scope::Tracing, "", "progress on standard error (auto: on a terminal)",
         [](Settings& s, const std::string& t) { s.progress = choose(t, kWhens).when; }},
        {"dialect", "DIALECT", Scope::Dialect, "",
         "what expressions are written in (default: heckbert)\n" + alternatives(taxonomy::kDialects),
         [](Settings& s, const std::string& t) { s.dialect = choose(t, taxonomy::kDialects).dialect; }},
        {"glossy", alternatives(taxonomy::kGlossyRules), Scope::Glossy, "",
         "what expressions without G say about glossy bounces (default: keep)",
         [](Settings& s, const std::string& t) { s.glossy = choose(t, taxonomy::kGlossyRules).rule; }},
        {"confidence", "P", Scope::Confidence, "", "confidence of the intervals (default: 0.95)",
         [](Settings& s, const std::string& t) { s.confidence = number_between(t, 0, 1); }},
        {"quiet", "", Scope::Everywhere, "verbose", "print nothing but results and errors",
         [](Settings& s, const std::string& t) { s.quiet = parse_switch(t); }},
        {"verbose", "", Scope::Everywhere, "quiet", "print more about what was read and done",
         [](Settings& s, const std::string& t) { s.verbose = parse_switch(t); }},
        {"color", alternatives(kWhens), Scope::Everywhere, "", "colours (auto: on a terminal, unless NO_COLOR is set)",
         [](Settings& s, const std::string& t) { s.color = choose(t, kWhens).when; }},
    };
  }();
  return settings;
}

std::string variable_of(const std::string& name) {
  std::string variable = "HECKBERT_" + name;
  for (char& c : variable) c = c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return variable;
}

std::string environment(const std::string& variable) {
  const char* value = std::getenv(variable.c_str());
  return value == nullptr ? "" : value;
}

using Refuse = std::function<void(const std::string& message)>;

/// A setting's text in one layer, and how that layer complains about it.
struct Given {
  std::string text;
  std::string place;  ///< "--spp", "HECKBERT_SPP", "spp"
  Refuse refuse;
};
using Layer = std::map<std::string, Given>;

/// What a layer of the command line itself says: complaints are about usage and name the place.
Given given_in_usage(const std::string& text, const std::string& place) {
  return {text, place,
          [place](const std::string& message) { throw UsageError(fmt::format("{}: {}", place, message)); }};
}

Layer flag_layer(const SettingFlags& flags) {
  Layer layer;
  for (const auto& [name, text] : flags.texts) layer[name] = given_in_usage(text, "--" + name);
  return layer;
}

Layer environment_layer() {
  Layer layer;
  for (const Setting& setting : all_settings()) {
    const std::string variable = variable_of(setting.name);
    const std::string text = environment(variable);
    if (!text.empty()) layer[setting.name] = given_in_usage(text, "environment variable " + variable);
  }
  return layer;
}

Layer config_layer(const std::string& path, std::vector<Diagnostic>& errors) {
  Layer layer;
  if (path.empty()) return layer;
  std::vector<std::string> names;
  for (const Setting& setting : all_settings()) names.push_back(setting.name);
  const std::string text = read_text(path);
  for (const ConfigEntry& entry : parse_config(text, path, names))
    layer[entry.name] = {entry.value, entry.name, [entry, text, path, &errors](const std::string& message) {
                           const std::size_t length = std::max<std::size_t>(entry.value.size(), 1);
                           errors.push_back(diagnose(path, text, entry.value_offset, length, message));
                         }};
  return layer;
}

/// Takes from `below` what `above` says nothing about.
void merge(Layer& above, const Layer& below) {
  const Layer decided = above;
  for (const Setting& setting : all_settings()) {
    const auto given = below.find(setting.name);
    if (given == below.end() || decided.contains(setting.name)) continue;
    if (!setting.rival.empty() && decided.contains(setting.rival)) continue;
    above.insert(*given);
  }
}

void refuse_rivals(const Layer& layer) {
  for (const Setting& setting : all_settings()) {
    if (setting.rival.empty() || !layer.contains(setting.name) || !layer.contains(setting.rival)) continue;
    layer.at(setting.rival).refuse(fmt::format("cannot be given together with {}", layer.at(setting.name).place));
    return;
  }
}

}  // namespace

transport::LabelRule parse_labels(const std::string& text) {
  transport::LabelRule labels;
  for (const std::string& name : split(text, ',')) {
    const transport::LabelRule rule = choose(name, transport::kLabelKinds).rule;
    const bool has_events = rule.events != transport::EventLabels::None;
    if (has_events && labels.events != transport::EventLabels::None)
      throw BadValue(fmt::format("'{}' asks for two labels of one event; expected object or material", text));
    if (has_events) labels.events = rule.events;
    labels.light_groups |= rule.light_groups;
  }
  return labels;
}

transport::Method parse_method(const std::string& text) {
  transport::Method method;
  for (const std::string& piece : split(text, ',')) {
    const std::vector<std::string> sides = split(piece, '=');
    if (sides.size() != 2) throw BadValue(fmt::format("'{}' is no setting; expected NAME=VALUE", piece));
    const transport::MethodOption& option = choose(sides[0], transport::kMethodOptions);
    constexpr double kAny = 1e9;
    const double value = number_between(sides[1], -kAny, kAny);
    if (value < option.least || value > option.most || (option.is_whole && value != std::floor(value)))
      throw BadValue(fmt::format("'{}' is no {}; expected a {}number from {} to {}", sides[1], option.name,
                                 option.is_whole ? "whole " : "", option.least, option.most));
    option.set(method, value);
  }
  return method;
}

void add_settings(CLI::App& command, SettingFlags& flags, std::initializer_list<Scope> scopes) {
  for (const Setting& setting : all_settings()) {
    const bool everywhere = setting.scope == Scope::Everywhere;
    if (!everywhere && std::find(scopes.begin(), scopes.end(), setting.scope) == scopes.end()) continue;
    const auto store = [&texts = flags.texts, name = setting.name](const std::string& text) { texts[name] = text; };
    CLI::Option* option = setting.value.empty()
                              ? command.add_flag_function(
                                    "--" + setting.name, [store](std::int64_t) { store("true"); }, setting.help)
                              : command.add_option_function<std::string>("--" + setting.name, store, setting.help);
    option->type_name(setting.value)
        ->group(setting.scope == Scope::Tracing || setting.scope == Scope::Rendering ? "Tracing" : "Options");
  }
  command.add_option("--config", flags.config, "file of settings, name = value; flags and environment win over it")
      ->type_name("FILE");
}

Settings resolve(const SettingFlags& flags) {
  std::vector<Diagnostic> config_errors;
  const std::string config = flags.config.empty() ? environment(variable_of("config")) : flags.config;
  Layer merged = flag_layer(flags);
  refuse_rivals(merged);
  const Layer variables = environment_layer();
  refuse_rivals(variables);
  merge(merged, variables);
  const Layer file = config_layer(config, config_errors);
  refuse_rivals(file);
  merge(merged, file);

  Settings settings;
  for (const Setting& setting : all_settings()) {
    const auto given = merged.find(setting.name);
    if (given == merged.end()) continue;
    try {
      setting.store(settings, given->second.text);
    } catch (const BadValue& error) {
      given->second.refuse(error.what());
    }
  }
  if (!config_errors.empty()) throw InputError(std::move(config_errors));
  return settings;
}

}  // namespace heckbert::cli
