// Walks from the light against walks from the eye: every word that both can find has one value, whichever technique
// found it, for every kind of light and eye; and the techniques that are used are those that the word allows.

#include <set>

#include <gtest/gtest.h>

#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/strategies.h>

#include "corner.h"
#include "test_scenes.h"
#include "word_comparison.h"

namespace heckbert::transport {
namespace {

/// Words of at most this many scatterings are compared.
constexpr int kLongest = 3;

constexpr int kMostComparisons = 1600;

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
        settings.seed = 5;
        const record::Record record = render(scene, settings);
        // Few walks from the light meet a lens.
        const Comparison result(reference, record, claimed_by(facts(AlgorithmId::Path)) & claimed_by(facts(algorithm)),
                                algorithm == AlgorithmId::Light ? 0.2 : 0.12, kMostComparisons,
                                std::string(light.name) + ", " + eye.name + ", " + std::string(facts(algorithm).name));
        compared += result.count();
      }
    }
  EXPECT_GT(compared, 1000);
  EXPECT_LE(compared, kMostComparisons);
}

// What a surface that is smoother than it is throws onto a floor, under a wide lamp. Where the normals differ, a walk
// from the light must make up for cosines that the one from the eye does not see (Veach 1997, 5.3), and must find the
// mirrored ways of every normal that the eye may see.
TEST(WalksFromTheLight, AgreeOnSurfacesThatAreSmootherThanTheyAre) {
  struct Thing {
    Geometry geometry;
    Material material;
  };
  const Mesh ball = pebble({0, 0.6f, 0}, 0.55f);
  const Thing things[] = {{ball, {.name = "mirror", .lobes = {Mirror{Rgb(0.9f)}}}},
                          {ball, {.name = "glass", .lobes = {Dielectric{.ior = 1.5f}}}},
                          {ball, {.name = "gloss", .lobes = {ggx(Rgb(0.9f), 0.4f)}}},
                          {ball, {.name = "matt", .lobes = {Lambert{Rgb(0.8f)}}}},
                          {make_quad({-0.9f, 0.1f, -0.8f}, {1.8f, 0, 0}, {0, 1.3f, 0}),
                           {.name = "rippled mirror", .lobes = {Mirror{Rgb(0.9f)}}, .normal_map = NormalMap{0, 1}}}};
  for (const auto& [geometry, material] : things) {
    Scene scene;
    scene.textures = {
        {.name = "ripples", .source = Checkerboard{{0.75f, 0.5f, 0.93f}, {0.35f, 0.2f, 0.88f}}, .scale = glm::vec2(5)}};
    add(scene, make_quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}), diffuse(0.7f));
    add(scene, geometry, material);
    add(scene, make_quad({-1.5f, 1.6f, -1.5f}, {3, 0, 0}, {0, 0, 3}), emitter(2));
    scene.camera = {.position = {0, 1.1f, 1.9f}, .look_at = {0, 0.1f, 0}, .vertical_fov_degrees = 60};
    RenderSettings settings{.width = 16, .height = 12, .samples_per_pixel = 1024, .max_depth = 3, .seed = 3};
    const record::Record reference = render(scene, settings);
    for (const AlgorithmId algorithm : {AlgorithmId::Light, AlgorithmId::Bidirectional}) {
      settings.algorithm = algorithm;
      settings.seed = 4;
      const Comparison result(reference, render(scene, settings),
                              claimed_by(facts(AlgorithmId::Path)) & claimed_by(facts(algorithm)), 0.05, 100,
                              material.name + ", " + std::string(facts(algorithm).name));
    }
  }
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

/// Smoke in and around the bin.
void fill_with_smoke(Scene& scene) {
  scene.media = {{.name = "smoke", .scattering = Rgb(0.6f), .anisotropy = 0.2f}};
  add(scene, make_box({-1.2f, -1.2f, -1.2f}, {1.2f, 1.2f, 1.2f}),
      {.name = "boundary", .interior = Interior{0, 0}, .is_index_matched = true});
}

/// Every word over some letters of at most so many scatterings.
std::vector<std::string> words_over(const std::string& letters, int longest) {
  std::vector<std::string> words{"LE"}, last{""};
  for (int length = 1; length <= longest; ++length) {
    std::vector<std::string> longer;
    for (const std::string& events : last)
      for (const char event : letters) longer.push_back(events + event);
    for (const std::string& events : longer) words.push_back("L" + events + "E");
    last = std::move(longer);
  }
  return words;
}

/// For every kind of light and eye.
void expect_allowed_techniques(const Scene& empty, const std::vector<std::string>& words, int length) {
  for (const LightKind& light : kEnds)
    for (const EyeKind& eye : kEyes) {
      Scene scene = empty;
      light.put(scene);
      eye.make(scene.camera);
      if (scene.camera.lens_radius > 0) scene.camera.lens_radius = 0.8f;  // to be met by chance often enough
      const std::string where = std::string(light.name) + ", " + eye.name;
      // Few walks from far away find a lens.
      const bool is_rare = scene.camera.lens_radius > 0 && (scene.environment.r > 0 || !scene.distant_lights.empty());
      // And few walks from parallel rays run into a lamp: 1.5 of 384 as LSSSSSE.
      const bool is_parallel = scene.camera.projection == Projection::Orthographic;
      const int samples = is_rare ? 8192 : is_parallel ? 2048 : scene.camera.lens_radius > 0 ? 768 : 384;
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
        if (is_parallel && plain == "LE" && word.light == taxonomy::Symbol::Le) expected = {0};
        const auto at = found.find(taxonomy::fine(word));
        EXPECT_EQ(at == found.end() ? std::set<std::size_t>{} : at->second, expected) << where << ", " << plain;
      }
    }
}

