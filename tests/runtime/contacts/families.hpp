// Pairs of elements near and in special positions.
#pragma once
#include <functional>
#include <random>
#include <vector>

namespace meetc::contacts_test {

struct pair_rows {
  std::vector<float> a, b; // 2 or 3 corners each
};
struct family {
  const char *name;
  std::function<pair_rows(std::mt19937 &)> pair;
};
// Families of two triangles, or of a segment and a triangle.
std::vector<family> families(int corners_a);

} // namespace meetc::contacts_test
