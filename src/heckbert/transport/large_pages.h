#pragma once
// An allocator for tables of many megabytes that are read in no order: pages of 2 MiB, where the system has them, so
// that reading an entry does not wait for the page's address as well (docs/performance.md).

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace heckbert::transport {

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}  // as std::vector asks of an allocator

  /// Errors: std::bad_alloc.
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T), alignment = bytes < kPage ? alignof(T) : kPage;
    void* memory = ::operator new(bytes, std::align_val_t(alignment));
#if defined(__linux__)
    // A wish: where it is not granted, pages are as small as ever.
    if (alignment == kPage) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, std::align_val_t(count * sizeof(T) < kPage ? alignof(T) : kPage));
  }
  friend bool operator==(const LargePages&, const LargePages&) {
    return true;
  }

 private:
  static constexpr std::size_t kPage = std::size_t{2} << 20;
};

}  // namespace heckbert::transport