TEST(Bidirectional, UsesTheTechniquesThatTheWordAllowsAndNoOther) {
  const std::vector<std::string> words = words_over_ds(5);
  ASSERT_EQ(words.size(), 63u);
  expect_allowed_techniques(bin(), words, 5);
}

TEST(Bidirectional, UsesTheTechniquesThatWordsWithGlossAllow) {
  const std::vector<std::string> words = words_over("DGS", 3);
  ASSERT_EQ(words.size(), 40u);
  expect_allowed_techniques(
      bin({.name = "wall", .lobes = {Lambert{Rgb(0.3f)}, ggx(Rgb(0.3f), 0.6f), Mirror{Rgb(0.3f)}}}), words, 3);
}

TEST(Bidirectional, UsesTheTechniquesThatWordsThroughMediaAllow) {
  Scene scene = bin();
  fill_with_smoke(scene);
  const std::vector<std::string> words = words_over("DSV", 3);
  ASSERT_EQ(words.size(), 40u);
  expect_allowed_techniques(scene, words, 3);
}

// What the table of algorithms says of their reach and what they claim, against what they used: no more, and all of it
// that short words allow; in smoke too.
TEST(HasTechnique, IsTrueOfTheTechniquesThatAreUsed) {
  Scene scene = bin();
  kEnds[0].put(scene);
  fill_with_smoke(scene);
  for (const AlgorithmFacts& algorithm : kAlgorithms) {
    if (algorithm.accuracy == Accuracy::NotLight || algorithm.id == AlgorithmId::LocalShading || algorithm.patches)
      continue;  // which see no lamps, or do not walk
    const taxonomy::Language claimed = claimed_by(algorithm);
    std::map<std::string, std::set<std::size_t>> used;
    for (const record::TechniqueSum& sum : measure_techniques(
             scene, {.algorithm = algorithm.id, .width = 16, .height = 12, .samples_per_pixel = 256, .max_depth = 4})) {
      EXPECT_TRUE(claimed.contains(sum.word)) << algorithm.name << ", " << taxonomy::fine(sum.word);
      if (sum.technique.merged) continue;
      EXPECT_TRUE(has_technique(algorithm, sum.word, sum.technique.light_vertices))
          << algorithm.name << ", " << taxonomy::fine(sum.word) << ", " << sum.technique.light_vertices;
      used[taxonomy::fine(sum.word)].insert(sum.technique.light_vertices);
    }
    for (const std::string& plain : words_over("DSV", 2)) {
      const taxonomy::Word word = taxonomy::parse_word(plain);
      std::set<std::size_t> expected;
      if (claimed.contains(word))
        for (const taxonomy::Strategy& strategy : taxonomy::strategies(word))
          if (has_technique(algorithm, word, strategy.light_vertices)) expected.insert(strategy.light_vertices);
      EXPECT_EQ(used[taxonomy::fine(word)], expected) << algorithm.name << ", " << plain;
    }
  }
}

// Photons lie on surfaces: what only merging finds in a medium is not found, and not claimed.
TEST(Claims, OfMergingInMediaTakeASurface) {
  const taxonomy::Language vcm = claimed_by(facts(AlgorithmId::ConnectionAndMerging)),
                           joined = claimed_by(facts(AlgorithmId::Bidirectional));
  const auto word = [](const char* text) { return taxonomy::parse_word(text); };
  for (const char* both : {"Lp V Ep", "Lp Sr V Dr Ep", "Lp V Sr V Ep", "La Sr V Sr Ep", "Lp Sr V Sr El"})
    EXPECT_TRUE(vcm.contains(word(both)) && joined.contains(word(both))) << both;
  for (const char* merged : {"Lp Sr Dr Sr Ep", "Lp Sr V Sr Dr Sr Ep"})
    EXPECT_TRUE(vcm.contains(word(merged)) && !joined.contains(word(merged))) << merged;
  for (const char* neither : {"Lp Sr V Sr Ep", "Lp Sr Ep", "Lp Sr V Sr V Sr Ep"})
    EXPECT_FALSE(vcm.contains(word(neither)) || joined.contains(word(neither))) << neither;
  for (const AlgorithmId dims : {AlgorithmId::PhotonMap, AlgorithmId::ProgressivePhotons, AlgorithmId::FinalGathering,
                                 AlgorithmId::InstantRadiosity, AlgorithmId::Whitted})
    EXPECT_TRUE((claimed_by(facts(dims)) & taxonomy::compile("L .* V .* E")).is_empty());
}

}  // namespace
}  // namespace heckbert::transport
