// Pairs of a ball with a segment, a triangle or another ball, near and in special positions.
#pragma once
#include <array>
#include <functional>
#include <random>
#include <vector>

namespace meetc::contacts_test {

struct round_rows {
  std::array<float, 4> ball;
  std::vector<float> other; // 4 numbers: a ball; 6: a segment; 9: a triangle
};
struct round_family {
  const char *name;
  std::function<round_rows(std::mt19937 &)> pair;
};
std::vector<round_family> round_families(std::size_t numbers);

} // namespace meetc::contacts_test
