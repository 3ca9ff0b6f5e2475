#include <algorithm>
#include <cctype>

#include <heckbert/import/import.h>
#include <heckbert/import/text_file.h>
#include <heckbert/import/words.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::import {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Imported named(Imported imported, const std::string& name) {
  if (imported.scene.name.empty()) {
    imported.scene.name = name;
  }
  return imported;
}

}  // namespace

Imported load_scene(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  if (ending == ".json") {
    return named(read_json_scene(read_text_file(path), path.string(), path.parent_path()), path.stem().string());
  }
  if (ending == ".obj") {
    return named(read_obj_scene(path), path.stem().string());
  }
  if (ending == ".xml") {
    return read_mitsuba_scene(path);
  }
  throw ReadError(path.string() + ": unknown kind of scene file, expected .json, .obj or .xml");
}

Imported load_scene_or_builtin(const std::string& name_or_path) {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name == name_or_path) {
      return read_json_scene(scene.json, scene.name, {});
    }
    names.emplace_back(scene.name);
  }
  const std::filesystem::path path(name_or_path);
  if (path.has_extension() || path.has_parent_path() || std::filesystem::exists(path)) {
    return load_scene(path);
  }
  const std::string near = nearest(name_or_path, names);
  throw ReadError("no scene \"" + name_or_path + "\": neither a file nor a built-in scene; " +
                  (near.empty() ? "built in are " + join(names) : "did you mean \"" + near + "\"?"));
}

}  // namespace heckbert::import
