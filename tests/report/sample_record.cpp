#include "report/sample_record.h"

#include <algorithm>
#include <cmath>

#include <heckbert/taxonomy/expression.h>

namespace heckbert::report::test {
namespace {

/// A round spot of light, 1 at its centre, that falls off smoothly; places are fractions of the picture.
std::function<Rgb(int, int)> spot(int width, int height, float cx, float cy, float radius, Rgb colour) {
  return [=](int x, int y) {
    const float dx = (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - cx;
    const float dy = (static_cast<float>(y) + 0.5f) / static_cast<float>(height) - cy;
    return colour * std::exp(-(dx * dx + dy * dy) / (radius * radius));
  };
}

/// Sixteen batches that wobble by two per cent around the mean that the picture has, each word in its own way.
std::vector<float> wobbling_batches(float mean, std::size_t word) {
  std::vector<float> batches;
  for (std::size_t b = 0; b < 16; ++b)
    batches.push_back(mean * (1 + 0.02f * std::sin(1.7f * static_cast<float>(b * b) + static_cast<float>(b * word))));
  return batches;
}

}  // namespace

record::Record sample_record(int width, int height, const std::vector<SampleWord>& words) {
  std::vector<std::pair<taxonomy::Word, const SampleWord*>> sorted;
  sorted.reserve(words.size());
  for (const SampleWord& word : words) sorted.emplace_back(taxonomy::parse_word(word.word), &word);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  record::Record record;
  record.info = {.scene = "sample",
                 .algorithm = "path",
                 .width = width,
                 .height = height,
                 .window = {0, 0, width, height},
                 .samples_per_pixel = words.empty() ? 4 : static_cast<int>(words[0].batches.size()),
                 .seed = 7,
                 .max_depth = 32,
                 .partial = false,
                 .labels = {},
                 .version = "0.0.0",
                 .ignored = {"sample.xml:7: <medium> is not read"}};
  record.tally.samples = record.info.window.pixel_count() * static_cast<std::size_t>(record.info.samples_per_pixel);
  for (const auto& [word, sample] : sorted) {
    record.words.push_back(word);
    for (std::size_t b = 0; b < record::kBatches; ++b)
      record.batch_means.emplace_back(b < sample->batches.size() ? sample->batches[b] : 0.0f);
  }
  record.counts.resize(sorted.size());
  record.offsets.push_back(0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (std::uint32_t w = 0; w < sorted.size(); ++w) {
        const Rgb light = sorted[w].second->light(x, y);
        if (is_black(light)) continue;
        record.entries.push_back({w, light, sorted[w].second->count});
        record.counts[w] += sorted[w].second->count;
      }
      record.offsets.push_back(record.entries.size());
    }
  return record;
}

record::Record lecture_like_record(int width, int height) {
  struct Spot {
    const char* word;
    float x, y, radius;
    Rgb colour;
  };
  const std::vector<Spot> spots{
      {"LE", 0.50f, 0.06f, 0.07f, {9.0f, 8.5f, 7.0f}},    {"LDE", 0.50f, 0.75f, 0.60f, {0.6f, 0.55f, 0.5f}},
      {"LDDE", 0.50f, 0.30f, 0.90f, {0.2f, 0.14f, 0.1f}}, {"LDDDE", 0.50f, 0.40f, 0.95f, {0.07f, 0.05f, 0.04f}},
      {"LSE", 0.66f, 0.44f, 0.02f, {6.0f, 6.0f, 6.0f}},   {"LSSE", 0.30f, 0.46f, 0.03f, {3.0f, 3.0f, 3.0f}},
      {"LDSE", 0.68f, 0.58f, 0.14f, {0.5f, 0.5f, 0.55f}}, {"LDSSE", 0.30f, 0.58f, 0.13f, {0.4f, 0.5f, 0.4f}},
      {"LSSDE", 0.26f, 0.88f, 0.05f, {1.5f, 1.5f, 1.3f}}, {"LSDE", 0.80f, 0.86f, 0.10f, {0.3f, 0.3f, 0.3f}},
      {"LGE", 0.50f, 0.55f, 0.08f, {0.4f, 0.3f, 0.2f}},   {"LDDSE", 0.68f, 0.56f, 0.12f, {0.1f, 0.1f, 0.1f}},
  };
  std::vector<SampleWord> words;
  for (const Spot& s : spots) {
    const auto light = spot(width, height, s.x, s.y, s.radius, s.colour);
    double sum = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) sum += static_cast<double>(luminance(light(x, y)));
    const auto mean = static_cast<float>(sum / (width * height));
    words.push_back({.word = s.word, .batches = wobbling_batches(mean, words.size()), .count = 3, .light = light});
  }
  return sample_record(width, height, words);
}

taxonomy::Grammar grammar_of(const std::string& name, const std::string& title, const std::string& expression) {
  taxonomy::Grammar grammar;
  grammar.name = name;
  grammar.title = title;
  grammar.expression = expression;
  grammar.language = taxonomy::compile(expression);
  return grammar;
}

std::vector<taxonomy::Grammar> four_grammars() {
  std::vector<taxonomy::Grammar> grammars{
      grammar_of("ray-casting", "Ray casting", "LD?E"),
      grammar_of("radiosity", "Radiosity", "LD*E"),
      grammar_of("lecture", "Recursive ray tracing", "LD?S*E"),
      grammar_of("global-illumination", "Global illumination", "L(D|G|S|V)*E"),
  };
  grammars[1].source = "Goral et al., 1984";
  grammars[1].biases = {"patches give LDDE a wrong value"};
  grammars[1].variances = {"hemicubes alias small lamps"};
  grammars[1].preconditions = {"every surface is diffuse"};
  grammars[2].expression_delta = "LDS*E";
  grammars[3].expression_delta = grammars[3].expression;
  return grammars;
}

taxonomy::Grammar proxy() {
  taxonomy::Grammar grammar;
  grammar.kind = taxonomy::GrammarKind::Proxy;
  grammar.name = "occlusion";
  grammar.title = "Occlusion";
  grammar.source = "the sample";
  return grammar;
}

}  // namespace heckbert::report::test
