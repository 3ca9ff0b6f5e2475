#include <heckbert/transport/form_factors.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <oneapi/tbb/parallel_for.h>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/hash.h>
#include <heckbert/transport/sobol.h>

namespace heckbert::transport {

namespace {

struct Landed {
  std::uint32_t side = 0;
  std::uint32_t count = 0;
};

std::vector<Landed> landings(const PatchScene& patches, std::size_t side, FormFactorRays rays) {
  std::vector<std::uint32_t> met;
  for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(rays.per_side); ++k)
    if (const auto hit = patches.tracer.intersect(ray_from_side(patches.mesh, side, k, rays.seed)))
      met.push_back(2 * hit->primitive + (hit->front ? 0 : 1));
  std::ranges::sort(met);
  std::vector<Landed> landed;
  for (const std::uint32_t other : met) {
    if (landed.empty() || landed.back().side != other) landed.push_back({other, 0});
    ++landed.back().count;
  }
  return landed;
}

}  // namespace

Ray ray_from_side(const PatchMesh& mesh, std::size_t side, std::uint32_t k, std::uint64_t seed) {
  const Patch& patch = mesh.patches[side / 2];
  const glm::vec3 normal = side % 2 == 0 ? patch.normal : -patch.normal;
  const SobolPoint point = scrambled_sobol(k, mix(seed + kWeyl) ^ mix(side + 1));
  const auto coordinate = [&](std::size_t i) { return static_cast<float>(point[i] >> 8) * 0x1p-24f; };
  const glm::vec2 at = uniform_triangle({coordinate(0), coordinate(1)});
  const glm::vec3 position = mesh.point(patch, at.x, at.y);
  const float size = glm::distance(mesh.corner(patch, 0), mesh.corner(patch, 1)) +
                     glm::distance(mesh.corner(patch, 0), mesh.corner(patch, 2));
  return {position + clearance(position, 0, size) * normal,
          Frame::around(normal).to_world(cosine_hemisphere({coordinate(2), coordinate(3)}))};
}

std::vector<Transfer> shoot(const PatchScene& patches, std::size_t side, FormFactorRays rays) {
  std::vector<Transfer> row;
  for (const Landed& landed : landings(patches, side, rays))
    row.push_back({landed.side, static_cast<float>(landed.count) / static_cast<float>(rays.per_side)});
  return row;
}

FormFactors::FormFactors(const PatchScene& patches, const std::vector<bool>& is_marked, FormFactorRays rays) {
  const std::size_t sides = patches.mesh.side_count();
  std::vector<std::vector<Landed>> landed(sides);
  tbb::parallel_for(std::size_t{0}, sides, [&](std::size_t side) {
    if (is_marked[side]) landed[side] = landings(patches, side, rays);
  });

  // Both counts of a pair meet in either row.
  std::vector<std::vector<Transfer>> rows(sides);
  const auto area = [&](std::size_t side) { return patches.mesh.patches[side / 2].area; };
  for (std::size_t i = 0; i < sides; ++i)
    for (const auto& [j, count] : std::exchange(landed[i], std::vector<Landed>())) {
      if (!is_marked[j]) continue;
      const float rays_of_both = static_cast<float>(rays.per_side) * (1 + area(i) / area(j));
      rows[i].push_back({j, static_cast<float>(count) / rays_of_both});
      rows[j].push_back(
          {static_cast<std::uint32_t>(i), static_cast<float>(count) / rays_of_both * (area(i) / area(j))});
    }

  offsets_.assign(1, 0);
  for (std::vector<Transfer>& row : rows) {
    std::ranges::sort(row, {}, &Transfer::side);
    for (const Transfer& transfer : row) {
      if (transfers_.size() > offsets_.back() && transfers_.back().side == transfer.side)
        transfers_.back().factor += transfer.factor;
      else
        transfers_.push_back(transfer);
    }
    offsets_.push_back(transfers_.size());
    row = std::vector<Transfer>();
  }
}

}  // namespace heckbert::transport
