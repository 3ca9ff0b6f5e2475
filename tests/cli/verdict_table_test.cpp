// The tables of verdicts: on the built-in scenes, which docs/verify.md and README.md show, and on one room by light and
// eye, which docs/verify.md shows. A row for each algorithm, a column for each scene. HECKBERT_UPDATE_DOCS=1 in the
// environment of these tests writes them anew.

#include <cctype>
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
const std::vector<TabledScene> kBuiltIn{{"cornell", "patch-edge=0.0625"},
                                        {"cornell-balls", "patch-edge=0.0625"},
                                        {"lecture", "patch-edge=0.0625"},
                                        {"caustic", "patch-edge=0.03125,refinements=2"},
                                        {"caustic-point", "patch-edge=0.03125,refinements=2"},
                                        {"door", "patch-edge=0.0625"},
                                        {"lantern", "patch-edge=0.125"}};
const std::vector<TabledScene> kRooms{{"La, Ep", "patch-edge=0.03125"}, {"La, El", "patch-edge=0.03125"},
                                      {"Lp, Ep", "patch-edge=0.03125"}, {"Lp, El", "patch-edge=0.03125"},
                                      {"Ld, Ep", "patch-edge=0.03125"}, {"Ld, El", "patch-edge=0.03125"},
                                      {"Le, Ep", "patch-edge=0.03125"}, {"Le, El", "patch-edge=0.03125"}};

/// A floor and a wall, a mirror and a plate of rough gold, by the name in kRooms.
std::string room(const std::string& name) {
  const std::string light = name.substr(0, 2);
  const bool has_lens = name.ends_with("El");
  json scene = {
      {"camera", {{"position", {0, 1.2, 4}}, {"look_at", {0, 0.5, 0}}, {"fov", 40}}},
      {"materials",
       {{{"name", "grey"}, {"type", "lambert"}, {"albedo", 0.5}},
        {{"name", "mirror"}, {"type", "mirror"}, {"reflectance", 0.9}},
        {{"name", "gold"}, {"type", "ggx"}, {"metal", "Au"}, {"roughness", 0.3}}}},
      {"shapes",
       {{{"type", "quad"}, {"material", "grey"}, {"corner", {-2, 0, 2}}, {"edge_u", {4, 0, 0}}, {"edge_v", {0, 0, -4}}},
        {{"type", "quad"},
         {"material", "grey"},
         {"corner", {-2, 0, -2}},
         {"edge_u", {4, 0, 0}},
         {"edge_v", {0, 2.5, 0}}},
        {{"type", "quad"},
         {"material", "mirror"},
         {"corner", {-1.2, 0, -0.9}},
         {"edge_u", {0.9, 0, -0.6}},
         {"edge_v", {0, 1.2, 0}}},
        {{"type", "quad"},
         {"material", "gold"},
         {"corner", {0.4, 0.02, 0.9}},
         {"edge_u", {0.9, 0, 0}},
         {"edge_v", {0, 0.1, -0.9}}}}}};
  if (has_lens) scene["camera"].update({{"lens_radius", 0.05}, {"focus_distance", 4}});
  if (light == "La") {
    scene["materials"].push_back({{"name", "lamp"}, {"type", "lambert"}, {"albedo", 0.5}, {"emission", 6}});
    scene["shapes"].push_back({{"type", "quad"},
                               {"material", "lamp"},
                               {"corner", {-0.5, 2.4, -0.3}},
                               {"edge_u", {1, 0, 0}},
                               {"edge_v", {0, 0, 1}}});
  } else if (light == "Lp") {
    scene["lights"] = {{{"type", "point"}, {"position", {0.3, 2.2, 0.5}}, {"intensity", 5}}};
  } else if (light == "Ld") {
    scene["lights"] = {{{"type", "distant"}, {"direction", {0.3, -1, -0.4}}, {"irradiance", 2}}};
  } else {
    scene["environment"] = 1;
  }
  return scene.dump();
}

/// Cells by row; the first row is the head, and the first cell of each its algorithm.
using Table = std::vector<std::vector<std::string>>;
/// By algorithm, in the order of the command.
using Column = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kCorner = "algorithm";

