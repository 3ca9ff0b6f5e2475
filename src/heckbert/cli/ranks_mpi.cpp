// Ranks with MPI.

#include <mpi.h>

#include <algorithm>
#include <cstdint>

#include <heckbert/cli/exit_code.h>
#include <heckbert/cli/launcher.h>
#include <heckbert/cli/ranks.h>

namespace heckbert::cli {
namespace {

constexpr int kTag = 1;
constexpr std::uint64_t kMostAtOnce = 1u << 30;  // MPI counts in int

}  // namespace

Ranks::Ranks() {
  if (!is_launched()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &number_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

void Ranks::send(int to, const std::string& bytes) const {
  const std::uint64_t size = bytes.size();
  MPI_Send(&size, 1, MPI_UINT64_T, to, kTag, MPI_COMM_WORLD);
  for (std::uint64_t at = 0; at < size; at += kMostAtOnce)
    MPI_Send(bytes.data() + at, static_cast<int>(std::min(kMostAtOnce, size - at)), MPI_BYTE, to, kTag, MPI_COMM_WORLD);
}

std::string Ranks::receive(int from) const {
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, from, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  std::string bytes(size, '\0');
  for (std::uint64_t at = 0; at < size; at += kMostAtOnce)
    MPI_Recv(bytes.data() + at, static_cast<int>(std::min(kMostAtOnce, size - at)), MPI_BYTE, from, kTag,
             MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return bytes;
}

void Ranks::leave() {
  int initialized = 0, finalized = 0;
  MPI_Initialized(&initialized);
  MPI_Finalized(&finalized);
  if (initialized != 0 && finalized == 0) MPI_Finalize();
}

void Ranks::interrupt_all() const {
  if (count_ > 1) MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ExitCode::Interrupted));
}

}  // namespace heckbert::cli
