#include <heckbert/import/text_file.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <heckbert/taxonomy/error.h>

namespace heckbert::import {

std::string read_text_file(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw ReadError(path.string() + ": cannot read: it is a folder");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file && file.peek() != std::ifstream::traits_type::eof()) {
    text << file.rdbuf();
  }
  if (!file.is_open() || file.bad() || text.fail()) {
    throw ReadError(path.string() + ": cannot read: " + std::strerror(errno != 0 ? errno : EIO));
  }
  return text.str();
}

}  // namespace heckbert::import
