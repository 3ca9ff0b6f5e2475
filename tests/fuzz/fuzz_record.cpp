// Record files. What can be read is written and read again as the same record.

#include <heckbert/record/file.h>

#include "readers.h"

#ifdef HECKBERT_IS_SANITIZED
// OpenEXR 3.1.5 forgets the headers of a file that ends before its table of chunks. The leak is its own.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOpenEXR\n";
}
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const auto& file = fuzz::scratch_file(fuzz::text_of(data, size), ".exr");
  fuzz::answer([&] { return record::read_layers(file); });
  const auto record = fuzz::answer([&] { return record::read_record(file); });
  if (!record) return 0;
  record::write_record(*record, file);
  fuzz::require(record::read_record(file) == *record, "written and read back as another record");
  return 0;
}
