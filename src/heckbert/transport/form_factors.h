#pragma once
// Form factors: F_ij is the share of what leaves side i of the patches that arrives at side j, with everything that is
// in between. Side i shoots rays from all over it, cosine-distributed (Malley 1988), and counts where they land. What j
// sees of i says the same by reciprocity, A_i F_ij = A_j F_ji, so both counts are used, each in proportion to its
// certainty: a lamp is seen by few of a wall's rays, but the wall is met by many of the lamp's.
//
// With n rays from either, the counts c have the expectations n F_ij and n F_ij A_i / A_j; hence
//   F_ij ~ (c_ij + c_ji) / (n (1 + A_i / A_j)),
// the balance heuristic (Veach 1997, 9.2.2), unbiased and exactly reciprocal.

#include <cstdint>
#include <span>
#include <vector>

#include <heckbert/transport/patch_mesh.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

/// Of the light that leaves one side, the share that arrives at another, or the other way round, as the list says.
struct Transfer {
  std::uint32_t side = 0;
  float factor = 0;
};

/// How a form factor is measured.
struct FormFactorRays {
  int per_side = 256;  ///< above 0; best a power of two
  std::uint64_t seed = 1;
};

/// Patches with a tracer of their own, whose Hit::primitive is the patch.
struct PatchScene {
  explicit PatchScene(PatchMesh cut) : mesh(std::move(cut)), scene(scene_of(mesh)), tracer(scene) {}
  PatchScene(const PatchScene&) = delete;
  PatchScene& operator=(const PatchScene&) = delete;

  PatchMesh mesh;
  Scene scene;
  Tracer tracer;
};

/// A point of a side, moved off it, and a direction to leave in, the k-th of so many.
Ray ray_from_side(const PatchMesh& mesh, std::size_t side, std::uint32_t k, std::uint64_t seed);

/// F_ij of one side i by its own rays alone, by ascending j. What escapes is in none.
std::vector<Transfer> shoot(const PatchScene& patches, std::size_t side, FormFactorRays rays);

/// All form factors: row(i) lists F_ij by ascending j.
class FormFactors {
 public:
  /// Of the sides that are marked; light neither leaves the others nor matters on them. Cost: per_side rays for each,
  /// on all cores; memory: 16 bytes per ray in the end, some 40 on the way.
  FormFactors(const PatchScene& patches, const std::vector<bool>& is_marked, FormFactorRays rays);

  std::span<const Transfer> row(std::size_t side) const {
    return std::span(transfers_).subspan(offsets_[side], offsets_[side + 1] - offsets_[side]);
  }

 private:
  std::vector<std::size_t> offsets_;
  std::vector<Transfer> transfers_;
};

}  // namespace heckbert::transport
