// The McGuire boxes (Computer Graphics Archive) from file to report: real scenes by other people, whose words are known
// from what is in them. They are looked for in ../shared beside the checkout; without them the test is skipped.

#include <filesystem>

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

const std::filesystem::path kBoxes =
    std::filesystem::path(HECKBERT_SOURCE_DIR).parent_path() / "shared" / "scenes" / "mcguire-cornell";

class McGuireBox : public testing::TestWithParam<const char*> {};

record::Record rendered(const std::string& name) {
  const auto imported = import::load_scene(kBoxes / ("CornellBox-" + name + ".obj"));
  return transport::render(imported.scene, {.width = 64, .height = 64, .samples_per_pixel = 64, .max_depth = 16});
}

double energy(const record::Record& record, const char* expression) {
  return record::energy(record, record::members(record, taxonomy::compile(expression))).mean;
}

TEST_P(McGuireBox, RendersClassifiesAndReports) {
  if (!std::filesystem::exists(kBoxes))
    GTEST_SKIP() << "SKIPPED: the McGuire boxes are not at " << kBoxes << "; nothing was tested";
  const std::string name = GetParam();
  const record::Record record = rendered(name);
  EXPECT_EQ(record.tally.rejected_not_finite + record.tally.rejected_negative, 0u);
  const double total = energy(record, "L .* E");
  EXPECT_GT(total, 0.01);
  EXPECT_GT(energy(record, "LDE"), 0.1 * total);

  const report::Coverage coverage = report::coverage(record, taxonomy::core_algorithms(taxonomy::builtin_grammars()));
  double previous = 0;
  for (const char* nested : {"ray-casting", "whitted", "path-tracing", "global-illumination"})
    for (const report::GrammarCoverage& grammar : coverage.grammars)
      if (grammar.name == nested) {
        EXPECT_GE(grammar.share.mean, previous - 1e-6) << nested;
        previous = grammar.share.mean;
      }
  EXPECT_NEAR(previous, 1.0, 1e-9);
  const std::string page = report::html(record, coverage, report::classify(record, report::GroupBy::Word, {}));
  EXPECT_NE(page.find("LDE"), std::string::npos);

  if (name == "Original") {
    EXPECT_EQ(energy(record, "L .* S .* E"), 0.0);
  }
  if (name == "Mirror") {
    EXPECT_GT(energy(record, "LDSE"), 0.0);
    EXPECT_GT(energy(record, "LSDE"), 0.0);
  }
  if (name == "Sphere") {
    EXPECT_GT(energy(record, "LSSDE"), 0.0);
  }
  if (name == "Glossy") {
    EXPECT_GT(energy(record, "LGE"), 0.0);
  }
  if (name == "Water") {
    EXPECT_GT(energy(record, "L .* St .* E"), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, McGuireBox,
                         testing::Values("Original", "Mirror", "Sphere", "Glossy", "Water", "Empty-CO", "Empty-RG",
                                         "Empty-Squashed", "Empty-White"),
                         [](const auto& box) {
                           std::string name = box.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace heckbert
