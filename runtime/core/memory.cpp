#include "core/memory.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace meetc {

owned_memory allocate(std::size_t bytes) {
  constexpr std::size_t large_page = std::size_t{1} << 21;
  const std::size_t alignment = bytes < 2 * large_page ? bump_allocator::line : large_page;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  owned_memory p(whole < bytes ? nullptr : std::aligned_alloc(alignment, whole));
  if (!p && bytes > 0)
    throw std::bad_alloc();
#ifdef __linux__
  if (alignment == large_page)
    madvise(p.get(), whole, MADV_HUGEPAGE); // a wish: that it is refused is no fault
#endif
  return p;
}

} // namespace meetc
