#pragma once
// Files as the command line names them: "-" is standard input or output.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <heckbert/record/file.h>

namespace heckbert::cli {

/// The whole text of a file or of standard input. Errors: ReadError.
std::string read_text(const std::string& name);

/// A record from a file or from standard input. Errors: ReadError.
record::Record read_record(const std::string& name);

/// One whose pixels are read when they are looked at. Errors: ReadError.
record::RecordFile open_record(const std::string& name);

/// A record without pixels, see record::read_record_totals().
record::Record read_record_totals(const std::string& name);

/// A record that keeps its sums, to be read a band of rows at a time. Errors: ReadError.
record::SumsStream open_sums(const std::string& name);

/// Throws WriteError unless a file of this name can be made: asked before long work, so that it is not done in vain.
void check_writable(const std::string& name);

/// Makes the folder if it is not there. Errors: WriteError, also when nothing can be written into it.
void make_writable_folder(const std::string& name);

/// Writes a file, whole or not at all. Errors: WriteError.
void write_bytes(const std::string& name, std::string_view bytes);

/// Calls `write` with the path to write to. For "-" that is a temporary file, whose bytes then go to standard output
/// (an EXR is not written front to back, so it cannot go there directly). Errors: WriteError.
void write_to(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);

}  // namespace heckbert::cli
