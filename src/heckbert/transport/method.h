#pragma once
// What algorithms can be told beyond what all have in common. The names of these settings: method_options.h.

#include <heckbert/transport/radiosity_settings.h>

namespace heckbert::transport {

struct Method {
  RadiositySettings radiosity{};
  float photon_radius =
      0.01f;                  ///< within which photons are near, of the radius of scene and eye; progressive: at first
  int photons_per_pixel = 1;  ///< walks from the light that leave photons, for each pixel and pass
  int gather_rays = 4;        ///< from each diffuse lobe
  bool one_branch = false;    ///< recursive tracers follow one ray of a surface instead of all
  bool operator==(const Method&) const = default;
};

}  // namespace heckbert::transport
