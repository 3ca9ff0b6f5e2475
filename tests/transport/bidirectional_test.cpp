// Walks from the light against walks from the eye: every word that both can find has one value, whichever technique
// found it, for every kind of light and eye; and the techniques that are used are those that the word allows.

#include <set>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/strategies.h>

#include "test_scenes.h"

namespace heckbert::transport {
namespace {

struct LightKind {
  const char* name;
  void (*put)(Scene&);
};

Mesh lamp_quad() {
  return make_quad({-0.6f, 1.95f, -0.6f}, {1.2f, 0, 0}, {0, 0, 1.2f});
}

/// Enough of them to be chosen through a tree.
Mesh lamp_of_many_pieces() {
  constexpr unsigned kSide = 10;
  Mesh mesh;
  for (unsigned i = 0; i < kSide * kSide; ++i) {
    const Mesh piece =
        make_quad({-0.6f + 0.12f * static_cast<float>(i % kSide), 1.8f + 0.02f * static_cast<float>(i % 7),
                   -0.6f + 0.12f * static_cast<float>(i / kSide)},
                  {0.1f, 0, 0}, {0, 0, 0.1f});
    const auto first = static_cast<unsigned>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), piece.positions.begin(), piece.positions.end());
    for (const glm::uvec3 t : piece.triangles) mesh.triangles.push_back(t + first);
  }
  return mesh;
}

/// Squares of two brightnesses, and half of it holes.
void put_patterned_lamp(Scene& scene) {
  scene.textures = {{.name = "bright", .source = Checkerboard{Rgb(1), Rgb(0.3f)}, .scale = glm::vec2(2)},
                    {.name = "holes", .source = Checkerboard{Rgb(1), Rgb(0)}, .scale = glm::vec2(3)}};
  Material lamp = emitter(6);
  lamp.emission_texture = 0;
  lamp.opacity = ScalarTexture{1, Channel::R};
  add(scene, lamp_quad(), lamp);
}

/// All in one room, so that each scene has one kind of light and all kinds of surfaces.
constexpr LightKind kLights[] = {
    {"area", [](Scene& s) { add(s, lamp_quad(), emitter(5)); }},
    {"ball",
     [](Scene& s) {
       add(s, Sphere{{-0.9f, 1.3f, 0.2f}, 0.25f}, emitter(12));
     }},
    {"sheet that shines on both sides",
     [](Scene& s) {
       add(s, Disk{{-0.8f, 1.0f, 0.3f}, {1, 0.5f, 0}, 0.4f}, emitter(8, Sides::Both));
     }},
    {"pieces", [](Scene& s) { add(s, lamp_of_many_pieces(), emitter(9)); }},
    {"pattern", put_patterned_lamp},
    {"point",
     [](Scene& s) {
       s.point_lights.push_back({.position = {-0.5f, 1.5f, 0.3f}, .intensity = Rgb(4)});
     }},
    {"spot",
     [](Scene& s) {
       s.spot_lights.push_back({.position = {-0.5f, 1.8f, 0.3f},
                                .direction = {0.4f, -1, -0.2f},
                                .intensity = Rgb(9),
                                .cutoff_degrees = 40,
                                .falloff_degrees = 25});
     }},
    {"distant",
     [](Scene& s) {
       s.distant_lights.push_back({.direction = {0.3f, -1, -0.4f}, .irradiance = Rgb(3)});
     }},
    {"sky", [](Scene& s) { s.environment = Rgb(1.5f); }},
};

/// Eight triangles that are shaded as if they were a ball: nowhere do shading and geometric normals differ more.
Mesh pebble(glm::vec3 center, float radius) {
  Mesh mesh{.positions = {}, .triangles = {}};
  for (const glm::vec3 n : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    mesh.positions.push_back(center + radius * n);
    mesh.normals.push_back(n);
  }
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {2u, 3u})
      for (const unsigned z : {4u, 5u})
        mesh.triangles.emplace_back((x + y + z) % 2 == 0 ? glm::uvec3(x, y, z) : glm::uvec3(x, z, y));
  return mesh;
}

