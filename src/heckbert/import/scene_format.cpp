#include <heckbert/import/scene_format.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include <heckbert/import/words.h>

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
          "what is in focus, along the viewing axis; for a lens")};
  return keys;
}

void read_camera(Reader& in, const JsonNode& node, Camera& out) {
  const std::size_t errors_before = in.error_count();
  read_object(in, node, "camera", camera_keys(), out);
  if (in.error_count() != errors_before) {
    return;
  }
  const glm::vec3 view = out.look_at - out.position;
  if (view == glm::vec3(0)) {
    in.error(*node.find("look_at"), "the camera looks at the place where it stands",
             "move \"look_at\" away from \"position\"");
  } else if (!(glm::length(glm::cross(glm::normalize(view), out.up)) > 1e-4f * glm::length(out.up))) {
    in.error(node, "\"up\" must not be zero or point along the line of sight");
  }
}

const std::vector<Key<RenderDefaults>>& render_keys() {
  using D = RenderDefaults;
  static const std::vector<Key<D>> keys{
      key("width", Integer{1, 16384}, &D::width, "program", "pixels"),
      key("height", Integer{1, 16384}, &D::height, "program", "pixels"),
      key("spp", Integer{1, 1000000}, &D::samples_per_pixel, "program", "samples per pixel"),
      key("max_depth", Integer{0, 1000}, &D::max_depth, "program", "most scatterings per path"),
      key("seed", Integer{0, 0xFFFFFFFFFFFFFFFF}, &D::seed, "program", "of the random numbers")};
  return keys;
}

void read_render(Reader& in, const JsonNode& node, RenderDefaults& out) {
  read_object(in, node, "render", render_keys(), out);
}

const Choice& light_types() {
  static const Choice types{{"point"}};
  return types;
}

const std::vector<Key<PointLight>>& point_light_keys() {
  static const std::vector<Key<PointLight>> keys{
      type_key<PointLight>(light_types(), "the kind of light"),
      key("position", Vector{}, &PointLight::position, kRequired, "where it is"),
      key("intensity", Colour{kNotNegative}, &PointLight::intensity, kRequired,
          "per steradian, the same in every direction")};
  return keys;
}

void read_lights(Reader& in, const JsonNode& node, std::vector<PointLight>& out) {
  read_list(in, node, "a list of lights", [&](const JsonNode& item) {
    if (read_type(in, item, "light", light_types())) {
      read_object(in, item, "point light", point_light_keys(), out.emplace_back());
    }
  });
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
      key("materials", Later{"list of materials"}, &D::materials, kRequired, "at least one"),
      key("shapes", Later{"list of shapes"}, &D::shapes, "`[]`", "in world space"),
      key("groups", Later{"list of groups"}, &D::groups, "`[]`", "shapes to be placed by instances"),
      key("instances", Later{"list of instances"}, &D::instances, "`[]`", "placed groups"),
      scene_key("lights", Custom<std::vector<PointLight>>{"list of lights", read_lights}, &Scene::point_lights, "`[]`",
                "lights without a surface; area lights are materials with `emission`"),
      scene_key("environment", Colour{kNotNegative}, &Scene::environment, "0", "radiance from every direction"),
      scene_key("ambient", Colour{kNotNegative}, &Scene::ambient, "0",
                "ambient light of the recursive tracers; no light path")};
  return keys;
}

class SceneBuilder {
 public:
  SceneBuilder(const JsonDocument& document, const std::filesystem::path& directory)
      : in_(document), root_(document.root), directory_(directory) {}

  Imported build() {
    SceneDraft draft;
    read_object(in_, root_, "scene", scene_keys(), draft);
    imported_.scene = std::move(draft.scene);
    if (root_.kind == JsonNode::Kind::Object) {
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
  void read_materials(const JsonNode* node) {
    if (node == nullptr) {
      return;
    }
    read_list(in_, *node, "a list of materials", [&](const JsonNode& item) {
      Material material = read_material(in_, item);
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
      imported_.scene.instances.push_back({group.value_or(0), to_world});
    });
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
    if (!lamps && scene.point_lights.empty() && is_black(scene.environment) && is_black(scene.ambient)) {
      in_.error(root_, "nothing in this scene gives light",
                "add \"emission\" to a material that a shape is made of, or \"lights\", or an \"environment\"");
    }
  }

  void tell() {
    const Scene& scene = imported_.scene;
    std::vector<std::string>& understood = imported_.account.understood;
    understood.push_back(count(scene.shapes.size(), "shape") + ", " + count(scene.groups.size(), "group") + ", " +
                         count(scene.instances.size(), "instance"));
    if (!scene.point_lights.empty()) {
      understood.push_back(count(scene.point_lights.size(), "point light"));
    }
    if (!is_black(scene.environment)) {
      understood.push_back("environment " + to_text(scene.environment));
    }
  }

  Reader in_;
  const JsonNode& root_;
  const std::filesystem::path& directory_;
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
  add(material_format());
  add(shape_format());
  add(transform_format());
  out.push_back(facts_of("group", "Shapes that instances place, all sharing one copy.", group_keys()));
  out.push_back(facts_of("instance", "A group in its place.", instance_keys()));
  out.push_back(
      facts_of("light of type point", "A light without extent; only shadow rays find it.", point_light_keys()));
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
