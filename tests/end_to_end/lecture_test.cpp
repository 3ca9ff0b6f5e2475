// The product's own scenes: what the lecture says about its scene is found in it, and the picture is the sum of its
// words.

#include <gtest/gtest.h>

#include <heckbert/import/import.h>
#include <heckbert/record/statistics.h>
#include <heckbert/report/coverage.h>
#include <heckbert/report/html.h>
#include <heckbert/taxonomy/expression.h>
#include <heckbert/taxonomy/grammar.h>
#include <heckbert/transport/render.h>

namespace heckbert {
namespace {

record::Record rendered(const char* name, int samples) {
  return transport::render(import::load_scene_or_builtin(name).scene,
                           {.width = 96, .height = 96, .samples_per_pixel = samples, .max_depth = 32});
}

TEST(LectureScene, HasTheWordsOfTheBlackboardAndTheReportNamesThem) {
  const record::Record record = rendered("lecture", 64);
  const auto all = std::vector<bool>(record.words.size(), true);
  for (const char* word : {"LDDE", "LSSE", "LDE", "LSE", "LDSE", "LSSDE"}) {
    const auto share = record::share(record, record::members(record, taxonomy::compile(word)), all);
    EXPECT_GT(share.lower, 0.0) << word;
  }
  const report::Coverage coverage = report::coverage(record, taxonomy::core_algorithms(taxonomy::builtin_grammars()));
  const std::string page = report::html(record, coverage, report::classify(record, report::GroupBy::Word, {}));
  for (const char* word : {"LDDE", "LSSE"}) EXPECT_NE(page.find(word), std::string::npos) << word;
}

TEST(BuiltinScenes, ArePicturesThatEqualTheSumOfTheirWords) {
  for (const import::BuiltinScene& scene : import::builtin_scenes()) {
    const record::Record record = rendered(std::string(scene.name).c_str(), 4);
    const record::Image beauty = record::beauty(record);
    std::vector<double> sum(beauty.pixels.size());
    for (std::size_t pixel = 0; pixel < sum.size(); ++pixel)
      for (std::size_t e = record.offsets[pixel]; e < record.offsets[pixel + 1]; ++e)
        sum[pixel] += static_cast<double>(record.entries[e].energy.g);
    for (std::size_t pixel = 0; pixel < sum.size(); ++pixel)
      ASSERT_EQ(beauty.pixels[pixel].g, static_cast<float>(sum[pixel])) << scene.name << " " << pixel;

    for (const char* expression : {"L S+ D E", "L D* E", "L X* S X* E", "LE"}) {
      const auto part = record::members(record, taxonomy::compile(expression));
      const auto rest = record::members(record, taxonomy::compile(std::string("!(") + expression + ")"));
      const record::Image a = record::image_of(record, part), b = record::image_of(record, rest);
      for (std::size_t pixel = 0; pixel < sum.size(); ++pixel)
        ASSERT_NEAR(a.pixels[pixel].g + b.pixels[pixel].g, beauty.pixels[pixel].g,
                    2 * std::numeric_limits<float>::epsilon() * beauty.pixels[pixel].g)
            << scene.name << " " << expression;
    }
  }
}

// A2 of docs/anchors.md on the furnace that ships with the tool: albedos one half and three tenths.
TEST(FurnaceScene, GivesEveryGrammarItsClosedForm) {
  const record::Record record = rendered("furnace", 96);
  const auto all = std::vector<bool>(record.words.size(), true);
  const struct {
    const char* grammar;
    double share;
  } rows[] = {{"ray-casting", 1.5 / 5},
              {"radiosity", 2.0 / 5},
              {"whitted", 15.0 / 7 / 5},
              {"lecture", 15.0 / 7 / 5},
              {"distribution-ray-tracing", 15.0 / 7 / 5},
              {"path-tracing", 1},
              {"global-illumination", 1},
              {"caustic", 3.0 / 14 / 5}};
  for (const auto& row : rows) {
    const taxonomy::Grammar* grammar = taxonomy::builtin_grammars().find(row.grammar);
    ASSERT_NE(grammar, nullptr) << row.grammar;
    const auto share = record::share(record, record::members(record, grammar->language), all);
    // Student's test with 31 degrees of freedom, 1 % over the table after Sidak.
    EXPECT_NEAR(share.mean, row.share, 3.5 * share.standard_error + 1e-9) << row.grammar;
    EXPECT_LT(share.standard_error, 0.002) << row.grammar;
  }
}

}  // namespace
}  // namespace heckbert
