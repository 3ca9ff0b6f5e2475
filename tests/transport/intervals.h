#pragma once
// How often the intervals of a furnace's words hold their known values, over many seeds.

#include <heckbert/record/sample_map.h>

#include "test_scenes.h"

namespace heckbert::transport {

enum class Sampled { Whole, Cropped, Adaptive };

struct Held {
  std::string word;
  double truth = 0;
  bool is_often_absent = false;
  int energies = 0;
  double squared_deviations = 0, squared_errors = 0;
};

/// Renders of 4x4 pixels and 32 samples each. The first six words are found by many paths in each, the next three by
/// some ten, and the last three by one to five, which are brighter than others and absent from 4 to 17 renders of a
/// hundred.
inline std::vector<Held> count_held(SamplerKind sampler, Sampled how, int seeds) {
  std::vector<Held> rows;
  for (const char* word :
       {"LDE", "LDDE", "LSDE", "LDSE", "LSSE", "LDDDE", "LSSSE", "LSSSSE", "LSDSDE", "LDDDSSSE", "LSSSSDE", "LSDSDSDE"})
    rows.push_back({word, product_of_albedos(word, 0.5, 0.3)});
  for (auto row = rows.end() - 3; row != rows.end(); ++row) row->is_often_absent = true;
  const Scene scene = furnace(0.5f, 0.3f);
  for (int seed = 0; seed < seeds; ++seed) {
    RenderSettings settings{.width = 4,
                            .height = 4,
                            .samples_per_pixel = 32,
                            .max_depth = 7,
                            .seed = static_cast<std::uint64_t>(seed) + 1,
                            .threads = 1,
                            .sampler = sampler};
    if (how == Sampled::Cropped) {
      settings.width = settings.height = 9;
      settings.crop = record::Window{3, 2, 7, 6};
    } else if (how == Sampled::Adaptive) {
      settings.sample_map = record::SampleMap{.window = {0, 0, 4, 4}};
      for (std::uint16_t pixel = 0; pixel < 16; ++pixel)
        settings.sample_map->repeats.push_back(static_cast<std::uint16_t>(1 + pixel % 3));
    }
    const record::Record record = render(scene, settings);
    for (Held& row : rows) {
      const record::Estimate e = energy_of(record, row.word);
      row.energies += e.lower <= row.truth && row.truth <= e.upper ? 1 : 0;
      row.squared_deviations += (e.mean - row.truth) * (e.mean - row.truth);
      row.squared_errors += e.standard_error * e.standard_error;
    }
  }
  return rows;
}

}  // namespace heckbert::transport
