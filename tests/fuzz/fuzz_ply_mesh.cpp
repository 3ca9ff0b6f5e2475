// Meshes in PLY. What can be read has finite corners, and triangles between corners that are there.

#include <cmath>

#include <heckbert/import/ply_file.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto ply = fuzz::answer([&] { return import::read_ply(fuzz::text_of(data, size), "fuzz.ply"); });
  if (!ply) return 0;
  const transport::Mesh& mesh = ply->mesh;
  for (const auto& p : mesh.positions)
    fuzz::require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "a corner that is not finite");
  for (const auto& t : mesh.triangles)
    fuzz::require(t.x < mesh.positions.size() && t.y < mesh.positions.size() && t.z < mesh.positions.size(),
                  "a triangle with a corner that is not there");
  fuzz::require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(), "normals for some corners");
  fuzz::require(mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size(),
                "texture coordinates for some corners");
  return 0;
}
