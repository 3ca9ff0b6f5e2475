#pragma once
// The parts of a record's file that keep its sums, beside the means that everyone reads: what is needed to add records
// up exactly (sums.h). Private to the layer: it shows OpenEXR's types.
//
//   sums            deep, as "paths": a sample per word, each sum as four uint channels, R0 (lowest) to B3
//   samples         flat: taken by pixel, uint
//   batches         flat: a row per word, a column per batch; paths as count0 and count1, sums as above
//   ambient sums, phantom sums    flat, where there is any

#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>

#include <vector>

#include <heckbert/record/deep_rows.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::record::exr {

/// The headers of the parts, in the order of write_sums_parts.
std::vector<Imf::Header> sums_headers(const SumsStream& sums);
/// Writes the parts, the first of which has number `first`.
void write_sums_parts(Imf::MultiPartOutputFile& file, int first, const SumsStream& sums);

/// The part that has the sums of entries. Errors: std::runtime_error for a file that keeps none.
Imf::DeepScanLineInputPart sums_part(Imf::MultiPartInputFile& file);
/// Of its rows, EntrySums without word and count.
DeepLayout entry_sums_layout();
/// The rest of the sums of what has been read as `totals`. Errors: std::runtime_error with the reason.
Tile read_sums_totals(Imf::MultiPartInputFile& file, const Record& totals);

}  // namespace heckbert::record::exr
