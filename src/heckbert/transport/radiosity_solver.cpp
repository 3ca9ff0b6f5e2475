#include <heckbert/transport/radiosity_solver.h>

#include <algorithm>

#include <oneapi/tbb/parallel_for.h>

namespace heckbert::transport {

namespace {

/// W, of all channels.
double power(const PatchMesh& mesh, std::size_t side, Rgb exitance) {
  return static_cast<double>(mesh.patches[side / 2].area) * (exitance.r + exitance.g + exitance.b);
}

double power(const PatchMesh& mesh, const std::vector<Rgb>& exitances) {
  double sum = 0;
  for (std::size_t side = 0; side < exitances.size(); ++side) sum += power(mesh, side, exitances[side]);
  return sum;
}

}  // namespace

Bounces solve_by_gathering(const PatchMesh& mesh, const FormFactors& factors, const std::vector<Rgb>& albedos,
                           const std::vector<Rgb>& exitances, int most) {
  Bounces bounces;
  std::vector<Rgb> sent = exitances;
  const double least = kLeastGathered * power(mesh, exitances);
  for (int n = 0; n < most && power(mesh, sent) > least; ++n) {
    std::vector<Rgb> received(sent.size());
    tbb::parallel_for(std::size_t{0}, sent.size(), [&](std::size_t side) {
      for (const Transfer& from : factors.row(side)) received[side] += from.factor * sent[from.side];
    });
    for (std::size_t side = 0; side < sent.size(); ++side) sent[side] = albedos[side] * received[side];
    bounces.push_back(std::move(received));
  }
  return bounces;
}

Bounces solve_by_shooting(const PatchScene& patches, const std::vector<Rgb>& albedos, const std::vector<Rgb>& exitances,
                          int most, FormFactorRays rays) {
  const PatchMesh& mesh = patches.mesh;
  const std::size_t sides = exitances.size();
  Bounces received, unshot{exitances};
  std::vector<double> unshot_power(sides);
  for (std::size_t side = 0; side < sides; ++side) unshot_power[side] = power(mesh, side, exitances[side]);
  double left = power(mesh, exitances);
  const double least = kLeastShot * left;
  while (left > least) {
    const auto strongest = std::ranges::max_element(unshot_power);
    const auto from = static_cast<std::size_t>(strongest - unshot_power.begin());
    left -= *strongest;
    *strongest = 0;
    const std::vector<Transfer> row = shoot(patches, from, rays);
    const float area = mesh.patches[from / 2].area;
    for (std::size_t n = 0; n < unshot.size() && n < static_cast<std::size_t>(most); ++n) {
      const Rgb light = std::exchange(unshot[n][from], Rgb{});
      if (is_black(light)) continue;
      if (received.size() == n) received.emplace_back(sides);
      if (unshot.size() == n + 1) unshot.emplace_back(sides);
      for (const Transfer& to : row) {
        const Rgb irradiance = (to.factor * area / mesh.patches[to.side / 2].area) * light;
        received[n][to.side] += irradiance;
        const Rgb reflected = albedos[to.side] * irradiance;
        unshot[n + 1][to.side] += reflected;
        if (n + 1 == static_cast<std::size_t>(most)) continue;
        unshot_power[to.side] += power(mesh, to.side, reflected);
        left += power(mesh, to.side, reflected);
      }
    }
  }
  return received;
}

}  // namespace heckbert::transport
