#pragma once
// What algorithms can be told beyond what all have in common. The names of these settings: method_options.h.

#include <heckbert/transport/radiosity_settings.h>

namespace heckbert::transport {

struct Method {
  RadiositySettings radiosity{};
  bool operator==(const Method&) const = default;
};

}  // namespace heckbert::transport
