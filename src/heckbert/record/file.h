#pragma once
// Records and pictures on disk, as OpenEXR.
//
// A record is a multi-part file. Its first part, "paths", is a deep scan-line image: per pixel one deep sample per
// word, with channels id (uint), R, G, B (half or float), count (uint), and A = 0 (half), Z = 0 (float) so that
// flattening adds the samples up to the beauty. The id manifest gives every id its word as taxonomy::fine() spells it,
// and the attribute "heckbert.words" repeats the words for tools that do not show manifests; other attributes
// "heckbert.*" hold the rest, "heckbert.record" the version of this layout. The part "words" has the batches of each
// word (words_part.h). Light that no path carries follows as flat parts "ambient" and "phantom" when there is any. Any
// OpenEXR reader can recover all of it.
//
// Files are written beside their target and renamed, so a failure never leaves half a file (atomic_file.h).

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <heckbert/record/record.h>
#include <heckbert/record/rows.h>
#include <heckbert/record/sums.h>
#include <heckbert/record/sums_stream.h>

namespace heckbert::record {

/// In the precision that record.info says. Errors: WriteError with the path and the system's reason.
void write_record(const Record& record, const std::filesystem::path& path);
/// What was written, exactly; everything in the file is checked before it is believed.
/// Errors: ReadError saying what the file is instead, or where it is torn.
Record read_record(const std::filesystem::path& path);
/// The same without pixels, that is without offsets, entries, ambient and phantom light: enough for all questions about
/// the picture as a whole, at a fraction of the cost.
Record read_record_totals(const std::filesystem::path& path);

/// A record whose pixels stay in the file, to be looked at row by row: for questions to all pixels that need each only
/// once. Memory: what totals() has, eight bytes per pixel, and a row per thread.
class RecordFile {
 public:
  /// Errors: ReadError.
  explicit RecordFile(const std::filesystem::path& path);
  RecordFile(RecordFile&&) noexcept;
  RecordFile& operator=(RecordFile&&) noexcept;
  ~RecordFile();

  /// All but offsets and entries.
  const Record& totals() const;
  /// With them. Errors: ReadError.
  Record whole() const;
  /// See Rows. Errors: ReadError, also for what the visitor throws; a damaged file may show some of its rows first.
  void visit_rows(const RowVisitor& visit) const;

 private:
  struct Open;
  std::unique_ptr<Open> open_;
};
/// The file must outlive them.
Rows rows_of(const RecordFile& file);

/// A record that keeps its sums, in parts of their own ("sums", "samples", "batches"; see sums_parts.h): some 15 bytes
/// more for each pair of pixel and word. read_record() reads its means, read_sums() what can be added to. A stream is
/// gone through twice. Errors: WriteError; those of a stream.
void write_sums(const Sums& sums, const std::filesystem::path& path);
void write_sums(const SumsStream& sums, const std::filesystem::path& path);
/// The means of a stream, as write_record() would of a record in memory. Takes: its totals_of(), which say the
/// precision. The stream is gone through once. Errors: as write_sums().
void write_record(const Record& totals, const SumsStream& sums, const std::filesystem::path& path);
/// Errors: ReadError, also for a record without sums.
Sums read_sums(const std::filesystem::path& path);
/// The same, a band of rows at a time: a pass reads the file again and may find damage, ReadError. The file stays open
/// as long as the stream is there.
SumsStream open_sums(const std::filesystem::path& path);
/// Blender cuts the names of channels at 63 characters, ".R" included.
inline constexpr std::size_t kLongestLayerName = 60;

/// One named picture of a flat multi-layer EXR. The layer with an empty name is the unprefixed R, G, B.
struct Layer {
  std::string name;  ///< a legal channel prefix; see layer_name()
  Image image;
  std::map<std::string, std::string> attributes;  ///< written as header attributes "<name>.<key>"
};

/// Four numbers per pixel that are no colour, written as the channels R, G, B and A of a layer.
struct DataLayer {
  std::string name;  ///< a legal channel prefix
  std::vector<std::array<float, 4>> pixels;
};

/// What a file has beside its pictures.
struct Attachment {
  std::vector<DataLayer> layers;
  std::map<std::string, std::string> attributes;  ///< of the file
};

/// Floats, bit for bit. All layers share the window `info.window`; names are distinct. Errors: WriteError.
void write_layers(const std::vector<Layer>& layers, const RenderInfo& info, const std::filesystem::path& path,
                  const Attachment& attachment = {});

/// Reads the layers of a flat EXR, those with channels R, G and B: the unnamed one first, then by name.
/// Errors: ReadError.
std::vector<Layer> read_layers(const std::filesystem::path& path);

/// A channel prefix made of `text` that Nuke and Blender take as it is: its letters, digits and underscores, everything
/// else turned into '_' ("LS+DE" gives "LS_DE"), never starting with a digit, at most kLongestLayerName characters,
/// none of the names that Nuke has layers of its own for, with a number appended while the name is among those `taken`,
/// capital or not.
std::string layer_name(std::string_view text, const std::vector<std::string>& taken = {});

}  // namespace heckbert::record
