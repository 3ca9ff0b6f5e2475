// How much of our reference path tracer is tracing: its paths per second, every word recorded, over those of a bare
// loop that does nothing but Embree, Lambert, next-event estimation and the same roulette, on the same scene. Both run
// on one thread, in turn; the figure is the median of the ratios of each pair, in processor time without the building
// of the tree, since other programs on the machine change the wall clock and the speed of the machine drifts.
//
// The bare loop takes every short cut that a scene of lambertian triangles with one lamp allows: no multiple importance
// weights, one light, one lobe, no texture, no medium, nothing spelt, one colour added per pixel.
//
// Usage: path_tracing [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]     defaults 5 16 256

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/render.h>
#include <heckbert/transport/tracer.h>

#include "embree_mesh.h"
#include "scenes.h"

namespace {

using namespace heckbert;
using transport::kPi;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class F>
double seconds(F f) {
  const double start = processor_seconds();
  f();
  return processor_seconds() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// ---- the bare loop --------------------------------------------------------------------------------------------------

/// xorshift64* (Vigna 2016): as cheap as random numbers get.
struct Random {
  std::uint64_t state;
  float operator()() {
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return static_cast<float>((state * 0x2545f4914f6cdd1du) >> 40) * 0x1p-24f;
  }
};

class BareLoop {
 public:
  explicit BareLoop(const transport::Scene& scene) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    for (const transport::Shape& shape : scene.shapes) attach(scene, shape);
    rtcCommitScene(scene_);
  }
  ~BareLoop() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  BareLoop(const BareLoop&) = delete;
  BareLoop& operator=(const BareLoop&) = delete;

  std::vector<Rgb> render(const transport::Camera& camera, int size, int samples, int max_depth) const {
    const glm::vec3 forward = glm::normalize(camera.look_at - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float half = std::tan(0.5f * glm::radians(camera.vertical_fov_degrees));
    const float pixel = 2.0f * half / static_cast<float>(size);
    std::vector<Rgb> picture(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    Random random{0x9e3779b97f4a7c15u};
    Rgb* out = picture.data();
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x, ++out) {
        for (int sample = 0; sample < samples; ++sample) {
          const float film_x = (static_cast<float>(x) + random()) * pixel - half;
          const float film_y = half - (static_cast<float>(y) + random()) * pixel;
          *out += trace(camera.position, glm::normalize(forward + film_x * right + film_y * up), random, max_depth);
        }
        *out *= 1.0f / static_cast<float>(samples);
      }
    return picture;
  }

 private:
  struct Surface {
    Rgb albedo, emission;
  };
  struct LampTriangle {
    glm::vec3 p0, edge1, edge2, normal;
  };
  static constexpr float kClearance = 1e-4f;  ///< relative to the distance travelled

  void attach(const transport::Scene& scene, const transport::Shape& shape) {
    const auto& mesh = std::get<transport::Mesh>(shape.geometry);
    const transport::Material& material = scene.materials[shape.material];
    bench::attach_mesh(device_, scene_, mesh);
    surfaces_.push_back({std::get<transport::Lambert>(material.lobes.at(0)).albedo, material.emission});
    if (is_black(material.emission)) return;
    lamp_emission_ = material.emission;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 p0 = mesh.positions[t.x];
      const glm::vec3 edge1 = mesh.positions[t.y] - p0, edge2 = mesh.positions[t.z] - p0;
      const glm::vec3 cross = glm::cross(edge1, edge2);
      lamp_.push_back({p0, edge1, edge2, glm::normalize(cross)});
      lamp_area_ += 0.5f * glm::length(cross);
    }
  }

  Rgb trace(glm::vec3 origin, glm::vec3 direction, Random& random, int max_depth) const {
    Rgb sum, throughput(1.0f);
    for (int depth = 0;; ++depth) {
      RTCRayHit query;
      query.ray.org_x = origin.x;
      query.ray.org_y = origin.y;
      query.ray.org_z = origin.z;
      query.ray.dir_x = direction.x;
      query.ray.dir_y = direction.y;
      query.ray.dir_z = direction.z;
      query.ray.tnear = 0;
      query.ray.tfar = std::numeric_limits<float>::infinity();
      query.ray.mask = ~0u;
      query.ray.time = 0;
      query.ray.flags = 0;
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(scene_, &context, &query);
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return sum;
      const Surface& surface = surfaces_[query.hit.geomID];
      const glm::vec3 front = glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z));
      const bool is_front = glm::dot(front, direction) < 0;
      if (depth == 0 && is_front) sum += surface.emission;
      if (depth == max_depth) return sum;
      const glm::vec3 normal = is_front ? front : -front;
      origin += query.ray.tfar * direction + kClearance * query.ray.tfar * normal;
      sum += throughput * surface.albedo * direct_light(origin, normal, random);
      direction = transport::Frame::around(normal).to_world(transport::cosine_hemisphere({random(), random()}));
      throughput *= surface.albedo;
      if (depth + 1 >= 4) {
        const float survival = std::min(0.95f, max_channel(throughput));
        if (random() >= survival) return sum;
        throughput *= 1.0f / survival;
      }
    }
  }

  Rgb direct_light(glm::vec3 origin, glm::vec3 normal, Random& random) const {
    const auto pick = static_cast<std::size_t>(random() * static_cast<float>(lamp_.size()));
    const LampTriangle& lamp = lamp_[pick];
    const glm::vec2 b = transport::uniform_triangle({random(), random()});
    const glm::vec3 d = lamp.p0 + b.x * lamp.edge1 + b.y * lamp.edge2 - origin;
    const float distance2 = glm::dot(d, d);
    const float cosines = -glm::dot(d, lamp.normal) * glm::dot(d, normal);
    if (cosines <= 0 || glm::dot(d, normal) <= 0) return {};
    RTCRay query{};
    query.org_x = origin.x;
    query.org_y = origin.y;
    query.org_z = origin.z;
    query.dir_x = d.x;
    query.dir_y = d.y;
    query.dir_z = d.z;
    query.tfar = 1.0f - kClearance;
    query.mask = ~0u;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_, &context, &query);
    if (query.tfar < 0) return {};
    return lamp_emission_ * (cosines * lamp_area_ / (kPi * distance2 * distance2));
  }

  RTCDevice device_;
  RTCScene scene_;
  std::vector<Surface> surfaces_;
  std::vector<LampTriangle> lamp_;
  Rgb lamp_emission_;
  float lamp_area_ = 0;
};

