#pragma once
// A prediction and what came of it, side by side with their difference.

#include <heckbert/report/evidence.h>
#include <heckbert/report/picture.h>

namespace heckbert::report {

/// The sum of pictures with independent errors. Takes: pictures of one window, at least one.
NoisyImage sum_of(const std::vector<NoisyImage>& images);

/// Standard errors at which the colours of difference_picture() are full.
inline constexpr double kFullColour = 5;

/// By how many standard errors of the difference each pixel of `found` is brighter (red) or darker (blue) than
/// predicted. Black: not at all.
Picture difference_picture(const NoisyImage& predicted, const NoisyImage& found);

}  // namespace heckbert::report
