#pragma once
// Radiosity (Goral, Torrance, Greenberg, Battaile 1984): the light that diffuse surfaces exchange, solved once for all
// views. Surfaces are cut into patches (patch_mesh.h), which exchange light by form factors (form_factors.h), bounce
// after bounce (radiosity_solver.h). Irradiance that was scattered n - 1 times before it arrived, seen through the
// surface's own albedo, shows the words L D^n E, each bounce by itself.
//
// Light begins with what patches receive directly, gathered at points all over them. Where irradiance is bent, so that
// a patch receives something else than its neighbours let expect, patches are split and all is solved again (after
// Cohen, Greenberg, Immel, Brock 1986).
//
// Taken for granted: surfaces reflect by their diffuse lobes alone, evenly to all sides; mirrors, glass and glossy
// surfaces only throw shadows, and so do surfaces with holes, as if they had none.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <heckbert/record/rgb.h>
#include <heckbert/taxonomy/symbol.h>
#include <heckbert/transport/lights.h>
#include <heckbert/transport/patch_mesh.h>
#include <heckbert/transport/radiosity_settings.h>
#include <heckbert/transport/radiosity_solver.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

/// Light of one kind of source.
struct RadiosityLight {
  taxonomy::Symbol kind = taxonomy::Symbol::La;
  Bounces irradiance;  ///< [n - 1][side]: scattered n - 1 times before it arrives
};

class RadiositySolution {
 public:
  /// Refers to nothing. Errors: LimitError as cut_into_patches.
  RadiositySolution(const Scene& scene, const Tracer& tracer, const Lights& lights, const RadiositySettings& settings,
                    int most_bounces, std::uint64_t seed);

  const PatchMesh& mesh() const { return patches_->mesh; }
  const std::vector<Rgb>& albedos() const { return albedos_; }           ///< diffuse, by side
  const std::vector<RadiosityLight>& lights() const { return lights_; }  ///< one per kind that there is

  /// A place on a side: how much each of its corners counts.
  struct Place {
    std::size_t side = 0;
    std::array<float, 3> weights{};
  };
  /// The place on the patches that belongs to a hit of the scene; nothing where there is none, beside a coarse ball.
  std::optional<Place> find(const Hit& hit) const;
  /// What arrives there of lights()[light], scattered `bounce` - 1 times before.
  Rgb irradiance(std::size_t light, std::size_t bounce, const Place& place) const;

 private:
  void solve(const Scene& scene, const Tracer& tracer, const Lights& lights, const RadiositySettings& settings,
             int most_bounces, std::uint64_t seed);
  std::vector<bool> patches_to_split() const;

  std::unique_ptr<PatchScene> patches_;
  std::vector<Rgb> albedos_;
  std::vector<RadiosityLight> lights_;
  std::vector<Bounces> at_corners_;  ///< by light: [n - 1][3 side + corner]
};

/// How much of even light from all around its front a diffuse lobe reflects towards wo; black for other lobes.
Rgb diffuse_reflectance(const Lobe& lobe, glm::vec3 wo);

}  // namespace heckbert::transport
