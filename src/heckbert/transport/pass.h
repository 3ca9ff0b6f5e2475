#pragma once
// Algorithms whose pixels share light, photons or virtual lights, go over the picture once for each sample number, each
// time with other light: errors that pixels share differ from pass to pass, and a fixed number of photons takes a fixed
// amount of memory.

#include <deque>
#include <optional>

#include <heckbert/transport/light_walk.h>
#include <heckbert/transport/photon_map.h>
#include <heckbert/transport/render.h>

namespace heckbert::transport {

/// A sample number of such an algorithm, with the light that its samples share.
class Pass {
 public:
  /// Walks from the light, on all threads. Refers to what `world` does.
  Pass(const World& world, const RenderSettings& settings, const SamplePlan& plan, int sample);
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  const World& world() const { return world_; }

 private:
  World world_;
  std::optional<PhotonMap> photons_, caustics_;
  std::deque<LightWalk> lights_;
};

}  // namespace heckbert::transport
