// Boxes with an end that is not finite: two boxes are apart only where a comparison holds.
#include "tests/catch.hpp"

#include <cga/shapes.hpp>
#include <cmath>
#include <limits>
#include <meetc/volume/tree.hpp>

namespace {

// A box as it is stored: low ends, then high ones.
struct stored_box {
  static void box(const float *row, float lo[3], float hi[3]) {
    for (int k = 0; k < 3; ++k)
      lo[k] = row[k], hi[k] = row[3 + k];
  }
};
bool touch(const float *a, const float *b) {
  return meetc::cuda::box_of_row<stored_box>(a).touches(meetc::cuda::box_of_row<stored_box>(b));
}

constexpr float inf = std::numeric_limits<float>::infinity(), not_a_number = std::numeric_limits<float>::quiet_NaN(),
                most = std::numeric_limits<float>::max();

} // namespace

TEST_CASE("closed boxes touch, and those beyond float32 touch what reaches there") {
  const float unit[] = {0, 0, 0, 1, 1, 1}, beside[] = {1, 1, 1, 2, 2, 2}, above[] = {0, 0, 1.5F, 1, 1, 2};
  const float all[] = {-inf, -inf, -inf, inf, inf, inf}, right[] = {1.25F, -inf, -inf, inf, inf, inf};
  const float last[] = {most, 0, 0, inf, 1, 1};
  CHECK(touch(unit, beside));
  CHECK_FALSE(touch(unit, above));
  for (const float *other : {unit, beside, above, last, all, right}) {
    CHECK(touch(all, other));
    CHECK(touch(other, all));
  }
  CHECK_FALSE(touch(unit, right));
  CHECK_FALSE(touch(last, unit));
  CHECK(touch(last, right));
}

TEST_CASE("an end that is not a number makes no boxes apart") {
  const float unit[] = {0, 0, 0, 1, 1, 1};
  for (int k = 0; k < 6; ++k) {
    float other[] = {0, 0, 0, 1, 1, 1};
    other[k] = not_a_number;
    CHECK(touch(unit, other));
    CHECK(touch(other, unit));
  }
}
