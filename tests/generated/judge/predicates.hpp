// The eleven predicates of the shipped scene with their kinds, so that one loop runs a check over all of them.
#ifndef MEETC_TESTS_GENERATED_PREDICATES_HPP
#define MEETC_TESTS_GENERATED_PREDICATES_HPP

#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <meetc/decide/boxes.hpp>
#include <vector>

namespace meetc::generated_test {

// A kind of operand: a hull of some points, perhaps with a radius, or the box between its least and its greatest corner.
enum class shape { point, sphere, segment, triangle, box };
constexpr int points_of(shape s) {
  return s == shape::triangle ? 3 : s == shape::segment || s == shape::box ? 2 : 1;
}
constexpr bool padded(shape s) {
  return s == shape::sphere;
}
constexpr int floats_of(shape s) {
  return 3 * points_of(s) + (padded(s) ? 1 : 0);
}

using row = std::vector<float>; // in store order: the points, then the radius

template <shape S> auto operand(const float *r) {
  if constexpr (S == shape::point)
    return cga::point<float>{r[0], r[1], r[2]};
  else if constexpr (S == shape::sphere)
    return cga::sphere<float>{{r[0], r[1], r[2]}, r[3]};
  else if constexpr (S == shape::segment)
    return cga::segment<float>{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
  else if constexpr (S == shape::box)
    return cga::box<float>{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
  else
    return cga::triangle<float>{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}};
}

template <class P, shape A, shape B, bool Surface> struct predicate {
  using type = P;
  static constexpr shape a = A, b = B;
  static constexpr bool surface = Surface; // spheres are surfaces, or else solids
  const char *name;

  static_assert(P::inputs_a == floats_of(A) && P::inputs_b == floats_of(B));

  static bool hit(const float *x, const float *y) { return P::hit(operand<A>(x), operand<B>(y)); }
  template <class T> static bool plain(const float *x, const float *y) {
    return P::template plain<T>(operand<A>(x), operand<B>(y));
  }
  static bool hit(const row &x, const row &y) { return hit(x.data(), y.data()); }
  template <class T> static bool plain(const row &x, const row &y) { return plain<T>(x.data(), y.data()); }
};

template <class F> void for_each_predicate(F &&f) {
  using enum shape;
  f(predicate<cga::segment_segment, segment, segment, false>{"segment_segment"});
  f(predicate<cga::point_triangle, point, triangle, false>{"point_triangle"});
  f(predicate<cga::segment_triangle, segment, triangle, false>{"segment_triangle"});
  f(predicate<cga::triangle_triangle, triangle, triangle, false>{"triangle_triangle"});
  f(predicate<cga::sphere_sphere, sphere, sphere, true>{"sphere_sphere"});
  f(predicate<cga::ball_ball, sphere, sphere, false>{"ball_ball"});
  f(predicate<cga::ball_segment, sphere, segment, false>{"ball_segment"});
  f(predicate<cga::sphere_segment, sphere, segment, true>{"sphere_segment"});
  f(predicate<cga::ball_triangle, sphere, triangle, false>{"ball_triangle"});
  f(predicate<cga::sphere_triangle, sphere, triangle, true>{"sphere_triangle"});
  f(predicate<cga::box_box, box, box, false>{"box_box"});
}

} // namespace meetc::generated_test

#endif
