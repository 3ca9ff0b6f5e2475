#include "end_to_end/photon_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/eye.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/tracer.h>
#include <heckbert/transport/vertex.h>

namespace heckbert::bitterli {

namespace {

using namespace transport;

constexpr float kPi = std::numbers::pi_v<float>;

struct Photon {
  glm::vec3 position;
  Rgb power;
  int scatterings;  ///< of the light, with the one to come
};

const Lambert* matt_lobe(const Vertex& vertex) {
  return vertex.lobes().empty() ? nullptr : std::get_if<Lambert>(&vertex.lobes().front());
}

/// Where the ray goes on from a mirror or glass, and what that does to radiance.
struct Passed {
  Ray ray;
  float radiance_scale;
};

std::optional<Passed> pass_delta(const Vertex& vertex, float u) {
  if (vertex.lobes().empty() || !is_delta(vertex.lobes().front())) return std::nullopt;
  const DeltaBranches branches = delta_branches(vertex.lobes().front(), vertex.wo, vertex.hit.front);
  if (u < branches.reflected.weight.g) return Passed{vertex.leave(branches.reflected.wi, false), 1};
  if (!branches.transmitted) return std::nullopt;
  return Passed{vertex.leave(branches.transmitted->wi, true), branches.transmitted->radiance_scale};
}

/// Light is bent about the shading normal, but its flux goes through the surface that is there: what a ray from the eye
/// need not know, light must (Veach 1997, 5.3.2).
float shading_correction(const Vertex& vertex, glm::vec3 in, glm::vec3 out) {
  const glm::vec3 shading = vertex.frame.n, geometric = vertex.hit.normal_geometric;
  return std::abs(glm::dot(in, shading) * glm::dot(out, geometric) /
                  (glm::dot(in, geometric) * glm::dot(out, shading)));
}

void trace_photon(const Scene& scene, const Tracer& tracer, const PhotonMap& settings, int number,
                  std::vector<Photon>& photons) {
  const Emitter& lamp = tracer.emitters().front();
  Sampler sampler(settings.seed, number, 0, 0);
  const glm::vec2 on_lamp = sampler.next2();
  Ray ray{lamp.origin + on_lamp.x * lamp.edge_u + on_lamp.y * lamp.edge_v + lamp.error * lamp.normal,
          Frame::around(lamp.normal).to_world(cosine_hemisphere(sampler.next2()))};
  Rgb power = scene.materials[lamp.material].emission * (kPi * lamp.area / static_cast<float>(settings.photons));
  for (int scatterings = 1; scatterings <= settings.longest; ++scatterings) {
    const std::optional<Hit> hit = tracer.intersect(ray);
    if (!hit) return;
    const Vertex vertex(scene, *hit, ray.direction);
    if (const Lambert* matt = matt_lobe(vertex)) {
      photons.push_back({hit->position, power, scatterings});
      const float survival = max_channel(matt->albedo);
      if (sampler.next() >= survival) return;
      power *= matt->albedo / survival;
      ray = vertex.leave(cosine_hemisphere(sampler.next2()), false);
    } else {
      const std::optional<Passed> passed = pass_delta(vertex, sampler.next());
      if (!passed) return;
      power *= shading_correction(vertex, ray.direction, passed->ray.direction);
      ray = passed->ray;
    }
  }
}

/// Photons sorted into cubes.
class Grid {
 public:
  Grid(std::vector<Photon> photons, float cell) : cell_(cell), photons_(photons.size()) {
    low_ = glm::vec3(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const Photon& photon : photons) {
      low_ = glm::min(low_, photon.position);
      high = glm::max(high, photon.position);
    }
    size_ = glm::ivec3((high - low_) / cell_) + 1;
    first_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y * size_.z) + 1, 0);
    for (const Photon& photon : photons) ++first_[index(cell_of(photon.position)) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const Photon& photon : photons) photons_[next[index(cell_of(photon.position))]++] = photon;
  }

