#include <heckbert/record/spool_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <heckbert/taxonomy/error.h>

namespace heckbert::record {

namespace {

[[noreturn]] void fail(const std::filesystem::path& target, int error) {
  throw WriteError(fmt::format("cannot write '{}': {}", target.string(), std::generic_category().message(error)));
}

}  // namespace

SpoolFile::SpoolFile(const std::filesystem::path& target) : target_(target) {
  std::string name = target.string() + ".spool-XXXXXX";
  file_ = mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0 || unlink(name.c_str()) != 0) fail(target_, errno);
}

SpoolFile::~SpoolFile() {
  close(file_);
}

std::uint64_t SpoolFile::append(std::span<const char> bytes) {
  const std::uint64_t place = size_;
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(target_, errno);
    size_ += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return place;
}

void SpoolFile::read(std::uint64_t place, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(target_, got == 0 ? EIO : errno);
    place += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

}  // namespace heckbert::record
