#pragma once
// The settings of single algorithms as numbers by name, in one table. A record keeps those that are not the default, as
// text, so that its paths can be traced again and parts of different renders are told apart.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include <heckbert/transport/render.h>

namespace heckbert::transport {

struct MethodOption {
  std::string_view name;  ///< as on the command line and in records
  std::string_view meaning;
  std::span<const AlgorithmId> algorithms;  ///< that read it
  double least = 0, most = 1;               ///< both included
  bool is_whole = true;
  double (*get)(const Method&);
  void (*set)(Method&, double);
  /// As which power of it, or faster, the error of a consistent algorithm falls; 0: it is no measure of fineness.
  double order = 0;
};

inline constexpr std::array<AlgorithmId, 2> kOverPatches{AlgorithmId::Radiosity, AlgorithmId::RadiosityMirrors};
inline constexpr std::array<AlgorithmId, 4> kWithPhotons{AlgorithmId::PhotonMap, AlgorithmId::FinalGathering,
                                                         AlgorithmId::ProgressivePhotons,
                                                         AlgorithmId::ConnectionAndMerging};
/// Without the one whose samples have a walk each.
inline constexpr auto kWithFreePhotons = std::span(kWithPhotons).first<3>();
inline constexpr std::array<AlgorithmId, 1> kGathering{AlgorithmId::FinalGathering};
inline constexpr std::array<AlgorithmId, 3> kRecursive{AlgorithmId::Whitted, AlgorithmId::Lecture,
                                                       AlgorithmId::Distribution};

inline constexpr auto kMethodOptions = std::to_array<MethodOption>({
    {"patch-edge", "longest edge of a patch, over the diagonal of the scene", kOverPatches, 1e-4, 1, false,
     [](const Method& m) { return static_cast<double>(m.radiosity.longest_edge); },
     [](Method& m, double value) { m.radiosity.longest_edge = static_cast<float>(value); }, 1},
    {"refinements", "how often patches may be split where light bends", kOverPatches, 0, 8, true,
     [](const Method& m) { return static_cast<double>(m.radiosity.refinements); },
     [](Method& m, double value) { m.radiosity.refinements = static_cast<int>(value); }},
    {"patch-rays", "rays from each side of a patch, for form factors", kOverPatches, 1, 1e6, true,
     [](const Method& m) { return static_cast<double>(m.radiosity.rays_per_side); },
     [](Method& m, double value) { m.radiosity.rays_per_side = static_cast<int>(value); }},
    {"shooting", "1: progressive refinement; 0: the full matrix", kOverPatches, 0, 1, true,
     [](const Method& m) { return m.radiosity.shooting ? 1.0 : 0.0; },
     [](Method& m, double value) { m.radiosity.shooting = value != 0; }},
    {"flat", "1: patches are shown constant; 0: interpolated", kOverPatches, 0, 1, true,
     [](const Method& m) { return m.radiosity.flat ? 1.0 : 0.0; },
     [](Method& m, double value) { m.radiosity.flat = value != 0; }},
    {"photon-radius", "within which photons are near, over the radius of the scene; sppm, vcm: at first", kWithPhotons,
     1e-6, 1, false, [](const Method& m) { return static_cast<double>(m.photon_radius); },
     [](Method& m, double value) { m.photon_radius = static_cast<float>(value); }, 1},
    {"photons", "walks from the light for photons, for each pixel", kWithFreePhotons, 1, 1e4, true,
     [](const Method& m) { return static_cast<double>(m.photons_per_pixel); },
     [](Method& m, double value) { m.photons_per_pixel = static_cast<int>(value); }},
    {"gather-rays", "rays that gather light from the photons of other surfaces", kGathering, 1, 1e4, true,
     [](const Method& m) { return static_cast<double>(m.gather_rays); },
     [](Method& m, double value) { m.gather_rays = static_cast<int>(value); }},
    {"one-branch", "1: one of a surface's rays is followed, drawn at random; 0: all", kRecursive, 0, 1, true,
     [](const Method& m) { return m.one_branch ? 1.0 : 0.0; },
     [](Method& m, double value) { m.one_branch = value != 0; }},
});

/// Does the algorithm read it?
bool reads(AlgorithmId algorithm, const MethodOption& option);

/// What makes a consistent algorithm finer; null where nothing does.
const MethodOption* refining_option(AlgorithmId algorithm);

/// "patch-edge=0.05,flat=1": the options that are not the default, in the order of the table.
std::string write(const Method& method);

}  // namespace heckbert::transport
