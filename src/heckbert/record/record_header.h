#pragma once
// What the header of a record's first part says: all that is known of the picture as a whole, except the batches
// (words_part.h). Private to the layer: it shows OpenEXR's types.

#include <OpenEXR/ImfHeader.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <heckbert/record/record.h>

namespace heckbert::record::exr {

/// Throws std::runtime_error with the reason; reading() adds the file.
inline void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

/// Header of a part that belongs to a picture.
Imf::Header part_header(const RenderInfo& info, const char* name, const std::string& type, const Window& window);

/// Writes layout version, words, tally.
void insert_totals(Imf::Header& header, const Record& record);

/// Throws std::runtime_error unless this is the header of a record that can be read.
void check_layout(const Imf::Header& header);
/// A record with its info, tally and words. Errors: std::runtime_error.
Record read_totals(const Imf::Header& header, std::uint64_t file_bytes);

}  // namespace heckbert::record::exr
