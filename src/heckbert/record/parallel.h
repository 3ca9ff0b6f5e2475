#pragma once
// Work that falls into independent pieces, on as many threads as OpenEXR has. Private to the layer.

#include <atomic>
#include <cstddef>
#include <future>
#include <vector>

#include <heckbert/record/exr.h>

namespace heckbert::record::exr {

/// Each thread makes a worker of its own and calls it with numbers from 0 to count - 1; every number is dealt out once.
/// Gives the workers. Errors: one of those that were thrown, once all threads have ended.
template <class Make>
auto in_parallel(std::size_t count, Make make) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    auto worker = make();
    for (std::size_t i = next++; i < count; i = next++) worker(i);
    return worker;
  };
  std::vector<std::future<decltype(work())>> others;
  for (int thread = 1; thread < threads(); ++thread) others.push_back(std::async(std::launch::async, work));
  std::vector<decltype(work())> workers;
  workers.push_back(work());
  for (auto& other : others) workers.push_back(other.get());
  return workers;
}

}  // namespace heckbert::record::exr
