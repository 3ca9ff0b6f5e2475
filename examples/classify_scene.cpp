// Traces a scene and classifies its paths, through the libraries alone: what the command line does, in forty lines.
//
// Usage: classify_scene [SCENE]     a built-in scene or a file; default cornell

#include <cstdio>
#include <exception>

#include <heckbert/import/import.h>
#include <heckbert/record/statistics.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/transport/render.h>

int main(int argc, char** argv) try {
  using namespace heckbert;

  // A scene is plain data; change it here, or build one from nothing.
  const transport::Scene scene = import::load_scene_or_builtin(argc > 1 ? argv[1] : "cornell").scene;
  const record::Record record =
      transport::render(scene, {.width = 128, .height = 128, .samples_per_pixel = 64, .max_depth = 16});
  std::printf("%s: %zu different words\n", scene.name.c_str(), record.words.size());

  // Every algorithm's grammar is a language, and so is any expression of your own.
  const std::vector<bool> everything(record.words.size(), true);
  const auto print_share = [&](const char* what, const taxonomy::Language& language) {
    const auto share = record::share(record, record::members(record, language), everything);
    std::printf("%-38s %5.1f %% +- %.1f\n", what, 100 * share.mean, 50 * (share.upper - share.lower));
  };
  for (const taxonomy::Grammar& grammar : taxonomy::core_algorithms(taxonomy::builtin_grammars()))
    print_share(grammar.title.c_str(), grammar.language);
  print_share("two diffuse bounces, LDDE", taxonomy::compile("LDDE"));

  // The picture of a language is a sum over the words it contains.
  const record::Image indirect = record::image_of(record, record::members(record, taxonomy::compile("L . .+ E")));
  const Rgb corner = indirect.at(20, 100);
  std::printf("indirect light at (20, 100): %.2f %.2f %.2f\n", corner.r, corner.g, corner.b);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
