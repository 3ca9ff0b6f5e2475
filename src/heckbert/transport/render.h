#pragma once
// The way in: a scene and settings in, a record out.

#include <array>
#include <atomic>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/record/recorder.h>
#include <heckbert/record/sample_map.h>
#include <heckbert/record/technique_table.h>
#include <heckbert/transport/label_rule.h>
#include <heckbert/transport/method.h>
#include <heckbert/transport/reach.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/scene.h>

namespace heckbert::transport {

enum class AlgorithmId : std::uint8_t {
  Path,
  PathHits,
  PathNextEvent,
  Light,
  Bidirectional,
  PhotonMap,
  FinalGathering,
  ProgressivePhotons,
  ConnectionAndMerging,
  InstantRadiosity,
  InstantRadiosityClamped,
  Whitted,
  Lecture,
  Distribution,
  RayCasting,
  LocalShading,
  AmbientOcclusion,
  Radiosity,
  RadiosityMirrors
};

/// What can be said of an algorithm's values, where its words are the right ones.
enum class Accuracy : std::uint8_t {
  Unbiased,    ///< right on average, with any number of samples
  Consistent,  ///< right in the limit of finer and finer settings: photons, patches
  Biased,      ///< wrong in the limit too: something is left out or put in
  NotLight     ///< it shows something else than the scene's light
};

struct AlgorithmFacts {
  AlgorithmId id;
  std::string_view name;     ///< as on the command line
  std::string_view grammar;  ///< the grammar that predicts its words
  std::string_view title;
  /// It walks from the light too. The paths of such an algorithm are not traced again.
  bool from_light = false;
  bool splats = false;  ///< what it finds may be for any pixel
  bool passes = false;  ///< each sample number is a pass over the picture, before which all pixels' light is prepared
  /// It shows light that was stored on patches beforehand, of which is known how often it was scattered, but not where:
  /// its letters have no labels, and it takes no scenes with media or bodies in one another.
  bool patches = false;
  /// It scatters light at particles of media: the grammar of its techniques but for merging, in which V counts as N
  /// (claims.h). Empty: it finds no word with a V, and media only dim what it finds.
  std::string_view joins_in_media = "";
  Accuracy accuracy = Accuracy::Unbiased;
  Reach reach = Reach::Eye;
};

/// Every algorithm that can render; the command line, the help and the tests read this table.
inline constexpr auto kAlgorithms = std::to_array<AlgorithmFacts>({
    {.id = AlgorithmId::Path,
     .name = "path",
     .grammar = "path-tracing",
     .title = "reference path tracer",
     .joins_in_media = "path-tracing"},
    {.id = AlgorithmId::PathHits,
     .name = "path-hits",
     .grammar = "path-tracing-hits",
     .title = "path tracer that runs into lights",
     .joins_in_media = "path-tracing-hits",
     .reach = Reach::Hit},
    {.id = AlgorithmId::PathNextEvent,
     .name = "path-next-event",
     .grammar = "path-tracing-next-event",
     .title = "path tracer that asks for the light",
     .joins_in_media = "path-tracing-next-event",
     .reach = Reach::NextEvent},
    {.id = AlgorithmId::Light,
     .name = "light",
     .grammar = "light-tracing",
     .title = "light tracing",
     .from_light = true,
     .splats = true,
     .joins_in_media = "light-tracing",
     .reach = Reach::Light},
    {.id = AlgorithmId::Bidirectional,
     .name = "bidirectional",
     .grammar = "bidirectional-path-tracing",
     .title = "bidirectional path tracing",
     .from_light = true,
     .splats = true,
     .joins_in_media = "bidirectional-path-tracing",
     .reach = Reach::Both},
    {.id = AlgorithmId::PhotonMap,
     .name = "photon-map",
     .grammar = "photon-map-direct",
     .title = "photon map, looked at directly",
     .from_light = true,
     .passes = true,
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Merging},
    {.id = AlgorithmId::FinalGathering,
     .name = "final-gathering",
     .grammar = "photon-mapping",
     .title = "photon mapping with final gathering",
     .from_light = true,
     .passes = true,
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Shiny},
    {.id = AlgorithmId::ProgressivePhotons,
     .name = "sppm",
     .grammar = "progressive-photon-mapping",
     .title = "stochastic progressive photon mapping",
     .from_light = true,
     .passes = true,
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Merging},
    {.id = AlgorithmId::ConnectionAndMerging,
     .name = "vcm",
     .grammar = "vertex-connection-merging",
     .title = "vertex connection and merging",
     .from_light = true,
     .splats = true,
     .passes = true,
     .joins_in_media = "bidirectional-path-tracing",
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Both},
    {.id = AlgorithmId::InstantRadiosity,
     .name = "vpl",
     .grammar = "instant-radiosity",
     .title = "instant radiosity",
     .from_light = true,
     .passes = true,
     .accuracy = Accuracy::Unbiased,
     .reach = Reach::VirtualLights},
    {.id = AlgorithmId::InstantRadiosityClamped,
     .name = "vpl-clamped",
     .grammar = "instant-radiosity",
     .title = "instant radiosity, near virtual lights clamped",
     .from_light = true,
     .passes = true,
     .accuracy = Accuracy::Biased,
     .reach = Reach::VirtualLights},
    {.id = AlgorithmId::Whitted,
     .name = "whitted",
     .grammar = "whitted",
     .title = "Whitted's recursive ray tracer",
     .reach = Reach::Matt},
    {.id = AlgorithmId::Lecture,
     .name = "lecture",
     .grammar = "lecture",
     .title = "the lecture's recursive ray tracer",
     .reach = Reach::Matt},
    {.id = AlgorithmId::Distribution,
     .name = "distribution",
     .grammar = "distribution-ray-tracing",
     .title = "distribution ray tracing (Cook)",
     .reach = Reach::Shiny},
    {.id = AlgorithmId::RayCasting,
     .name = "ray-casting",
     .grammar = "ray-casting",
     .title = "ray casting with shadow rays (Appel)",
     .reach = Reach::Matt},
    {.id = AlgorithmId::LocalShading,
     .name = "local-shading",
     .grammar = "local-shading",
     .title = "local shading without shadows (Phong)",
     .accuracy = Accuracy::Biased,
     .reach = Reach::NextEvent},
    {.id = AlgorithmId::AmbientOcclusion,
     .name = "ambient-occlusion",
     .grammar = "ambient-occlusion",
     .title = "ambient occlusion, no light of the scene",
     .accuracy = Accuracy::NotLight},
    {.id = AlgorithmId::Radiosity,
     .name = "radiosity",
     .grammar = "radiosity",
     .title = "radiosity over patches",
     .patches = true,
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Merging},
    {.id = AlgorithmId::RadiosityMirrors,
     .name = "radiosity-mirrors",
     .grammar = "radiosity-mirrors",
     .title = "radiosity seen through ray-traced mirrors",
     .patches = true,
     .accuracy = Accuracy::Consistent,
     .reach = Reach::Merging},
});

static_assert(
    [] {
      for (std::size_t i = 0; i < kAlgorithms.size(); ++i)
        if (kAlgorithms[i].id != static_cast<AlgorithmId>(i)) return false;
      return true;
    }(),
    "the table is in the order of AlgorithmId");

constexpr const AlgorithmFacts& facts(AlgorithmId id) {
  return kAlgorithms[static_cast<std::size_t>(id)];
}

inline constexpr std::string_view kAdaptive = ", adaptive";

struct RenderSettings {
  AlgorithmId algorithm = AlgorithmId::Path;
  int width = 512, height = 512;
  std::optional<record::Window> crop{};
  int samples_per_pixel = 64;  ///< of the whole, whatever the part
  record::Part part{};         ///< which of them to trace
  std::vector<bool> skip{};    ///< by pixel of the window, row by row: not to be traced; empty: all are
  int max_depth = 32;          ///< most scatterings per path
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
  /// For the window; unset: every pixel once. The record's `sampler` tells that there was one, by kAdaptive at its end.
  std::optional<record::SampleMap> sample_map{};
  PixelFilter filter{};
  SamplerKind sampler = kSamplers.front().kind;
  LabelRule labels{};  ///< nothing
  Method method{};
};

/// The part of the picture that is traced: all of it unless cropped.
inline record::Window picture_window(const RenderSettings& settings) {
  return settings.crop.value_or(record::Window{0, 0, settings.width, settings.height});
}

struct Progress {
  double fraction = 0;     ///< of all samples
  std::uint64_t rays = 0;  ///< traced so far
  double seconds = 0;      ///< since the start
};

struct RenderHooks {
  std::function<void(const Progress&)> progress;  ///< called from tracing threads, one at a time, a few times a second
  const std::atomic<bool>* stop = nullptr;        ///< set it to stop soon; the record comes back partial
  /// Called as tiles are handed over, after some of them: when all that were so far are what some number of whole
  /// samples
  /// found, and nothing else.
  std::function<void()> settled{};
};

/// Memory of each thread for what waits to be handed over with splats.
inline constexpr std::size_t kSplatBytes = 16 << 20;

/// What the record of such a render says about it. Takes: settings that render() accepts.
record::RenderInfo info_of(const Scene& scene, const RenderSettings& settings);

/// Traces the scene. The same settings and seed give the same record for any number of threads, and the
/// records of all parts of a render merge to that of the whole, bit for bit.
/// A render that splats and was stopped lacks light everywhere, not only where pixels are missing.
/// Errors: std::invalid_argument for settings out of range or a scene that breaks the rules of scene.h. A scene without
/// lights is black, not an error.
record::Record render(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks = {});

/// Traces the scene and hands over sums as tiles are finished: in no certain order, from tracing threads, one at a
/// time. Tiles of an algorithm that splats or goes by passes overlap: they add up (record/sums.h), and until the last
/// one is there, splats of walks not yet made are missing. Those of other algorithms are apart. Memory: the tiles in
/// flight and, where walks splat, kSplatBytes for each thread. Gives back whether it was not stopped. Errors: as
/// render().
bool render_tiles(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks,
                  const std::function<void(record::Tile)>& take);

/// Which techniques find the paths of each word, and how much each brings: the same walks as render()'s. Errors: as
/// render().
record::TechniqueTable measure_techniques(const Scene& scene, const RenderSettings& settings,
                                          const RenderHooks& hooks = {});

/// The same walk with nothing recorded but the picture: what recording costs is measured against this.
record::Image render_picture_only(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks = {});

}  // namespace heckbert::transport
