#include <heckbert/transport/fault.h>

namespace heckbert::transport {
namespace {

Fault the_fault = Fault::None;

}  // namespace

void plant(Fault fault) {
  the_fault = fault;
}

Fault planted() {
  return the_fault;
}

}  // namespace heckbert::transport
