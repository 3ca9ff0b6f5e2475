#include <heckbert/transport/radiosity_solution.h>

#include <algorithm>
#include <cmath>

#include <oneapi/tbb/parallel_for.h>
#include <glm/common.hpp>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/lobe.h>
#include <heckbert/transport/sobol.h>
#include <heckbert/transport/texture.h>
#include <heckbert/transport/vertex.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

/// Directions of even light.
constexpr std::uint32_t kDirections = 16;

glm::vec3 direction_of_even_light(std::uint32_t i) {
  const SobolPoint point = scrambled_sobol(i, 0);
  const auto coordinate = [&](std::size_t k) { return static_cast<float>(point[k] >> 8) * 0x1p-24f; };
  return cosine_hemisphere({coordinate(0), coordinate(1)});
}

glm::vec3 normal_of(const PatchMesh& mesh, std::size_t side) {
  const glm::vec3 front = mesh.patches[side / 2].normal;
  return side % 2 == 0 ? front : -front;
}

/// The middle of a side as the scene's own surface: met from close by where the material has textures, so that their
/// coordinates are known.
Hit middle_of(const Scene& scene, const Tracer& tracer, const PatchMesh& mesh, std::size_t side) {
  const Patch& patch = mesh.patches[side / 2];
  const PatchPart& part = mesh.parts[patch.part];
  const Material& material = scene.materials[part.material];
  Hit hit;
  hit.position = mesh.point(patch, 1.0f / 3.0f, 1.0f / 3.0f);
  hit.normal_geometric = hit.normal_shading = patch.normal;
  hit.front = side % 2 == 0;
  hit.material = part.material;
  hit.shape = part.shape;
  if (material.textures.empty()) return hit;
  const float near = std::sqrt(patch.area);
  const glm::vec3 normal = normal_of(mesh, side);
  const auto met = tracer.intersect({hit.position + near * normal, -normal}, 2 * near);
  return met && met->shape == part.shape && met->front == hit.front ? *met : hit;
}

Rgb albedo_of(const Scene& scene, const Hit& middle, glm::vec3 normal) {
  const Vertex vertex(scene, middle, -normal);
  Rgb albedo;
  for (const Lobe& lobe : vertex.lobes())
    for (std::uint32_t i = 0; i < kDirections; ++i)
      albedo += diffuse_reflectance(lobe, direction_of_even_light(i)) / static_cast<float>(kDirections);
  return albedo;
}

constexpr std::array<Symbol, 4> kKinds{Symbol::La, Symbol::Lp, Symbol::Ld, Symbol::Le};

/// By kind of light.
using DirectIrradiance = std::array<Rgb, kKinds.size()>;

struct SurfacePoint {
  glm::vec3 position, normal;
};

/// The k-th of many points all over a side: on the surface itself where that is a ball, and moved off it.
SurfacePoint point_of_side(const PatchMesh& mesh, std::size_t side, std::uint32_t k, std::uint64_t seed) {
  const glm::vec3 normal = normal_of(mesh, side);
  const glm::vec3 position = ray_from_side(mesh, side, k, seed).origin;
  const PatchPart& part = mesh.parts[mesh.patches[side / 2].part];
  if (part.form != PatchPart::Form::Sphere) return {position, normal};
  const glm::vec3 outward = glm::normalize(position - part.center);
  const glm::vec3 on_ball = part.center + part.radius * outward;
  const glm::vec3 towards = side % 2 == 0 ? outward : -outward;
  return {on_ball + clearance(on_ball, 0, part.radius) * towards, towards};
}

/// What a light sends to a point along its sample, when nothing is in between.
Rgb arriving(const Tracer& tracer, const Lights& lights, glm::vec3 from, const LightSample& light) {
  const Ray ray{from, light.direction};
  if (light.to_be_met != kNoEmitter) {
    const auto met = tracer.intersect(ray);
    return met && met->emitter == light.to_be_met ? lights.emitted(*met) : Rgb{};
  }
  return (light.infinite ? tracer.is_occluded(ray) : tracer.is_occluded(from, light.target)) ? Rgb{} : light.radiance;
}

