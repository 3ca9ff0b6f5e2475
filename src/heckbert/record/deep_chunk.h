#pragma once
// Rows of a deep scan-line image from the bytes that the file has of them. OpenEXR's own reader unpacks with zlib, byte
// by byte, and follows a pointer per pixel and channel; this takes half the time, which is nearly all of what a
// question to a record costs. Private to the layer: it shows OpenEXR's types.
//
// A chunk is one row: its y, the sizes of its table of sample counts, of its packed and of its unpacked values, the
// table, the values. These lie channel by channel in the order of their names. ZIPS replaces bytes by differences from
// the one before, those at even places first, and deflates. Source: "OpenEXR File Layout" and "Technical Introduction
// to OpenEXR", openexr.com.

#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfHeader.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <heckbert/record/deep_rows.h>

struct libdeflate_decompressor;

namespace heckbert::record::exr {

/// Reads rows of one part; each thread has its own.
class DeepRowReader {
 public:
  /// The file may have more channels than the layout, and halves where that has floats. Errors: std::runtime_error
  /// with the reason when it has less, and for another compression than ZIPS.
  DeepRowReader(const Imf::DeepScanLineInputPart& part, const DeepLayout& layout);

  /// Fills `count` structs with the samples of row y. Errors: std::runtime_error with the reason, also when the row has
  /// another number of samples.
  void read(int y, std::size_t count, char* structs);

 private:
  /// A channel of the file; one that is not wanted has no `scatter`.
  struct Channel {
    std::size_t bytes;
    void (*scatter)(const char* values, std::size_t count, char* field, std::size_t stride);
    std::size_t offset;  ///< of the field in the struct
  };
  struct Free {
    void operator()(libdeflate_decompressor* decompressor) const;
  };

  const char* unpacked(int y, std::size_t bytes);

  Imf::DeepScanLineInputPart part_;
  std::size_t table_bytes_, struct_bytes_;
  std::size_t sample_bytes_ = 0;   ///< of one sample in the file
  std::vector<Channel> channels_;  ///< in the order of the file
  std::unique_ptr<libdeflate_decompressor, Free> decompressor_;
  std::vector<char> chunk_, differences_, values_;
};

}  // namespace heckbert::record::exr