/// A corner open to the sky: a diffuse wall, a floor with two lobes, a metal wall, a glass ball, paper that lets light
/// through, rough glass, and a pebble that is smoother than it is.
Scene corner() {
  Scene scene;
  add(scene, make_quad({-2, -1, -2}, {4, 0, 0}, {0, 3, 0}), {.name = "wall", .lobes = {Lambert{{0.7f, 0.6f, 0.5f}}}});
  add(scene, make_quad({-2, -1, 2}, {4, 0, 0}, {0, 0, -4}),
      {.name = "floor", .lobes = {Lambert{Rgb(0.4f)}, ggx(Rgb(0.4f), 0.5f)}});
  add(scene, make_quad({-2, -1, 2}, {0, 0, -4}, {0, 3, 0}),
      {.name = "metal", .lobes = {Lambert{Rgb(0.2f)}, Mirror{Rgb(0.6f)}}});
  add(scene, Sphere{{0.5f, -0.3f, -0.2f}, 0.6f}, {.name = "glass", .lobes = {Dielectric{}}});
  add(scene, make_quad({0.9f, -1, -1.6f}, {0.8f, 0, 0.6f}, {0, 1.6f, 0}),
      {.name = "paper", .lobes = {Lambert{Rgb(0.3f)}, DiffuseTransmission{Rgb(0.4f)}}});
  add(scene, Sphere{{-0.8f, -0.6f, 0.4f}, 0.4f},
      {.name = "rough glass", .lobes = {RoughDielectric{.ior = 1.5f, .facets = {.alpha_x = 0.4f, .alpha_y = 0.4f}}}});
  add(scene, pebble({0.1f, 0.6f, 0.4f}, 0.5f), {.name = "pebble", .lobes = {Lambert{Rgb(0.4f)}, Mirror{Rgb(0.3f)}}});
  scene.camera = {.position = {1.2f, 0.6f, 2.2f}, .look_at = {-0.2f, -0.3f, -0.4f}, .vertical_fov_degrees = 60};
  return scene;
}

struct EyeKind {
  const char* name;
  void (*make)(Camera&);
};
constexpr EyeKind kEyes[] = {{"pinhole", [](Camera&) {}},
                             {"lens",
                              [](Camera& c) {
                                c.lens_radius = 0.4f;
                                c.focus_distance = 2;
                              }},
                             {"orthographic",
                              [](Camera& c) {
                                c.projection = Projection::Orthographic;
                                c.height = 2.5f;
                              }},
                             {"panoramic", [](Camera& c) { c.projection = Projection::Panoramic; }}};

/// Words of at most this many scatterings are compared.
constexpr int kLongest = 3;

/// A word of fewer paths than this has no spread that one could trust by itself.
constexpr std::uint64_t kEnough = 200;
constexpr int kMostComparisons = 1600;

/// Two-sample tests at 1 % for all comparisons after Sidak: of every word that both records have found often; of all
/// others together, so that none can be lost; and of all light, which is known best.
class Comparison {
 public:
  /// `most_noise`: the standard error of all light, over its energy, that still says something.
  Comparison(const record::Record& reference, const record::Record& other, const taxonomy::Language& both,
             double most_noise, std::string where)
      : reference_(reference), other_(other), where_(std::move(where)) {
    std::map<std::string, std::array<std::uint64_t, 2>> counts;
    for (const std::size_t which : {0u, 1u}) {
      const record::Record& record = which == 0 ? reference : other;
      for (std::size_t w = 0; w < record.words.size(); ++w)
        if (both.contains(record.words[w])) counts[taxonomy::plain(record.words[w])][which] += record.counts[w];
    }
    std::set<std::string> all, rare;
    for (const auto& [word, found] : counts) {
      all.insert(word);
      if (std::min(found[0], found[1]) < kEnough)
        rare.insert(word);
      else
        test({word}, word);
    }
    if (!rare.empty()) test(rare, "all rare words");
    const double error = test(all, "all words");
    EXPECT_LT(error, most_noise) << where_ << ": too noisy to say anything";
  }
  int count() const { return count_; }

 private:
  static record::Estimate energy(const record::Record& record, const std::set<std::string>& words) {
    std::vector<bool> chosen;
    for (const taxonomy::Word& word : record.words) chosen.push_back(words.contains(taxonomy::plain(word)));
    return record::energy(record, chosen);
  }
  /// Gives back the standard error of the difference over the energy.
  double test(const std::set<std::string>& words, const std::string& what) {
    static const double bound = record::student_quantile(1 - 0.005 / kMostComparisons, record::kBatches - 1);
    const record::Estimate a = energy(reference_, words), b = energy(other_, words);
    const double error = std::hypot(a.standard_error, b.standard_error);
    EXPECT_NEAR(a.mean, b.mean, bound * error + 1e-5 * a.mean)
        << where_ << ", " << what << ": " << (b.mean - a.mean) / error << " standard errors, relative "
        << b.mean / a.mean - 1;
    ++count_;
    return error / a.mean;
  }

  const record::Record &reference_, &other_;
  std::string where_;
  int count_ = 0;
};

