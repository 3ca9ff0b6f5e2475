// The table of verdicts on the built-in scenes, which docs/verify.md and README.md show: a row for each algorithm, a
// column for each scene. HECKBERT_UPDATE_DOCS=1 in the environment of these tests writes it anew.

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using nlohmann::json;

struct TabledScene {
  std::string name;
  std::string patches;  ///< fine enough for its shadows
};
const TabledScene kScenes[] = {{"cornell", "patch-edge=0.0625"},
                               {"cornell-balls", "patch-edge=0.0625"},
                               {"lecture", "patch-edge=0.0625"},
                               {"caustic", "patch-edge=0.03125,refinements=2"},
                               {"caustic-point", "patch-edge=0.03125,refinements=2"},
                               {"door", "patch-edge=0.0625"},
                               {"lantern", "patch-edge=0.125"}};

/// Cells by row; the first row is the head, and the first cell of each its algorithm.
using Table = std::vector<std::vector<std::string>>;
/// By algorithm, in the order of the command.
using Column = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kCorner = "algorithm";

/// What `verify` says of every algorithm, and the column's head.
Column column_of(const TabledScene& scene) {
  const Outcome outcome = run({"verify", scene.name, "--size", "48x48", "--spp", "32", "--reference-spp", "64",
                               "--json", "--method", "photon-radius=0.02,patch-rays=16," + scene.patches});
  EXPECT_EQ(outcome.exit_code, 0) << "some algorithm does not do what its grammar says" << outcome.err;
  const json document = json::parse(outcome.out);
  Column column{{kCorner, fmt::format("{}, {}", scene.name, document["verdicts"][0]["light"].get<std::string>())}};
  for (const json& verdict : document["verdicts"]) {
    const std::string ruling = verdict["verdict"], word = verdict["shortest"];
    column.emplace_back(
        fmt::format("`{}`", verdict["algorithm"].get<std::string>()),
        (verdict["expected"] ? ruling : "**" + ruling + "**") + (word.empty() ? "" : fmt::format(", `{}`", word)));
  }
  return column;
}

/// Where the table stands in a text: begin and end.
std::pair<std::size_t, std::size_t> place_of_table(const std::string& text) {
  const std::size_t begin = text.find(fmt::format("| {} | {}", kCorner, kScenes[0].name));
  if (begin == std::string::npos) throw std::runtime_error("the document has no table of verdicts");
  const std::size_t end = text.find("\n\n", begin);
  return {begin, end == std::string::npos ? text.size() : end + 1};
}

Table parse(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("|--")) continue;
    std::vector<std::string>& cells = table.emplace_back();
    for (std::size_t at = 2, bar; (bar = line.find(" |", at)) != std::string::npos; at = bar + 3)
      cells.push_back(line.substr(at, bar - at));
  }
  return table;
}

std::string print(const Table& table) {
  std::string text;
  for (std::size_t row = 0; row < table.size(); ++row) {
    text += '|';
    for (const std::string& cell : table[row]) text += fmt::format(" {} |", cell);
    text += '\n';
    if (row == 0) {
      for (std::size_t i = 0; i < table[row].size(); ++i) text += "|---";
      text += "|\n";
    }
  }
  return text;
}

/// The table with one column anew: its rows are the column's.
Table with_column(const Table& table, std::size_t number, const Column& column) {
  Table changed;
  for (const auto& [algorithm, cell] : column) {
    std::vector<std::string>& row = changed.emplace_back();
    row.push_back(algorithm);
    for (const std::vector<std::string>& old : table)
      if (old.front() == algorithm) row = old;
    row.resize(std::size(kScenes) + 1);
    row[number] = cell;
  }
  return changed;
}

class VerdictTable : public ::testing::TestWithParam<std::size_t> {};

TEST_P(VerdictTable, IsWhatTheDocumentsShow) {
  const Column column = column_of(kScenes[GetParam()]);
  for (const std::string name : {"/docs/verify.md", "/README.md"}) {
    const std::string file = HECKBERT_SOURCE_DIR + name;
    const std::string text = read_bytes(file);
    const auto [begin, end] = place_of_table(text);
    const std::string shown = text.substr(begin, end - begin);
    const std::string expected = print(with_column(parse(shown), GetParam() + 1, column));
    if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr)
      std::ofstream(file) << text.substr(0, begin) << expected << text.substr(end);
    else
      EXPECT_EQ(shown, expected) << "write it anew: HECKBERT_UPDATE_DOCS=1 cli_test --gtest_filter='*VerdictTable*'";
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltInScenes, VerdictTable, ::testing::Range(std::size_t{0}, std::size(kScenes)),
                         [](const ::testing::TestParamInfo<std::size_t>& column) {
                           std::string name = kScenes[column.param].name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace heckbert::cli::testing
