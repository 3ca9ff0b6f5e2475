#pragma once
// What all fuzz targets do: read a text, and accept exactly the errors that a reader may give.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include <heckbert/taxonomy/error.h>

namespace heckbert::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program, which libFuzzer takes as a finding, with a word on what is wrong.
[[noreturn]] inline void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}
inline void require(bool holds, const char* otherwise) {
  if (!holds) fail(otherwise);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HECKBERT_IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HECKBERT_IS_SANITIZED 1
#endif
#endif
/// Seconds that reading may take, of this program's own time: other work on the machine counts for nothing.
#ifdef HECKBERT_IS_SANITIZED
inline constexpr double kLongestReading = 15;
#else
inline constexpr double kLongestReading = 1;
#endif

/// Fails when its scope took longer than a reading may.
class Clocked {
 public:
  Clocked() = default;
  Clocked(const Clocked&) = delete;
  Clocked& operator=(const Clocked&) = delete;
  ~Clocked() {
    require(static_cast<double>(std::clock() - begin_) < kLongestReading * CLOCKS_PER_SEC, "reading took too long");
  }

 private:
  std::clock_t begin_ = std::clock();
};

/// What `read` gives, or nothing when the text is wrong. Fails when it throws anything but the user's errors, or an
/// error that says nothing or points beside the text, or when it takes too long. What is done with the answer belongs
/// outside: there an error is a finding.
template <class Read>
auto answer(Read read) -> std::optional<decltype(read())> {
  const Clocked clocked;
  try {
    return read();
  } catch (const InputError& error) {
    require(!error.diagnostics().empty(), "an error without a diagnostic");
    for (const Diagnostic& d : error.diagnostics()) {
      require(!d.message.empty(), "a diagnostic without a message");
      require(d.line == 0 || (d.column != 0 && d.length != 0), "a diagnostic without a place in its line");
    }
  } catch (const ReadError& error) {
    require(*error.what() != 0, "an error without a message");
  } catch (const LimitError& error) {
    require(*error.what() != 0, "an error without a message");
  }
  return std::nullopt;
}

/// A file with these bytes, for readers that take a path; gone when the program ends.
inline const std::filesystem::path& scratch_file(std::string_view bytes, std::string_view ending) {
  struct Scratch {
    std::filesystem::path folder, file;
    explicit Scratch(std::string_view end) {
      std::string name = (std::filesystem::temp_directory_path() / "heckbert-fuzz-XXXXXX").string();
      require(mkdtemp(name.data()) != nullptr, "no scratch folder");
      folder = name;
      file = folder / ("input" + std::string(end));
    }
    ~Scratch() {
      std::error_code ignored;
      std::filesystem::remove_all(folder, ignored);
    }
  };
  static const Scratch scratch(ending);
  std::ofstream(scratch.file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return scratch.file;
}

}  // namespace heckbert::fuzz
