#include "sets.hpp"

#include "meet/core/query/find.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>

namespace words_test {

rows some_rows(const meetc::kind_info &kind, unsigned seed) {
  std::mt19937 g(seed);
  const auto whole = [&g](int lo, int hi) { return lo + static_cast<int>(g() % static_cast<unsigned>(hi - lo + 1)); };
  const bool is_box = std::string_view(kind.name) == "box";
  rows out;
  for (int element = 0; element < 60; ++element) {
    // 0: on an integer grid at subnormal height; 1: in every coordinate; 2: ordinary numbers; 3: huge ones
    const int sort = element % 6 < 3 ? 0 : element % 6 - 2;
    const std::size_t first = out.size();
    for (int i = 0; i < kind.fields; ++i) {
      const auto step = static_cast<float>(whole(-4, 4));
      switch (kind.roles[i]) {
      case meetc::role::length:
        out.push_back(sort == 0 || sort == 1 ? std::ldexp(static_cast<float>(whole(0, 6)), -149)
                      : sort == 2            ? static_cast<float>(whole(0, 1000)) / 700
                                             : static_cast<float>(whole(0, 2)) * 1e37F);
        break;
      case meetc::role::z:
        out.push_back(sort <= 1 ? std::ldexp(step, -149) : sort == 2 ? step / 3 : step * 0x1p124F);
        break;
      default:
        out.push_back(sort == 0   ? step / 4
                      : sort == 1 ? std::ldexp(step, -149)
                      : sort == 2 ? step / 3
                                  : step * 0x1p124F);
      }
    }
    if (is_box)
      for (std::size_t k = 0; k < 3; ++k)
        if (out[first + k] > out[first + 3 + k])
          std::swap(out[first + k], out[first + 3 + k]);
  }
  // Two reports: a flat triangle at subnormal height over a point there, and a segment that is subnormal itself.
  static constexpr float point[] = {0.25F, 0.25F, 1e-40F}, sphere[] = {0.25F, 0.25F, 1.5e-40F, 0.5e-40F},
                         segment[] = {0, 0, 0, 0, 0, 0x1p-140F},
                         triangle[] = {0, 0, 1e-40F, 1, 0, 1e-40F, 0, 1, 1e-40F},
                         across[] = {-1, -1, 0x1p-141F, 1, -1, 0x1p-141F, 0, 1, 0x1p-141F};
  const auto add = [&](const auto &row) {
    if (std::size(row) == static_cast<std::size_t>(kind.fields))
      out.insert(out.end(), std::begin(row), std::end(row));
  };
  add(point), add(sphere), add(triangle), add(across);
  if (!is_box)
    add(segment);
  return out;
}

using namespace meetc;

const predicate_info &touching() {
  static const predicate_info &p = find_predicate(cga::catalogue(), "triangle_triangle");
  return p;
}
std::span<const pair_of_sets> every_pair_of_sets() {
  static const std::vector<pair_of_sets> all = [] {
    std::vector<pair_of_sets> out;
    const catalogue &c = cga::catalogue();
    for (int i = 0; i < c.predicate_count; ++i)
      out.emplace_back(c.predicates[i]);
    return out;
  }();
  return all;
}
const pair_of_sets &one_pair() {
  for (const pair_of_sets &p : every_pair_of_sets())
    if (&p.by == &touching())
      return p;
  throw std::logic_error("no triangles");
}

pose some_pose(double grid) {
  pose at;
  at.m[0] = 1 / 3.0, at.m[5] = 0.1, at.m[10] = 0.75, at.m[3] = 1e-310, at.m[11] = 0x1.8p-148;
  at.length_scale = 1 / 3.0;
  at.grid = grid;
  return at;
}

} // namespace words_test
