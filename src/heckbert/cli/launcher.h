#pragma once
// Whether the program is one of several that mpirun or the like has started together.

#include <cstdlib>
#include <string_view>

namespace heckbert::cli {

/// Asks the variables by which Open MPI, MPICH and Slurm tell a process how many there are.
inline bool is_launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* count = std::getenv(name); count != nullptr && std::string_view(count) != "1") return true;
  return false;
}

}  // namespace heckbert::cli
