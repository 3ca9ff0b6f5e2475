#include <heckbert/transport/texture.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <heckbert/transport/lobe.h>
#include <heckbert/transport/overload.h>

namespace heckbert::transport {

namespace {

/// The sRGB curve (IEC 61966-2-1), byte to linear light.
const std::array<float, 256>& srgb_to_linear() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      const double c = static_cast<double>(i) / 255.0;
      made[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return made;
  }();
  return table;
}

glm::vec4 pixel(const Image& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  if (!image.floats.empty()) {
    const float* p = &image.floats[at];
    return {p[0], p[1], p[2], p[3]};
  }
  const std::uint8_t* p = &image.bytes[at];
  const auto plain = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  if (!image.srgb) return {plain(p[0]), plain(p[1]), plain(p[2]), plain(p[3])};
  const auto& linear = srgb_to_linear();
  return {linear[p[0]], linear[p[1]], linear[p[2]], plain(p[3])};
}

int wrapped(int i, int size) {
  const int rest = i % size;
  return rest < 0 ? rest + size : rest;
}

glm::vec4 look_up(const Image& image, glm::vec2 uv) {
  // Pixel centres are at halves; the fraction first, so that far coordinates keep their precision.
  const float x = (uv.x - std::floor(uv.x)) * static_cast<float>(image.width) - 0.5f;
  const float y = (1.0f - (uv.y - std::floor(uv.y))) * static_cast<float>(image.height) - 0.5f;
  const float x_floor = std::floor(x), y_floor = std::floor(y);
  const int x0 = wrapped(static_cast<int>(x_floor), image.width), x1 = wrapped(x0 + 1, image.width);
  const int y0 = wrapped(static_cast<int>(y_floor), image.height), y1 = wrapped(y0 + 1, image.height);
  const glm::vec4 upper = glm::mix(pixel(image, x0, y0), pixel(image, x1, y0), x - x_floor);
  const glm::vec4 lower = glm::mix(pixel(image, x0, y1), pixel(image, x1, y1), x - x_floor);
  return glm::mix(upper, lower, y - y_floor);
}

glm::vec4 look_up(const Checkerboard& board, glm::vec2 uv) {
  const auto half = [](float x) { return x - std::floor(x) < 0.5f; };
  const Rgb c = half(uv.x) == half(uv.y) ? board.first : board.second;
  return {c.r, c.g, c.b, 1.0f};
}

/// Colour of a lobe as a texture multiplies it: see LobeTexture::Parameter::Colour.
void multiply_colour(Lobe& lobe, Rgb colour) {
  if (auto* coated = std::get_if<CoatedDiffuse>(&lobe)) {
    coated->albedo *= colour;
    return;
  }
  Fresnel* fresnel = nullptr;
  if (auto* mirror = std::get_if<Mirror>(&lobe)) fresnel = &mirror->fresnel;
  if (auto* facets = std::get_if<MicrofacetReflection>(&lobe)) fresnel = &facets->fresnel;
  if (auto* schlick = fresnel != nullptr ? std::get_if<SchlickFresnel>(fresnel) : nullptr)
    schlick->f0 *= colour;
  else
    scale(lobe, colour);
}

/// A surface smoother than this is no longer computed well in single precision.
constexpr float kNarrowest = 1e-3f;

void multiply_width(Lobe& lobe, float factor) {
  const auto narrow = [&](Microfacets& facets) {
    facets.alpha_x = std::max(kNarrowest, facets.alpha_x * factor);
    facets.alpha_y = std::max(kNarrowest, facets.alpha_y * factor);
  };
  std::visit(Overload{
                 [&](OrenNayar& l) { l.roughness *= factor; },
                 [&](CoatedDiffuse& l) { l.coat.alpha = std::max(kNarrowest, l.coat.alpha * factor); },
                 [&](MicrofacetReflection& l) { narrow(l.facets); },
                 [&](RoughDielectric& l) { narrow(l.facets); },
                 [](auto&) {},
             },
             lobe);
}

}  // namespace

glm::vec4 look_up(const Texture& texture, glm::vec2 uv) {
  const glm::vec2 placed = uv * texture.scale + texture.offset;
  return std::visit([&](const auto& source) { return look_up(source, placed); }, texture.source);
}

Rgb mean_colour(const Texture& texture) {
  return std::visit(Overload{
                        [](const Image& image) {
                          glm::dvec3 sum(0);
                          for (int y = 0; y < image.height; ++y)
                            for (int x = 0; x < image.width; ++x) sum += glm::dvec3(pixel(image, x, y));
                          const glm::vec3 mean(sum / (static_cast<double>(image.width) * image.height));
                          return Rgb(mean.x, mean.y, mean.z);
                        },
                        [](const Checkerboard& board) { return (board.first + board.second) * 0.5f; },
                    },
                    texture.source);
}

float look_up(const Scene& scene, const ScalarTexture& texture, glm::vec2 uv) {
  return look_up(scene.textures[texture.texture], uv)[static_cast<int>(texture.channel)];
}

float opacity(const Scene& scene, const Material& material, glm::vec2 uv) {
  return material.opacity ? std::clamp(look_up(scene, *material.opacity, uv), 0.0f, 1.0f) : 1.0f;
}

void apply_texture(const Scene& scene, const LobeTexture& use, glm::vec2 uv, Lobe& lobe) {
  using Parameter = LobeTexture::Parameter;
  if (use.parameter == Parameter::Colour) {
    const glm::vec4 c = look_up(scene.textures[use.texture.texture], uv);
    return multiply_colour(lobe, Rgb(c.r, c.g, c.b) * use.factor);
  }
  const float value = look_up(scene, use.texture, uv) * use.factor;
  switch (use.parameter) {
    case Parameter::Colour:
    case Parameter::Weight:
      return scale(lobe, Rgb(value));
    case Parameter::OneMinusWeight:
      return scale(lobe, Rgb(1.0f - value));
    case Parameter::Alpha:
      return multiply_width(lobe, value);
    case Parameter::Roughness:
      return multiply_width(lobe, value * value);
  }
}

glm::vec3 mapped_normal(const Scene& scene, const NormalMap& map, glm::vec2 uv) {
  const glm::vec4 stored = look_up(scene.textures[map.texture], uv);
  const glm::vec3 n = 2.0f * glm::vec3(stored) - 1.0f;
  constexpr float kLowest = 1e-3f;
  return glm::normalize(glm::vec3(map.strength * n.x, map.strength * n.y, std::max(kLowest, n.z)));
}

bool needs_surface_coordinates(const Material& material) {
  const auto is_anisotropic = [](const Lobe& lobe) {
    const Microfacets* facets = nullptr;
    if (const auto* glossy = std::get_if<MicrofacetReflection>(&lobe)) facets = &glossy->facets;
    if (const auto* glass = std::get_if<RoughDielectric>(&lobe)) facets = &glass->facets;
    return facets != nullptr && facets->alpha_x != facets->alpha_y;
  };
  return material.normal_map || material.opacity || material.emission_texture || !material.textures.empty() ||
         std::any_of(material.lobes.begin(), material.lobes.end(), is_anisotropic);
}

}  // namespace heckbert::transport
