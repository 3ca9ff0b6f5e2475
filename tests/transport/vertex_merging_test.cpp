// Vertex connection and merging: its weights against the densities of whole paths, through media too. That its words
// have the values they should: photon_test.cpp, bidirectional_test.cpp.

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/pass.h>
#include <heckbert/transport/stage.h>
#include <heckbert/transport/vertex_merging.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

/// A path x_0 (light) to x_k (a pinhole), with densities that could be anything.
struct Path {
  /// A vertex between the ends.
  struct Between {
    bool is_delta = false, is_particle = false;
    double to_eye = 1, to_light = 1;          ///< per steradian, of walks that come from the other side
    double facing_light = 1, facing_eye = 1;  ///< cosines; of a particle, rates of flights that end there
  };
  std::vector<Between> between;                    ///< x_1 to x_(k-1)
  std::vector<double> squared_distances, chances;  ///< by edge: of flights to get through
  double place = 1, departure = 1;                 ///< of walks from the light: per area; per steradian
  double next_event = 1, cos_light = 1;            ///< at x_0: per area; of the first edge
  double ray = 1;                                  ///< of the walk from the eye, per steradian
  double walks = 1, merging = 1;

  std::size_t last() const { return between.size() + 1; }
  const Between& at(std::size_t i) const { return between[i - 1]; }
  /// With which a walk from the light comes to x_i from the one before, per area; likewise from the eye.
  double from_light(std::size_t i) const {
    return (i == 1 ? departure : at(i - 1).to_eye) * at(i).facing_light * chances[i - 1] / squared_distances[i - 1];
  }
  double from_eye(std::size_t i) const {
    const double facing = i == 0 ? cos_light : at(i).facing_eye;
    return (i + 1 == last() ? ray : at(i + 1).to_light) * facing * chances[i] / squared_distances[i];
  }
  bool is_delta(std::size_t i) const { return i != 0 && i != last() && at(i).is_delta; }

  Rivals light_rivals(std::size_t i) const {
    Rivals rivals{.near = squared(next_event / (place * from_light(1))),
                  .far = squared(cos_light * chances[0] / squared_distances[0] / (place * from_light(1)))};
    for (std::size_t j = 1;; ++j) {
      if (!at(j).is_particle) rivals.near += squared(merging);
      if (j == i) return rivals;
      Step step{.is_delta = at(j).is_delta,
                .is_from_particle = at(j).is_particle,
                .pdf_solid_angle = at(j).to_eye,
                .pdf_reverse = at(j).to_light};
      rivals = rivals_after(rivals, ended(step, at(j).facing_eye, at(j + 1).facing_light, j));
    }
  }
  Rivals eye_rivals(std::size_t i) const {
    Rivals rivals{.near = squared(walks / from_eye(last() - 1))};
    for (std::size_t j = last() - 1; j != i; --j) {
      if (!at(j).is_particle) rivals.near += squared(merging);
      Step step{.is_delta = at(j).is_delta,
                .is_from_particle = at(j).is_particle,
                .pdf_solid_angle = at(j).to_light,
                .pdf_reverse = at(j).to_eye};
      rivals = rivals_after(rivals, ended(step, at(j).facing_light, j == 1 ? cos_light : at(j - 1).facing_eye, j - 1));
    }
    if (i != 0 && !at(i).is_particle) rivals.near += squared(merging);
    return rivals;
  }
  /// Along the edge of that number; a particle's rate is known only once the step is made.
  Step ended(Step step, double facing_from, double facing_to, std::size_t edge) const {
    if (!step.is_from_particle) step.facing_from = facing_from;
    step.end({.chance = static_cast<float>(chances[edge]), .rate_begin = static_cast<float>(facing_from)}, facing_to,
             squared_distances[edge]);
    return step;
  }
};

/// What the two tables below have in common: by number of vertices from the light, joined and merged.
struct Table {
  std::vector<double> joined, merged;
  double sum() const {
    double sum = 0;
    for (const double x : joined) sum += x;
    for (const double x : merged) sum += x;
    return sum;
  }
};

bool can_be_joined(const Path& path, std::size_t s) {
  return s == 0 || (!path.is_delta(s - 1) && !path.is_delta(s));
}

bool can_be_merged(const Path& path, std::size_t i) {
  return !path.is_delta(i) && !path.at(i).is_particle;
}

/// The square of each technique's density, of all walks of a pass.
Table squared_densities(const Path& path) {
  const auto of_light = [&](std::size_t s) {
    double density = path.place;
    for (std::size_t i = 1; i < s; ++i) density *= path.from_light(i);
    return density;
  };
  const auto of_eye = [&](std::size_t s) {
    double density = 1;
    for (std::size_t i = s; i < path.last(); ++i) density *= path.from_eye(i);
    return density;
  };
  Table table;
  for (std::size_t s = 0; s <= path.last(); ++s) {
    const double light = s == 0 ? 1 : s == 1 ? path.next_event : of_light(s);
    const double walks = s == path.last() ? path.walks : 1;
    table.joined.push_back(can_be_joined(path, s) ? squared(light * of_eye(s) * walks) : 0);
  }
  for (std::size_t i = 1; i < path.last(); ++i)
    table.merged.push_back(!can_be_merged(path, i) ? 0 : squared(of_light(i + 1) * of_eye(i) * path.merging));
  return table;
}

