#include <heckbert/transport/environment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <heckbert/transport/frame.h>

namespace heckbert::transport {

namespace {

constexpr double kTau = 2 * std::numbers::pi;

}  // namespace

Environment::Environment(const Scene& scene) : scene_(scene), mean_radiance_(max_channel(scene.environment)) {
  if (!scene.environment_image) return;
  const EnvironmentImage& image = *scene.environment_image;
  if (image.width < 1 || image.height < 1 ||
      image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
    throw std::invalid_argument(
        fmt::format("the environment image has {} pixels, not {}x{}", image.pixels.size(), image.width, image.height));

  for (int y = 0; y <= image.height; ++y) row_cosines_.push_back(std::cos(std::numbers::pi * y / image.height));
  // The mean of an interpolated image over a pixel is one eighth each from its neighbours and six from itself, per
  // axis.
  const bool smooth = image.interpolation == Interpolation::Bilinear;
  const std::array<float, 3> weights = smooth ? std::array{0.125f, 0.75f, 0.125f} : std::array{0.0f, 1.0f, 0.0f};
  std::vector<double> row_sums;
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    std::vector<double> row(static_cast<std::size_t>(image.width));
    double row_sum = 0;
    for (int x = 0; x < image.width; ++x) {
      Rgb mean = scene.environment;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          mean += pixel(x + i, y + j) *
                  (weights[static_cast<std::size_t>(i + 1)] * weights[static_cast<std::size_t>(j + 1)]);
      row_sum += row[static_cast<std::size_t>(x)] = max_channel(mean);
    }
    columns_.emplace_back(std::move(row));
    const auto r = static_cast<std::size_t>(y);
    row_sums.push_back(row_sum * (row_cosines_[r] - row_cosines_[r + 1]));
    sum += row_sums.back();
  }
  rows_ = DiscreteDistribution(std::move(row_sums));
  mean_radiance_ = sum / (2.0 * image.width);
}

/// Around the sphere in x; the top and bottom rows continue beyond the poles.
const Rgb& Environment::pixel(int x, int y) const {
  const EnvironmentImage& image = *scene_.environment_image;
  const int column = (x % image.width + image.width) % image.width;
  const int row = std::clamp(y, 0, image.height - 1);
  return image
      .pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column)];
}

/// In pixels, from the upper left corner of the image.
glm::dvec2 Environment::place_of(glm::vec3 direction) const {
  const EnvironmentImage& image = *scene_.environment_image;
  const glm::dvec3 d = glm::transpose(image.to_world) * direction;
  double turn = std::atan2(d.x, -d.z) / kTau;
  if (turn < 0) turn += 1;
  return {turn * image.width, std::atan2(std::hypot(d.x, d.z), d.y) / std::numbers::pi * image.height};
}

Rgb Environment::radiance_at(glm::dvec2 place) const {
  if (scene_.environment_image->interpolation == Interpolation::Nearest)
    return scene_.environment + pixel(static_cast<int>(place.x), static_cast<int>(place.y));
  const double x = place.x - 0.5, y = place.y - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  return scene_.environment + (pixel(x0, y0) * (1 - fx) + pixel(x0 + 1, y0) * fx) * (1 - fy) +
         (pixel(x0, y0 + 1) * (1 - fx) + pixel(x0 + 1, y0 + 1) * fx) * fy;
}

Rgb Environment::radiance(glm::vec3 direction) const {
  return scene_.environment_image ? radiance_at(place_of(direction)) : scene_.environment;
}

float Environment::pdf_in(std::size_t row, std::size_t column) const {
  const double solid_angle = kTau / scene_.environment_image->width * (row_cosines_[row] - row_cosines_[row + 1]);
  return static_cast<float>(rows_.probability(row) * columns_[row].probability(column) / solid_angle);
}

EnvironmentSample Environment::sample(glm::vec2 u) const {
  if (!scene_.environment_image) return {uniform_sphere(u), scene_.environment, 1.0f / (4.0f * kPi)};
  const EnvironmentImage& image = *scene_.environment_image;
  const auto [row, below] = rows_.sample(static_cast<double>(u.y));
  const auto [column, right] = columns_[row].sample(static_cast<double>(u.x));
  const double cosine = row_cosines_[row] + below * (row_cosines_[row + 1] - row_cosines_[row]);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const glm::dvec2 place((static_cast<double>(column) + right),
                         std::atan2(sine, cosine) / std::numbers::pi * image.height);
  const double phi = place.x / image.width * kTau;
  const glm::vec3 local(sine * std::sin(phi), cosine, -sine * std::cos(phi));
  return {glm::normalize(image.to_world * local), radiance_at(place), pdf_in(row, column)};
}

float Environment::pdf_solid_angle(glm::vec3 direction) const {
  if (!scene_.environment_image) return 1.0f / (4.0f * kPi);
  const glm::dvec2 place = place_of(direction);
  const auto last_row = columns_.size() - 1, last_column = columns_.front().size() - 1;
  return pdf_in(std::min(static_cast<std::size_t>(place.y), last_row),
                std::min(static_cast<std::size_t>(place.x), last_column));
}

}  // namespace heckbert::transport
