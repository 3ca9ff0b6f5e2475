#include <heckbert/transport/stage.h>

#include <heckbert/transport/ambient_occlusion.h>
#include <heckbert/transport/bidirectional.h>
#include <heckbert/transport/fault.h>
#include <heckbert/transport/final_gathering.h>
#include <heckbert/transport/instant_radiosity.h>
#include <heckbert/transport/light_tracer.h>
#include <heckbert/transport/local_shading.h>
#include <heckbert/transport/path_tracer.h>
#include <heckbert/transport/photon_tracer.h>
#include <heckbert/transport/radiosity.h>
#include <heckbert/transport/ray_casting.h>
#include <heckbert/transport/recursive_tracer.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

namespace {

/// Of the radius of scene and eye: nearer virtual lights send as if they were that far.
constexpr float kClampedDistance = 0.1f;

}  // namespace

Stage::Stage(const Scene& scene, const RenderSettings& settings)
    : tracer_(scene),
      lights_(scene, tracer_),
      eye_(scene.camera, settings.width, settings.height, settings.filter),
      emission_(scene, tracer_, lights_, scene.camera.position, scene.camera.lens_radius),
      labels_(scene, tracer_, settings.labels),
      world_{scene,
             tracer_,
             lights_,
             eye_,
             labels_,
             settings.max_depth,
             has_bodies(scene),
             has_bodies(scene) ? bodies_at(scene, tracer_, scene.camera.position) : Bodies{},
             emission_,
             picture_window(settings),
             1.0f / static_cast<float>(picture_window(settings).pixel_count()),
             planted()} {
  world_.one_branch = settings.method.one_branch;
  if (!facts(settings.algorithm).patches) return;
  radiosity_ = std::make_unique<RadiositySolution>(scene, tracer_, lights_, settings.method.radiosity,
                                                   settings.max_depth + kBouncesPastTheLimit, settings.seed);
  world_.radiosity = radiosity_.get();
}

void trace(const World& world, Walk& walk, int x, int y, AlgorithmId algorithm) {
  const auto ray = [&] { return world.eye.ray(x, y, walk.sampler); };
  switch (algorithm) {
    case AlgorithmId::Path:
      return trace_path(world, walk, ray());
    case AlgorithmId::PathHits:
      return trace_path(world, walk, ray(), {.next_event = false});
    case AlgorithmId::PathNextEvent:
      return trace_path(world, walk, ray(), {.hits = false});
    case AlgorithmId::Light:
      return trace_from_light(world, walk);
    case AlgorithmId::Bidirectional:
    case AlgorithmId::ConnectionAndMerging:
      return trace_bidirectionally(world, walk, ray());
    case AlgorithmId::PhotonMap:
    case AlgorithmId::ProgressivePhotons:
      return trace_to_photons(world, walk, ray());
    case AlgorithmId::FinalGathering:
      return trace_with_final_gathering(world, walk, ray());
    case AlgorithmId::InstantRadiosity:
      return trace_to_virtual_lights(world, walk, ray(), 0);
    case AlgorithmId::InstantRadiosityClamped:
      return trace_to_virtual_lights(world, walk, ray(), kClampedDistance * world.emission.radius());
    case AlgorithmId::Whitted:
      return trace_recursively(world, walk, ray(), {.one_branch = world.one_branch});
    case AlgorithmId::Lecture:
      return trace_recursively(world, walk, ray(),
                               {.glossy_highlights = false, .mirror_at_diffuse = true, .one_branch = world.one_branch});
    case AlgorithmId::Distribution:
      return trace_recursively(world, walk, ray(), {.spread_glossy = true, .one_branch = world.one_branch});
    case AlgorithmId::RayCasting:
      return cast_ray(world, walk, ray());
    case AlgorithmId::LocalShading:
      return shade_locally(world, walk, ray());
    case AlgorithmId::AmbientOcclusion:
      return trace_occlusion(world, walk, ray());
    case AlgorithmId::Radiosity:
      return trace_radiosity(world, walk, ray(), *world.radiosity, false);
    case AlgorithmId::RadiosityMirrors:
      return trace_radiosity(world, walk, ray(), *world.radiosity, true);
  }
}

}  // namespace heckbert::transport
