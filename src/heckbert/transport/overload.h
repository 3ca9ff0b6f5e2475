#pragma once
// A visitor made of lambdas, one per alternative of a std::variant.

namespace heckbert::transport {

template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

}  // namespace heckbert::transport
