// Bad input: every kind of text that a person can get wrong, with what the tool says about it and the exit code. In
// each case nothing crashes, nothing goes to standard output, and no file is left behind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run.h"

namespace heckbert::cli::testing {
namespace {

using ::testing::HasSubstr;

struct Malformed {
  std::string claim;
  std::vector<std::string> arguments;
  int exit_code;
  std::vector<std::string> messages;           ///< each is part of standard error
  std::map<std::string, std::string> files{};  ///< name -> text, in the working directory
  std::map<std::string, std::string> variables{};
  std::string input{};
};

constexpr const char* kScene =
    R"({"camera": {"position": [0, 0, 5], "look_at": [0, 0, 0], "fov": 40},
 "materials": [{"name": "lamp", "type": "lambert", "albedo": 0.5, "emission": 1}],
 "shapes": [{"type": "sphere", "name": "ball", "material": "lamp", "center": [0, 0, 0], "radius": 1}]})";

/// kScene with one piece of text exchanged.
std::string scene_with(const std::string& piece, const std::string& replacement) {
  std::string text = kScene;
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::invalid_argument("the scene has no " + piece);
  return text.replace(at, piece.size(), replacement);
}

std::vector<Malformed> usage() {
  return {
      {"no command", {}, 2, {"which command? One of render, coverage"}},
      {"no grammar command", {"grammar"}, 2, {"which command? One of list, show", "see 'heckbert grammar --help'"}},
      {"unknown command", {"rendr"}, 2, {"there is no command 'rendr'; did you mean 'render'?"}},
      {"unknown inner command", {"grammar", "sho"}, 2, {"there is no command 'sho'; did you mean 'show'?"}},
      {"unknown flag",
       {"render", "cornell", "-o", "x.exr", "--sppp", "4"},
       2,
       {"there is no flag '--sppp'; did you mean '--spp'?", "see 'heckbert render --help'"}},
      {"flag without value", {"render", "cornell", "-o"}, 2, {"--output needs a value"}},
      {"no scene", {"render", "-o", "x.exr"}, 2, {"SCENE is required"}},
      {"one argument too many", {"coverage", "a.exr", "b.exr"}, 2, {"'b.exr' is one argument too many"}},
      {"nothing to write", {"render", "cornell"}, 2, {"-o FILE.exr, --record FILE.paths.exr, or both"}},
      {"one name for two outputs",
       {"render", "cornell", "-o", "x.exr", "--record", "x.exr"},
       2,
       {"two outputs would go to 'x.exr'"}},
      {"json and picture to standard output",
       {"render", "cornell", "-o", "-", "--json"},
       2,
       {"both want standard output"}},
      {"no samples",
       {"render", "cornell", "-o", "x.exr", "--spp", "0"},
       2,
       {"--spp: '0' is not a whole number from 1 to 1000000"}},
      {"negative number",
       {"render", "cornell", "-o", "x.exr", "--threads", "-2"},
       2,
       {"--threads: '-2' is not a whole number from 0"}},
      {"number too large",
       {"render", "cornell", "-o", "x.exr", "--seed", "18446744073709551616"},
       2,
       {"--seed: '18446744073709551616' is not a whole number"}},
      {"no size", {"render", "cornell", "-o", "x.exr", "--size", "10by10"}, 2, {"expected WIDTHxHEIGHT"}},
      {"empty crop", {"render", "cornell", "-o", "x.exr", "--crop", "4,4,2,8"}, 2, {"'4,4,2,8' is an empty window"}},
      {"crop outside",
       {"render", "cornell", "-o", "x.exr", "--size", "8x8", "--crop", "0,0,9,8"},
       2,
       {"reaches beyond the picture of 8x8"}},
      {"samples and time",
       {"render", "cornell", "-o", "x.exr", "--spp", "4", "--time", "3"},
       2,
       {"--time: cannot be given together with --spp"}},
      {"no time",
       {"render", "cornell", "-o", "x.exr", "--time", "nan"},
       2,
       {"--time: 'nan' is not a number between 0"}},
      {"unknown algorithm",
       {"render", "cornell", "-o", "x.exr", "--algorithm", "pathh"},
       2,
       {"--algorithm: 'pathh' is none of path, path-hits, ", ", radiosity-mirrors; did you mean 'path'?"}},
      {"unknown rule for G", {"match", "LDE", "LDE", "--glossy", "difuse"}, 2, {"did you mean 'diffuse'?"}},
      {"unknown grouping", {"classify", "a.exr", "--by", "lenght"}, 2, {"--by: 'lenght'", "did you mean 'length'?"}},
      {"variable",
       {"render", "cornell", "-o", "x.exr"},
       2,
       {"environment variable HECKBERT_SPP: 'many' is not a whole number"},
       {},
       {{"HECKBERT_SPP", "many"}}},
      {"rival variables",
       {"grammar", "list"},
       2,
       {"HECKBERT_VERBOSE: cannot be given together with environment variable HECKBERT_QUIET"},
       {},
       {{"HECKBERT_QUIET", "1"}, {"HECKBERT_VERBOSE", "1"}}},
  };
}

