#pragma once
// The part "paths" of a record's file: by pixel and word, energy and count, in either precision. Private to the layer:
// it shows OpenEXR's types.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include <heckbert/record/deep_rows.h>
#include <heckbert/record/record.h>

namespace heckbert::record::exr {

/// Structs as they go to the file; the first four bytes are the word.
DeepLayout paths_layout(Precision precision);
/// Appends the struct of an entry.
void append_entry(std::vector<char>& structs, Precision precision, const Entry& entry);
/// Counts what half precision cannot hold of an energy.
void count_rounding(Tally& tally, Rgb energy);

/// Writes a file: `record` is the record, but its pixels come from `fill` (see write_deep). Errors: WriteError.
void write_record_file(const Record& record, const std::function<void(DeepBand&)>& fill,
                       const std::filesystem::path& path);

/// Reads offsets and entries. Errors: std::runtime_error with the reason.
void read_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record);

}  // namespace heckbert::record::exr
