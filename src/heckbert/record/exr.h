#pragma once
// What the files of this layer have in common: render information as header attributes, window and box, failures of
// OpenEXR as our errors. Private to the layer: it shows OpenEXR's types.

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>

#include <heckbert/record/record.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::record::exr {

/// Threads for one file. OpenEXR's pool belongs to the process and starts without workers: it gets one per processor
/// the first time, unless the program has chosen a number of its own.
int threads();

Window window_of(const Imath::Box2i& box);
Imath::Box2i box_of(const Window& window);

/// A header with the picture's size and window and all of `info`.
Imf::Header header_for(const RenderInfo& info);
/// Errors: std::runtime_error naming the attribute.
RenderInfo info_of(const Imf::Header& header);

/// The value of an attribute of type A. Errors: std::runtime_error naming it.
template <class A>
const auto& attribute(const Imf::Header& header, const std::string& name) {
  if (const A* found = header.findTypedAttribute<A>(name)) return found->value();
  throw std::runtime_error(fmt::format("the header attribute '{}' is missing or of another type", name));
}

/// A number that an attribute spells out, OpenEXR having none of 64 bits or more. Errors: std::runtime_error naming it.
std::uint64_t parse_number(const std::string& digits, const std::string& name);
Quanta parse_quanta(const std::string& digits, const std::string& name);

/// Adds slices for R, G and B of pixels over `window`, under the channel prefix ("" or "name.").
void insert_rgb(Imf::FrameBuffer& frame, const std::string& prefix, const Rgb* pixels, const Window& window);
void insert_rgb(Imf::ChannelList& channels, const std::string& prefix);

/// A file that OpenEXR writes. Its own streams tell nobody when the last bytes find no place on the disk.
class OutputStream final : public Imf::OStream {
 public:
  /// Errors: std::runtime_error with the system's reason, as from all of its functions.
  explicit OutputStream(const std::filesystem::path& path);
  void write(const char bytes[], int count) override;
  std::uint64_t tellp() override;
  void seekp(std::uint64_t place) override;
  /// Call when OpenEXR is done: a file is written only when this has returned.
  void close();

 private:
  void check();

  std::ofstream file_;
  int error_ = 0;  ///< the first one: OpenEXR goes on after it
};

/// False for a size that no file of `file_bytes` can unpack to, so that a damaged header cannot make us allocate it.
/// Deflate packs at most 1032 to 1 (zlib technical details).
bool can_unpack_to(std::uint64_t unpacked_bytes, std::uint64_t file_bytes);

/// Throws std::runtime_error unless the path is a readable OpenEXR file whose header fits in it; gives its size in
/// bytes.
std::uint64_t check_is_exr(const std::filesystem::path& path);

/// Runs `read`; whatever it throws becomes a ReadError naming the file.
template <class F>
auto reading(const std::filesystem::path& path, F read) {
  std::string reason;
  try {
    return read();
  } catch (const std::bad_alloc&) {
    reason = "not enough memory";
  } catch (const std::exception& error) {
    reason = error.what();
  }
  throw ReadError(fmt::format("cannot read '{}': {}", path.string(), reason));
}

/// Runs `write`; whatever it throws, save a WriteError and a ReadError of what it copies, becomes a WriteError naming
/// the file.
template <class F>
void writing(const std::filesystem::path& path, F write) {
  try {
    write();
  } catch (const WriteError&) {
    throw;
  } catch (const ReadError&) {
    throw;
  } catch (const std::exception& error) {
    throw WriteError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
  }
}

}  // namespace heckbert::record::exr
