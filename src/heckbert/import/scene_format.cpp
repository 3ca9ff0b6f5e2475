#include <heckbert/import/scene_format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <heckbert/import/radiance_image.h>
#include <heckbert/import/words.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/filter.h>

namespace heckbert::import {
namespace {

using namespace transport;

const std::vector<Key<Camera>>& camera_keys() {
  static const std::vector<Key<Camera>> keys{
      key("position", Vector{}, &Camera::position, kRequired, "where the eye is"),
      key("look_at", Vector{}, &Camera::look_at, kRequired, "what stands in the middle of the picture"),
      key("up", Vector{}, &Camera::up, "[0, 1, 0]", "what points upwards in the picture"),
      key("fov", Number{{0, 175, true}}, &Camera::vertical_fov_degrees, "40", "vertical field of view, degrees"),
      key("lens_radius", Number{kNotNegative}, &Camera::lens_radius, "0", "0 is a pinhole, more a thin lens"),
      key("focus_distance", Number{kPositive}, &Camera::focus_distance, "1",
          "what is in focus, along the viewing axis; for a lens"),
      key("projection", Choice{{"perspective", "orthographic", "panoramic"}}, &Camera::projection, "perspective",
          "`orthographic`: parallel rays; `panoramic`: all directions, longitude across and latitude down"),
      key("height", Number{kPositive}, &Camera::height, "2", "of an orthographic picture, in scene units")};
  return keys;
}

/// A key that says something about another projection is a misunderstanding.
void check_projection(Reader& in, const JsonNode& node, const Camera& camera) {
  const struct {
    const char* key;
    Projection projection;
    const char* name;
  } rules[] = {{"fov", Projection::Perspective, "perspective"},
               {"lens_radius", Projection::Perspective, "perspective"},
               {"focus_distance", Projection::Perspective, "perspective"},
               {"height", Projection::Orthographic, "orthographic"}};
  for (const auto& rule : rules) {
    const JsonNode* given = node.find(rule.key);
    if (given != nullptr && camera.projection != rule.projection) {
      in.error(*given,
               std::string("only a camera with \"projection\": \"") + rule.name + "\" takes \"" + rule.key + "\"");
    }
  }
}

void read_camera(Reader& in, const JsonNode& node, Camera& out) {
  const std::size_t errors_before = in.error_count();
  read_object(in, node, "camera", camera_keys(), out);
  if (in.error_count() != errors_before) {
    return;
  }
  check_projection(in, node, out);
  const glm::vec3 view = out.look_at - out.position;
  if (view == glm::vec3(0)) {
    in.error(*node.find("look_at"), "the camera looks at the place where it stands",
             "move \"look_at\" away from \"position\"");
  } else if (!(glm::length(glm::cross(glm::normalize(view), out.up)) > 1e-4f * glm::length(out.up))) {
    in.error(node, "\"up\" must not be zero or point along the line of sight");
  }
}

const Choice& filter_names() {
  static const Choice names = [] {
    Choice choice;
    for (const FilterFacts& filter : kFilters) {
      choice.words.emplace_back(filter.name);
    }
    return choice;
  }();
  return names;
}

void read_filter(Reader& in, const JsonNode& node, std::optional<PixelFilter>& out) {
  if (const auto index = filter_names().parse(in, node)) {
    out = {kFilters[*index].kind, kFilters[*index].radius};
  }
}

const std::vector<Key<RenderDefaults>>& render_keys() {
  using D = RenderDefaults;
  static const std::vector<Key<D>> keys{
      key("width", Integer{1, 16384}, &D::width, "program", "pixels"),
      key("height", Integer{1, 16384}, &D::height, "program", "pixels"),
      key("spp", Integer{1, 1000000}, &D::samples_per_pixel, "program", "samples per pixel"),
      key("max_depth", Integer{0, 1000}, &D::max_depth, "program", "most scatterings per path"),
      key("seed", Integer{0, 0xFFFFFFFFFFFFFFFF}, &D::seed, "program", "of the random numbers"),
      key("filter", Custom<std::optional<PixelFilter>>{filter_names().describe(), read_filter}, &D::filter, "program",
          "pixel filter")};
  return keys;
}

void read_render(Reader& in, const JsonNode& node, RenderDefaults& out) {
  read_object(in, node, "render", render_keys(), out);
}

const Choice& light_types() {
  static const Choice types{{"point", "spot", "distant"}};
  return types;
}

/// The key that every light without a surface has.
template <class Light>
Key<Light> light_group_key() {
  return key("light_group", Text{}, &Light::light_group, "none",
             "what words recorded with `--labels light-group` call it");
}

const std::vector<Key<PointLight>>& point_light_keys() {
  static const std::vector<Key<PointLight>> keys{
      type_key<PointLight>(light_types(), "the kind of light"),
      key("position", Vector{}, &PointLight::position, kRequired, "where it is"),
      key("intensity", Colour{kNotNegative}, &PointLight::intensity, kRequired,
          "per steradian, the same in every direction"),
      light_group_key<PointLight>()};
  return keys;
}

const std::vector<Key<SpotLight>>& spot_light_keys() {
  static const std::vector<Key<SpotLight>> keys{
      type_key<SpotLight>(light_types(), "the kind of light"),
      key("position", Vector{}, &SpotLight::position, kRequired, "where it is"),
      key("direction", Vector{}, &SpotLight::direction, kRequired, "of its axis, of any length"),
      key("intensity", Colour{kNotNegative}, &SpotLight::intensity, kRequired, "per steradian, on the axis"),
      key("cutoff", Number{{0, 180, true}}, &SpotLight::cutoff_degrees, "20",
          "angle from the axis where the light ends, degrees"),
      key("falloff", Number{{0, 180}}, &SpotLight::falloff_degrees, "15",
          "angle from the axis where it begins to fall, linearly in the angle; at most the cutoff"),
      light_group_key<SpotLight>()};
  return keys;
}

const std::vector<Key<DistantLight>>& distant_light_keys() {
  static const std::vector<Key<DistantLight>> keys{
      type_key<DistantLight>(light_types(), "the kind of light"),
      key("direction", Vector{}, &DistantLight::direction, kRequired, "in which the light travels, of any length"),
      key("irradiance", Colour{kNotNegative}, &DistantLight::irradiance, kRequired, "on a surface that faces it"),
      light_group_key<DistantLight>()};
  return keys;
}

struct LightsDraft {
  std::vector<PointLight> points;
  std::vector<SpotLight> spots;
  std::vector<DistantLight> distant;
};

void check_direction(Reader& in, const JsonNode& light, glm::vec3 direction) {
  if (direction == glm::vec3(0)) {
    in.error(light, "\"direction\" must not be zero");
  }
}

void read_spot(Reader& in, const JsonNode& node, SpotLight& out) {
  const std::size_t errors_before = in.error_count();
  read_object(in, node, "spot light", spot_light_keys(), out);
  if (in.error_count() != errors_before) {
    return;
  }
  check_direction(in, node, out.direction);
  if (out.falloff_degrees > out.cutoff_degrees) {
    const JsonNode* falloff = node.find("falloff");
    in.error(falloff != nullptr ? *falloff : node,
             "the light cannot begin to fall beyond its cutoff of " + to_text(Rgb(out.cutoff_degrees)) + " degrees");
  }
}

void read_distant(Reader& in, const JsonNode& node, DistantLight& out) {
  const std::size_t errors_before = in.error_count();
  read_object(in, node, "distant light", distant_light_keys(), out);
  if (in.error_count() == errors_before) {
    check_direction(in, node, out.direction);
  }
}

void read_lights(Reader& in, const JsonNode& node, LightsDraft& out) {
  read_list(in, node, "a list of lights", [&](const JsonNode& item) {
    const auto type = read_type(in, item, "light", light_types());
    if (!type) {
      return;
    }
    const std::string& name = light_types().words[*type];
    if (name == "point") {
      read_object(in, item, "point light", point_light_keys(), out.points.emplace_back());
    } else if (name == "spot") {
      read_spot(in, item, out.spots.emplace_back());
    } else {
      read_distant(in, item, out.distant.emplace_back());
    }
  });
}

const std::vector<Key<Medium>>& medium_keys() {
  static const std::vector<Key<Medium>> keys{
      key("name", Text{}, &Medium::name, kRequired, "what materials and the scene call it"),
      key("absorption", Colour{kNotNegative}, &Medium::absorption, "0", "coefficient per unit of length"),
      key("scattering", Colour{kNotNegative}, &Medium::scattering, "0", "coefficient per unit of length"),
      key("anisotropy", Number{{-0.999, 0.999}}, &Medium::anisotropy, "0",
          "mean cosine of the angle of scattering; 0 is isotropic, above 0 forward")};
  return keys;
}

struct EnvironmentDraft {
  std::string file;
  Rgb scale{1.0f};
  const JsonNode* transform = nullptr;
  Interpolation interpolation = Interpolation::Bilinear;
};

const std::vector<Key<EnvironmentDraft>>& environment_image_keys() {
  using D = EnvironmentDraft;
  static const std::vector<Key<D>> keys{
      key("file", Text{}, &D::file, kRequired, "HDR or EXR file, from the folder of the scene file"),
      key("scale", Colour{kNotNegative}, &D::scale, "1", "multiplies the image"),
      key("transform", Later{"list of transform steps"}, &D::transform, "`[]`", "turns the image; no move, no stretch"),
      key("interpolation", Choice{{"nearest", "bilinear"}}, &D::interpolation, "bilinear", "between pixels")};
  return keys;
}

struct GroupDraft {
  std::string name;
  const JsonNode* shapes = nullptr;
};

const std::vector<Key<GroupDraft>>& group_keys() {
  static const std::vector<Key<GroupDraft>> keys{
      key("name", Text{}, &GroupDraft::name, kRequired, "what instances call it"),
      key("shapes", Later{"list of shapes"}, &GroupDraft::shapes, kRequired, "in the group's own space")};
  return keys;
}

struct InstanceDraft {
  const JsonNode* group = nullptr;
  const JsonNode* transform = nullptr;
};

const std::vector<Key<InstanceDraft>>& instance_keys() {
  using D = InstanceDraft;
  static const std::vector<Key<D>> keys{
      key("group", Later{"name of a group"}, &D::group, kRequired, "what to place"),
      key("transform", Later{"list of transform steps"}, &D::transform, "`[]`", "from the group's space to the world")};
  return keys;
}

struct SceneDraft {
  Scene scene;
  LightsDraft lights;
  const JsonNode* environment_image = nullptr;
  const JsonNode* media = nullptr;
  const JsonNode* textures = nullptr;
  const JsonNode* medium = nullptr;
  const JsonNode* materials = nullptr;
  const JsonNode* shapes = nullptr;
  const JsonNode* groups = nullptr;
  const JsonNode* instances = nullptr;
};

/// A key of the scene object that fills a member of the scene itself.
template <class Rule, class Member>
Key<SceneDraft> scene_key(std::string_view name, Rule rule, Member Scene::*member, std::string_view otherwise,
                          std::string_view meaning) {
  KeyFacts facts{std::string(name), rule.describe(), std::string(otherwise), std::string(meaning)};
  return {std::move(facts), [rule = std::move(rule), member](Reader& in, const JsonNode& node, SceneDraft& out) {
            rule.read(in, node, out.scene.*member);
          }};
}

const std::vector<Key<SceneDraft>>& scene_keys() {
  using D = SceneDraft;
  static const std::vector<Key<D>> keys{
      scene_key("name", Text{}, &Scene::name, "name of the file", "a word for lists and file names"),
      scene_key("title", Text{}, &Scene::title, "", "one line for people"),
      scene_key("camera", Custom<Camera>{"a camera", read_camera}, &Scene::camera, kRequired, "the eye"),
      scene_key("render", Custom<RenderDefaults>{"a render object", read_render}, &Scene::defaults, "program",
                "what the author suggests; flags override it"),
      key("textures", Later{"list of textures"}, &D::textures, "`[]`", "pictures and patterns that materials name"),
      key("media", Later{"list of media"}, &D::media, "`[]`", "fog, milk, the colour of glass"),
      key("medium", Later{"name of a medium"}, &D::medium, "nothing", "what fills all space outside of bodies"),
      key("materials", Later{"list of materials"}, &D::materials, kRequired, "at least one"),
      key("shapes", Later{"list of shapes"}, &D::shapes, "`[]`", "in world space"),
      key("groups", Later{"list of groups"}, &D::groups, "`[]`", "shapes to be placed by instances"),
      key("instances", Later{"list of instances"}, &D::instances, "`[]`", "placed groups"),
      key("lights", Custom<LightsDraft>{"list of lights", read_lights}, &D::lights, "`[]`",
          "lights without a surface; area lights are materials with `emission`"),
      scene_key("environment", Colour{kNotNegative}, &Scene::environment, "0", "radiance from every direction"),
      key("environment_image", Later{"an environment image"}, &D::environment_image, "none",
          "radiance by direction; comes on top of `environment`"),
      scene_key("ambient", Colour{kNotNegative}, &Scene::ambient, "0",
                "ambient light of the recursive tracers; no light path")};
  return keys;
}

bool has_round_shape(const Group& group) {
  return std::any_of(group.shapes.begin(), group.shapes.end(),
                     [](const Shape& shape) { return !std::holds_alternative<Mesh>(shape.geometry); });
}

class SceneBuilder {
 public:
  SceneBuilder(const JsonDocument& document, const std::filesystem::path& directory)
      : in_(document), root_(document.root), directory_(directory) {}

