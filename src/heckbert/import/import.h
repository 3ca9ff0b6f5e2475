#pragma once
// Files to scenes. load_scene looks at the file's ending; every importer also says what it made of the file.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/transport/scene.h>

namespace heckbert::import {

/// What an importer did with the file, in sentences for people, in file order.
struct Account {
  std::vector<std::string> understood;  ///< "material 'mirror': illum 5, mirror lobe 0.95"
  std::vector<std::string> guessed;     ///< "no camera: placed one in front of the bounding box"
  std::vector<std::string> ignored;     ///< "map_Kd wood.png: textures are not read"
};

struct Imported {
  transport::Scene scene;
  Account account;
};

/// Reads a scene by its ending: .json (docs/scene-format.md), .obj (docs/obj-import.md) or .xml (Mitsuba's,
/// docs/mitsuba-import.md).
/// Errors: InputError with all errors of the file; ReadError when it cannot be read or the format is unknown.
Imported load_scene(const std::filesystem::path& path);

/// A built-in scene, from scenes/ at build time: its name, one line about it, and its JSON text.
struct BuiltinScene {
  std::string_view name;
  std::string_view title;
  std::string_view json;
};
const std::vector<BuiltinScene>& builtin_scenes();

/// A built-in scene by name, or else a file. Errors: as load_scene; an unknown name suggests the nearest built-in.
Imported load_scene_or_builtin(const std::string& name_or_path);

/// Reads the native format from memory. `source` names the text in errors; relative paths resolve against `directory`.
Imported read_json_scene(std::string_view text, std::string_view source, const std::filesystem::path& directory);
Imported read_obj_scene(const std::filesystem::path& path);
Imported read_mitsuba_scene(const std::filesystem::path& path);

}  // namespace heckbert::import
