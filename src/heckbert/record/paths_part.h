#pragma once
// The part "paths" of a record's file: by pixel and word, energy and count, in either precision. Private to the layer:
// it shows OpenEXR's types.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include <heckbert/record/deep_chunk.h>
#include <heckbert/record/deep_rows.h>
#include <heckbert/record/record.h>
#include <heckbert/record/rows.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::record::exr {

/// Structs as they go to the file; the first four bytes are the word.
DeepLayout paths_layout(Precision precision);
/// Appends the struct of an entry.
void append_entry(std::vector<char>& structs, Precision precision, const Entry& entry);
/// Counts what half precision cannot hold of an energy.
void count_rounding(Tally& tally, Rgb energy);

/// Fills bands (see write_deep) with the means of sums, once from the top downwards. The stream must outlive it.
std::function<void(DeepBand&)> means_of_bands(const SumsStream& sums, Precision precision);

/// Writes a file: `record` is the record, but its pixels come from `fill` (see write_deep). With `sums`, which they are
/// the means of, their parts too. Errors: WriteError; ReadError from where the pixels come from.
void write_record_file(const Record& record, const std::function<void(DeepBand&)>& fill, const SumsStream* sums,
                       const std::filesystem::path& path);
/// All but offsets and entries. Errors: std::runtime_error with the reason.
Record read_file_totals(Imf::MultiPartInputFile& file, std::uint64_t file_bytes);

/// Reads rows and throws unless they keep the promises of Record; each thread has its own.
class PathRowReader {
 public:
  PathRowReader(const Imf::DeepScanLineInputPart& part, std::size_t words);
  /// Takes: the offsets of the row's pixels, and room for its entries. Errors: std::runtime_error with the reason.
  void read(int y, std::span<const std::size_t> offsets, std::span<Entry> entries);
  /// By word, contributions in the rows that were read.
  const std::vector<std::uint64_t>& counts() const { return counts_; }

 private:
  void check(std::span<const Entry> pixel);

  DeepRowReader reader_;
  std::vector<std::uint64_t> counts_;
};
/// Throws std::runtime_error unless the counts of all rows are those of the record.
void check_counts(const std::vector<std::uint64_t>& counts, const Record& totals);
/// The offsets of all pixels. Errors: std::runtime_error with the reason, also when the file cannot hold so many
/// entries.
std::vector<std::size_t> read_path_offsets(const Imf::DeepScanLineInputPart& part, std::uint64_t file_bytes);

/// Reads offsets and entries. Errors: std::runtime_error with the reason.
void read_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record);
/// Shows them, a row at a time. Takes: the record that they are of, with its words and counts.
/// Errors: std::runtime_error with the reason, when some rows may have been shown.
void visit_paths(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, const Record& record,
                 const RowVisitor& visit);

}  // namespace heckbert::record::exr
