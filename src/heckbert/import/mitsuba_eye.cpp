#include <heckbert/import/mitsuba_eye.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

constexpr float kHighestFov = 179;
/// What stands for paths of any length.
constexpr int kUnlimited = 1000;

template <std::size_t N, class Kind>
const Kind* find_kind(const Kind (&kinds)[N], std::string_view type) {
  const auto found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.type == type; });
  return found == std::end(kinds) ? nullptr : found;
}

template <std::size_t N, class Kind>
std::vector<std::string> types_of(const Kind (&kinds)[N]) {
  std::vector<std::string> out;
  for (const Kind& kind : kinds) {
    out.emplace_back(kind.type);
  }
  return out;
}

template <std::size_t N, class Kind>
std::vector<MitsubaPluginFacts> facts_of(std::string_view tag, const Kind (&kinds)[N]) {
  std::vector<MitsubaPluginFacts> out;
  for (const Kind& kind : kinds) {
    out.push_back({tag, kind.type, kind.meaning});
  }
  return out;
}

// ---- film -----------------------------------------------------------------------------------------------------------

PixelFilter read_box(MitsubaObject& o) {
  return {FilterKind::Box, o.number("radius", 0.5f, {0, 100, true})};
}
PixelFilter read_tent(MitsubaObject& o) {
  return {FilterKind::Tent, o.number("radius", 1, {0, 100, true})};
}
PixelFilter read_gaussian(MitsubaObject& o) {
  return {FilterKind::Gaussian, 4 * o.number("stddev", 0.5f, {0, 25, true})};
}
PixelFilter read_negative(MitsubaObject& o) {
  o.skip_all();
  o.in().guessed(o.place(), o.describe() + " has negative parts; the Blackman-Harris filter is used");
  return {FilterKind::BlackmanHarris, 1.5f};
}

struct FilterKindOfFile {
  std::string_view type, meaning;
  PixelFilter (*read)(MitsubaObject&);
};

constexpr FilterKindOfFile kFilters[] = {
    {"box", "box", read_box},
    {"tent", "tent", read_tent},
    {"gaussian", "Gaussian", read_gaussian},
    {"mitchell", "Blackman-Harris (guessed)", read_negative},
    {"catmullrom", "Blackman-Harris (guessed)", read_negative},
    {"lanczos", "Blackman-Harris (guessed)", read_negative},
};

struct FilmSize {
  int width = 768, height = 576;  // Mitsuba's
};

FilmSize read_film(MitsubaReader& in, const XmlNode& node, RenderDefaults& defaults) {
  constexpr int kLargest = 16384;
  MitsubaObject film(in, node);
  FilmSize size;
  size.width = film.integer("width", size.width);
  size.height = film.integer("height", size.height);
  if (size.width < 1 || size.height < 1 || size.width > kLargest || size.height > kLargest) {
    in.error(node.place, film.describe() + ": expected a width and a height from 1 to " + std::to_string(kLargest));
    size = {};
  }
  // How the picture is stored is not a matter of the scene.
  film.skip({"filename", "file_format", "pixel_format", "component_format", "gamma", "banner", "exposure",
             "high_quality_edges", "tonemap_method", "attach_log", "compensate"});
  for (const XmlNode* filter : film.nested("rfilter")) {
    MitsubaObject object(in, *filter);
    if (const FilterKindOfFile* kind = find_kind(kFilters, object.type())) {
      defaults.filter = kind->read(object);
    } else {
      tell_unknown(object, types_of(kFilters), "the box filter is used");
    }
  }
  return size;
}

// ---- sensor ---------------------------------------------------------------------------------------------------------

/// The vertical field of view that the file means, in degrees. Mitsuba's default axis is x.
float vertical_fov(MitsubaObject& o, const FilmSize& size) {
  const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
  std::string axis = o.text("fov_axis", "x");
  float half = std::tan(0.5f * glm::radians(o.number("fov", 50, {0, static_cast<double>(kHighestFov), true})));
  if (const XmlNode* focal = o.find("focal_length"); focal != nullptr && !o.has("fov")) {
    // Of a lens before 35 mm film, 36 by 24 mm, across the diagonal.
    std::string_view text = (*focal)["value"];
    if (text.ends_with("mm")) {
      text.remove_suffix(2);
    }
    const auto millimetres = parse_number(text);
    if (!millimetres || !(*millimetres > 0)) {
      o.in().error(focal->place, "expected a focal length such as \"50mm\"");
    } else {
      half = std::sqrt(36.0f * 36.0f + 24.0f * 24.0f) / (2 * *millimetres);
      axis = "diagonal";
    }
  }
  if (axis == "smaller") {
    axis = aspect > 1 ? "y" : "x";
  } else if (axis == "larger") {
    axis = aspect > 1 ? "x" : "y";
  }
  if (axis == "x") {
    half /= aspect;
  } else if (axis == "diagonal") {
    half /= std::sqrt(1 + aspect * aspect);
  } else if (axis != "y") {
    o.in().error(o.place(),
                 o.describe() + ": expected fov_axis x, y, diagonal, smaller or larger, found \"" + axis + "\"");
  }
  return 2 * glm::degrees(std::atan(half));
}