/// Direct light at points all over a side, with a shadow ray each: form factors of lamps as Wallace, Elmquist and
/// Haines (1989) measure them.
DirectIrradiance gather_directly(const Tracer& tracer, const Lights& lights, const PatchMesh& mesh, std::size_t side,
                                 FormFactorRays rays) {
  const SamplePlan plan{SamplerKind::Sobol, rays.seed, rays.per_side};
  DirectIrradiance sum{};
  for (int k = 0; k < rays.per_side; ++k) {
    const auto [position, normal] = point_of_side(mesh, side, static_cast<std::uint32_t>(k), rays.seed);
    Sampler sampler(plan, static_cast<int>(side & 0xffff), static_cast<int>(side >> 16), k);
    const LightSample light = lights.sample(position, sampler);
    const float cosine = glm::dot(normal, light.direction);
    if (!(light.pdf_solid_angle > 0) || !(cosine > 0)) continue;
    const auto kind = std::ranges::find(kKinds, light.kind);
    sum[static_cast<std::size_t>(kind - kKinds.begin())] +=
        arriving(tracer, lights, position, light) *
        (cosine / (light.pdf_solid_angle * static_cast<float>(rays.per_side)));
  }
  return sum;
}

/// By corner of a side, 3 side + corner: the sides around it that go on smoothly, the side itself included.
std::vector<std::vector<std::uint32_t>> smooth_neighbours(const PatchMesh& mesh) {
  constexpr float kSmooth = 0.9f;  // cosine of the angle between neighbours
  std::vector<std::vector<std::uint32_t>> around(mesh.positions.size());
  for (std::uint32_t i = 0; i < mesh.patches.size(); ++i)
    for (const std::uint32_t corner : mesh.patches[i].corners) around[corner].push_back(i);
  std::vector<std::vector<std::uint32_t>> neighbours(3 * mesh.side_count());
  for (std::size_t side = 0; side < mesh.side_count(); ++side) {
    const Patch& patch = mesh.patches[side / 2];
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::uint32_t other : around[patch.corners[k]])
        if (mesh.patches[other].part == patch.part && glm::dot(mesh.patches[other].normal, patch.normal) > kSmooth)
          neighbours[3 * side + k].push_back(2 * other + static_cast<std::uint32_t>(side % 2));
  }
  return neighbours;
}

/// What the corners of sides receive: the mean of the sides around them.
Bounces at_corners(const PatchMesh& mesh, const std::vector<std::vector<std::uint32_t>>& neighbours,
                   const Bounces& by_side) {
  Bounces result;
  for (const std::vector<Rgb>& irradiance : by_side) {
    std::vector<Rgb>& corners = result.emplace_back(neighbours.size());
    tbb::parallel_for(std::size_t{0}, neighbours.size(), [&](std::size_t corner) {
      float area = 0;
      for (const std::uint32_t side : neighbours[corner]) {
        corners[corner] += mesh.patches[side / 2].area * irradiance[side];
        area += mesh.patches[side / 2].area;
      }
      corners[corner] *= 1 / area;
    });
  }
  return result;
}

Bounces constant_over_sides(const Bounces& by_side) {
  Bounces result;
  for (const std::vector<Rgb>& irradiance : by_side) {
    std::vector<Rgb>& corners = result.emplace_back();
    for (const Rgb value : irradiance) corners.insert(corners.end(), 3, value);
  }
  return result;
}

}  // namespace

Rgb diffuse_reflectance(const Lobe& lobe, glm::vec3 wo) {
  if (const auto* lambert = std::get_if<Lambert>(&lobe)) return lambert->albedo;
  if (is_delta(lobe) || letter(lobe) != Symbol::Dr) return {};
  Rgb sum;
  for (std::uint32_t i = 0; i < kDirections; ++i) sum += evaluate(lobe, wo, direction_of_even_light(i));
  return sum * (kPi / static_cast<float>(kDirections));
}

RadiositySolution::RadiositySolution(const Scene& scene, const Tracer& tracer, const Lights& lights,
                                     const RadiositySettings& settings, int most_bounces, std::uint64_t seed) {
  const float longest = settings.longest_edge * glm::distance(tracer.bounds_low(), tracer.bounds_high());
  patches_ = std::make_unique<PatchScene>(cut_into_patches(scene, longest));
  for (int refinement = 0;; ++refinement) {
    solve(scene, tracer, lights, settings, most_bounces, seed);
    if (refinement == settings.refinements) break;
    const std::vector<bool> marked = patches_to_split();
    if (std::ranges::find(marked, true) == marked.end()) break;
    patches_ = std::make_unique<PatchScene>(split(patches_->mesh, marked));
  }
  if (!settings.flat) return;
  for (std::size_t i = 0; i < lights_.size(); ++i) at_corners_[i] = constant_over_sides(lights_[i].irradiance);
}

