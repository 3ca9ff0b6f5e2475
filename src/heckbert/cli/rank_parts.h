#pragma once
// What the ranks of mpirun found comes together at rank 0. Ranks may be on machines that share no files, so parts are
// sent as files, in pieces; and they are added up a band of rows at a time, so that no rank ever holds a record.

#include <optional>
#include <string>

#include <heckbert/cli/ranks.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::cli {

/// "room.paths.exr.part-3-of-8"
std::string name_of_part(const std::string& output, const record::Part& part);

/// A rank of several has traced its part: writes it as the file `kept` and brings all parts together at rank 0, where
/// the sums of all come back, which read files that are gone with them. The files of the parts stay until all is
/// written, for others to merge when this job does not come to its end. Errors: WriteError, ReadError.
std::optional<record::SumsStream> share(const Ranks& ranks, record::SumsStream part, const std::string& kept);

/// Rank 0 tells the others that everything is written, and every rank removes its part.
void part_from(const Ranks& ranks, const std::string& kept);

}  // namespace heckbert::cli