  Imported build() {
    SceneDraft draft;
    read_object(in_, root_, "scene", scene_keys(), draft);
    imported_.scene = std::move(draft.scene);
    imported_.scene.point_lights = std::move(draft.lights.points);
    imported_.scene.spot_lights = std::move(draft.lights.spots);
    imported_.scene.distant_lights = std::move(draft.lights.distant);
    read_environment_image(draft.environment_image);
    if (root_.kind == JsonNode::Kind::Object) {
      read_media(draft.media);
      imported_.scene.medium = media_.find(in_, draft.medium);
      read_textures(draft.textures);
      read_materials(draft.materials);
      read_groups(draft.groups);
      read_shapes(draft.shapes, imported_.scene.shapes);
      read_instances(draft.instances);
    }
    if (in_.error_count() == 0) {
      check_whole();
    }
    if (std::vector<Diagnostic> errors = in_.errors(); !errors.empty()) {
      throw InputError(std::move(errors));
    }
    tell();
    return std::move(imported_);
  }

 private:
  void read_media(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of media", [&](const JsonNode& item) {
      Medium& medium = imported_.scene.media.emplace_back();
      read_object(in_, item, "medium", medium_keys(), medium);
      media_.add(in_, item, medium.name);
      imported_.account.understood.push_back("medium \"" + medium.name + "\": absorption " +
                                             to_text(medium.absorption) + ", scattering " + to_text(medium.scattering));
    });
  }

