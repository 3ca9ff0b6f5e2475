// Paths of another renderer, as text and as binary. What can be read holds what a record holds: it is written to a file
// and read again as the same record.

#include <sstream>
#include <string>

#include <heckbert/record/file.h>
#include <heckbert/record/path_stream.h>
#include <heckbert/record/path_stream_header.h>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace heckbert;
  const std::string text(fuzz::text_of(data, size));
  std::istringstream beginning(text), whole(text);
  record::StreamLines lines(beginning, "fuzz");
  const auto header = fuzz::answer([&] { return record::read_path_stream_header(lines); });
  // A record has room for every pixel of its picture, which takes long and finds nothing.
  constexpr std::size_t kLargePicture = 1 << 12;
  if (header && header->info.window.pixel_count() > kLargePicture) return 0;
  const auto record = fuzz::answer([&] { return record::read_path_stream(whole, "fuzz"); });
  fuzz::require(header.has_value() || !record.has_value(), "a record without a header");
  if (!record) return 0;
  const auto& file = fuzz::scratch_file("", ".exr");
  record::write_record(*record, file);
  fuzz::require(record::read_record(file) == *record, "written and read back as another record");
  return 0;
}