void read_perspective(MitsubaObject& o, const FilmSize& size, Camera& camera) {
  camera.vertical_fov_degrees = vertical_fov(o, size);
  // A pinhole has everything in focus.
  o.skip({"focus_distance"});
}

void read_thin_lens(MitsubaObject& o, const FilmSize& size, Camera& camera) {
  camera.vertical_fov_degrees = vertical_fov(o, size);
  if (!o.has("aperture_radius")) {
    o.in().error(o.place(), o.describe() + " needs \"aperture_radius\"");
  }
  camera.lens_radius = o.number("aperture_radius", 0, kNotNegative);
  camera.focus_distance = o.number("focus_distance", 1, kPositive);
}

/// The film is two units wide before the transform.
void read_orthographic(MitsubaObject& o, const FilmSize& size, Camera& camera) {
  camera.projection = Projection::Orthographic;
  const glm::vec3 vertical(o.transform("to_world")[1]);
  camera.height = 2 * glm::length(vertical) * static_cast<float>(size.height) / static_cast<float>(size.width);
}

struct SensorKind {
  std::string_view type, meaning;
  void (*read)(MitsubaObject&, const FilmSize&, Camera&);
};

constexpr SensorKind kSensors[] = {
    {"perspective", "pinhole; `fov` along `fov_axis`, or `focal_length`", read_perspective},
    {"thinlens", "thin lens", read_thin_lens},
    {"orthographic", "orthographic", read_orthographic},
};

void place_camera(MitsubaObject& o, Camera& camera) {
  const glm::mat4 to_world = o.transform("to_world");
  const glm::mat3 linear(to_world);
  if (!(std::abs(glm::determinant(linear)) > 0)) {
    o.in().error(o.place(), o.describe() + ": its transform flattens the camera");
    return;
  }
  camera.position = glm::vec3(to_world[3]);
  camera.look_at = camera.position + glm::normalize(linear[2]);
  camera.up = glm::normalize(linear[1]);
  camera.mirrored = glm::determinant(linear) < 0;
}

}  // namespace

void read_sensor(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject sensor(in, node);
  RenderDefaults& defaults = in.imported.scene.defaults;
  const std::vector<const XmlNode*> films = sensor.nested("film");
  const FilmSize size = films.empty() ? FilmSize{} : read_film(in, *films.front(), defaults);
  defaults.width = size.width;
  defaults.height = size.height;
  for (const XmlNode* sampler : sensor.nested("sampler")) {
    MitsubaObject object(in, *sampler);
    defaults.samples_per_pixel = std::clamp(object.integer("sample_count", 4), 1, 1 << 20);
    object.skip_all();  // which numbers are drawn is the renderer's choice
  }
  Camera& camera = in.imported.scene.camera;
  place_camera(sensor, camera);
  if (const SensorKind* kind = find_kind(kSensors, sensor.type())) {
    kind->read(sensor, size, camera);
  } else {
    tell_unknown(sensor, types_of(kSensors), "a pinhole is used, from the same place");
  }
  // All that lies in front of the camera is seen, and the shutter is open for one instant.
  sensor.skip({"near_clip", "far_clip", "shutter_open", "shutter_close"});
  in.understood(node.place, sensor.describe() + ", " + std::to_string(size.width) + "x" + std::to_string(size.height));
}

void read_integrator(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject integrator(in, node);
  std::optional<int>& depth = in.imported.scene.defaults.max_depth;
  if (integrator.type() == "direct") {
    depth = 1;
    integrator.skip({"emitter_samples", "bsdf_samples", "shading_samples"});
    return;
  }
  if (const std::vector<const XmlNode*> nested = integrator.nested("integrator"); !nested.empty()) {
    return read_integrator(in, *nested.front());
  }
  if (integrator.type() != "path" && integrator.type() != "volpath") {
    in.guessed(node.place, integrator.describe() + " is not read: what the reference path tracer sees is traced");
  }
  const int segments = integrator.integer("max_depth", -1);
  if (segments == 0 || segments < -1) {
    in.error(node.place, integrator.describe() + ": expected a max_depth of -1 for unlimited, or at least 1");
  } else if (segments == -1) {
    depth = kUnlimited;
    in.guessed(node.place, integrator.describe() + ": unlimited depth read as at most " + std::to_string(kUnlimited) +
                               " scatterings");
  } else {
    depth = std::min(segments - 1, kUnlimited);
    in.understood(node.place, integrator.describe() + ": paths of at most " + std::to_string(segments) + " segments, " +
                                  count(static_cast<std::size_t>(*depth), "scattering"));
  }
}

std::vector<MitsubaPluginFacts> sensor_facts() {
  return facts_of("sensor", kSensors);
}
std::vector<MitsubaPluginFacts> filter_facts() {
  return facts_of("rfilter", kFilters);
}
std::vector<MitsubaPluginFacts> integrator_facts() {
  return {{"integrator", "path", "`max_depth` segments are one scattering less; -1 is 1000 scatterings (guessed)"},
          {"integrator", "volpath", "the same"},
          {"integrator", "direct", "one scattering"}};
}

}  // namespace heckbert::import