  void read_textures(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of textures", [&](const JsonNode& item) {
      Texture& texture = imported_.scene.textures.emplace_back(read_texture(in_, item, directory_));
      textures_.add(in_, item, texture.name);
    });
  }

  void read_materials(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of materials", [&](const JsonNode& item) {
      Material material = read_material(in_, item, media_, textures_);
      materials_.add(in_, item, material.name);
      imported_.account.understood.push_back("material \"" + material.name + "\": " + describe(material));
      imported_.scene.materials.push_back(std::move(material));
    });
  }

  void read_shapes(const JsonNode* node, std::vector<Shape>& out) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of shapes", [&](const JsonNode& item) {
      if (auto shape = read_shape(in_, item, materials_, directory_, imported_.account)) {
        out.push_back(std::move(*shape));
      }
    });
  }

  void read_groups(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of groups", [&](const JsonNode& item) {
      GroupDraft draft;
      read_object(in_, item, "group", group_keys(), draft);
      groups_.add(in_, item, draft.name);
      Group& group = imported_.scene.groups.emplace_back();
      group.name = draft.name;
      read_shapes(draft.shapes, group.shapes);
      if (draft.shapes != nullptr && draft.shapes->items.empty()) {
        in_.error(*draft.shapes, "a group needs at least one shape");
      }
    });
  }

  void read_instances(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of instances", [&](const JsonNode& item) {
      InstanceDraft draft;
      read_object(in_, item, "instance", instance_keys(), draft);
      const auto group = groups_.find(in_, draft.group);
      const glm::mat4 to_world = draft.transform == nullptr ? glm::mat4(1) : read_transform(in_, *draft.transform);
      if (group && !is_similarity(to_world) && has_round_shape(imported_.scene.groups[*group])) {
        in_.error(*draft.transform, "this transform stretches a sphere or disk of its group",
                  "move, turn or scale it evenly; a stretched one can be a mesh");
      }
      imported_.scene.instances.push_back({group.value_or(0), to_world});
    });
  }

  void read_environment_image(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    EnvironmentDraft draft;
    const std::size_t errors_before = in_.error_count();
    read_object(in_, *node, "environment image", environment_image_keys(), draft);
    const glm::mat4 to_world = draft.transform == nullptr ? glm::mat4(1) : read_transform(in_, *draft.transform);
    if (in_.error_count() != errors_before) {
      return;
    }
    EnvironmentImage image;
    image.to_world = glm::mat3(to_world);
    image.interpolation = draft.interpolation;
    if (!is_similarity(to_world) || std::abs(glm::length(image.to_world[0]) - 1) > 1e-4f) {
      in_.error(*draft.transform, "an environment image can only be turned or mirrored");
      return;
    }
    try {
      RadianceImage file = read_radiance_image(directory_ / draft.file);
      image.width = file.width;
      image.height = file.height;
      image.pixels = std::move(file.pixels);
    } catch (const ReadError& problem) {
      in_.error(*node->find("file"), problem.what());
      return;
    }
    for (Rgb& pixel : image.pixels) {
      pixel *= draft.scale;
    }
    imported_.scene.environment_image = std::move(image);
  }

  /// What only the whole scene can tell.
  void check_whole() {
    const Scene& scene = imported_.scene;
    if (scene.shapes.empty() && scene.instances.empty()) {
      in_.error(root_, "this scene is empty: it has no shapes and no instances");
    }
    const auto emits = [&](const Shape& shape) { return !is_black(scene.materials[shape.material].emission); };
    const auto has_lamp = [&](const std::vector<Shape>& shapes) {
      return std::any_of(shapes.begin(), shapes.end(), emits);
    };
    const bool lamps = has_lamp(scene.shapes) ||
                       std::any_of(scene.instances.begin(), scene.instances.end(),
                                   [&](const Instance& i) { return has_lamp(scene.groups[i.group].shapes); });
    const bool lights = !scene.point_lights.empty() || !scene.spot_lights.empty() || !scene.distant_lights.empty();
    const bool sky = !is_black(scene.environment) || scene.environment_image;
    if (!lamps && !lights && !sky && is_black(scene.ambient)) {
      in_.error(root_, "nothing in this scene gives light",
                "add \"emission\" to a material that a shape is made of, or \"lights\", or an \"environment\"");
    }
  }

  void tell() {
    const Scene& scene = imported_.scene;
    std::vector<std::string>& understood = imported_.account.understood;
    understood.push_back(count(scene.shapes.size(), "shape") + ", " + count(scene.groups.size(), "group") + ", " +
                         count(scene.instances.size(), "instance"));
    const auto tell_lights = [&](std::size_t number, const char* kind) {
      if (number > 0) {
        understood.push_back(count(number, kind));
      }
    };
    tell_lights(scene.point_lights.size(), "point light");
    tell_lights(scene.spot_lights.size(), "spot light");
    tell_lights(scene.distant_lights.size(), "distant light");
    if (!is_black(scene.environment)) {
      understood.push_back("environment " + to_text(scene.environment));
    }
    if (scene.environment_image) {
      understood.push_back("environment image of " + std::to_string(scene.environment_image->width) + "x" +
                           std::to_string(scene.environment_image->height) + " pixels");
    }
  }

  Reader in_;
  const JsonNode& root_;
  const std::filesystem::path& directory_;
  Names media_{"medium", {}};
  Names textures_{"texture", {}};
  Names materials_{"material", {}};
  Names groups_{"group", {}};
  Imported imported_;
};

}  // namespace

