#pragma once
// Four scenes by Benedikt Bitterli (Rendering Resources), read straight from their Mitsuba XML, and the author's
// converged pictures of them. They are looked for in ../shared beside the checkout; without them the tests are skipped.
//
// What is compared. The pictures were made by Tungsten, whose `max_bounces` b ends a path with its segment b, while its
// exporter writes b + 1 segments into the XML (cornell-box: 64 and 65). So the scenes are traced as the file says, and
// of the record those words are taken that have one scattering less than the file allows.
//
// Water-caustic is another case. Its lamp is five millimetres wide, and what it does through glass a path tracer finds
// once in a million paths; so the lamp is made larger at equal power (Case::lamp_growth), and where it is seen,
// directly or in the water, both sides are left out: there the picture is a few samples of half a million each. And the
// picture comes from a photon map of twenty neighbours, which is 20/19 too bright (photon_map.h; bitterli_test.cpp
// shows it); ours is made as bright for the comparison (Case::bias).

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

#include <gtest/gtest.h>

#include <heckbert/import/import.h>
#include <heckbert/record/file.h>
#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/transport/render.h>

#include "end_to_end/photon_map.h"

namespace heckbert::bitterli {

inline const std::filesystem::path kScenes =
    std::filesystem::path(HECKBERT_SOURCE_DIR).parent_path() / "shared" / "scenes";

struct Case {
  const char* name;
  int segments;           ///< max_depth of the file
  std::size_t ignored;    ///< sentences about what is not read
  record::Window window;  ///< of the full picture, without lamps
  float lamp_growth = 1;  ///< of the lamp's two edges
  double bias = 1;        ///< of the picture: how many times the truth it shows
};

inline constexpr Case kCases[] = {
    {"cornell-box", 65, 0, {256, 448, 384, 512}},
    {"veach-mis", 3, 0, {576, 500, 704, 564}},
    {"veach-bidir", 7, 0, {128, 256, 256, 320}},
    {"water-caustic", 9, 10, {640, 64, 768, 128}, 32, nearest_neighbours_bias(20)},
};

inline std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::erase(name, '-');
  return name;
}

inline std::filesystem::path folder_of(const Case& scene) {
  return kScenes / ("bitterli-" + std::string(scene.name));
}

/// The author's picture; black where its half floats could not hold the lamp, and wherever a lamp that is left out is
/// seen: nothing else is brighter than 2, and no pixel with the lamp in it darker than 20.
inline record::Image reference(const Case& scene) {
  constexpr float kLamp = 10;
  record::Image image = record::read_layers(folder_of(scene) / "TungstenRender.exr").front().image;
  for (Rgb& pixel : image.pixels)
    if (!is_finite(pixel) || (scene.lamp_growth > 1 && max_channel(pixel) > kLamp)) pixel = {};
  return image;
}

/// The scene, its lamp enlarged.
inline import::Imported load(const Case& scene) {
  import::Imported imported = import::load_scene(folder_of(scene) / "scene.xml");
  for (transport::Shape& shape : imported.scene.shapes) {
    transport::Material& material = imported.scene.materials[shape.material];
    auto* mesh = std::get_if<transport::Mesh>(&shape.geometry);
    if (scene.lamp_growth == 1 || is_black(material.emission) || mesh == nullptr) continue;
    const glm::vec3 middle = 0.5f * (mesh->positions[0] + mesh->positions[2]);
    for (glm::vec3& p : mesh->positions) p = middle + scene.lamp_growth * (p - middle);
    material.emission *= 1 / (scene.lamp_growth * scene.lamp_growth);
  }
  return imported;
}

inline transport::RenderSettings settings_of(const import::Imported& imported, int samples_per_pixel) {
  const transport::RenderDefaults& file = imported.scene.defaults;
  transport::RenderSettings settings;
  settings.width = file.width.value();
  settings.height = file.height.value();
  settings.max_depth = file.max_depth.value();
  settings.filter = file.filter.value();
  settings.samples_per_pixel = samples_per_pixel;
  settings.sampler = transport::SamplerKind::Random;
  return settings;
}

