// Every way to get a Mitsuba scene wrong has its message, and the message points at the culprit. Damaged files give
// errors, all of them, and never a crash.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/import.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kGood = R"(<?xml version="1.0"?>
<scene version="0.5.0">
  <default name="spp" value="16"/>
  <integrator type="path"><integer name="maxDepth" value="9"/></integrator>
  <sensor type="perspective">
    <float name="fov" value="20"/>
    <transform name="toWorld"><lookAt origin="0, 0, 9" target="0, 0, 0" up="0, 1, 0"/></transform>
    <sampler type="independent"><integer name="sampleCount" value="$spp"/></sampler>
    <film type="ldrfilm"><integer name="width" value="64"/><integer name="height" value="64"/></film>
  </sensor>
  <bsdf type="diffuse" id="wall"><rgb name="reflectance" value="0.5, 0.5, 0.5"/></bsdf>
  <bsdf type="dielectric" id="glass"><string name="intIOR" value="water"/></bsdf>
  <shape type="sphere">
    <float name="radius" value="2"/>
    <transform name="toWorld"><matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform>
    <ref id="wall"/>
    <emitter type="area"><spectrum name="radiance" value="400:1, 700:2"/></emitter>
  </shape>
</scene>
)";

/// One change to kGood and the error that it causes; `^` marks where the caret stands.
struct Malformed {
  std::string_view what, instead;
  std::string_view message, suggestion;
};

const Malformed kMalformed[] = {
    {"<integrator type=\"path\">", "^<integrator type=\"path>", "this is no XML", ""},
    {"</scene>", "</^shape>", "this is no XML", ""},
    {"\"$spp\"", "\"^$sp\"", "the parameter $sp has no value", "did you mean $spp?"},
    {"\"$spp\"", "\"^$quality\"", "the parameter $quality has no value", "<default name=\"quality\""},
    {"<default name=\"spp\" ", "<^default ", "<default> needs the attribute \"name\"", ""},
    {"<default", "<include filename=\"^nowhere.xml\"/><default", "cannot read", ""},
    {"<default", "<include filename=\"^room.xml\"/><default", "includes itself", ""},
    {"value=\"20\"", "value=\"^twenty\"", "expected a number above 0, at most 179, found \"twenty\"", ""},
    {"value=\"20\"", "value=\"^1e999\"", "expected a number", ""},
    {"value=\"20\"", "value=\"^-5\"", "expected a number above 0", ""},
    {"<float name=\"fov\" value=\"20\"/>", "<^string name=\"fov\" value=\"20\"/>",
     "sensor \"perspective\": expected float for \"fov\", found string", ""},
    {"<float name=\"fov\" value=\"20\"/>", "<^float name=\"fov\"/>", "<float> needs the attribute \"value\"", ""},
    {"value=\"64\"/></film>", "value=\"^6.5\"/></film>", "expected a whole number", ""},
    {"target=\"0, 0, 0\"", "target=\"^0, 0\"", "expected three numbers", ""},
    {"target=\"0, 0, 0\"", "target=\"^0, 0, x\"", "expected three numbers", ""},
    {"<lookAt origin=\"0, 0, 9\" target=\"0, 0, 0\"", "<^lookAt origin=\"0, 0, 9\"", "needs the attribute \"target\"",
     ""},
    {"<lookAt origin=\"0, 0, 9\"", "<^lookAt origin=\"0, 0, 0\"", "the target is where the origin is", ""},
    {"0.5, 0.5, 0.5", "^0.5, 0.5", "expected one number, three numbers or #rrggbb", ""},
    {"0.5, 0.5, 0.5", "^-0.5, 0.5, 0.5", "expected numbers from 0 to 1e+09, found -0.5 0.5 0.5", ""},
    {"value=\"water\"", "value=\"^watre\"", "there is no substance \"watre\"", "did you mean \"water\"?"},
    {"<ref id=\"wall\"/>", "<ref id=\"^wal\"/>", "nothing has the id \"wal\"", "did you mean \"wall\"?"},
    {"<ref id=\"wall\"/>", "<^ref/>", "a reference needs the attribute \"id\"", ""},
    {"id=\"glass\"", "id=\"^wall\"", "two objects have the id \"wall\"", ""},
    {"<float name=\"radius\" value=\"2\"/>", "<float name=\"radius\" value=\"^0\"/>", "expected a number above 0", ""},
    {"0 0 0 1\"/>", "0 0 1 1\"/>", "expected 0 0 0 1 in the last row", ""},
    {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "^1 0 0 0", "expected a matrix of 16 or 9 numbers", ""},
    {"<shape type=\"sphere\">", "<^shape>", "<shape> needs the attribute \"type\"", ""},
    {"400:1, 700:2", "^700:1, 400:2", "pairs wavelength:value in rising order", ""},
    {"maxDepth\" value=\"9\"", "maxDepth\" value=\"0\"", "expected a max_depth of -1 for unlimited, or at least 1", ""},
    {"type=\"diffuse\" id=\"wall\">", "type=\"twosided\" id=\"wall\">",
     "bsdf \"twosided\" needs one nested bsdf, found 0", ""},
    {"<shape type=\"sphere\">", "<^shape type=\"obj\">", "shape \"obj\" needs \"filename\"", ""},
    {"<shape type=\"sphere\">",
     "<shape type=\"obj\"><string name=\"filename\" value=\"^gone.obj\"/></shape><shape type=\"sphere\">",
     "expected a file that can be read", ""},
};

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << "the table names a text that is not in the good scene: " << what;
  return text.replace(at, what.size(), with);
}

