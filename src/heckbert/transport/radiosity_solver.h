#pragma once
// The exchange of light between diffuse surfaces, bounce by bounce. What sides send out at first, E, arrives as
//   H_1 = F E,  H_(n+1) = F rho H_n   (irradiance H, exitance E, W m^-2; F form factors, rho albedos)
// so that every power of the transport operator stands by itself (Goral, Torrance, Greenberg, Battaile 1984, eq. 5,
// expanded into its Neumann series).

#include <vector>

#include <heckbert/record/rgb.h>
#include <heckbert/transport/form_factors.h>

namespace heckbert::transport {

/// Shares of what was sent out at first: less than so much is not followed any further by either solver.
inline constexpr double kLeastGathered = 1e-5, kLeastShot = 1e-3;

/// Irradiances by bounce and side: H_1, H_2, ...
using Bounces = std::vector<std::vector<Rgb>>;

/// Gathering: every side receives from all others at once. Ends after `most` bounces or with kLeastGathered.
/// Cost: the number of form factors, for every bounce.
Bounces solve_by_gathering(const PatchMesh& mesh, const FormFactors& factors, const std::vector<Rgb>& albedos,
                           const std::vector<Rgb>& exitances, int most);

/// Shooting, which is progressive refinement (Cohen, Chen, Wallace, Greenberg 1988, section 4): the side with most
/// unshot light sends it to all others, by form factors that are measured then and forgotten. What is unshot is kept by
/// bounces. Ends when kLeastShot is unshot; light of more than `most` bounces is not followed.
Bounces solve_by_shooting(const PatchScene& patches, const std::vector<Rgb>& albedos, const std::vector<Rgb>& exitances,
                          int most, FormFactorRays rays);

}  // namespace heckbert::transport