void Names::add(Reader& in, const JsonNode& node, const std::string& name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) != names.end()) {
    in.error(*node.find("name"), "there are two " + what + "s with the name \"" + name + "\"");
  }
  names.push_back(name);
}

std::optional<std::uint32_t> Names::find(Reader& in, const JsonNode* node) const {
  if (node == nullptr) {
    return {};
  }
  if (node->kind != JsonNode::Kind::Text) {
    in.error_expected(*node, "the name of a " + what);
    return {};
  }
  const auto at = std::find(names.begin(), names.end(), node->text);
  if (at == names.end()) {
    in.error(*node, "there is no " + what + " \"" + node->text + "\"", Reader::suggest(node->text, names));
    return {};
  }
  return static_cast<std::uint32_t>(at - names.begin());
}

Imported read_json_scene(std::string_view text, std::string_view source, const std::filesystem::path& directory) {
  const JsonDocument document = parse_json(text, source);
  return SceneBuilder(document, directory).build();
}

std::vector<ObjectFacts> scene_format() {
  std::vector<ObjectFacts> out{facts_of("scene", "The whole file is one such object.", scene_keys()),
                               facts_of("camera", "The eye.", camera_keys()),
                               facts_of("render", "Settings that the author suggests.", render_keys())};
  const auto add = [&](std::vector<ObjectFacts> more) {
    out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  out.push_back(facts_of("medium",
                         "Homogeneous; light that it scatters has the letter V. Without scattering it only absorbs.",
                         medium_keys()));
  add(texture_format());
  add(material_format());
  add(shape_format());
  add(transform_format());
  out.push_back(facts_of("group", "Shapes that instances place, all sharing one copy.", group_keys()));
  out.push_back(facts_of("instance", "A group in its place.", instance_keys()));
  out.push_back(
      facts_of("light of type point", "A light without extent; only shadow rays find it.", point_light_keys()));
  out.push_back(facts_of("light of type spot", "A point light that shines into a cone.", spot_light_keys()));
  out.push_back(facts_of("light of type distant", "Parallel light from infinitely far away.", distant_light_keys()));
  out.push_back(facts_of("environment image",
                         "An equirectangular image around the scene, +y up: its left edge lies towards -z, its middle "
                         "towards +z.",
                         environment_image_keys()));
  return out;
}

std::string scene_format_reference() {
  std::string out;
  for (const ObjectFacts& object : scene_format()) {
    out += "### " + object.name + "\n\n" + object.meaning +
           "\n\n| key | value | when absent | meaning |\n|---|---|---|---|\n";
    for (const KeyFacts& k : object.keys) {
      out += "| `" + k.name + "` | " + k.value + " | " + k.otherwise + " | " + k.meaning + " |\n";
    }
    out += "\n";
  }
  return out;
}

}  // namespace heckbert::import
