#pragma once
// A file that is there whole or not at all. What is written goes to "<target>.tmp-<process id>" beside the target;
// commit renames it, and anything that goes wrong before removes it again.

#include <filesystem>
#include <string_view>

namespace heckbert::record {

class AtomicFile {
 public:
  /// Creates the temporary file, empty. A symbolic link is followed; its target is what will be replaced.
  /// Errors: WriteError with the path and the system's reason (no such folder, no permission, is a directory), also
  /// when the target exists and is something that must not be replaced, such as a device.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }  ///< write here
  void commit();                                                         ///< Errors: WriteError.

 private:
  std::filesystem::path target_, temporary_;
  bool committed_ = false;
};

/// Writes all of `bytes` as the file `path`. Errors: WriteError.
void write_file(std::string_view bytes, const std::filesystem::path& path);

}  // namespace heckbert::record
