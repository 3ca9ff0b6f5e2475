// Ranks without MPI.

#include <stdexcept>

#include <heckbert/cli/launcher.h>
#include <heckbert/cli/ranks.h>

namespace heckbert::cli {

Ranks::Ranks() {
  if (is_launched())
    throw std::runtime_error(
        "this heckbert was built without MPI, so that every process would do the whole work; build it with "
        "libopenmpi-dev "
        "(docs/machines.md), or give each process a part of its own: --part I/N");
}

void Ranks::send(int, const std::string&) const {}
std::string Ranks::receive(int) const {
  return {};
}
void Ranks::leave() {}
void Ranks::interrupt_all() const {}

}  // namespace heckbert::cli
