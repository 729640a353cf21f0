#include "meet/core/views/memory.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace meetc {

namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;

} // namespace

void wish_for_large_pages([[maybe_unused]] void *data, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  const auto address = reinterpret_cast<std::uintptr_t>(data);
  const std::size_t before = (large_page - address % large_page) % large_page;
  if (bytes >= before + large_page)
    madvise(static_cast<std::byte *>(data) + before, (bytes - before) / large_page * large_page, MADV_HUGEPAGE);
#endif
}

owned_memory allocate(std::size_t bytes) {
  const std::size_t alignment = bytes < 2 * large_page ? bump_allocator::line : large_page;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  owned_memory p(whole < bytes ? nullptr : std::aligned_alloc(alignment, whole));
  if (!p && bytes > 0)
    throw std::bad_alloc();
  if (alignment == large_page)
    wish_for_large_pages(p.get(), whole);
  return p;
}

} // namespace meetc
