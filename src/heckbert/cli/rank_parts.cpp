#include <heckbert/cli/rank_parts.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/file.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {

namespace {

/// An empty piece is the end.
void send_file(const Ranks& ranks, int to, const std::filesystem::path& path) {
  constexpr std::size_t kPiece = 1 << 20;
  std::ifstream file(path, std::ios::binary);
  std::string piece;
  do {
    piece.resize(kPiece);
    file.read(piece.data(), static_cast<std::streamsize>(kPiece));
    if (file.bad() || !file.is_open()) throw ReadError(fmt::format("{}: {}", path.string(), std::strerror(errno)));
    piece.resize(static_cast<std::size_t>(file.gcount()));
    ranks.send(to, piece);
  } while (!piece.empty());
}

void receive_file(const Ranks& ranks, int from, const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  for (std::string piece = ranks.receive(from); !piece.empty(); piece = ranks.receive(from)) file << piece;
  if (!file.flush()) throw WriteError(fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
}

/// The sums that another rank sends. Their file has no name any more when this returns.
record::SumsStream received(const Ranks& ranks, int from, const std::string& kept) {
  const record::AtomicFile copy(fmt::format("{}.from-{}", kept, from));
  receive_file(ranks, from, copy.temporary());
  return record::open_sums(copy.temporary());
}

void send_sums(const Ranks& ranks, int to, std::vector<record::SumsStream> parts, const std::string& kept) {
  if (parts.size() == 1) return send_file(ranks, to, kept);
  const record::AtomicFile copy(fmt::format("{}.sum", kept));
  record::write_sums(record::merged(std::move(parts)), copy.temporary());
  send_file(ranks, to, copy.temporary());
}

}  // namespace

std::string name_of_part(const std::string& output, const record::Part& part) {
  return fmt::format("{}.part-{}-of-{}", output, part.number, part.of);
}

std::optional<record::SumsStream> share(const Ranks& ranks, record::SumsStream part, const std::string& kept) {
  record::write_sums(part, kept);
  if (part.info.partial) ranks.interrupt_all();
  std::vector<record::SumsStream> parts;
  parts.push_back(std::move(part));
  // Up a binary tree: as many steps as the number of ranks has bits, and the order of additions changes nothing.
  for (int step = 1; step < ranks.count(); step *= 2) {
    if (ranks.number() % (2 * step) != 0) {
      send_sums(ranks, ranks.number() - step, std::move(parts), kept);
      return {};
    }
    const int other = ranks.number() + step;
    if (other < ranks.count()) parts.push_back(received(ranks, other, kept));
  }
  return record::merged(std::move(parts));
}

void part_from(const Ranks& ranks, const std::string& kept) {
  for (int other = 1; ranks.number() == 0 && other < ranks.count(); ++other) ranks.send(other, "written");
  if (ranks.number() > 0) ranks.receive(0);
  std::filesystem::remove(kept);
}

}  // namespace heckbert::cli
