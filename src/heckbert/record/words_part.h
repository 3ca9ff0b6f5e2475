#pragma once
// The part "words" of a record's file: what each batch of samples says of each word, for interval estimates. It is a
// deep image, like the paths: pixel number w, row by row, is word w, and has a sample per batch that saw light, with
// channels batch (uint), R, G, B (float; the picture mean as that batch alone estimates it) and count0, count1 (uint;
// the low and high half of the word's contributions, told with its first batch). Not an attribute, because attributes
// are neither packed nor skipped: of 40 000 words most were seen in a few batches. Private to the layer.

#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>

#include <cstdint>

#include <heckbert/record/record.h>

namespace heckbert::record::exr {

inline constexpr const char* kWordsPart = "words";

/// Takes: a record with words; without, there is no such part.
Imf::Header words_header(const Record& record);
void write_words(Imf::MultiPartOutputFile& file, int part, const Record& record);

/// Reads counts and batch means of the record's words. Errors: std::runtime_error with the reason.
void read_words(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record);

}  // namespace heckbert::record::exr
