#pragma once
// The parts of a record's file that keep its sums, beside the means that everyone reads: what is needed to add records
// up exactly (sums.h). Private to the layer: it shows OpenEXR's types.
//
//   sums            deep, as "paths": a sample per word, each sum as four uint channels, R0 (lowest) to B3
//   samples         flat: taken by pixel, uint
//   batches         flat: a row per word, a column per batch; paths as count0 and count1, sums as above
//   ambient sums, phantom sums    flat, where there is any

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>

#include <cstdint>
#include <vector>

#include <heckbert/record/sums.h>

namespace heckbert::record::exr {

/// The headers of the parts, in the order of write_sums_parts.
std::vector<Imf::Header> sums_headers(const Sums& sums);
/// Writes the parts, the first of which has number `first`.
void write_sums_parts(Imf::MultiPartOutputFile& file, int first, const Sums& sums);

/// Whether the file keeps sums.
bool has_sums(const Imf::MultiPartInputFile& file);
/// The sums of what has been read as `record`. Errors: std::runtime_error with the reason.
Sums read_sums_parts(Imf::MultiPartInputFile& file, const Record& record);

}  // namespace heckbert::record::exr
