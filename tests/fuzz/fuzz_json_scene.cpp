// Scenes in the native format.

#include <heckbert/import/import.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  static const std::filesystem::path folder = fuzz::scratch_file("", ".json").parent_path();
  fuzz::answer([&] { return import::read_json_scene(fuzz::text_of(data, size), "fuzz.json", folder); });
  return 0;
}
