// Lights among lights: the chance of being chosen and hit is what is said of it, the three ways of finding a light
// (hitting it, next-event estimation, both weighted) agree, and every kind gives what its closed form says, by class.

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <heckbert/transport/delta_lights.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/light_tree.h>
#include <heckbert/transport/lights.h>
#include <heckbert/transport/vertex.h>

#include "chi_square.h"
#include "test_scenes.h"

namespace heckbert::transport {
namespace {

constexpr double kPiD = std::numbers::pi;

/// An environment image with a bright spot, dark parts and black rows.
EnvironmentImage spotted_sky(Interpolation interpolation) {
  EnvironmentImage image{.width = 16, .height = 8, .interpolation = interpolation};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.pixels.push_back(y == 2             ? Rgb(0)
                             : y == 1 && x == 5 ? Rgb(40)
                                                : Rgb(0.1f * static_cast<float>((x + 2 * y) % 5)));
  image.to_world = glm::mat3(glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 0.3f, 0.2f))));
  return image;
}

struct LightScene {
  std::string name;
  Scene scene;
};

/// Lights over the origin, from where the upper half-space is looked at.
std::vector<LightScene> light_scenes() {
  std::vector<LightScene> all;
  const auto with = [&](const char* name, Geometry geometry, Sides sides = Sides::Front) {
    LightScene& s = all.emplace_back();
    s.name = name;
    add(s.scene, std::move(geometry), emitter(2, sides));
  };
  with("near rectangle", make_quad({-0.5f, 0.6f, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.9f}));
  with("far rectangle", make_quad({-0.5f, 3.6f, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.9f}));
  with("near triangle",
       Mesh{.positions = {{-1, 0.7f, -0.5f}, {0.6f, 0.9f, -0.4f}, {0.2f, 0.5f, 0.8f}}, .triangles = {{0, 1, 2}}});
  with("disk", Disk{{0.3f, 0.8f, 0.2f}, {-0.2f, -1, 0}, 0.7f});
  with("sphere", Sphere{{0.4f, 0.9f, 0.2f}, 0.5f});
  with("sphere from inside", Sphere{{0.2f, 0.1f, 0}, 1.5f}, Sides::Both);
  // A hundred small triangles of all orientations: chosen through the tree.
  Mesh cloud;
  for (unsigned i = 0; i < 100; ++i) {
    Sampler sampler(11, static_cast<int>(i), 0, 0);
    const glm::vec3 center = glm::vec3(0, 1.2f, 0) + uniform_sphere(sampler.next2());
    for (int k = 0; k < 3; ++k) cloud.positions.push_back(center + 0.25f * uniform_sphere(sampler.next2()));
    cloud.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  with("cloud of triangles", cloud);
  with("two-sided cloud", cloud, Sides::Both);
  // Bright on one pixel of four by four, dark elsewhere.
  const auto with_texture = [&](const char* name, Geometry geometry) {
    with(name, std::move(geometry), Sides::Both);
    Image image{.width = 4, .height = 4};
    for (int i = 0; i < 16; ++i) image.floats.insert(image.floats.end(), {0.1f, i == 6 ? 9.0f : 0.2f, 0.1f, 1});
    all.back().scene.textures = {{.source = image}};
    all.back().scene.materials.back().emission_texture = 0;
  };
  with_texture("textured rectangle", make_quad({-0.5f, 0.6f, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.9f}));
  with_texture("textured disk", Disk{{0.3f, 0.8f, 0.2f}, {-0.2f, -1, 0}, 0.7f});
  with_texture("textured sphere", Sphere{{0.4f, 0.9f, 0.2f}, 0.5f});
  with_texture("textured cloud", cloud);
  all.push_back({"constant sky", {}});
  all.back().scene.environment = Rgb(0.7f);
  for (const Interpolation interpolation : {Interpolation::Nearest, Interpolation::Bilinear}) {
    all.push_back({interpolation == Interpolation::Nearest ? "nearest sky" : "bilinear sky", {}});
    all.back().scene.environment_image = spotted_sky(interpolation);
  }
  all.push_back({"everything", {}});
  add(all.back().scene, make_quad({-1.7f, 0.6f, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.9f}), emitter(1));
  add(all.back().scene, Disk{{0.1f, 0.9f, 1.0f}, {-0.2f, -1, 0}, 0.4f}, emitter(4));
  add(all.back().scene, Sphere{{0.6f, 0.9f, -0.2f}, 0.5f}, emitter(5));
  all.back().scene.environment = Rgb(0.1f);
  all.back().scene.environment_image = spotted_sky(Interpolation::Bilinear);
  return all;
}

Rgb arriving(const Tracer& tracer, const Lights& lights, glm::vec3 from, const LightSample& light) {
  if (light.to_be_met != kNoEmitter) {
    const auto met = tracer.intersect({from, light.direction});
    return met && met->emitter == light.to_be_met ? lights.emitted(*met) : Rgb{};
  }
  const bool occluded =
      light.infinite ? tracer.is_occluded(Ray{from, light.direction}) : tracer.is_occluded(from, light.target);
  return occluded ? Rgb{} : light.radiance;
}

/// Irradiance at the origin, facing up, found in one of three ways.
enum class Way { Hit, NextEvent, Both };

record::Estimate irradiance(const Scene& scene, Way way, int count, int seed) {
  const Tracer tracer(scene);
  const Lights lights(scene, tracer);
  const glm::vec3 from(0);
  double sum = 0, sum2 = 0;
  for (int n = 0; n < count; ++n) {
    Sampler sampler(static_cast<std::uint64_t>(seed), n, 0, 0);
    double value = 0;
    if (way != Way::NextEvent) {
      const glm::vec3 local = cosine_hemisphere(sampler.next2());
      const glm::vec3 direction(local.x, local.z, local.y);
      const float pdf = direction.y / kPi;
      const auto hit = tracer.intersect({from, direction});
      const Rgb radiance = hit ? lights.emitted(*hit) : lights.environment(direction);
      const float other = !hit                         ? lights.pdf_environment(direction)
                          : hit->emitter != kNoEmitter ? lights.pdf_solid_angle(*hit, from)
                                                       : 0.0f;
      const float weight = way == Way::Both ? power_heuristic(pdf, other) : 1.0f;
      value += static_cast<double>(radiance.g * direction.y / pdf * weight);
    }
    if (way != Way::Hit) {
      const auto light = lights.sample(from, sampler);
      if (light.pdf_solid_angle > 0 && light.direction.y > 0) {
        const float weight = way == Way::Both ? power_heuristic(light.pdf_solid_angle, light.direction.y / kPi) : 1.0f;
        value += static_cast<double>(arriving(tracer, lights, from, light).g * light.direction.y /
                                     light.pdf_solid_angle * weight);
      }
    }
    sum += value;
    sum2 += value * value;
  }
  record::Estimate e;
  e.mean = sum / count;
  e.standard_error = std::sqrt(std::max(0.0, sum2 / count - e.mean * e.mean) / count);
  return e;
}

TEST(Lights, AreFoundAlikeByHittingByNextEventAndByBoth) {
  // Two-sample z-tests, thirty-two comparisons at 1 % together after Sidak: 3.60 standard errors.
  for (const LightScene& s : light_scenes()) {
    const auto hit = irradiance(s.scene, Way::Hit, 400'000, 1);
    const auto next = irradiance(s.scene, Way::NextEvent, 100'000, 2);
    const auto both = irradiance(s.scene, Way::Both, 100'000, 3);
    EXPECT_NEAR(next.mean, hit.mean, 3.60 * std::hypot(next.standard_error, hit.standard_error)) << s.name;
    EXPECT_NEAR(both.mean, hit.mean, 3.60 * std::hypot(both.standard_error, hit.standard_error)) << s.name;
    EXPECT_LT(std::hypot(both.standard_error, hit.standard_error), 0.02 * hit.mean) << s.name;
  }
}

TEST(Lights, AreSampledWithTheDensityThatIsAskedForTheirHits) {
  for (const LightScene& s : light_scenes()) {
    const Tracer tracer(s.scene);
    const Lights lights(s.scene, tracer);
    int compared = 0;
    for (int n = 0; n < 2000; ++n) {
      Sampler sampler(5, n, 0, 0);
      const glm::vec3 from = 0.3f * uniform_sphere(sampler.next2());
      const auto light = lights.sample(from, sampler);
      if (!(light.pdf_solid_angle > 0)) continue;
      if (light.infinite) {
        EXPECT_NEAR(lights.pdf_environment(light.direction) / light.pdf_solid_angle, 1, 1e-3) << s.name;
        EXPECT_NEAR(lights.environment(light.direction).g, light.radiance.g, 1e-3) << s.name;
        ++compared;
        continue;
      }
      const auto hit = tracer.intersect({from, light.direction});
      if (!hit || hit->emitter == kNoEmitter || glm::distance(hit->position, light.target) > 1e-3f) continue;
      ASSERT_NEAR(lights.pdf_solid_angle(*hit, from) / light.pdf_solid_angle, 1, 1e-2) << s.name;
      ++compared;
    }
    EXPECT_GT(compared, 400) << s.name;
  }
}

// ---- the tree ---------------------------------------------------------------------------------------------------

std::vector<LightBounds> scattered_lights(int count) {
  std::vector<LightBounds> lights;
  for (int i = 0; i < count; ++i) {
    Sampler sampler(21, i, 0, 0);
    const glm::vec3 place = 5.0f * uniform_sphere(sampler.next2()) * sampler.next();
    if (i % 3 == 0) {
      lights.push_back(bounds_of(PointLight{place, Rgb(sampler.next() + 0.1f)}));
    } else if (i % 3 == 1) {
      lights.push_back(
          bounds_of(SpotLight{.position = place, .direction = uniform_sphere(sampler.next2()), .cutoff_degrees = 60}));
    } else {
      const Emitter e =
          triangle_emitter({place, place + uniform_sphere(sampler.next2()), place + uniform_sphere(sampler.next2())});
      lights.push_back(bounds_of(e, i % 2 == 0, 3 * e.area));
    }
  }
  return lights;
}

const std::vector<glm::vec3> kPlaces{{0, 0, 0}, {4, 1, -2}, {20, -3, 5}, {0.5f, 0.4f, 0.3f}};

TEST(LightTree, DrawsEachLightWithTheProbabilityThatIsAskedForIt) {
  const std::vector<LightBounds> lights = scattered_lights(300);
  const LightTree tree(lights);
  constexpr int kDraws = 300'000;
  for (const glm::vec3 from : kPlaces) {
    std::vector<double> expected, seen(lights.size());
    double sum = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      expected.push_back(tree.probability(i, from) * kDraws);
      sum += tree.probability(i, from);
    }
    EXPECT_LE(sum, 1 + 1e-9);
    double none = 0;
    for (int n = 0; n < kDraws; ++n) {
      const auto choice = tree.sample(from, Sampler(23, n, 0, 0).next_fine());
      if (!choice) {
        ++none;
        continue;
      }
      ASSERT_NEAR(choice->probability, tree.probability(choice->light, from), 1e-12);
      ++seen[choice->light];
    }
    expected.push_back((1 - sum) * kDraws);
    seen.push_back(none);
    EXPECT_LT(chi_square_excess(expected, seen), 3.6) << from.x;  // 1 % over four places after Sidak, with skew
  }
}

TEST(LightTree, NeverOverlooksALightThatShines) {
  const std::vector<LightBounds> lights = scattered_lights(200);
  const LightTree tree(lights);
  for (int n = 0; n < 2000; ++n) {
    Sampler sampler(29, n, 0, 0);
    const glm::vec3 from = 8.0f * sampler.next() * uniform_sphere(sampler.next2());
    for (std::size_t i = 0; i < lights.size(); ++i)
      ASSERT_TRUE(importance(lights[i], from) <= 0 || tree.probability(i, from) > 0) << i;
  }
}

TEST(LightTree, PrefersTheNearLightAndTheOneThatFacesHere) {
  std::vector<LightBounds> lights;
  for (int i = 0; i < 100; ++i) lights.push_back(bounds_of(PointLight{{static_cast<float>(i), 1, 0}, Rgb(1)}));
  const LightTree tree(lights);
  EXPECT_GT(tree.probability(50, {50, 0, 0}), 20 * tree.probability(70, {50, 0, 0}));
  EXPECT_GT(tree.probability(50, {50, 0, 0}), 2 * 0.01) << "twice its share of the power";
  const Emitter down = triangle_emitter({{{0, 1, 0}, {1, 1, 0}, {0, 1, 1}}});
  const LightTree pair(
      {bounds_of(down, false, 1), bounds_of(triangle_emitter({{{0, 1, 0}, {0, 1, 1}, {1, 1, 0}}}), false, 1)});
  EXPECT_EQ(pair.probability(0, {0.3f, 0, 0.3f}), 1.0);
}

TEST(Cone, JoinedConesHoldBoth) {
  for (int n = 0; n < 500; ++n) {
    Sampler sampler(31, n, 0, 0);
    const Cone a{uniform_sphere(sampler.next2()), 1 - 2 * sampler.next()},
        b{uniform_sphere(sampler.next2()), 1 - sampler.next()};
    const Cone both = join(a, b);
    for (int k = 0; k < 20; ++k)
      for (const Cone& c : {a, b}) {
        const float z = c.cos_angle + (1 - c.cos_angle) * sampler.next(), phi = 2 * kPi * sampler.next();
        const float r = std::sqrt(std::max(0.0f, 1 - z * z));
        const glm::vec3 inside = Frame::around(c.axis).to_world({r * std::cos(phi), r * std::sin(phi), z});
        EXPECT_GE(glm::dot(inside, both.axis), both.cos_angle - 2e-3f);
      }
  }
}

// ---- closed forms -------------------------------------------------------------------------------------------------

/// A floor of albedo one half, seen from the side at one point.
Scene floor_at(glm::vec3 point) {
  Scene scene;
  add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
  scene.camera = {.position = point + glm::vec3(2, 0.5f, 2), .look_at = point, .vertical_fov_degrees = 0.01f};
  return scene;
}
const RenderSettings kFloor{.width = 8, .height = 8, .samples_per_pixel = 1024, .max_depth = 1};

TEST(ClosedForm, OfATrueDisk) {
  for (const Sides sides : {Sides::Front, Sides::Both}) {
    Scene scene = floor_at({0, 0, 0});
    add(scene, Disk{{0, 2, 0}, {0, -1, 0}, 1}, emitter(2, sides));
    expect_energies(render(scene, kFloor), {{"LDE", 1.0 / 5.0}});  // R^2 / (R^2 + h^2) with R = 1, h = 2
  }
  Scene away = floor_at({0, 0, 0});
  add(away, Disk{{0, 2, 0}, {0, 1, 0}, 1}, emitter(2));
  EXPECT_TRUE(render(away, kFloor).words.empty());
}

TEST(ClosedForm, OfADiskInAnInstance) {
  Scene scene = floor_at({0, 0, 0});
  scene.materials.push_back(emitter(2));
  scene.groups.push_back(
      {.name = "lamp", .shapes = {{.name = "disk", .geometry = Disk{{3, 0, 0}, {1, 0, 0}, 4}, .material = 1}}});
  // A quarter of the size, turned so that x points down, and 2 up.
  scene.instances.push_back({.to_world = glm::scale(glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0, 2.75f, 0)),
                                                                glm::radians(-90.0f), glm::vec3(0, 0, 1)),
                                                    glm::vec3(0.25f))});
  expect_energies(render(scene, kFloor), {{"LDE", 1.0 / 5.0}});
}