/// The paths that both algorithms find.
taxonomy::Language common(AlgorithmId a, AlgorithmId b) {
  const auto& grammars = taxonomy::builtin_grammars();
  return grammars.find(facts(a).grammar)->language & grammars.find(facts(b).grammar)->language;
}

TEST(WalksFromTheLight, AgreeWithWalksFromTheEyeWordByWord) {
  int compared = 0;
  for (const LightKind& light : kLights)
    for (const EyeKind& eye : kEyes) {
      Scene scene = corner();
      light.put(scene);
      eye.make(scene.camera);
      RenderSettings settings{.width = 16, .height = 12, .samples_per_pixel = 192, .max_depth = kLongest, .seed = 3};
      const record::Record reference = render(scene, settings);
      for (const AlgorithmId algorithm : {AlgorithmId::Light, AlgorithmId::Bidirectional,
                                          AlgorithmId::ConnectionAndMerging, AlgorithmId::FinalGathering}) {
        // Photons see nothing of the eye but where its walks come to.
        if (facts(algorithm).passes && scene.camera.projection != Projection::Perspective) continue;
        settings.algorithm = algorithm;
        settings.seed = 4;
        const record::Record record = render(scene, settings);
        // Few walks from the light meet a lens.
        const Comparison result(reference, record, common(AlgorithmId::Path, algorithm),
                                algorithm == AlgorithmId::Light ? 0.2 : 0.12,
                                std::string(light.name) + ", " + eye.name + ", " + std::string(facts(algorithm).name));
        compared += result.count();
      }
    }
  EXPECT_GT(compared, 1000);
  EXPECT_LE(compared, kMostComparisons);
}

// ---- which techniques -----------------------------------------------------------------------------------------------

const Material kMattAndMirror{.name = "wall", .lobes = {Lambert{Rgb(0.5f)}, Mirror{Rgb(0.4f)}}};

/// Five walls of several lobes, open at the top, so that all light gets in, and a ball, which sends even parallel rays
/// everywhere, so that all words over their letters come about.
Scene bin(const Material& wall = kMattAndMirror) {
  Scene scene;
  add(scene, make_quad({-1, -1, 1}, {2, 0, 0}, {0, 0, -2}), wall);
  add(scene, make_quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}), wall);
  add(scene, make_quad({1, -1, 1}, {-2, 0, 0}, {0, 2, 0}), wall);
  add(scene, make_quad({-1, -1, 1}, {0, 0, -2}, {0, 2, 0}), wall);
  add(scene, make_quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}), wall);
  add(scene, Sphere{{0.3f, 0.3f, -0.2f}, 0.35f}, wall);
  scene.camera = {.position = {0.1f, -0.6f, 0.3f}, .look_at = {-0.1f, 0.4f, 0.1f}, .vertical_fov_degrees = 100};
  return scene;
}

constexpr LightKind kEnds[] = {
    {"area",
     [](Scene& s) {
       add(s, make_quad({-0.9f, 0.95f, -0.9f}, {1.8f, 0, 0}, {0, 0, 1.4f}), emitter(1));
     }},
    {"point",
     [](Scene& s) {
       s.point_lights.push_back({.position = {-0.4f, 0.4f, 0.2f}});
     }},
    {"spot",
     [](Scene& s) {
       s.spot_lights.push_back({.position = {-0.3f, 0.9f, 0}, .direction = {0.1f, -1, 0}, .cutoff_degrees = 60});
     }},
    {"distant",
     [](Scene& s) {
       s.distant_lights.push_back({.direction = {0.2f, -1, -0.3f}});
     }},
    {"sky", [](Scene& s) { s.environment = Rgb(1); }}};

using Techniques = std::map<std::string, std::set<std::size_t>>;  // light vertices, by fine word

Techniques techniques_of(const Scene& scene, const RenderSettings& settings) {
  Techniques found;
  for (const record::TechniqueSum& sum : measure_techniques(scene, settings)) {
    EXPECT_FALSE(sum.technique.merged);
    found[taxonomy::fine(sum.word)].insert(sum.technique.light_vertices);
  }
  return found;
}

/// A light that is a point or a direction, seen by an eye that is one: the sum rule counts the one line between them,
/// which no picture shows.
bool is_degenerate(const taxonomy::Word& word) {
  const auto is_delta = [](taxonomy::Symbol s) { return s == taxonomy::Symbol::Lp || s == taxonomy::Symbol::Ld; };
  return word.events.empty() && is_delta(word.light) && word.eye == taxonomy::Symbol::Ep;
}