  /// The squared distances of the nearest photons, the farthest first; fewer than `count` only if there are no more.
  using Neighbour = std::pair<float, const Photon*>;
  void nearest(glm::vec3 place, std::size_t count, std::vector<Neighbour>& found) const {
    float reach = cell_;
    do {
      found.clear();
      search(place, reach, count, found);
      reach *= 2;
    } while (found.size() < std::min(count, photons_.size()));
  }

 private:
  glm::ivec3 cell_of(glm::vec3 place) const {
    return glm::clamp(glm::ivec3((place - low_) / cell_), glm::ivec3(0), size_ - 1);
  }
  std::size_t index(glm::ivec3 c) const { return static_cast<std::size_t>((c.z * size_.y + c.y) * size_.x + c.x); }

  void search(glm::vec3 place, float reach, std::size_t count, std::vector<Neighbour>& found) const {
    const glm::ivec3 low = cell_of(place - reach), high = cell_of(place + reach);
    float farthest = reach * reach;
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (std::size_t i = first_[index({low.x, y, z})]; i < first_[index({high.x, y, z}) + 1]; ++i) {
          const glm::vec3 d = photons_[i].position - place;
          const float distance2 = glm::dot(d, d);
          if (distance2 >= farthest) continue;
          if (found.size() == count) {
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
          }
          found.emplace_back(distance2, &photons_[i]);
          std::push_heap(found.begin(), found.end());
          if (found.size() == count) farthest = found.front().first;
        }
  }

  float cell_;
  glm::vec3 low_{};
  glm::ivec3 size_{};
  std::vector<std::size_t> first_;  ///< photon of each cube, and the end
  std::vector<Photon> photons_;
};

}  // namespace

record::Image photon_mapped(const Scene& scene, const PhotonMap& settings, int width, int height,
                            int samples_per_pixel) {
  const Tracer tracer(scene);
  std::vector<Photon> photons;
  for (int i = 0; i < settings.photons; ++i) trace_photon(scene, tracer, settings, i, photons);
  const glm::vec3 extent = tracer.bounds_high() - tracer.bounds_low();
  constexpr float kCells = 256;
  const Grid grid(std::move(photons), std::max({extent.x, extent.y, extent.z}) / kCells);

  const Eye eye(scene.camera, width, height);
  record::Image image{{0, 0, width, height}, {}};
  image.pixels.resize(image.window.pixel_count());
  std::vector<Grid::Neighbour> neighbours;
  const auto radiance = [&](Sampler& sampler, Ray ray) {
    float scale = 1;
    for (int mirrors = 0; mirrors < settings.longest; ++mirrors) {
      const std::optional<Hit> hit = tracer.intersect(ray);
      if (!hit) break;
      const Vertex vertex(scene, *hit, ray.direction);
      if (const Lambert* matt = matt_lobe(vertex)) {
        grid.nearest(hit->position, static_cast<std::size_t>(settings.neighbours), neighbours);
        if (neighbours.empty()) break;
        Rgb power;
        for (const auto& [distance2, photon] : neighbours)
          if (photon->scatterings + mirrors <= settings.longest) power += photon->power;
        return matt->albedo * power * (scale / (kPi * kPi * neighbours.front().first));
      }
      const std::optional<Passed> passed = pass_delta(vertex, sampler.next());
      if (!passed) break;
      scale *= passed->radiance_scale;
      ray = passed->ray;
    }
    return Rgb{};
  };
  for (int y = 0, pixel = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++pixel) {
      Rgb& sum = image.pixels[static_cast<std::size_t>(pixel)];
      for (int sample = 0; sample < samples_per_pixel; ++sample) {
        Sampler sampler(settings.seed + 1, x, y, sample);
        const Ray ray = eye.ray(x, y, sampler);
        sum += radiance(sampler, ray) / static_cast<float>(samples_per_pixel);
      }
    }
  return image;
}

}  // namespace heckbert::bitterli