TEST(ClosedForm, OfATwoSidedLampBetweenTwoWalls) {
  // The unit square of A8, halfway between a floor and a ceiling that face each other.
  for (const Sides sides : {Sides::Front, Sides::Both})
    for (const float y : {0.0f, 2.0f}) {
      Scene scene;
      add(scene, make_quad({-50, 0, -50}, {0, 0, 100}, {100, 0, 0}), diffuse(0.5f));
      add(scene, make_quad({-50, 2, -50}, {100, 0, 0}, {0, 0, 100}), diffuse(0.5f));
      add(scene, make_quad({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), emitter(2, sides));
      const glm::vec3 point(0.5f, y, 0.5f);
      scene.camera = {.position = {2, 1, 2}, .look_at = point, .vertical_fov_degrees = 0.01f};
      const auto record = render(scene, kFloor);
      if (y == 0 || sides == Sides::Both)
        expect_energies(record, {{"LDE", 0.239456471}});
      else
        EXPECT_TRUE(record.words.empty());
    }
}

TEST(ClosedForm, OfASpotInsideAndOnTheEdgeOfItsCone) {
  const SpotLight spot{
      .position = {0, 2, 0}, .direction = {0, -3, 0}, .intensity = Rgb(8), .cutoff_degrees = 60, .falloff_degrees = 30};
  const struct { double degrees, share; } rows[] = {{0, 1}, {20, 1}, {45, 0.5}, {50, 1.0 / 3.0}};
  for (const auto& row : rows) {
    const double angle = row.degrees / 180 * kPiD;
    Scene scene = floor_at({static_cast<float>(2 * std::tan(angle)), 0, 0});
    scene.spot_lights.push_back(spot);
    // Intensity cos^3 / h^2.
    const auto record = render(scene, kFloor);
    expect_energies(record, {{"LDE", 0.5 / kPiD * 8 * row.share * std::pow(std::cos(angle), 3) / 4}});
    EXPECT_EQ(taxonomy::fine(record.words.at(0)), "LpDrEp");
  }
  Scene outside = floor_at({4, 0, 0});
  outside.spot_lights.push_back(spot);
  EXPECT_TRUE(render(outside, kFloor).words.empty());
}

TEST(ClosedForm, OfTheFluxOfASpotInAClosedRoom) {
  // A3: the first indirect light of a sphere is the same everywhere, the flux times two albedos over pi times the area.
  for (const float falloff : {20.0f, 50.0f}) {
    Scene scene = inside_sphere(diffuse(0.5f));
    const SpotLight spot{.position = {0.3f, -0.2f, 0.1f},
                         .direction = {1, 2, 3},
                         .intensity = Rgb(2),
                         .cutoff_degrees = 50,
                         .falloff_degrees = falloff};
    scene.spot_lights.push_back(spot);
    double flux = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = (i + 0.5) * 50 / kSteps;
      flux += 2 * kPiD * std::sin(angle / 180 * kPiD) * 2 *
              std::min(1.0, (50 - angle) / std::max(1e-9, 50.0 - static_cast<double>(falloff))) *
              (50.0 / kSteps / 180 * kPiD);
    }
    EXPECT_NEAR(power(spot), flux, 1e-4 * flux);
    const auto record =
        render(scene, {.width = 16, .height = 16, .samples_per_pixel = 1024, .max_depth = 3, .seed = 2});
    expect_energies(record, {{"LDDE", 0.25 * flux / (4 * kPiD * kPiD)}, {"LDDDE", 0.125 * flux / (4 * kPiD * kPiD)}});
  }
}

