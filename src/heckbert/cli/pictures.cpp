#include <heckbert/cli/pictures.h>

#include <cstddef>
#include <vector>

namespace heckbert::cli {

std::string png_of(const report::Picture& picture) {
  const std::vector<std::byte> bytes = report::encode_png(picture);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string png_of(const record::Image& image, float exposure) {
  return png_of(report::to_srgb(image, exposure));
}

}  // namespace heckbert::cli
