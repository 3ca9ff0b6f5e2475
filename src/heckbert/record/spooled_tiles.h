#pragma once
// The entries of tiles in a temporary file, to be read back a row of the picture at a time. Tiles may overlap. What
// stays in memory are 24 bytes for each row of a tile. Private to the layer.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <heckbert/record/recorder.h>
#include <heckbert/record/spool_file.h>

namespace heckbert::record {

class SpooledTiles {
 public:
  /// Of a picture's window; the file lies beside `target`. Errors: WriteError, as from all of these.
  SpooledTiles(const Window& picture, const std::filesystem::path& target);

  /// Takes: the number of entries by pixel of the window, and entries pixel by pixel. Not thread-safe.
  void append(const Window& window, std::span<const std::uint32_t> counts, std::span<const EntrySum> entries);
  std::uint64_t bytes() const { return file_.bytes(); }

  /// What one tile has of one row.
  struct Piece {
    int x0 = 0;
    std::vector<std::uint32_t> counts;  ///< of entries, by pixel from x0 on
    std::uint64_t entries = 0;          ///< their place in the file
  };
  /// Those of row y, in the order in which their tiles came.
  std::vector<Piece> pieces(int y) const;
  void read(const Piece& piece, std::vector<EntrySum>& entries) const;

 private:
  struct RowOfTile {
    std::uint64_t counts = 0, entries = 0;  ///< their places in the file
    std::int32_t x0 = 0, x1 = 0;
  };

  Window picture_;
  SpoolFile file_;
  std::vector<std::vector<RowOfTile>> rows_;  ///< by row of the picture
};

}  // namespace heckbert::record
