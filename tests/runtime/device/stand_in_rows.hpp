// Rows in a pose, on the host: see stand_in.cpp.
#pragma once
#include <meetc/joined_box.hpp>
#include <meetc/tolerant.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace meetc::stand_in {

// Whether it is a row of its kind.
template <class Shape> bool is_good(const float *row) {
  return std::all_of(row, row + Shape::fields, [](float x) { return std::isfinite(x); }) && Shape::obeys(row);
}
// Returns whether the row in the pose is one.
template <class Shape> bool posed_row(const cuda::pose_matrix &at, const float *row, float *out) {
  constexpr int fields = Shape::fields;
  std::copy_n(row, fields, out);
  for (int f = 0; f < fields && !at.identity; ++f)
    if (Shape::role_of(f) == role::length)
      out[f] = static_cast<float>(static_cast<double>(row[f]) * at.length_scale);
    else if (Shape::role_of(f) == role::x)
      for (int k = 0; k < 3; ++k) {
        const double *m = at.m + 4 * k;
        const double x = row[f], y = row[f + 1], z = row[f + 2];
        out[f + k] = static_cast<float>(((m[0] * x + m[1] * y) + m[2] * z) + m[3]);
      }
  for (int f = 0; f < fields && at.on_grid; ++f)
    out[f] = nearest_multiple(out[f], at.grid_low);
  return is_good<Shape>(out);
}
inline void join(cuda::joined_box &around, const cuda::tree_box &b) {
  for (int k = 0; k < 3; ++k) {
    around.below[k] = std::max(around.below[k], cuda::below_of(b.low[k]));
    around.above[k] = std::max(around.above[k], cuda::above_of(b.high[k]));
  }
}
inline std::uint32_t number_in(const cuda::view &v, std::uint32_t i) {
  return v.only ? v.only[i] : i;
}
// The same of the element with this number among all of a view.
template <class Shape>
bool posed_element(const cuda::view &v, const cuda::pose_matrix &at, std::uint32_t number, float *out) {
  constexpr int fields = Shape::fields;
  float row[fields] = {};
  bool there = true;
  for (int f = 0; f < fields; ++f) {
    const std::size_t at_row = v.index ? v.index[number * (fields / 3) + f / 3] : number;
    const std::size_t at_field = static_cast<std::size_t>(v.index ? f % 3 : f);
    there = there && (!v.index || at_row < v.vertices);
    if (there)
      std::memcpy(row + f, reinterpret_cast<const char *>(v.data) + at_row * v.stride_bytes + at_field * sizeof(float),
                  sizeof(float));
  }
  return posed_row<Shape>(at, row, out) && there;
}

} // namespace meetc::stand_in
