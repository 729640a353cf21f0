// core/views/memory.hpp: memory that a caller lends, and the one way of cutting it into arrays.
//
// The same function takes arrays from an allocator without memory, to learn the size, and from one with memory, to use
// it, so the two cannot disagree. Every array starts on a cache line.
#ifndef MEETC_CORE_VIEWS_MEMORY_HPP
#define MEETC_CORE_VIEWS_MEMORY_HPP

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace meetc {

struct memory {
  void *data = nullptr;
  std::size_t bytes = 0;
};

struct free_memory {
  void operator()(void *p) const { std::free(p); } // NOLINT: of std::aligned_alloc
};
using owned_memory = std::unique_ptr<void, free_memory>;

// Uninitialised memory. A large block asks the system for large pages, where it has them: with small ones, most of the
// time of filling it for the first time is spent on page faults. Throws std::bad_alloc.
owned_memory allocate(std::size_t bytes);

// Asks for large pages where these bytes, which nobody has filled, hold whole ones. A wish: that it is refused is no fault.
void wish_for_large_pages(void *data, std::size_t bytes);

class bump_allocator {
public:
  static constexpr std::size_t line = 64;

  bump_allocator() = default; // only measures
  explicit bump_allocator(memory m) : base_(static_cast<std::byte *>(m.data)) {
    const auto address = reinterpret_cast<std::uintptr_t>(m.data);
    skip_ = (line - address % line) % line;
  }

  // n objects of a trivial type, uninitialised; null where the allocator only measures.
  template <class T> T *take(std::size_t n) {
    const std::size_t at = used_;
    used_ += (n * sizeof(T) + line - 1) / line * line;
    return base_ ? reinterpret_cast<T *>(base_ + skip_ + at) : nullptr;
  }

  // The number of bytes that suffices, wherever the memory starts.
  std::size_t bytes() const { return used_ + line; }

private:
  std::byte *base_ = nullptr;
  std::size_t skip_ = 0, used_ = 0;
};

} // namespace meetc

#endif
