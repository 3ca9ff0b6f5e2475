#pragma once
// Photon mapping as Tungsten does it (Bitterli; integrator `progressive_photon_map`), for scenes of matt surfaces,
// mirrors and glass under one rectangular lamp: an independent twin of the path tracer where that is noisy, and the way
// in which the reference picture of water-caustic was made.
//
// A photon is left wherever light meets a matt surface. A ray from the eye goes on at mirrors and glass; where it meets
// a matt surface, the radiance is albedo / pi times the power of the k nearest photons over the disk that reaches to
// the k-th. That estimate is too bright: k - 1 photons lie inside the disk of the k-th by chance, one does by
// construction, so that of a mean density it makes k / (k - 1) times as much (Loftsgaarden and Quesenberry 1965, "A
// Nonparametric Estimate of a Multivariate Density Function", has the k - 1).

#include <cstdint>

#include <heckbert/record/record.h>
#include <heckbert/transport/scene.h>

namespace heckbert::bitterli {

struct PhotonMap {
  int photons = 0;  ///< that leave the lamp
  int neighbours = 20;
  int longest = 0;  ///< most scatterings of a path
  std::uint64_t seed = 1;
};

/// The picture of every word that ends in D S* E. What is seen of the lamp itself, directly or in mirrors, is not in
/// it.
record::Image photon_mapped(const transport::Scene& scene, const PhotonMap& settings, int width, int height,
                            int samples_per_pixel);

/// How much too bright the estimate is on average.
constexpr double nearest_neighbours_bias(int neighbours) {
  return static_cast<double>(neighbours) / (neighbours - 1);
}

}  // namespace heckbert::bitterli