void RadiositySolution::solve(const Scene& scene, const Tracer& tracer, const Lights& lights,
                              const RadiositySettings& settings, int most_bounces, std::uint64_t seed) {
  const PatchMesh& mesh = patches_->mesh;
  const std::size_t sides = mesh.side_count();
  const FormFactorRays rays{settings.rays_per_side, seed};
  albedos_.assign(sides, {});
  std::vector<bool> reflects(sides);
  for (std::size_t side = 0; side < sides; ++side) {
    albedos_[side] = albedo_of(scene, middle_of(scene, tracer, mesh, side), normal_of(mesh, side));
    reflects[side] = !is_black(albedos_[side]);
  }
  std::vector<DirectIrradiance> direct(sides);
  if (!lights.empty() && most_bounces > 0)
    tbb::parallel_for(std::size_t{0}, sides, [&](std::size_t side) {
      if (reflects[side]) direct[side] = gather_directly(tracer, lights, mesh, side, rays);
    });

  std::optional<FormFactors> factors;
  if (!settings.shooting) factors.emplace(*patches_, reflects, rays);
  lights_.clear();
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    std::vector<Rgb> first(sides), reflected(sides);
    for (std::size_t side = 0; side < sides; ++side) {
      first[side] = direct[side][kind];
      reflected[side] = albedos_[side] * first[side];
    }
    if (std::ranges::all_of(first, is_black)) continue;
    Bounces bounces = factors ? solve_by_gathering(mesh, *factors, albedos_, reflected, most_bounces - 1)
                              : solve_by_shooting(*patches_, albedos_, reflected, most_bounces - 1, rays);
    bounces.insert(bounces.begin(), std::move(first));
    lights_.push_back({kKinds[kind], std::move(bounces)});
  }

  const auto neighbours = smooth_neighbours(mesh);
  at_corners_.clear();
  for (const RadiosityLight& light : lights_) at_corners_.push_back(at_corners(mesh, neighbours, light.irradiance));
}

std::vector<bool> RadiositySolution::patches_to_split() const {
  // Over the mean of all that reflects, so that dark corners are not cut finer than can be seen.
  constexpr double kMuch = 0.1;
  const PatchMesh& mesh = patches_->mesh;
  std::vector<double> received(mesh.side_count()), at_corners(3 * mesh.side_count());
  for (std::size_t i = 0; i < lights_.size(); ++i)
    for (std::size_t n = 0; n < lights_[i].irradiance.size(); ++n)
      for (std::size_t side = 0; side < received.size(); ++side) {
        received[side] += luminance(lights_[i].irradiance[n][side]);
        for (std::size_t k = 3 * side; k < 3 * side + 3; ++k) at_corners[k] += luminance(at_corners_[i][n][k]);
      }
  double sum = 0, area = 0;
  for (std::size_t side = 0; side < received.size(); ++side) {
    if (is_black(albedos_[side])) continue;
    sum += mesh.patches[side / 2].area * received[side];
    area += mesh.patches[side / 2].area;
  }
  std::vector<bool> marked(mesh.patches.size());
  for (std::size_t side = 0; side < received.size(); ++side) {
    if (is_black(albedos_[side])) continue;
    const double expected = (at_corners[3 * side] + at_corners[3 * side + 1] + at_corners[3 * side + 2]) / 3;
    if (std::abs(received[side] - expected) > kMuch * sum / area) marked[side / 2] = true;
  }
  return marked;
}

std::optional<RadiositySolution::Place> RadiositySolution::find(const Hit& hit) const {
  const PatchMesh& mesh = patches_->mesh;
  // The patches of a ball lie below it, by less than their size; other surfaces may lie in between.
  const glm::vec3 normal = hit.front ? hit.normal_geometric : -hit.normal_geometric;
  const float farthest = 1e-2f * glm::distance(patches_->tracer.bounds_low(), patches_->tracer.bounds_high());
  Ray ray{hit.position + 2 * hit.error * normal, -normal};
  constexpr int kMostInBetween = 8;
  for (int i = 0; i < kMostInBetween; ++i) {
    const auto met = patches_->tracer.intersect(ray, farthest);
    if (!met) return std::nullopt;
    const Patch& patch = mesh.patches[met->primitive];
    if (mesh.parts[patch.part].shape == hit.shape && met->front == hit.front) {
      const std::array<float, 3> weights = mesh.barycentric(patch, met->position);
      return Place{2 * std::size_t{met->primitive} + (hit.front ? 0 : 1), weights};
    }
    ray.origin = leave(*met, !met->front);
  }
  return std::nullopt;
}

Rgb RadiositySolution::irradiance(std::size_t light, std::size_t bounce, const Place& place) const {
  const std::vector<Rgb>& corners = at_corners_[light][bounce - 1];
  Rgb sum;
  for (std::size_t k = 0; k < 3; ++k) sum += place.weights[k] * corners[3 * place.side + k];
  return sum;
}

}  // namespace heckbert::transport
