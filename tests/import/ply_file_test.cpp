// PLY in its three encodings, and files that are broken.

#include <bit>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heckbert/import/ply_file.h>
#include <heckbert/taxonomy/error.h>

#include "test_files.h"

namespace heckbert::import {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n"
         "property uchar red\nproperty float s\nproperty float t\nelement face 2\nproperty uchar flags\n"
         "property list uchar int vertex_indices\nend_header\n";
}

const std::string kText = header("ascii") +
                          "0 0 0 255 0 0\n2 0 0 255 1 0\n2 3 0 255 1 1\n0 3 0.5 255 0 1\n"
                          "7 4 0 1 2 3\n7 3 0 1 2\n";

/// The same data as kText.
std::string binary(bool little) {
  std::string out = header(little ? "binary_little_endian" : "binary_big_endian");
  const auto put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (little != (std::endian::native == std::endian::little)) std::reverse(raw, raw + sizeof value);
    out.append(raw, sizeof value);
  };
  const float rows[4][5] = {{0, 0, 0, 0, 0}, {2, 0, 0, 1, 0}, {2, 3, 0, 1, 1}, {0, 3, 0.5f, 0, 1}};
  for (const auto& r : rows) {
    put(r[0]), put(double(r[1])), put(r[2]), put(std::uint8_t{255}), put(r[3]), put(r[4]);
  }
  put(std::uint8_t{7}), put(std::uint8_t{4}), put(0), put(1), put(2), put(3);
  put(std::uint8_t{7}), put(std::uint8_t{3}), put(0), put(1), put(2);
  return out;
}

std::string error_of(const std::string& bytes) {
  try {
    read_ply(bytes, "mesh.ply");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Ply, IsTheSameInEveryEncoding) {
  for (const std::string& bytes : {kText, binary(true), binary(false)}) {
    const transport::Mesh mesh = read_ply(bytes, "mesh.ply").mesh;
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[3], glm::vec3(0, 3, 0.5f));
    EXPECT_EQ(mesh.texcoords.at(2), glm::vec2(1, 1));
    ASSERT_EQ(mesh.triangles.size(), 3u) << "a quadrilateral and a triangle";
    EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_TRUE(mesh.normals.empty());
  }
}

TEST(Ply, NormalsAreMadeUnit) {
  const auto mesh =
      read_ply(
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
          "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
          "property list uchar int vertex_index\nend_header\n0 0 0 0 0 2\n1 0 0 0 0 2\n0 1 0 0 3 4\n3 0 1 2\n",
          "mesh.ply")
          .mesh;
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(mesh.normals[2].y, 0.6f);
}

std::string spoiled(const std::string& what, const std::string& with) {
  std::string text = kText;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(Ply, BrokenFilesSayWhatAndWhere) {
  const struct {
    std::string bytes;
    const char* message;
  } kRows[] = {
      {"", "no PLY file"},
      {"obj\n", "mesh.ply:1:1: error: this is no PLY file"},
      {"ply\nformat ascii 1.0\n", "ends before its end_header"},
      {spoiled("ascii", "utf8"), "mesh.ply:2:1: error: expected format ascii"},
      {spoiled("format ascii 1.0\n", ""), "the header says no format"},
      {spoiled("element vertex 4", "element vertex four"), "mesh.ply:4:1: error: expected element"},
      {spoiled("element vertex 4", "element vertex 400000000000"), "the file ends early: the header promises"},
      {spoiled("property double y", "property number y"), "mesh.ply:6:1: error: expected property"},
      {spoiled("property double y", "property double w"), "no x, y and z"},
      {spoiled("2 3 0 255", "2 3 zero 255"), "mesh.ply:17:5: error: expected a number"},
      {spoiled("2 3 0 255", "2 1e30 0 255"), "vertex 3 has a number that is not from"},
      {spoiled("7 3 0 1 2\n", ""), "the file ends early, in face 2 of 2"},
      {spoiled("7 3 0 1 2\n", "7 3 0 1 9\n"), "there is no vertex 9: the file has 4, counted from 0"},
      {spoiled("7 3 0 1 2\n", "7 3 0 1 -1\n"), "face 2 has the corner -1"},
      {spoiled("vertex_indices", "corners"), "no vertex_indices"},
      {spoiled("2 0 0 255 1 0\n2 3 0 255 1 1\n0 3 0.5", "0 0 0 255 1 0\n0 0 0 255 1 1\n0 0 0"), "no triangles"},
  };
  for (const auto& row : kRows) {
    EXPECT_THAT(error_of(row.bytes), HasSubstr(row.message)) << row.bytes.substr(0, 300);
  }
}

// Every prefix, and every byte replaced: an error or a mesh, never a crash and never memory beyond the file's size.
TEST(Ply, TruncatedAndDamagedFilesAreErrors) {
  for (const std::string& whole : {kText, binary(true), binary(false)}) {
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
      EXPECT_NE(error_of(whole.substr(0, size)), "no error") << size;
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
      for (const char byte : {'\0', '9', '\xff', '-', '\n'}) {
        std::string damaged = whole;
        damaged[at] = byte;
        error_of(damaged);
      }
    }
  }
}

TEST(Ply, WhatIsLeftOutIsTold) {
  EXPECT_THAT(read_ply(spoiled("7 3 0 1 2\n", "7 3 0 1 1\n"), "mesh.ply").notes, Contains("1 triangle without area"));
  EXPECT_THAT(read_ply(spoiled("7 3 0 1 2\n", "7 2 0 1\n"), "mesh.ply").notes,
              Contains("1 face of less than three corners"));
}

}  // namespace
}  // namespace heckbert::import