/// What `verify` says of every algorithm, and the column's head.
Column column_of(const std::string& head, const std::string& scene, const std::string& patches,
                 const std::string& size) {
  const Outcome outcome = run({"verify", scene, "--size", size, "--spp", "32", "--reference-spp", "64", "--json",
                               "--method", "photon-radius=0.02,patch-rays=16," + patches});
  EXPECT_EQ(outcome.exit_code, 0) << "some algorithm does not do what its grammar says" << outcome.err;
  const json document = json::parse(outcome.out);
  Column column{{kCorner, head}};
  for (const json& verdict : document["verdicts"]) {
    const std::string ruling = verdict["verdict"], word = verdict["shortest"];
    column.emplace_back(
        fmt::format("`{}`", verdict["algorithm"].get<std::string>()),
        (verdict["expected"] ? ruling : "**" + ruling + "**") + (word.empty() ? "" : fmt::format(", `{}`", word)));
  }
  return column;
}

/// Where the table stands in a text: begin and end.
std::pair<std::size_t, std::size_t> place_of_table(const std::string& text, const std::string& first_head) {
  const std::size_t begin = text.find(fmt::format("| {} | {}", kCorner, first_head));
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
Table with_column(const Table& table, std::size_t number, std::size_t columns, const Column& column) {
  Table changed;
  for (const auto& [algorithm, cell] : column) {
    std::vector<std::string>& row = changed.emplace_back();
    row.push_back(algorithm);
    for (const std::vector<std::string>& old : table)
      if (old.front() == algorithm) row = old;
    row.resize(columns + 1);
    row[number] = cell;
  }
  return changed;
}

/// Holds a column against the tables of documents, or puts it there.
void expect_shown(const Column& column, std::size_t number, const std::vector<TabledScene>& scenes,
                  const std::vector<std::string>& documents) {
  for (const std::string& name : documents) {
    const std::string file = HECKBERT_SOURCE_DIR + name;
    const std::string text = read_bytes(file);
    const auto [begin, end] = place_of_table(text, scenes.front().name);
    const std::string shown = text.substr(begin, end - begin);
    const std::string expected = print(with_column(parse(shown), number + 1, scenes.size(), column));
    if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr)
      std::ofstream(file) << text.substr(0, begin) << expected << text.substr(end);
    else
      EXPECT_EQ(shown, expected) << "write it anew: HECKBERT_UPDATE_DOCS=1 cli_test --gtest_filter='*VerdictTable*'";
  }
}

std::string name_of_test(const std::string& name) {
  std::string letters;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) letters += c;
  return letters;
}

class VerdictTable : public ::testing::TestWithParam<std::size_t> {};

TEST_P(VerdictTable, OfABuiltInSceneIsWhatTheDocumentsShow) {
  const auto& [name, patches] = kBuiltIn[GetParam()];
  const std::string light = name == "caustic-point" ? "Lp" : "La";
  const Column column = column_of(fmt::format("{}, {}", name, light), name, patches, "48x48");
  expect_shown(column, GetParam(), kBuiltIn, {"/docs/verify.md", "/README.md"});
}

INSTANTIATE_TEST_SUITE_P(BuiltInScenes, VerdictTable, ::testing::Range(std::size_t{0}, kBuiltIn.size()),
                         [](const auto& scene) { return name_of_test(kBuiltIn[scene.param].name); });

class VerdictTableOfLights : public ::testing::TestWithParam<std::size_t> {};

TEST_P(VerdictTableOfLights, IsWhatTheDocumentShows) {
  const TemporaryFolder folder;
  const auto& [name, patches] = kRooms[GetParam()];
  const Column column = column_of(name, folder.write("room.json", room(name)), patches, "32x32");
  expect_shown(column, GetParam(), kRooms, {"/docs/verify.md"});
}

INSTANTIATE_TEST_SUITE_P(Rooms, VerdictTableOfLights, ::testing::Range(std::size_t{0}, kRooms.size()),
                         [](const auto& scene) { return name_of_test(kRooms[scene.param].name); });

}  // namespace
}  // namespace heckbert::cli::testing