/// The words that the reference picture has too, without the lamp itself where that is left out.
inline std::vector<bool> comparable(const record::Record& record, const Case& scene) {
  const std::string words = "L X{0," + std::to_string(scene.segments - 2) + "} E";
  return record::members(record, taxonomy::compile(scene.lamp_growth == 1 ? words : words + " - L S* E"));
}

using Colour = std::array<double, 3>;

inline Colour colour_of(Rgb c) {
  return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
}

/// Mean over a window, and its standard error from the spread of the batches.
struct Mean {
  Colour value{}, standard_error{};
};

inline Mean mean_of(const record::Record& record, const std::vector<bool>& chosen) {
  const int batches = record::batch_count(record.info.samples_per_pixel);
  std::vector<Colour> sums(static_cast<std::size_t>(batches));
  for (std::size_t word = 0; word < record.words.size(); ++word)
    for (std::size_t batch = 0; chosen[word] && batch < sums.size(); ++batch) {
      const Colour c = colour_of(record.batch_means[word * record::kBatches + batch]);
      for (std::size_t channel = 0; channel < 3; ++channel) sums[batch][channel] += c[channel];
    }
  Mean mean;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double sum = 0, squares = 0;
    for (const Colour& c : sums) sum += c[channel];
    mean.value[channel] = sum / batches;
    for (const Colour& c : sums) squares += (c[channel] - mean.value[channel]) * (c[channel] - mean.value[channel]);
    mean.standard_error[channel] = std::sqrt(squares / batches / (batches - 1));
  }
  return mean;
}

inline Colour mean_of(const record::Image& image, const record::Window& window) {
  Colour sum{};
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const Colour c = colour_of(image.at(x, y));
      for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += c[channel];
    }
  for (double& channel : sum) channel /= static_cast<double>(window.pixel_count());
  return sum;
}

/// Squared errors of green against the reference, added up for each of `parts` groups of rows.
inline std::vector<double> squared_errors(const record::Record& record, const Case& scene,
                                          const record::Image& expected, int parts) {
  const record::Image image = record::image_of(record, comparable(record, scene));
  const record::Window& window = record.info.window;
  std::vector<double> squares(static_cast<std::size_t>(parts));
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const double error =
          scene.bias * static_cast<double>(image.at(x, y).g) - static_cast<double>(expected.at(x, y).g);
      squares[static_cast<std::size_t>((y - window.y0) * parts / window.height())] += error * error;
    }
  return squares;
}

/// How the error falls: the slope of its logarithm over that of the samples, and its standard error by the jackknife
/// over 16 groups of rows.
struct Slope {
  double value = 0, standard_error = 0;
};

inline Slope slope(const record::Record& few, const record::Record& many, const Case& scene) {
  constexpr std::size_t kParts = 16;
  const record::Image expected = reference(scene);
  const std::vector<double> a = squared_errors(few, scene, expected, kParts);
  const std::vector<double> b = squared_errors(many, scene, expected, kParts);
  const double all_a = std::accumulate(a.begin(), a.end(), 0.0), all_b = std::accumulate(b.begin(), b.end(), 0.0);
  const double samples = std::log(double(many.info.samples_per_pixel) / double(few.info.samples_per_pixel));
  const auto of = [&](double x, double y) { return 0.5 * std::log(y / x) / samples; };
  Slope result{of(all_a, all_b), 0};
  double spread = 0;
  for (std::size_t part = 0; part < kParts; ++part) {
    const double without = of(all_a - a[part], all_b - b[part]) - result.value;
    spread += without * without;
  }
  result.standard_error = std::sqrt(spread * (kParts - 1) / kParts);
  return result;
}

class BitterliScene : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_of(GetParam())))
      GTEST_SKIP() << "SKIPPED: " << GetParam().name << " is not at " << kScenes << "; nothing was tested";
    imported_ = load(GetParam());
  }

  /// The case's window.
  record::Record rendered(int samples_per_pixel, std::uint64_t seed) const {
    transport::RenderSettings settings = settings_of(imported_, samples_per_pixel);
    settings.crop = GetParam().window;
    settings.seed = seed;
    return transport::render(imported_.scene, settings);
  }

  import::Imported imported_;
};

}  // namespace heckbert::bitterli
