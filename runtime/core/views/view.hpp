// core/views/view.hpp: elements in the caller's memory.
#ifndef MEETC_CORE_VIEWS_VIEW_HPP
#define MEETC_CORE_VIEWS_VIEW_HPP

#include <cstddef>
#include <cstdint>

namespace meetc {

// Borrowed memory. With `index`, each element is kind->points indices into `vertices` points x, y, z; without, each is
// a row of kind->fields floats and `vertices` is not read. A stride is 0, which means packed, or any that is not shorter than a
// point or row, even an odd one. `data` is null only where nothing is read.
struct view {
  const float *data = nullptr;
  std::size_t vertices = 0;
  std::size_t stride_bytes = 0; // from a point or row to the next
  const std::uint32_t *index = nullptr;
  std::size_t elements = 0;
};

} // namespace meetc

#endif
