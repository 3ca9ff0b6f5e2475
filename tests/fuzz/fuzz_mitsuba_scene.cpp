// Mitsuba's XML scenes.

#include <heckbert/import/import.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto& file = fuzz::scratch_file(fuzz::text_of(data, size), ".xml");
  fuzz::answer([&] { return import::read_mitsuba_scene(file); });
  return 0;
}
