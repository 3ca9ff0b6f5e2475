// The documents against the program: docs/cli.md is what the help pages say, docs/json.md names every key that is
// written and no other. HECKBERT_UPDATE_DOCS=1 in the environment of this test writes docs/cli.md anew.

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

std::string help_of(std::vector<std::string> command) {
  command.emplace_back("--help");
  return run(command).out;
}

std::string command_line_page() {
  std::string page =
      "# Command line\n\n"
      "The help pages of the tool, word by word; a test compares.\n\n"
      "Settings are looked up in this order: flag, environment, `--config` file, the scene file's\n"
      "`render` object, the tool's default. A config file has one `name = value` a line, the names being\n"
      "those of the long flags. Of `--spp` and `--time`, and of `--quiet` and `--verbose`, one given in a\n"
      "stronger layer hides the other in weaker ones.\n";
  std::vector<std::vector<std::string>> pages = kCommands;
  pages.insert(pages.begin(), std::vector<std::string>{});  // heckbert itself
  for (const auto& command : pages)
    page += fmt::format("\n## heckbert{}{}\n\n```text\n{}```\n", command.empty() ? "" : " ", fmt::join(command, " "),
                        help_of(command));
  return page;
}

TEST(CommandLinePage, IsWhatTheHelpPagesSay) {
  const char* file = HECKBERT_SOURCE_DIR "/docs/cli.md";
  if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) std::ofstream(file) << command_line_page();
  EXPECT_EQ(read_bytes(file), command_line_page()) << "write it anew: HECKBERT_UPDATE_DOCS=1 cli_test";
}

TEST(CommandLinePage, FitsATerminalOf100Columns) {
  std::istringstream page(command_line_page());
  for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 100u) << line;
}

// ---- docs/phases.md -------------------------------------------------------------------------------------------------

std::string phases_page() {
  std::string page =
      "# From text to automaton\n\n"
      "What becomes of an expression, made by running `heckbert grammar phases`; a test compares. First the tree of "
      "the\n"
      "text. Then its letters, numbered, with the letters that may follow each: an automaton that may go several ways\n"
      "at once (Glushkov 1961). Then one that never does, each of its states a set of such letters. Last the minimal\n"
      "one, the same for every expression of the same language, which is what the tool compares and counts with.\n";
  for (const std::string expression : {"L(D|S)*DE", "LE | LDE | LD(D|S*D)+E", "LX*E - E(S*D)?L"})
    page += fmt::format("\n## {0}\n\n```text\n$ heckbert grammar phases '{0}'\n{1}```\n", expression,
                        run({"grammar", "phases", expression}).out);
  return page;
}

TEST(PhasesPage, IsWhatTheToolSays) {
  const char* file = HECKBERT_SOURCE_DIR "/docs/phases.md";
  if (std::getenv("HECKBERT_UPDATE_DOCS") != nullptr) std::ofstream(file) << phases_page();
  EXPECT_EQ(read_bytes(file), phases_page()) << "write it anew: HECKBERT_UPDATE_DOCS=1 cli_test";
}

// ---- docs/json.md -------------------------------------------------------------------------------------------------

using Json = nlohmann::json;
using Keys = std::map<std::string, std::string>;  ///< path -> type

/// The tables of docs/json.md by heading.
std::map<std::string, Keys> tables() {
  static const std::regex heading(R"(^##+ (\S+)$)"), row(R"(^\| `([^`]+)` \| ([^|]+) \|.*$)");
  std::ifstream file(HECKBERT_SOURCE_DIR "/docs/json.md");
  std::map<std::string, Keys> sections;
  std::string section;
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_match(line, match, heading)) section = match[1];
    if (std::regex_match(line, match, row)) sections[section][match[1]] = match[2];
  }
  return sections;
}

/// A section's keys, links to other sections followed.
Keys documented(const std::map<std::string, Keys>& sections, const std::string& name) {
  static const std::regex link(R"(^\[\w+\]\(#(\w+)\)$)");
  Keys keys;
  for (const auto& [path, type] : sections.at(name)) {
    std::smatch match;
    if (!std::regex_match(type, match, link)) {
      keys[path] = type;
      continue;
    }
    for (const auto& [inner, inner_type] : documented(sections, match[1]))
      keys[fmt::format("{}.{}", path, inner)] = inner_type;
  }
  return keys;
}