/// The weights that tracers give them.
Table weights(const Path& path) {
  Table table;
  for (std::size_t s = 0; s <= path.last(); ++s) {
    double rivals = 0;
    if (s == 0) {
      const Rivals eye = path.eye_rivals(0);
      rivals = squared(path.next_event) * eye.near + squared(path.place * path.departure) * eye.far;
    } else if (s == 1) {
      rivals = squared(path.from_eye(0) / path.next_event) +
               path.eye_rivals(1).sum(path.place * path.from_light(1) / path.next_event, path.at(1).to_eye);
    } else {
      const double reached = path.from_eye(s - 1) / (s == path.last() ? path.walks : 1);
      rivals = path.light_rivals(s - 1).sum(reached, path.at(s - 1).to_light);
      if (s < path.last()) rivals += path.eye_rivals(s).sum(path.from_light(s), path.at(s).to_eye);
    }
    table.joined.push_back(can_be_joined(path, s) ? weight_against(rivals) : 0);
  }
  for (std::size_t i = 1; i < path.last(); ++i)
    table.merged.push_back(!can_be_merged(path, i)
                               ? 0
                               : weight_of_merging(path.merging, path.light_rivals(i), path.at(i).to_light,
                                                   path.eye_rivals(i), path.at(i).to_eye));
  return table;
}

TEST(VertexMerging, WeightsOfOnePathAreThePowerHeuristicAndAddUpToOne) {
  std::mt19937 random(5);
  const auto any = [&] { return std::exp(std::uniform_real_distribution(-2.0, 2.0)(random)); };
  // What a Passage has is in single precision.
  const auto any_float = [&] { return static_cast<double>(static_cast<float>(any())); };
  const auto chance = [&] { return static_cast<double>(std::uniform_real_distribution(0.05f, 1.0f)(random)); };
  for (int round = 0; round < 1000; ++round) {
    Path path{.between = std::vector<Path::Between>(1 + static_cast<std::size_t>(round % 6)),
              .squared_distances = {any()},
              .chances = {chance()},
              .place = any(),
              .departure = any(),
              .next_event = any(),
              .cos_light = any(),
              .ray = any(),
              .walks = any(),
              .merging = any()};
    for (Path::Between& vertex : path.between) {
      const auto kind = random() % 4;  // two of them surfaces that are not specular
      vertex = {
          .is_delta = kind == 0, .is_particle = kind == 1, .facing_light = any_float(), .facing_eye = any_float()};
      if (!vertex.is_delta) vertex.to_eye = any(), vertex.to_light = any();
      path.squared_distances.push_back(any());
      path.chances.push_back(chance());
    }
    const Table weight = weights(path), density = squared_densities(path);
    EXPECT_NEAR(weight.sum(), 1, 1e-12);
    for (std::size_t s = 0; s < weight.joined.size(); ++s)
      EXPECT_NEAR(weight.joined[s], density.joined[s] / density.sum(), 1e-12) << s;
    for (std::size_t i = 0; i < weight.merged.size(); ++i)
      EXPECT_NEAR(weight.merged[i], density.merged[i] / density.sum(), 1e-12) << i;
  }
}

// On the inside of a ball the first photons of walks from its centre lie evenly, 1 / (4 pi) per area and walk, and pi
// r^2 of the wall are nearer than r to a place of it.
TEST(VertexMerging, KnowsHowManyWalksComeNear) {
  Scene ball = inside_sphere(diffuse(0.5f));
  ball.point_lights.push_back({});
  const RenderSettings settings{.algorithm = AlgorithmId::ConnectionAndMerging,
                                .width = 64,
                                .height = 64,
                                .max_depth = 1,
                                .method = {.photon_radius = 0.1f}};
  const Stage stage(ball, settings);
  const Pass pass(stage.world(), settings, {}, 0);
  Sampler sampler(1, 0, 0, 0);
  std::vector<const Photon*> found;
  constexpr int kPlaces = 10'000;
  double count = 0;
  for (int i = 0; i < kPlaces; ++i) {
    pass.world().photons->find(uniform_sphere(sampler.next2()), found);
    count += static_cast<double>(found.size());
  }
  // Pairs of a place and a photon are not correlated, so the count spreads as Poisson's. A z-test at 1 %.
  const double expected = kPlaces * pass.world().merging / (4 * std::numbers::pi);
  EXPECT_NEAR(count, expected, 2.58 * std::sqrt(expected));
}

}  // namespace
}  // namespace heckbert::transport
