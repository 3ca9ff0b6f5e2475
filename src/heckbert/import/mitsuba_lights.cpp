#include <heckbert/import/mitsuba_lights.h>

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <heckbert/import/radiance_image.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

using namespace transport;

glm::vec3 origin_of(const glm::mat4& to_world) {
  return glm::vec3(to_world[3]);
}

/// Mitsuba's lights shine along +z.
glm::vec3 axis_of(const glm::mat4& to_world) {
  return glm::vec3(to_world[2]);
}

void read_point(MitsubaObject& o, Scene& scene) {
  const glm::vec3 origin = origin_of(o.transform("to_world"));
  scene.point_lights.push_back({o.vector("position", origin), o.colour("intensity", Rgb(1))});
}

void read_spot(MitsubaObject& o, Scene& scene) {
  const glm::mat4 to_world = o.transform("to_world");
  SpotLight light;
  light.position = origin_of(to_world);
  light.direction = axis_of(to_world);
  light.intensity = o.colour("intensity", Rgb(1));
  light.cutoff_degrees = o.number("cutoff_angle", 20, {0, 180, true});
  light.falloff_degrees = o.number("beam_width", 0.75f * light.cutoff_degrees, {0, 180});
  light.falloff_degrees = std::min(light.falloff_degrees, light.cutoff_degrees);
  scene.spot_lights.push_back(light);
}

void read_directional(MitsubaObject& o, Scene& scene) {
  const glm::vec3 axis = axis_of(o.transform("to_world"));
  const glm::vec3 direction = o.vector("direction", axis);
  if (direction == glm::vec3(0)) {
    o.in().error(o.place(), o.describe() + ": its direction is zero");
  }
  scene.distant_lights.push_back({direction, o.colour("irradiance", Rgb(1))});
}

void read_constant(MitsubaObject& o, Scene& scene) {
  scene.environment += o.colour("radiance", Rgb(1));
}

void read_environment_map(MitsubaObject& o, Scene& scene) {
  const float scale = o.number("scale", 1, kNotNegative);
  const glm::mat4 transform = o.transform("to_world");
  const glm::mat3 to_world(glm::normalize(transform[0]), glm::normalize(transform[1]), glm::normalize(transform[2]));
  const std::filesystem::path path = o.file("filename");
  if (path.empty()) {
    return;
  }
  try {
    RadianceImage image = read_radiance_image(path);
    for (Rgb& pixel : image.pixels) {
      pixel *= scale;
    }
    scene.environment_image = EnvironmentImage{image.width, image.height, std::move(image.pixels), to_world};
  } catch (const ReadError& problem) {
    o.in().error(o.place(), problem.what());
  }
}

struct LightKind {
  std::string_view type, meaning;
  void (*read)(MitsubaObject&, Scene&);
};

constexpr LightKind kLights[] = {
    {"point", "point light", read_point},
    {"spot", "spot light, without its texture", read_spot},
    {"directional", "distant light", read_directional},
    {"constant", "constant environment", read_constant},
    {"envmap", "environment image, HDR or EXR", read_environment_map},
};

}  // namespace

void read_light(MitsubaReader& in, const XmlNode& node) {
  MitsubaObject object(in, node);
  const auto kind =
      std::find_if(std::begin(kLights), std::end(kLights), [&](const LightKind& k) { return k.type == object.type(); });
  if (kind == std::end(kLights)) {
    std::vector<std::string> known;
    for (const LightKind& k : kLights) {
      known.emplace_back(k.type);
    }
    tell_unknown(object, known, "left out");
    return;
  }
  object.skip({"sampling_weight"});
  kind->read(object, in.imported.scene);
  in.understood(node.place, object.describe());
}

std::vector<MitsubaPluginFacts> light_facts() {
  std::vector<MitsubaPluginFacts> out;
  for (const LightKind& kind : kLights) {
    out.push_back({"emitter", kind.type, kind.meaning});
  }
  out.push_back({"emitter", "area", "the shape that it stands in emits from its front; `radiance` may be a texture"});
  return out;
}

}  // namespace heckbert::import
