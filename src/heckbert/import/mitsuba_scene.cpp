// A Mitsuba scene: its elements handed to their readers, and what they make of it together.

#include <algorithm>
#include <tuple>

#include <heckbert/import/framing.h>
#include <heckbert/import/import.h>
#include <heckbert/import/mitsuba_bsdfs.h>
#include <heckbert/import/mitsuba_document.h>
#include <heckbert/import/mitsuba_eye.h>
#include <heckbert/import/mitsuba_lights.h>
#include <heckbert/import/mitsuba_reader.h>
#include <heckbert/import/mitsuba_shapes.h>
#include <heckbert/import/mitsuba_textures.h>
#include <heckbert/import/words.h>

namespace heckbert::import {
namespace {

using namespace transport;

/// A BSDF that nothing refers to may be wrong all the same.
void check_bsdf(MitsubaReader& in, const XmlNode& node) {
  read_bsdf(in, node);
}

/// Elements of a scene that have their reader. `luminaire` and `camera` are what versions before 0.4 call the others.
struct ElementKind {
  std::string_view tag;
  void (*read)(MitsubaReader&, const XmlNode&);  ///< null: read when something refers to it
};

constexpr ElementKind kElements[] = {
    {"shape", read_shape},   {"emitter", read_light}, {"luminaire", read_light},
    {"sensor", read_sensor}, {"camera", read_sensor}, {"integrator", read_integrator},
    {"bsdf", check_bsdf},    {"texture", nullptr},    {"spectrum", nullptr},
    {"rgb", nullptr},
};

const XmlNode* first(const XmlNode& root, std::string_view tag) {
  const auto found =
      std::find_if(root.children.begin(), root.children.end(), [&](const XmlNode& n) { return n.tag == tag; });
  return found == root.children.end() ? nullptr : &*found;
}

void read_elements(MitsubaReader& in) {
  const XmlNode& root = in.document.root;
  for (const XmlNode& node : root.children) {
    const auto kind = std::find_if(std::begin(kElements), std::end(kElements),
                                   [&](const ElementKind& k) { return k.tag == node.tag; });
    if (kind == std::end(kElements)) {
      in.ignored(node.place, "<" + node.tag + "> is not read");
    } else if ((kind->read == read_sensor || kind->read == read_integrator) && &node != first(root, node.tag)) {
      in.ignored(node.place, "<" + node.tag + ">: only the first is read");
    } else if (kind->read != nullptr) {
      kind->read(in, node);
    }
  }
}

bool gives_light(const Scene& scene) {
  const auto emits = [&](const Material& material) { return !is_black(material.emission); };
  return !is_black(scene.environment) || scene.environment_image || !scene.point_lights.empty() ||
         !scene.spot_lights.empty() || !scene.distant_lights.empty() ||
         std::any_of(scene.materials.begin(), scene.materials.end(), emits);
}

void check_whole(MitsubaReader& in) {
  Scene& scene = in.imported.scene;
  const XmlNode& root = in.document.root;
  if (scene.shapes.empty() && scene.instances.empty() && in.errors.empty()) {
    in.error(root.place, "this scene has no shape that can be read");
    return;
  }
  if (first(root, "sensor") == nullptr && first(root, "camera") == nullptr) {
    scene.camera = frame(scene.shapes);
    in.guessed(root.place, "no sensor: placed one in front of the bounding box, on the z axis");
  }
  // Faithful darkness would cost more than it gives: exported rooms have walls that face outwards, and their reference
  // pictures come from renderers that light both sides.
  if (!in.one_sided.empty()) {
    in.guessed(in.one_sided.front()->place, count(in.one_sided.size(), "bsdf") +
                                                " outside \"twosided\": black from behind in Mitsuba, "
                                                "read as reflecting on both sides");
  }
  if (!gives_light(scene)) {
    in.guessed(root.place, "nothing gives light: the picture will be black");
  }
}

/// By place in the text; errors of meshes stay behind those of the scene.
void sort_errors(const XmlDocument& document, std::vector<Diagnostic>& errors) {
  const auto rank = [&](const Diagnostic& d) {
    const auto file = std::find_if(document.sources.begin(), document.sources.end(),
                                   [&](const XmlSource& source) { return source.name == d.source; });
    const bool is_scene = file != document.sources.end();
    return std::tuple(file - document.sources.begin(), is_scene ? d.line : 0, is_scene ? d.column : 0);
  };
  std::stable_sort(errors.begin(), errors.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
}

}  // namespace

Imported read_mitsuba_scene(const std::filesystem::path& path) {
  const XmlDocument document = read_mitsuba_document(path);
  MitsubaReader in(document);
  in.imported.scene.name = path.stem().string();
  in.imported.scene.title = path.filename().string();
  read_elements(in);
  check_whole(in);
  if (!in.errors.empty()) {
    sort_errors(document, in.errors);
    throw InputError(std::move(in.errors));
  }
  in.imported.account.understood.push_back(count(in.imported.scene.shapes.size(), "shape"));
  return std::move(in.imported);
}

std::string mitsuba_plugin_reference() {
  std::string out;
  for (const auto& facts : {bsdf_facts(), texture_facts(), shape_facts(), light_facts(), sensor_facts(), filter_facts(),
                            integrator_facts()}) {
    out += (out.empty() ? "| " : "\n| ") + std::string(facts.front().tag) + " | read as |\n|---|---|\n";
    for (const MitsubaPluginFacts& plugin : facts) {
      out += "| " + std::string(plugin.type) + " | " + std::string(plugin.meaning) + " |\n";
    }
  }
  return out;
}

}  // namespace heckbert::import
