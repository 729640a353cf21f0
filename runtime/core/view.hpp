// core/view.hpp: elements in the caller's memory.
#ifndef MEETC_CORE_VIEW_HPP
#define MEETC_CORE_VIEW_HPP

#include <cstddef>
#include <cstdint>

namespace meetc {

// Borrowed memory. With `index`, each element is kind->points indices into `vertices` points x, y, z; without, each is
// a row of kind->fields floats and `vertices` is not read. Any stride will do, even an odd one.
struct view {
  const float *data = nullptr;
  std::size_t vertices = 0;
  std::size_t stride_bytes = 0;
  const std::uint32_t *index = nullptr;
  std::size_t elements = 0;
};

} // namespace meetc

#endif
