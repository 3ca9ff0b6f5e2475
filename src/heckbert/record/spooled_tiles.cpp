#include <heckbert/record/spooled_tiles.h>

#include <numeric>

namespace heckbert::record {

namespace {

template <class T>
std::span<const char> bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
template <class T>
std::span<char> bytes_of(std::vector<T>& values) {
  return {reinterpret_cast<char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

SpooledTiles::SpooledTiles(const Window& picture, const std::filesystem::path& target)
    : picture_(picture), file_(target), rows_(static_cast<std::size_t>(picture.height())) {}

void SpooledTiles::append(const Window& window, std::span<const std::uint32_t> counts,
                          std::span<const EntrySum> entries) {
  const auto width = static_cast<std::size_t>(window.width());
  std::uint64_t counts_place = file_.append(bytes_of(counts)), entries_place = file_.append(bytes_of(entries));
  for (int y = window.y0; y < window.y1; ++y) {
    const auto of_row = counts.first(width);
    if (const auto entry_count = std::accumulate(of_row.begin(), of_row.end(), std::uint64_t{0}); entry_count > 0) {
      rows_[static_cast<std::size_t>(y - picture_.y0)].push_back({counts_place, entries_place, window.x0, window.x1});
      entries_place += entry_count * sizeof(EntrySum);
    }
    counts_place += of_row.size_bytes();
    counts = counts.subspan(width);
  }
}

std::vector<SpooledTiles::Piece> SpooledTiles::pieces(int y) const {
  std::vector<Piece> pieces;
  for (const RowOfTile& row : rows_[static_cast<std::size_t>(y - picture_.y0)]) {
    Piece piece{row.x0, std::vector<std::uint32_t>(static_cast<std::size_t>(row.x1 - row.x0)), row.entries};
    file_.read(row.counts, bytes_of(piece.counts));
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void SpooledTiles::read(const Piece& piece, std::vector<EntrySum>& entries) const {
  entries.resize(std::accumulate(piece.counts.begin(), piece.counts.end(), std::size_t{0}));
  file_.read(piece.entries, bytes_of(entries));
}

}  // namespace heckbert::record