TEST(ClosedForm, OfADistantLightAndItsWords) {
  Scene scene = floor_at({0, 0, 0});
  scene.materials[0].lobes.push_back(Mirror{Rgb(0.3f)});
  scene.distant_lights.push_back({.direction = {3, -4, 0}, .irradiance = Rgb(2)});
  for (const AlgorithmFacts& algorithm : algorithms_that_find("LdDrEp")) {
    RenderSettings settings = kFloor;
    settings.algorithm = algorithm.id;
    const auto record = render(scene, settings);
    expect_energies(record, {{"LDE", 0.5 / kPiD * 2 * 0.8}});
    ASSERT_EQ(record.words.size(), 1u);
    EXPECT_EQ(taxonomy::fine(record.words[0]), "LdDrEp");
  }
}

TEST(ClosedForm, OfADistantLightBehindAWall) {
  Scene scene = floor_at({0, 0, 0});
  add(scene, make_quad({-1000, 300, -1000}, {2000, 0, 0}, {0, 0, 2000}), {.name = "black", .lobes = {}});
  scene.distant_lights.push_back({.direction = {0, -1, 0}, .irradiance = Rgb(2)});
  EXPECT_TRUE(render(scene, kFloor).words.empty());
}

TEST(ClosedForm, OfALightMadeOfManyTriangles) {
  // The disk of A8 as a fan of 200 triangles with a coaxial hole of other triangles: all through the tree. The fan's
  // form factor is a sum over its edges (Lambert 1760); the polygon stands for the disk to 2e-4.
  Mesh disk{.positions = {{0, 2, 0}}, .triangles = {}};
  constexpr unsigned kSegments = 200;
  for (unsigned i = 0; i < kSegments; ++i) {
    const double phi = 2 * kPiD * i / kSegments;
    disk.positions.emplace_back(std::cos(phi), 2, std::sin(phi));
    disk.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % kSegments);
  }
  double edges = 0;
  for (unsigned i = 0; i < kSegments; ++i) {
    const glm::dvec3 a(disk.positions[1 + i]), b(disk.positions[1 + (i + 1) % kSegments]);
    const double angle = std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b)));
    edges += angle * std::abs(glm::normalize(glm::cross(a, b)).y);
  }
  Scene scene = floor_at({0, 0, 0});
  add(scene, disk, emitter(2));
  const auto record = render(scene, kFloor);
  expect_energies(record, {{"LDE", edges / (2 * kPiD)}});
}

