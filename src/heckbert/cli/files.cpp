#include <heckbert/cli/files.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/file.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

namespace fs = std::filesystem;

std::string reason() {
  return std::strerror(errno);
}

/// A folder of our own that goes away with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "heckbert-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw WriteError(fmt::format("{}: {}", name, reason()));
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string read_stream(std::istream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Calls `read` with the path to read from; for "-", that of a copy.
template <class T>
T read_from(const std::string& name, T (*read)(const fs::path&)) {
  if (name != "-") return read(name);
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "standard input";
  std::ofstream(copy, std::ios::binary) << std::cin.rdbuf();
  return read(copy);
}

}  // namespace

std::string read_text(const std::string& name) {
  if (name == "-") return read_stream(std::cin);
  if (fs::is_directory(name)) throw ReadError(name + ": is a folder, not a file");
  std::ifstream file(name, std::ios::binary);
  if (!file) throw ReadError(fmt::format("{}: {}", name, reason()));
  std::string text = read_stream(file);
  if (file.bad()) throw ReadError(fmt::format("{}: {}", name, reason()));
  return text;
}

record::Record read_record(const std::string& name) {
  return read_from(name, record::read_record);
}

record::RecordFile open_record(const std::string& name) {
  return read_from<record::RecordFile>(name, [](const fs::path& path) { return record::RecordFile(path); });
}

record::Record read_record_totals(const std::string& name) {
  return read_from(name, record::read_record_totals);
}

record::SumsStream open_sums(const std::string& name) {
  return read_from(name, record::open_sums);
}

void check_writable(const std::string& name) {
  if (name == "-") return;
  const fs::path path(name);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::is_directory(path)) throw WriteError(name + ": is a folder; expected the name of a file");
  if (fs::exists(path) && !fs::is_regular_file(path))
    throw WriteError(name + ": is there and is no file; '-' is standard output");
  if (!fs::exists(folder)) throw WriteError(fmt::format("{}: there is no folder {}", name, folder.string()));
  if (!fs::is_directory(folder)) throw WriteError(fmt::format("{}: {} is not a folder", name, folder.string()));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw WriteError(fmt::format("{}: cannot write into {}: {}", name, folder.string(), reason()));
}

void make_writable_folder(const std::string& name) {
  std::error_code error;
  fs::create_directories(name, error);
  if (!error && !fs::is_directory(name)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw WriteError(fmt::format("{}: cannot make this folder: {}", name, error.message()));
  if (access(name.c_str(), W_OK | X_OK) != 0)
    throw WriteError(fmt::format("{}: cannot write into it: {}", name, reason()));
}

void write_bytes(const std::string& name, std::string_view bytes) {
  if (name != "-") return record::write_file(bytes, name);
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size())
    throw WriteError("standard output: " + reason());
}

void write_to(const std::string& name, const std::function<void(const std::filesystem::path&)>& write) {
  if (name != "-") return write(name);
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "standard output";
  write(copy);
  write_bytes(name, read_text(copy.string()));
}

}  // namespace heckbert::cli
