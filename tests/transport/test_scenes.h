#pragma once
// Scenes with known answers, and the comparison of a record with them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/taxonomy/word.h>
#include <heckbert/transport/material.h>
#include <heckbert/transport/render.h>

namespace heckbert::transport {

/// One shape more, with a material of its own.
inline void add(Scene& scene, Geometry geometry, Material material) {
  scene.materials.push_back(std::move(material));
  scene.shapes.push_back({.name = "",
                          .geometry = std::move(geometry),
                          .material = static_cast<std::uint32_t>(scene.materials.size() - 1)});
}

inline Material diffuse(float albedo) {
  return {.name = "diffuse", .lobes = {Lambert{Rgb(albedo)}}};
}

inline Material emitter(float radiance, Sides sides = Sides::Front) {
  return {.name = "light", .lobes = {}, .emission = Rgb(radiance), .emission_sides = sides};
}

/// A closed box seen from inside whose every surface emits 1 and reflects diffusely and specularly.
inline Scene furnace(float diffuse_albedo, float mirror_reflectance) {
  Scene scene;
  scene.name = "furnace";
  add(scene, make_box({-1, -1, -1}, {1, 1, 1}, true),
      {.name = "wall", .lobes = {Lambert{Rgb(diffuse_albedo)}, Mirror{Rgb(mirror_reflectance)}}, .emission = Rgb(1)});
  scene.camera = {.position = {0.1f, 0.2f, 0.3f}, .look_at = {0.9f, 0.1f, -0.4f}, .vertical_fov_degrees = 60};
  return scene;
}

/// A unit sphere of one material seen from inside.
inline Scene inside_sphere(Material material) {
  Scene scene;
  add(scene, Sphere{{0, 0, 0}, 1}, std::move(material));
  scene.camera = {.position = {0.1f, 0.2f, 0.3f}, .look_at = {0.9f, 0.1f, -0.4f}, .vertical_fov_degrees = 60};
  return scene;
}

/// The picture-mean energy of all words that print as `plain`.
inline record::Estimate energy_of(const record::Record& record, const std::string& plain) {
  std::vector<bool> chosen(record.words.size());
  for (std::size_t i = 0; i < record.words.size(); ++i) chosen[i] = taxonomy::plain(record.words[i]) == plain;
  return record::energy(record, chosen);
}

/// Student's test of each word's energy against its true value, at 1 % for the whole table after Sidak. An estimate
/// without spread must be right to rounding.
inline void expect_energies(const record::Record& record, const std::map<std::string, double>& truth,
                            double significance = 0.01) {
  const double per_word = 1.0 - std::pow(1.0 - significance, 1.0 / static_cast<double>(truth.size()));
  const int degrees = record::batch_count(record.info.samples_per_pixel) - 1;
  const double bound = record::student_quantile(1.0 - per_word / 2.0, degrees);
  for (const auto& [word, expected] : truth) {
    const record::Estimate e = energy_of(record, word);
    const double rounding = 2e-5 * expected;
    EXPECT_NEAR(e.mean, expected, bound * e.standard_error + rounding)
        << word << ": " << (e.mean - expected) / e.standard_error << " standard errors, relative "
        << e.mean / expected - 1;
    EXPECT_LT(e.standard_error, 0.05 * expected + 1e-12) << word << ": too noisy to say anything";
  }
}

/// The unbiased algorithms that walk from the eye alone and whose grammar has the word, given light -> eye. Those that
/// walk from the light too are compared with them in bidirectional_test.cpp.
inline std::vector<AlgorithmFacts> algorithms_that_find(const std::string& word) {
  std::vector<AlgorithmFacts> found;
  for (const AlgorithmFacts& algorithm : kAlgorithms)
    if (!algorithm.from_light && algorithm.accuracy == Accuracy::Unbiased &&
        taxonomy::builtin_grammars().find(algorithm.grammar)->language.contains(taxonomy::parse_word(word)))
      found.push_back(algorithm);
  return found;
}

/// Every word over D and S of at most `longest` scatterings.
inline std::vector<std::string> words_over_ds(std::size_t longest) {
  std::vector<std::string> interiors{""};
  for (std::size_t i = 0; i < interiors.size(); ++i)
    if (interiors[i].size() < longest)
      for (const char* letter : {"D", "S"}) interiors.push_back(interiors[i] + letter);
  for (std::string& w : interiors) w = "L" + w + "E";
  return interiors;
}

inline double product_of_albedos(const std::string& word, double diffuse_albedo, double mirror_reflectance) {
  double product = 1;
  for (const char c : word) product *= c == 'D' ? diffuse_albedo : c == 'S' ? mirror_reflectance : 1.0;
  return product;
}

}  // namespace heckbert::transport
