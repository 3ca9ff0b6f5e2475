#pragma once
// The way in: a scene and settings in, a record out.

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string_view>

#include <heckbert/record/path_sink.h>
#include <heckbert/record/record.h>
#include <heckbert/record/sample_map.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

enum class AlgorithmId : std::uint8_t { Path, Whitted, Lecture };

struct AlgorithmFacts {
  AlgorithmId id;
  std::string_view name;     ///< as on the command line
  std::string_view grammar;  ///< the grammar that predicts its words
  std::string_view title;
};

/// Every algorithm that can render; the command line, the help and the tests read this table.
inline constexpr std::array<AlgorithmFacts, 3> kAlgorithms{{
    {AlgorithmId::Path, "path", "path-tracing", "reference path tracer"},
    {AlgorithmId::Whitted, "whitted", "whitted", "Whitted's recursive ray tracer"},
    {AlgorithmId::Lecture, "lecture", "lecture", "the lecture's recursive ray tracer"},
}};

struct RenderSettings {
  AlgorithmId algorithm = AlgorithmId::Path;
  int width = 512, height = 512;
  std::optional<record::Window> crop{};
  int samples_per_pixel = 64;
  int max_depth = 32;  ///< most scatterings per path
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
  /// Off: the path tracer finds lamps by running into them alone. For comparison; lights that cannot be hit stay dark.
  bool next_event_estimation = true;
  std::optional<record::SampleMap> sample_map{};  ///< for the window; unset: every pixel once
  PixelFilter filter{};
  SamplerKind sampler = kSamplers.front().kind;
};

struct Progress {
  double fraction = 0;     ///< of all samples
  std::uint64_t rays = 0;  ///< traced so far
  double seconds = 0;      ///< since the start
};

struct RenderHooks {
  std::function<void(const Progress&)> progress;  ///< called from tracing threads, one at a time, a few times a second
  const std::atomic<bool>* stop = nullptr;        ///< set it to stop soon; the record comes back partial
};

/// Traces the scene. The same settings and seed give the same record for any number of threads.
/// Errors: std::invalid_argument for settings out of range or a scene that breaks the rules of scene.h. A scene without
/// lights is black, not an error.
record::Record render(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks = {});

/// The same walk with nothing recorded but the picture: what recording costs is measured against this.
record::Image render_picture_only(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks = {});

}  // namespace heckbert::transport