TEST(Render, GivesTheSameBytesWithEveryKindOfLight) {
  Scene scene = light_scenes().back().scene;
  add(scene, make_quad({-5, -0.5f, -5}, {0, 0, 10}, {10, 0, 0}), diffuse(0.5f));
  add(scene, light_scenes()[6].scene.shapes[0].geometry, emitter(1));
  scene.point_lights.push_back({.position = {1, 1, 1}});
  scene.spot_lights.push_back({.position = {-1, 2, 1}, .direction = {0, -1, 0}, .cutoff_degrees = 50});
  scene.distant_lights.push_back({});
  scene.camera = {.position = {3, 2, 3}, .look_at = {0, 0, 0}};
  RenderSettings settings{.width = 70, .height = 40, .samples_per_pixel = 4, .threads = 1};
  const auto one = render(scene, settings);
  for (const int threads : {2, 4}) {
    settings.threads = threads;
    EXPECT_TRUE(render(scene, settings) == one) << threads;
  }
  std::map<std::string, int> kinds;
  for (const taxonomy::Word& word : one.words) ++kinds[taxonomy::fine(word).substr(0, 2)];
  EXPECT_EQ(kinds.size(), 4u) << "La, Lp, Ld and Le";
}

}  // namespace
}  // namespace heckbert::transport
