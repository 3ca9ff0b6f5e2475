#pragma once
// A scene with everything that walking through it takes, made once per render.

#include <memory>

#include <heckbert/transport/emission.h>
#include <heckbert/transport/radiosity_solution.h>
#include <heckbert/transport/render.h>
#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

class Stage {
 public:
  /// Refers to the scene, which must outlive it. Errors: as Tracer.
  Stage(const Scene& scene, const RenderSettings& settings);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const World& world() const { return world_; }

 private:
  Tracer tracer_;
  Lights lights_;
  Eye eye_;
  Emission emission_;
  Labels labels_;
  std::unique_ptr<RadiositySolution> radiosity_;  ///< for the algorithms that show it
  World world_;
};

/// Takes one sample of a pixel by an algorithm; what it finds is in walk.found.
void trace(const World& world, Walk& walk, int x, int y, AlgorithmId algorithm);

}  // namespace heckbert::transport
