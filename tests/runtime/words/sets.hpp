// Small sets of every kind for queries whose answers a flushed subnormal or another rounding would change.
#ifndef MEETC_TESTS_RUNTIME_WORDS_SETS_HPP
#define MEETC_TESTS_RUNTIME_WORDS_SETS_HPP

#include "meet/core/sets/prepared.hpp"

#include <cga/cga_runtime.hpp>

#include <span>
#include <vector>

namespace words_test {

using rows = std::vector<float>;

// Points, spheres, segments, triangles or boxes: most within [-1, 1]^2 at subnormal height, some at ordinary places, and the
// cases of reports. Every row is valid.
rows some_rows(const meetc::kind_info &kind, unsigned seed);

inline meetc::view view_of(const rows &r, const meetc::kind_info &kind) {
  return {.data = r.data(), .elements = r.size() / static_cast<std::size_t>(kind.fields)};
}

// The arguments of calls, made under the default word: the predicate of two triangles, sets of each predicate, and a pose whose
// arithmetic rounds, and makes and meets subnormal numbers; boxes can stand in it, too.
const meetc::predicate_info &touching();
struct pair_of_sets {
  const meetc::predicate_info &by;
  rows a, b;
  meetc::prepared set_a, set_b;
  explicit pair_of_sets(const meetc::predicate_info &p)
      : by(p), a(some_rows(*p.a, 1)), b(some_rows(*p.b, 2)), set_a(prepare(view_of(a, *p.a), *p.a)),
        set_b(prepare(view_of(b, *p.b), *p.b)) {}
};
std::span<const pair_of_sets> every_pair_of_sets();
const pair_of_sets &one_pair();
meetc::pose some_pose(double grid = 0);

} // namespace words_test

#endif