std::vector<Diagnostic> errors_of(const TemporaryFolder& folder, std::string_view text) {
  try {
    load_scene(folder.write("room.xml", text));
  } catch (const InputError& error) {
    return error.diagnostics();
  }
  return {};
}

TEST(MalformedMitsuba, TheSceneThatTheTableSpoilsIsGood) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(load_scene(folder.write("room.xml", kGood)));
}

TEST(MalformedMitsuba, EachHasItsMessageUnderTheCulprit) {
  const TemporaryFolder folder;
  for (const Malformed& row : kMalformed) {
    std::string text = replaced(std::string(kGood), row.what, row.instead);
    const std::size_t culprit = text.find('^');
    if (culprit != std::string::npos) {
      text.erase(culprit, 1);
    }
    SCOPED_TRACE(row.instead);
    const std::vector<Diagnostic> errors = errors_of(folder, text);
    ASSERT_GE(errors.size(), 1u);
    EXPECT_THAT(errors[0].message, HasSubstr(row.message));
    EXPECT_THAT(errors[0].suggestion, HasSubstr(row.suggestion));
    if (culprit != std::string::npos && row.message != "this is no XML") {
      const auto line_begin = text.rfind('\n', culprit - 1) + 1;
      EXPECT_EQ(errors[0].line,
                1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + long(culprit), '\n')));
      EXPECT_EQ(errors[0].column, culprit - line_begin + 1);
    }
  }
}

TEST(MalformedMitsuba, AllErrorsAreReported) {
  const TemporaryFolder folder;
  std::string text = replaced(std::string(kGood), "value=\"20\"", "value=\"x\"");
  text = replaced(text, "0.5, 0.5, 0.5", "red");
  text = replaced(text, "<ref id=\"wall\"/>", "<ref id=\"wall\"/><ref id=\"missing\"/>");
  const std::vector<Diagnostic> errors = errors_of(folder, text);
  ASSERT_EQ(errors.size(), 3u) << InputError(errors).what();
  EXPECT_EQ(errors[0].line, 6u);
  EXPECT_EQ(errors[1].line, 11u);
  EXPECT_EQ(errors[2].line, 16u);
}

TEST(MalformedMitsuba, ErrorsOfMeshesFollowTheSceneThatNamesThem) {
  const TemporaryFolder folder;
  folder.write("bad.ply", "ply\nformat ascii 1.0\nend_header\n");
  folder.write("bad.obj", "v 0 0\nf 1 2 3\n");
  for (const char* kind : {"ply", "obj"}) {
    const std::vector<Diagnostic> errors =
        errors_of(folder, std::string("<scene version=\"3.0.0\">\n<shape type=\"") + kind +
                              "\"><string name=\"filename\" value=\"bad." + kind + "\"/></shape></scene>");
    ASSERT_GE(errors.size(), 2u) << kind;
    EXPECT_EQ(errors[0].line, 2u);
    EXPECT_THAT(errors[0].message, HasSubstr("has errors of its own"));
    EXPECT_THAT(errors[1].source, HasSubstr(std::string("bad.") + kind));
  }
}

// Nothing that a broken disk or an editor can do to a file brings the reader down.
TEST(MalformedMitsuba, TruncatedAndDamagedFilesNeverCrash) {
  const TemporaryFolder folder;
  for (std::size_t size = 0; size + 12 < kGood.size(); size += 3) {
    EXPECT_FALSE(errors_of(folder, kGood.substr(0, size)).empty()) << size;
  }
  for (std::size_t at = 0; at < kGood.size(); at += 2) {
    for (const char byte : {'<', '"', '$', 'Z', '\0'}) {
      std::string damaged(kGood);
      damaged[at] = byte;
      errors_of(folder, damaged);
    }
  }
}

TEST(MalformedMitsuba, NestingHasAnEnd) {
  const TemporaryFolder folder;
  std::string deep = "<scene version=\"3.0.0\">";
  for (int i = 0; i < 50'000; ++i) deep += "<bsdf type=\"twosided\">";
  for (int i = 0; i < 50'000; ++i) deep += "</bsdf>";
  const std::vector<Diagnostic> errors = errors_of(folder, deep + "</scene>");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_THAT(errors[0].message, HasSubstr("nested more than 100 deep"));
}

TEST(MalformedMitsuba, ReferencesInACircleAreErrors) {
  const TemporaryFolder folder;
  const std::vector<Diagnostic> errors =
      errors_of(folder,
                "<scene version=\"3.0.0\">\n<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>\n"
                "<shape type=\"sphere\"><ref id=\"a\"/></shape></scene>");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_THAT(errors[0].message, HasSubstr("needs one nested bsdf, found 0"));
  EXPECT_THAT(errors[1].message, HasSubstr("refers to itself"));
}

}  // namespace
}  // namespace heckbert::import
