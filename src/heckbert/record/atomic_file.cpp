#include <heckbert/record/atomic_file.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include <heckbert/taxonomy/error.h>

namespace heckbert::record {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw WriteError(fmt::format("cannot write '{}': {}", path.string(), reason));
}

std::string system_reason(int error) {
  return std::generic_category().message(error);
}

/// Opens the file anew, so that the system's reason is known when it cannot be.
std::ofstream create(const fs::path& path, const fs::path& target) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (!file) fail(target, system_reason(errno));
  return file;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : target_(target) {
  std::error_code ignored;
  if (fs::is_symlink(target, ignored) && fs::exists(target, ignored)) target_ = fs::canonical(target, ignored);
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status) || !target_.has_filename()) fail(target, system_reason(EISDIR));
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(target, "exists and is not a regular file");
  temporary_ = target_;
  temporary_ += fmt::format(".tmp-{}", getpid());
  create(temporary_, target);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(target_, error.message());
  committed_ = true;
}

void write_file(std::string_view bytes, const fs::path& path) {
  AtomicFile file(path);
  std::ofstream out = create(file.temporary(), path);
  errno = 0;
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) fail(path, system_reason(errno));
  file.commit();
}

}  // namespace heckbert::record