/// For every kind of light and eye.
void expect_allowed_techniques(const Material& wall, const std::vector<std::string>& words, int length) {
  for (const LightKind& light : kEnds)
    for (const EyeKind& eye : kEyes) {
      Scene scene = bin(wall);
      light.put(scene);
      eye.make(scene.camera);
      if (scene.camera.lens_radius > 0) scene.camera.lens_radius = 0.8f;  // to be met by chance often enough
      const std::string where = std::string(light.name) + ", " + eye.name;
      // Few walks from far away find a lens.
      const bool is_rare = scene.camera.lens_radius > 0 && (scene.environment.r > 0 || !scene.distant_lights.empty());
      const int samples = is_rare ? 4096 : 384;
      const Techniques found = techniques_of(scene, {.algorithm = AlgorithmId::Bidirectional,
                                                     .width = 16,
                                                     .height = 12,
                                                     .samples_per_pixel = samples,
                                                     .max_depth = length});
      ASSERT_FALSE(found.empty());
      const taxonomy::Word sample = taxonomy::parse_word(found.begin()->first);
      for (const std::string& plain : words) {
        taxonomy::Word word = taxonomy::parse_word(plain);
        word.light = sample.light;
        word.eye = sample.eye;
        std::set<std::size_t> expected;
        for (const taxonomy::Strategy& strategy : taxonomy::strategies(word)) expected.insert(strategy.light_vertices);
        if (is_degenerate(word)) expected.clear();
        // Parallel rays see one direction of the sky: joining a direction of the light's choice to it means nothing.
        if (scene.camera.projection == Projection::Orthographic && plain == "LE" && word.light == taxonomy::Symbol::Le)
          expected = {0};
        const auto at = found.find(taxonomy::fine(word));
        EXPECT_EQ(at == found.end() ? std::set<std::size_t>{} : at->second, expected) << where << ", " << plain;
      }
    }
}

TEST(Bidirectional, UsesTheTechniquesThatTheWordAllowsAndNoOther) {
  const std::vector<std::string> words = words_over_ds(5);
  ASSERT_EQ(words.size(), 63u);
  expect_allowed_techniques(kMattAndMirror, words, 5);
}

TEST(Bidirectional, UsesTheTechniquesThatWordsWithGlossAllow) {
  std::vector<std::string> words{"LE"}, longest{""};
  for (int length = 1; length <= 3; ++length) {
    std::vector<std::string> longer;
    for (const std::string& events : longest)
      for (const char event : {'D', 'G', 'S'}) longer.push_back(events + event);
    for (const std::string& events : longer) words.push_back("L" + events + "E");
    longest = std::move(longer);
  }
  ASSERT_EQ(words.size(), 40u);
  expect_allowed_techniques({.name = "wall", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.3f), 0.6f), Mirror{Rgb(0.3f)}}},
                            words, 3);
}

// What the table of algorithms says of their reach, against what they used: no more, and all of it that short words
// allow.
TEST(HasTechnique, IsTrueOfTheTechniquesThatAreUsed) {
  Scene scene = bin();
  kEnds[0].put(scene);
  for (const AlgorithmFacts& algorithm : kAlgorithms) {
    if (algorithm.accuracy == Accuracy::NotLight || algorithm.id == AlgorithmId::LocalShading || algorithm.patches)
      continue;  // which see no lamps, or do not walk
    std::map<std::string, std::set<std::size_t>> used;
    for (const record::TechniqueSum& sum : measure_techniques(
             scene, {.algorithm = algorithm.id, .width = 16, .height = 12, .samples_per_pixel = 256, .max_depth = 4})) {
      if (sum.technique.merged) continue;
      EXPECT_TRUE(has_technique(algorithm.reach, sum.word, sum.technique.light_vertices))
          << algorithm.name << ", " << taxonomy::fine(sum.word) << ", " << sum.technique.light_vertices;
      used[taxonomy::fine(sum.word)].insert(sum.technique.light_vertices);
    }
    const auto& claimed = taxonomy::builtin_grammars().find(algorithm.grammar)->language;
    for (const std::string& plain : words_over_ds(2)) {
      const taxonomy::Word word = taxonomy::parse_word(plain);
      std::set<std::size_t> expected;
      if (claimed.contains(word))
        for (const taxonomy::Strategy& strategy : taxonomy::strategies(word))
          if (has_technique(algorithm.reach, word, strategy.light_vertices)) expected.insert(strategy.light_vertices);
      EXPECT_EQ(used[taxonomy::fine(word)], expected) << algorithm.name << ", " << plain;
    }
  }
}

}  // namespace
}  // namespace heckbert::transport
