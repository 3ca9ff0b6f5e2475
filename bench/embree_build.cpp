// What Embree's build qualities and scene flags are worth: the same rays through the same triangles under each of them,
// in rays per second of one thread, with the time and memory that building took. Rays are those of a path tracer: the
// ones from the eye, and the ones that go on from where they hit, in cosine-distributed directions, up to eight times;
// and from every hit a shadow ray to a point among the scene's vertices. The settings take turns, the figures are
// medians of rounds, time is processor time.
//
// Usage: embree_build [ROUNDS [FILE...]]     default 5; scene files are added to the two built-in scenes

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/import/import.h>
#include <heckbert/transport/frame.h>

#include "embree_mesh.h"
#include "scenes.h"

namespace {

using namespace heckbert;

constexpr int kSize = 256;  ///< of the picture whose rays are traced, one per pixel
constexpr int kBounces = 8;

struct Setting {
  const char* name;
  RTCBuildQuality quality = RTC_BUILD_QUALITY_HIGH;
  RTCSceneFlags flags = RTC_SCENE_FLAG_NONE;
  RTCIntersectContextFlags hint = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
};
constexpr std::array<Setting, 7> kSettings{{
    {"high"},
    {"medium", RTC_BUILD_QUALITY_MEDIUM},
    {"low", RTC_BUILD_QUALITY_LOW},
    {"high, robust", RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_ROBUST},
    {"high, compact", RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_COMPACT},
    {"dynamic", RTC_BUILD_QUALITY_LOW, RTC_SCENE_FLAG_DYNAMIC},
    {"high, coherent hint", RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_NONE, RTC_INTERSECT_CONTEXT_FLAG_COHERENT},
}};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A scene's triangles in Embree, under one setting.
class Triangles {
 public:
  Triangles(const transport::Scene& scene, const Setting& setting)
      : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    const auto add_bytes = [](void* bytes, ssize_t more, bool) {
      *static_cast<std::atomic<ssize_t>*>(bytes) += more;
      return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device_, add_bytes, &bytes_);
    const double start = processor_seconds();
    rtcSetSceneBuildQuality(scene_, setting.quality);
    rtcSetSceneFlags(scene_, setting.flags);
    for (const transport::Shape& shape : scene.shapes)
      if (const auto* mesh = std::get_if<transport::Mesh>(&shape.geometry)) attach(*mesh);
    rtcCommitScene(scene_);
    build_seconds = processor_seconds() - start;
  }
  ~Triangles() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Triangles(const Triangles&) = delete;
  Triangles& operator=(const Triangles&) = delete;

  RTCScene get() const { return scene_; }
  double megabytes() const { return static_cast<double>(bytes_) * 1e-6; }
  double build_seconds = 0;
  std::size_t count = 0;

 private:
  void attach(const transport::Mesh& mesh) {
    bench::attach_mesh(device_, scene_, mesh);
    count += mesh.triangles.size();
  }

  RTCDevice device_;
  RTCScene scene_;
  std::atomic<ssize_t> bytes_{0};
};

RTCRay ray_from(glm::vec3 origin, glm::vec3 direction, float farthest) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = farthest;
  ray.mask = ~0u;
  return ray;
}

RTCHit trace(RTCScene scene, RTCRay& ray, RTCIntersectContextFlags hint) {
  RTCRayHit query;
  query.ray = ray;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = hint;
  rtcIntersect1(scene, &context, &query);
  ray.tfar = query.ray.tfar;
  return query.hit;
}

struct Rays {
  std::vector<RTCRay> primary, bounced, shadow;  ///< in the order in which a path tracer meets them
};