// ---- the comparison -------------------------------------------------------------------------------------------------

double mean_green(const std::vector<Rgb>& pixels) {
  double sum = 0;
  for (const Rgb& p : pixels) sum += static_cast<double>(p.g);
  return sum / static_cast<double>(pixels.size());
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  const int samples = argc > 2 ? std::atoi(argv[2]) : 16;
  const int size = argc > 3 ? std::atoi(argv[3]) : 256;
  if (rounds < 1 || samples < 1 || size < 1) {
    fmt::print(stderr, "usage: path_tracing [ROUNDS [SAMPLES_PER_PIXEL [SIZE]]]\n");
    return 2;
  }
  const struct {
    const char* name;
    transport::Scene scene;
    double aim;
  } rows[] = {{"boxes, 32 triangles", bench::boxes(), 0.6}, {"ball, half a million triangles", bench::ball(), 0.75}};
  for (const auto& row : rows) {
    // The bare loop draws random numbers, so the renderer does too.
    const transport::RenderSettings settings{.width = size,
                                             .height = size,
                                             .samples_per_pixel = samples,
                                             .threads = 1,
                                             .sampler = transport::SamplerKind::Random};
    const BareLoop bare_loop(row.scene);
    std::vector<double> ratios, ours, bare;
    double our_mean = 0, bare_mean = 0;
    for (int round = 0; round < rounds; ++round) {
      const double building = seconds([&] { const transport::Tracer tracer(row.scene); });
      ours.push_back(seconds([&] {
                       const record::Record record = transport::render(row.scene, settings);
                       our_mean = mean_green(record::beauty(record).pixels);
                     }) -
                     building);
      bare.push_back(seconds(
          [&] { bare_mean = mean_green(bare_loop.render(row.scene.camera, size, samples, settings.max_depth)); }));
      ratios.push_back(bare.back() / ours.back());
    }
    const double paths = static_cast<double>(size) * size * samples;
    fmt::print(
        "{}: ours {:.2f}, bare {:.2f} million paths per second, ratio {:.3f} ({:.3f} to {:.3f}), aim {}; mean green "
        "{:.4f} and {:.4f}\n",
        row.name, 1e-6 * paths / median(ours), 1e-6 * paths / median(bare), median(ratios),
        *std::min_element(ratios.begin(), ratios.end()), *std::max_element(ratios.begin(), ratios.end()), row.aim,
        our_mean, bare_mean);
  }
}