std::vector<Malformed> config_files() {
  return {
      {"unknown key in the config",
       {"grammar", "list", "--config", "a.toml"},
       3,
       {"a.toml:2:1: error: there is no setting 'sppp'", "^^^^", "did you mean 'spp'?"},
       {{"a.toml", "seed = 1\nsppp = 4\n"}}},
      {"bad value in the config",
       {"grammar", "list", "--config", "a.toml"},
       3,
       {"a.toml:1:8: error: '4x' is not a whole number"},
       {{"a.toml", "spp = \"4x\"\n"}}},
      {"all errors of a config",
       {"grammar", "list", "--config", "a.toml"},
       3,
       {"a.toml:1:1: error: this is no setting", "a.toml:2:1: error: there is no setting 'x'",
        "a.toml:4:1: error: 'spp' is set twice"},
       {{"a.toml", "[render]\nx = 1\nspp = 4\nspp = 5\n"}}},
      {"rivals in a config",
       {"grammar", "list", "--config", "a.toml"},
       3,
       {"cannot be given together with spp"},
       {{"a.toml", "spp = 4\ntime = 3\n"}}},
      {"no config", {"grammar", "list", "--config", "a.toml"}, 3, {"a.toml: No such file or directory"}},
  };
}

std::vector<Malformed> scenes() {
  const auto check = [](const std::string& claim, const std::string& text, std::vector<std::string> messages) {
    return Malformed{claim, {"render", "s.json", "-o", "x.exr"}, 3, std::move(messages), {{"s.json", text}}};
  };
  return {
      {"unknown scene", {"render", "cornel", "-o", "x.exr"}, 3, {"no scene \"cornel\"", "did you mean \"cornell\"?"}},
      {"missing scene", {"render", "s.json", "-o", "x.exr"}, 3, {"s.json", "No such file or directory"}},
      {"unknown kind of scene",
       {"render", "s.xyz", "-o", "x.exr"},
       3,
       {"expected .json, .obj or .xml"},
       {{"s.xyz", "x"}}},
      check("empty scene", "", {"s.json:1:1: error: this is not JSON"}),
      check("torn scene", R"({"camera": )", {"s.json:1:", "this is not JSON: unexpected end of input"}),
      check("no scene but a list", "[]", {"s.json:1:1: error: "}),
      check("unknown key", scene_with("albedo", "albdo"),
            {"s.json:2:", "has no key \"albdo\"", "did you mean \"albedo\"?"}),
      check("wrong type", scene_with("[0, 0, 5]", "\"here\""),
            {"s.json:1:25: error: expected [x, y, z]", "/camera/position"}),
      check("unknown material", scene_with("\"material\": \"lamp\"", "\"material\": \"lmap\""),
            {"s.json:3:", "lmap", "lamp"}),
      check("unknown shape", scene_with("\"sphere\"", "\"spere\""), {"s.json:3:", "spere", "sphere"}),
      check("radius below zero", scene_with("\"radius\": 1", "\"radius\": -1"), {"s.json:3:", "/shapes/0/radius"}),
      check("albedo above one", scene_with("0.5", "1.5"), {"s.json:2:", "/materials/0/albedo"}),
      check("deep nesting", std::string(100'000, '['), {"s.json:1:"}),
      {"face without position",
       {"scene", "check", "s.obj"},
       3,
       {"s.obj:4:7: error: there is no position 9"},
       {{"s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"}}},
      {"no number",
       {"scene", "check", "s.obj"},
       3,
       {"s.obj:1:7: error: expected a number"},
       {{"s.obj", "v 0 0 zero\n"}}},
      {"two scenes, both checked",
       {"scene", "check", "a.json", "b.json"},
       3,
       {"a.json:1:1: error", "b.json:1:1: error"},
       {{"a.json", ""}, {"b.json", ""}}},
  };
}

std::vector<Malformed> expressions() {
  const auto match = [](const std::string& expression, std::vector<std::string> messages, int code = 3) {
    return Malformed{"expression " + expression, {"match", expression, "LDE"}, code, std::move(messages)};
  };
  return {
      match("LD(E", {"EXPR:1:3: error: '(' is never closed", "\n  LD(E\n    ^\n"}),
      match("LDL", {"EXPR:1:3: error: both ends are light ends"}),
      match("LQE", {"EXPR:1:2: error: unknown letter 'Q'"}),
      match("", {"EXPR:1:1: error: an empty expression"}),
      match("LD{3,1}E", {"EXPR:1:3: error: the least number of this count exceeds the greatest"}),
      match("*LDE", {"EXPR:1:1: error: "}),
      match("LQE | LZE", {"EXPR:1:2: error: unknown letter 'Q'", "EXPR:1:8: error: unknown letter 'Z'"}),
      match("@whited", {"EXPR:1:2: error: no class or algorithm is called 'whited'", "did you mean 'whitted'?"}),
      match("@metropolis", {"EXPR:1:1: error: 'metropolis' is a transformer and has no language", "its host is",
                            "'heckbert grammar show metropolis' says what it is"}),
      match("ambient-occlusion", {"EXPR:1:1: error: 'ambient-occlusion' is a proxy and has no language"}),
      match("LDE | @metropolis", {"EXPR:1:7: error: 'metropolis' is a transformer and has no language"}),
      match("whited", {"EXPR:1:1: error: no class or algorithm is called 'whited'", "did you mean 'whitted'?"}),
      match("LD\xff"
            "E",
            {"EXPR:1:3: error: "}),
      match(std::string(100'000, '('), {"EXPR:1:"}),
      match("L(D|S)*D(D|S){20}E", {"is too large: the automaton needs more than 20000 states", "'(D|S)*D(D|S){20}'"},
            4),
      {"classes of a render, before it traces",
       {"render", "cornell", "-o", "x.exr", "--spp", "1000000", "--lpe", "a=LD(E", "--lpe", "LDL"},
       3,
       {"--lpe:1:3: error: '(' is never closed", "--lpe:1:3: error: both ends"}},
      {"one name for two layers",
       {"render", "cornell", "-o", "x.exr", "--lpe", "a=LDE", "--lpe", "a=LSE"},
       3,
       {"two layers of the name 'a'"}},
      {"grammar equal", {"grammar", "equal", "LDE", "LD(E"}, 3, {"argument:1:3: error: '(' is never closed"}},
      {"words from standard input", {"match", "LDE"}, 3, {"error: 'X' stands for several words"}, {}, {}, "LXE\n"},
      {"all wrong words", {"match", "LDE", "LDQE", "DE"}, 3, {"  LDQE\n", "  DE\n"}},
  };
}

std::vector<Malformed> grammar_files() {
  const auto show = [](const std::string& claim, const std::string& text, std::vector<std::string> messages) {
    return Malformed{claim, {"grammar", "show", "g.grammar"}, 3, std::move(messages), {{"g.grammar", text}}};
  };
  const std::string head = "kind: class\nname: mine\ntitle: Mine\norder: 1\nsource: me\n";
  return {
      show("empty grammar", "", {"g.grammar: error: the key 'kind' is missing", "the key 'expression' is missing"}),
      show("unknown key of a grammar", head + "expresion: LDE\n",
           {"g.grammar:6:1: error: unknown key 'expresion'", "did you mean 'expression'?"}),
      show("no key at all", head + "LDE\n", {"g.grammar:6:1: error: expected 'key: value'"}),
      show("expression of a grammar", head + "expression: L(D|E\n", {"g.grammar:6:14: error: '(' is never closed"}),
      show("unknown name in a grammar", head + "expression: @mien\n", {"g.grammar:6:", "mien"}),
      show("unknown kind", "kind: clas\n" + head.substr(12) + "expression: LDE\n", {"g.grammar:1:7: error: "}),
      show("key of another kind", head + "expression: LDE\ncore: yes\n",
           {"g.grammar:7:1: error: the key 'core' does not belong to kind class"}),
      show("key twice", head + "name: again\nexpression: LDE\n", {"g.grammar:6:1: error: "}),
      {"missing grammar", {"coverage", "a.exr", "--grammar", "g.grammar"}, 3, {"g.grammar: No such file or directory"}},
  };
}

std::vector<Malformed> records() {
  const auto classify = [](const std::string& claim, const std::string& bytes, std::vector<std::string> messages) {
    return Malformed{claim, {"classify", "r.exr"}, 3, std::move(messages), {{"r.exr", bytes}}};
  };
  return {
      classify("empty record", "", {"cannot read 'r.exr': this is not an OpenEXR file"}),
      classify("text as record", "hello\n", {"cannot read 'r.exr': this is not an OpenEXR file"}),
      classify("only the magic number of a record", std::string("\x76\x2f\x31\x01\x02\x00\x00\x00", 8),
               {"cannot read 'r.exr'"}),
      {"missing record", {"query", "r.exr", "LDE"}, 3, {"cannot read 'r.exr': No such file or directory"}},
      {"folder as record", {"coverage", "."}, 3, {"cannot read '.'"}},
      {"empty standard input", {"report", "-", "-o", "x.html"}, 3, {"this is not an OpenEXR file"}},
  };
}

std::vector<Malformed> outputs() {
  return {
      {"no such folder", {"render", "cornell", "-o", "no/x.exr", "--spp", "1000000"}, 5, {"there is no folder no"}},
      {"folder as output", {"render", "cornell", "-o", ".", "--spp", "1000000"}, 5, {"is a folder"}},
      {"no such folder of the record",
       {"render", "cornell", "--record", "no/x.exr", "--spp", "1000000"},
       5,
       {"no/x.exr: there is no folder no"}},
      {"file as folder", {"render", "cornell", "-o", "f/x.exr"}, 5, {"f is not a folder"}, {{"f", ""}}},
      {"device as output", {"render", "cornell", "-o", "/dev/null"}, 5, {"/dev/null"}},
      {"no such folder of the page", {"report", "r.exr", "-o", "no/x.html"}, 5, {"there is no folder no"}},
  };
}

struct Table {
  std::string name;
  std::vector<Malformed> (*rows)();
};
void PrintTo(const Table& table, std::ostream* out) {
  *out << table.name;
}

class MalformedInput : public ::testing::TestWithParam<Table> {};

TEST_P(MalformedInput, IsExplainedAndLeavesNothingBehind) {
  const std::vector<Malformed> table = GetParam().rows();
  ASSERT_FALSE(table.empty());
  for (const Malformed& malformed : table) {
    SCOPED_TRACE(malformed.claim);
    const TemporaryFolder folder;
    for (const auto& [name, text] : malformed.files) folder.write(name, text);
    const std::vector<std::string> before = folder.listing();
    const Outcome outcome = run(
        malformed.arguments, {.input = malformed.input, .environment = malformed.variables, .folder = folder.path()});
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.exit_code, malformed.exit_code);
    for (const std::string& message : malformed.messages) EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_THAT(outcome.err, HasSubstr("error: "));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.listing(), before);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, MalformedInput,
                         ::testing::Values(Table{"Usage", usage}, Table{"ConfigFiles", config_files},
                                           Table{"Scenes", scenes}, Table{"Expressions", expressions},
                                           Table{"GrammarFiles", grammar_files}, Table{"Records", records},
                                           Table{"Outputs", outputs}),
                         [](const auto& tested) { return tested.param.name; });

/// Cuts and changes a good record at many places: each must be refused, or be read as a record, but never crash.
TEST(MalformedRecord, TornAnywhereIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "good.exr").string();
  ASSERT_EQ(run({"render", "lecture", "--size", "16x16", "--spp", "2", "--record", path}).exit_code, 0);
  const std::string bytes = read_bytes(path);
  ASSERT_GT(bytes.size(), 1000u);
  for (int i = 0; i < 24; ++i) {
    const std::size_t length = bytes.size() * static_cast<std::size_t>(i) / 24;
    const Outcome outcome = run({"classify", folder.write("torn.exr", bytes.substr(0, length))});
    EXPECT_EQ(outcome.exit_code, 3) << length << " of " << bytes.size() << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(MalformedRecord, WithOtherBytesDoesNotCrash) {
  const TemporaryFolder folder;
  const std::string path = (folder / "good.exr").string();
  ASSERT_EQ(run({"render", "lecture", "--size", "16x16", "--spp", "2", "--record", path}).exit_code, 0);
  const std::string bytes = read_bytes(path);
  for (std::size_t i = 0; i < 60; ++i) {
    std::string changed = bytes;
    const std::size_t at = 8 + i * (bytes.size() - 16) / 60;
    for (std::size_t k = 0; k < 4; ++k) changed[at + k] = static_cast<char>(~changed[at + k]);
    const Outcome outcome = run({"classify", folder.write("changed.exr", changed)});
    EXPECT_TRUE(outcome.exit_code == 3 || outcome.exit_code == 0) << at << ": " << outcome.exit_code << outcome.err;
    EXPECT_EQ(outcome.signal, 0) << at;
  }
}

TEST(MalformedRecord, IsNotAFlatPicture) {
  const TemporaryFolder folder;
  const std::string path = (folder / "flat.exr").string();
  ASSERT_EQ(run({"render", "lecture", "--size", "16x16", "--spp", "2", "-o", path}).exit_code, 0);
  const Outcome outcome = run({"classify", path});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("this is a flat EXR; expected a record"));
}

}  // namespace
}  // namespace heckbert::cli::testing
