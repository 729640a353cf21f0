#include "core/device/search.hpp"

#include "meetc/cuda_table.hpp"

#include <algorithm>

namespace meetc {

const char *name_of(search s) {
  static const char *const names[] = {"every pair", "groups", "hierarchy"};
  return names[static_cast<int>(s)];
}

namespace {

search_costs costs_of(const search_sizes &s) {
  constexpr double start = 54e-6, pair = 1 / 12e12, near_pair = 1 / 1e11;
  constexpr double start_groups = 65e-6, group_pair = 1 / 14e12, taken_apart = 2.1e-9;
  constexpr double start_tree = 30e-6, start_boxes = 20e-6, enclosed = 0.011e-9;
  constexpr double walks = 0.066e-9, walked_over = 0.274e-9; // of the larger set, and of the other
  constexpr double walks_together = 0.018e-9; // of a set so large that its neighbours go down together first
  const double together_from = s.balls ? 1e6 : 5.4e6;
  constexpr double column = 0.024e-9; // of an element, for the filter
  const double a = static_cast<double>(s.a), b = static_cast<double>(s.b),
               near = s.long_elements ? near_pair * a * b : 0;
  const double columns = column * ((s.made_a ? 0 : a) + (s.made_b ? 0 : b)), many = std::max(a, b);
  search_costs c;
  const auto in_tiles = [](std::uint64_t n) { // the filter tests whole ones
    const std::uint64_t tiles = (n + cuda::part_step - 1) / cuda::part_step;
    return static_cast<double>(tiles * cuda::part_step);
  };
  c.of[static_cast<int>(search::every_pair)] = start + columns + pair * in_tiles(s.a) * in_tiles(s.b) + near;
  c.of[static_cast<int>(search::groups)] = start_groups + columns +
                                           group_pair * (a / cuda::group_size) * (b / cuda::group_size) +
                                           taken_apart * (a + b) / 2 + near;
  double tree = start_tree + (many < together_from ? walks : walks_together) * many + walked_over * std::min(a, b);
  tree += (s.made_a && s.made_b ? 0 : start_boxes) + (s.made_a ? 0 : enclosed * a) + (s.made_b ? 0 : enclosed * b);
  c.of[static_cast<int>(search::tree)] = tree;
  return c;
}

} // namespace

search search_costs::least() const {
  return under_standard_word([&] { return static_cast<search>(std::min_element(of, of + searches) - of); });
}

search_costs expected_costs(const search_sizes &s) {
  return under_standard_word([&] { return costs_of(s); });
}

} // namespace meetc
