// Balls that touch, or nearly touch, in ways that a filter may get wrong; and the exact answers.
#ifndef MEETC_TESTS_MATRIX_SCENES_HPP
#define MEETC_TESTS_MATRIX_SCENES_HPP

#include <cga/ball_form.hpp>
#include <cga/shapes.hpp>
#include <meetc/every_pair/frame.hpp>
#include <meetc/every_pair/matrix.hpp>

#include <array>
#include <gmpxx.h>
#include <random>
#include <span>
#include <vector>

namespace meetc::matrix_test {

using sphere = std::array<float, 4>; // x, y, z, r
using ball = std::array<double, 4>;
using form = cga::ball_form;

// The frame is made from `owners`; `others` are compared with them.
struct scene {
  std::vector<sphere> owners, others;
};
struct family {
  const char *name;
  scene (*make)(std::mt19937_64 &random);
};
std::span<const family> families();

bool has_finite_box(const sphere &s);

// The frame of a set, and an element in it, as a device makes them.
meetc::matrix_frame frame_around(const std::vector<sphere> &set);
meetc::placing place(const meetc::matrix_frame &frame, const sphere &s, meetc::cover c, ball &in_frame);

// Whether closed balls share a point, in rationals.
bool touch(const sphere &a, const sphere &b);
bool touch(const ball &a, const ball &b);

// ---- the results that the assumed unit may give ----

using columns = std::array<std::uint16_t, meetc::matrix_columns>;

// The exact sum of the products, and the error allowed to the unit: 17 2^-23 of the sum of their magnitudes. Both are
// integers, scaled by the same factor.
struct unit_result {
  bool always_negative, never_negative; // of every result within the model
};
unit_result multiply(const columns &x, const columns &y);

template <class Form, bool First> columns columns_of(const ball &in_frame, meetc::placing where) {
  columns out;
  meetc::to_columns<Form, First>(in_frame.data(), where, out.data());
  return out;
}

} // namespace meetc::matrix_test

#endif
