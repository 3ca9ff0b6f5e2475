#pragma once
// A file for bytes that do not fit into memory: it has no name, so nothing of it is left whatever happens.

#include <cstdint>
#include <filesystem>
#include <span>

namespace heckbert::record {

class SpoolFile {
 public:
  /// Lies beside `target`, which errors name. Errors: WriteError with the system's reason, as from all of these.
  explicit SpoolFile(const std::filesystem::path& target);
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  /// Gives the place where the bytes begin. Not thread-safe.
  std::uint64_t append(std::span<const char> bytes);
  std::uint64_t bytes() const { return size_; }
  /// Takes: a place from append() and as many bytes as lie from there on.
  void read(std::uint64_t place, std::span<char> bytes) const;

 private:
  std::filesystem::path target_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace heckbert::record
