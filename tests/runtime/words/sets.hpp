// Small sets of every kind for queries whose answers a flushed subnormal or another rounding would change.
#ifndef MEETC_TESTS_RUNTIME_WORDS_SETS_HPP
#define MEETC_TESTS_RUNTIME_WORDS_SETS_HPP

#include "meet/core/views/view.hpp"

#include <cga/cga_runtime.hpp>

#include <vector>

namespace words_test {

using rows = std::vector<float>;

// Points, spheres, segments, triangles or boxes: most within [-1, 1]^2 at subnormal height, some at ordinary places, and the
// cases of reports. Every row is valid.
rows some_rows(const meetc::kind_info &kind, unsigned seed);

inline meetc::view view_of(const rows &r, const meetc::kind_info &kind) {
  return {.data = r.data(), .elements = r.size() / static_cast<std::size_t>(kind.fields)};
}

} // namespace words_test

#endif
