#include <heckbert/report/verdict_picture.h>

#include <algorithm>
#include <cmath>

namespace heckbert::report {

NoisyImage sum_of(const std::vector<NoisyImage>& images) {
  NoisyImage sum = images.front();
  for (std::size_t i = 1; i < images.size(); ++i)
    for (std::size_t p = 0; p < sum.standard_error.size(); ++p) {
      sum.mean.pixels[p] += images[i].mean.pixels[p];
      sum.standard_error[p] = std::hypot(sum.standard_error[p], images[i].standard_error[p]);
    }
  return sum;
}

Picture difference_picture(const NoisyImage& predicted, const NoisyImage& found) {
  const record::Window& window = found.mean.window;
  Picture picture{window.width(), window.height(), {}};
  for (std::size_t p = 0; p < found.mean.pixels.size(); ++p) {
    const double expected = luminance(predicted.mean.pixels[p]);
    const double difference = luminance(found.mean.pixels[p]) - expected;
    const double error = std::hypot(predicted.standard_error[p], found.standard_error[p]);
    // Rounding, where neither has any spread, is no difference.
    const bool differs = std::abs(difference) > 1e-6 * std::abs(expected);
    const double strength = !differs ? 0 : error > 0 ? std::min(std::abs(difference) / error / kFullColour, 1.0) : 1;
    const auto level = static_cast<std::uint8_t>(std::lround(255 * strength));
    const auto pale = static_cast<std::uint8_t>(level / 3);
    if (difference > 0)
      picture.rgb.insert(picture.rgb.end(), {level, pale, 0});
    else
      picture.rgb.insert(picture.rgb.end(), {0, pale, level});
  }
  return picture;
}

}  // namespace heckbert::report