/// Found once, so that every setting gets the same.
Rays rays_of(const transport::Scene& scene) {
  const Triangles triangles(scene, kSettings.front());
  std::vector<glm::vec3> targets;
  for (const transport::Shape& shape : scene.shapes)
    if (const auto* mesh = std::get_if<transport::Mesh>(&shape.geometry))
      targets.insert(targets.end(), mesh->positions.begin(), mesh->positions.end());
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  std::uniform_int_distribution<std::size_t> any_target(0, targets.size() - 1);

  const transport::Camera& camera = scene.camera;
  const transport::Frame eye = transport::Frame::along(glm::normalize(camera.position - camera.look_at),
                                                       glm::cross(camera.up, camera.position - camera.look_at));
  const float half = std::tan(0.5f * glm::radians(camera.vertical_fov_degrees));
  Rays rays;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 film = 2.0f * glm::vec2(x, y) / static_cast<float>(kSize) - 1.0f;
      glm::vec3 origin = camera.position;
      glm::vec3 direction = glm::normalize(eye.to_world({half * film.x, -half * film.y, -1}));
      for (int bounce = 0; bounce < kBounces; ++bounce) {
        RTCRay ray = ray_from(origin, direction, std::numeric_limits<float>::infinity());
        (bounce == 0 ? rays.primary : rays.bounced).push_back(ray);
        const RTCHit hit = trace(triangles.get(), ray, RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
        if (hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
        glm::vec3 normal = glm::normalize(glm::vec3(hit.Ng_x, hit.Ng_y, hit.Ng_z));
        if (glm::dot(normal, direction) > 0) normal = -normal;
        origin += ray.tfar * direction + 1e-4f * ray.tfar * normal;
        rays.shadow.push_back(ray_from(origin, targets[any_target(generator)] - origin, 0.999f));
        direction = transport::Frame::around(normal).to_world(
            transport::cosine_hemisphere({uniform(generator), uniform(generator)}));
      }
    }
  return rays;
}

/// Million rays per second.
double speed(RTCScene scene, const std::vector<RTCRay>& rays, RTCIntersectContextFlags hint) {
  const double start = processor_seconds();
  for (RTCRay ray : rays) trace(scene, ray, hint);
  return 1e-6 * static_cast<double>(rays.size()) / (processor_seconds() - start);
}

double speed_of_shadows(RTCScene scene, const std::vector<RTCRay>& rays) {
  const double start = processor_seconds();
  for (RTCRay ray : rays) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
  }
  return 1e-6 * static_cast<double>(rays.size()) / (processor_seconds() - start);
}

void measure(const std::string& name, const transport::Scene& scene, int rounds) {
  struct Figures {
    std::vector<double> primary, bounced, shadow, build;
    double megabytes = 0;
  };
  const Rays rays = rays_of(scene);
  std::array<Figures, kSettings.size()> figures;
  std::size_t triangles_count = 0;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < kSettings.size(); ++i) {
      const Triangles triangles(scene, kSettings[i]);
      Figures& f = figures[i];
      f.build.push_back(triangles.build_seconds);
      f.megabytes = triangles.megabytes();
      f.primary.push_back(speed(triangles.get(), rays.primary, kSettings[i].hint));
      f.bounced.push_back(speed(triangles.get(), rays.bounced, kSettings[i].hint));
      f.shadow.push_back(speed_of_shadows(triangles.get(), rays.shadow));
      triangles_count = triangles.count;
    }
  fmt::print("{}, {} triangles; million rays per second\n{:<20}{:>10}{:>10}{:>10}{:>10}{:>10}\n", name, triangles_count,
             "", "eye", "bounced", "shadow", "build ms", "MB");
  for (std::size_t i = 0; i < kSettings.size(); ++i)
    fmt::print("{:<20}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.1f}{:>10.1f}\n", kSettings[i].name, median(figures[i].primary),
               median(figures[i].bounced), median(figures[i].shadow), 1e3 * median(figures[i].build),
               figures[i].megabytes);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  if (rounds < 1) {
    fmt::print(stderr, "usage: embree_build [ROUNDS [FILE...]]\n");
    return 2;
  }
  measure("boxes", bench::boxes(), rounds);
  measure("ball", bench::ball(), rounds);
  for (int i = 2; i < argc; ++i) measure(argv[i], import::load_scene(argv[i]).scene, rounds);
}