void collect(const Json& value, const std::string& path, Keys& keys) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items())
      collect(inner, path.empty() ? key : fmt::format("{}.{}", path, key), keys);
  } else if (value.is_array()) {
    for (const Json& inner : value) collect(inner, path + "[]", keys);
  } else {
    keys[path] = value.is_number_integer() ? "integer" : value.is_number() ? "number" : value.type_name();
  }
}

TEST(JsonPage, NamesEveryKeyOfEveryDocument) {
  const TemporaryFolder folder;
  const std::string record = (folder / "a.paths.exr").string();
  const std::string part = (folder / "part.paths.exr").string();
  const std::string stream =
      folder.write("paths.txt", "heckbert-paths 1 text\nsize 1 1\nsamples 1\npaths\n0 0 LE 1 1 1 1\nend\n");
  // An OBJ without a camera and with a texture: its import guesses and ignores.
  folder.write("room.mtl", "newmtl lamp\nKd .5 .5 .5\nKe 1 1 1\nmap_Kd wood.png\n");
  const std::string room =
      folder.write("room.obj", "mtllib room.mtl\nusemtl lamp\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::vector<std::vector<std::string>> commands{
      {"render", room, "--record", record, "--size", "16x16", "--spp", "4", "--lpe", "LE", "--json"},
      {"coverage", record, "--json"},
      {"paths", record, "--pixel", "8,8", "--json"},
      {"query", record, "LE", "--json"},
      {"classify", record, "--json"},
      {"report", record, "-o", (folder / "a.html").string(), "--json"},
      {"render", "lecture", "--record", record, "--size", "16x16", "--spp", "4", "--json"},
      {"paths", record, "--pixel", "3,4", "--trace", "--json"},
      {"coverage", record, "--require", "whitted>=1", "--json"},
      {"coverage", record, "--grammar", "all", "--json"},
      {"query", record, "LDE", "--json"},
      {"classify", record, "--json"},
      {"report", record, "-o", (folder / "a.html").string(), "--json"},
      {"match", "LDE", "LSE", "--json"},
      {"grammar", "list", "--json"},
      {"grammar", "show", "whitted", "--json"},
      {"grammar", "equal", "LDE", "LSE", "--json"},
      {"grammar", "subset", "LDE", "LSE", "--json"},
      {"grammar", "translate", "unoccluded;CD|DL", "--from", "renderman", "--to", "karma", "--json"},
      {"grammar", "disjoint", "LDE", "L.E", "--json"},
      {"grammar", "partition", "LDE", "L.E", "--json"},
      {"grammar", "words", "LDE", "--json"},
      {"grammar", "count", "LDE", "--json"},
      {"grammar", "identify", "LNS*E", "--json"},
      {"grammar", "identify", "LD?S?E", "--json"},
      {"grammar", "explain", "LDE", "LSE", "--json"},
      {"grammar", "dot", "LDE", "--json"},
      {"grammar", "minimize", "LDE", "--json"},
      {"grammar", "strategies", "LDE", "--json"},
      {"grammar", "lattice", "LDE", "L.E", "--json"},
      {"grammar", "phases", "LDE", "--json"},
      {"grammar", "errors", "HB101", "--json"},
      {"scene", "list", "--json"},
      {"scene", "check", room, "--json"},
      {"render", room, "--record", part, "--part", "2/4", "--size", "16x16", "--spp", "4", "--json"},
      {"verify", "caustic-point", "--algorithm", "local-shading", "--algorithm", "photon-map", "--method",
       "photon-radius=0.08", "--size", "64x64", "--spp", "32", "--json"},
      {"why", "caustic", "--algorithm", "path", "--size", "16x16", "--spp", "32", "--cheapest", "--json"},
      {"merge", part, "-o", record, "--json"},
      {"record", "import", stream, "-o", record, "--json"}};
  std::map<std::string, Keys> written;
  for (const auto& command : commands) {
    const Outcome outcome = run(command);
    const Json document = Json::parse(outcome.out, nullptr, false);
    ASSERT_TRUE(document.is_object()) << command[0] << outcome.err;
    collect(document, "", written[document["schema"].get<std::string>()]);
  }
  ASSERT_EQ(written.size(), 29u);
  const std::map<std::string, Keys> sections = tables();
  for (const auto& [schema, keys] : written) {
    ASSERT_TRUE(sections.contains(schema)) << schema << " has no section in docs/json.md";
    Keys expected = documented(sections, schema);
    if (schema == "heckbert.record_import") expected.erase("render.ignored[]");  // a stream has nothing to ignore
    EXPECT_EQ(keys, expected) << schema;
  }
}

}  // namespace
}  // namespace heckbert::cli::testing
