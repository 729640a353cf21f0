// Meshes that meet, for programs that live long: two tori that cross themselves, segments and balls, and how they move.
#ifndef MEETC_TESTS_RUNTIME_LIVE_SCENES_HPP
#define MEETC_TESTS_RUNTIME_LIVE_SCENES_HPP

#include "tests/runtime/self/made_meshes.hpp"

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/query/chunks.hpp"
#include "meet/core/sets/moving_set.hpp"

#include <algorithm>
#include <random>
#include <string_view>
#include <vector>

namespace live_test {

using namespace meetc;
using self_test::mesh;

inline const predicate_info &predicate(std::string_view name) {
  return find_predicate(cga::catalogue(), name);
}

// Every rung but the tolerant one, for which the shipped scene is not generated.
inline constexpr rung rungs[] = {rung::fp32, rung::fp64, rung::fp64x2, rung::exact, rung::certified};

inline std::vector<std::pair<std::uint32_t, std::uint32_t>> plain(const std::vector<index_pair> &pairs) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const index_pair p : pairs)
    out.emplace_back(p.a, p.b);
  return out;
}

// Each number is moved by up to `far`.
inline std::vector<float> shaken(std::vector<float> numbers, float far, unsigned seed) {
  std::mt19937 random(seed);
  for (float &x : numbers)
    x += far * (static_cast<float>(random() >> 8) * 0x1p-23F - 1);
  return numbers;
}

// The mesh with its points in other places.
inline mesh shaken(mesh m, float far, unsigned seed) {
  m.xyz = shaken(std::move(m.xyz), far, seed);
  return m;
}

// Rows of segments or balls in the cube [-1, 1)^3, as long as `size`.
inline std::vector<float> some_segments(std::size_t n, float size, unsigned seed) {
  std::vector<float> out;
  const std::vector<float> from = shaken(std::vector<float>(3 * n, 0), 1, seed);
  const std::vector<float> to = shaken(from, size, seed + 1);
  for (std::size_t i = 0; i < 3 * n; i += 3) {
    out.insert(out.end(), from.begin() + static_cast<std::ptrdiff_t>(i),
               from.begin() + static_cast<std::ptrdiff_t>(i + 3));
    out.insert(out.end(), to.begin() + static_cast<std::ptrdiff_t>(i), to.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return out;
}
inline std::vector<float> some_balls(std::size_t n, float size, unsigned seed) {
  std::vector<float> out = shaken(std::vector<float>(4 * n, 0), 1, seed);
  for (std::size_t i = 3; i < out.size(); i += 4)
    out[i] = size * (1 + out[i]);
  return out;
}

// Boxes around the origin, each of which meets each other one.
inline std::vector<float> nested_boxes(std::size_t n) {
  std::vector<float> out;
  for (std::size_t i = 1; i <= n; ++i)
    for (const float side : {-1.0F, 1.0F})
      for (int k = 0; k < 3; ++k)
        out.push_back(side * static_cast<float>(i));
  return out;
}

inline view rows(const std::vector<float> &numbers, const kind_info &kind) {
  return {.data = numbers.data(), .elements = numbers.size() / static_cast<std::size_t>(kind.fields)};
}

} // namespace live_test

#endif
