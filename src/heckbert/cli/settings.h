#pragma once
// Settings that several commands share, and where their values come from. A value is text until the last moment: each
// layer (flags, environment, config file) says what it has, the first that has a setting wins, and only then is the
// text read, so that every layer obeys the same rules and an error names the layer. The scene file's own defaults and
// the tool's come after these three; render adds them.
//
// The layers are merged here and not by CLI11, because CLI11 2.1.2 lets a config file win over the environment and
// skips config keys that it does not know.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/dialect.h>
#include <heckbert/taxonomy/glossy_rule.h>
#include <heckbert/transport/label_rule.h>
#include <heckbert/transport/method.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>

namespace CLI {
class App;
}

namespace heckbert::cli {

inline constexpr int kMaxSamples = 1'000'000;  ///< of a pixel

enum class When : std::uint8_t { Auto, Always, Never };

struct Size {
  int width = 0, height = 0;
};

struct Settings {
  std::optional<int> samples_per_pixel;
  std::optional<double> seconds;
  record::Part part;
  std::optional<double> checkpoint;     ///< seconds
  std::optional<std::uint64_t> memory;  ///< bytes
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;
  std::optional<Size> size;
  std::optional<record::Window> crop;
  std::optional<int> max_depth;
  std::optional<transport::PixelFilter> filter;
  transport::SamplerKind sampler = transport::kSamplers.front().kind;
  transport::LabelRule labels{};
  transport::Method method{};
  When progress = When::Auto;
  taxonomy::GlossyRule glossy = taxonomy::GlossyRule::Keep;
  taxonomy::Dialect dialect = taxonomy::Dialect::Heckbert;
  double confidence = 0.95;
  bool quiet = false;
  bool verbose = false;
  When color = When::Auto;
};

/// Which commands a setting is for: those that trace, that make a picture to keep, and so on.
enum class Scope : std::uint8_t { Tracing, Rendering, Dialect, Glossy, Confidence, Everywhere };

/// What the flags of one command line say.
struct SettingFlags {
  std::map<std::string, std::string> texts;  ///< by setting name
  std::string config;                        ///< file name; empty when not given
};

/// Adds the flags of these scopes, and those of Scope::Everywhere, to a command. `flags` must outlive the parse.
void add_settings(CLI::App& command, SettingFlags& flags, std::initializer_list<Scope> scopes);

/// "object,light-group": names of transport::kLabelKinds. Errors: BadValue.
transport::LabelRule parse_labels(const std::string& text);
/// "patch-edge=0.05,flat=1": names of transport::kMethodOptions, within their bounds. Errors: BadValue.
transport::Method parse_method(const std::string& text);

/// Merges flags, environment and config file. Two rivals (--spp and --time, --quiet and --verbose) exclude each other
/// within a layer, and one hides the other in the layers below.
/// Errors: UsageError for flags and environment; InputError for the config file, all its errors; ReadError.
Settings resolve(const SettingFlags& flags);

}  // namespace heckbert::cli
