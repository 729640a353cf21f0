// The predicates of the shipped scene with their kinds as the judge knows them, so that one loop runs a check over all.
#ifndef MEETC_TESTS_GENERATED_PREDICATES_HPP
#define MEETC_TESTS_GENERATED_PREDICATES_HPP

#include <cga/for_each.hpp>
#include <cga/header_only.hpp>
#include <meetc/decide/boxes.hpp>
#include <string_view>
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

constexpr shape shape_named(std::string_view kind) {
  using enum shape;
  return kind == "point"      ? point
         : kind == "sphere"   ? sphere
         : kind == "segment"  ? segment
         : kind == "triangle" ? triangle
                              : box;
}

using row = std::vector<float>; // in store order: the points, then the radius

template <class P, class A, class B> struct predicate {
  using type = P;
  using kind_a = A;
  using kind_b = B;
  static constexpr shape a = shape_named(A::name), b = shape_named(B::name);
  const char *name;
  bool surface = std::string_view(name).starts_with("sphere_"); // spheres are surfaces, or else solids

  static_assert(P::inputs_a == floats_of(a) && P::inputs_b == floats_of(b));

  static bool hit(const float *x, const float *y) { return P::hit(A::in(x), B::in(y)); }
  template <class T> static bool plain(const float *x, const float *y) {
    return P::template plain<T>(A::in(x), B::in(y));
  }
  static bool hit(const row &x, const row &y) { return hit(x.data(), y.data()); }
  template <class T> static bool plain(const row &x, const row &y) { return plain<T>(x.data(), y.data()); }
};

template <class F> void for_each_predicate(F &&f) {
  cga::for_each_predicate(
      [&f]<class P, class A, class B>(const cga::detail::on_kinds<P, A, B> &p) { f(predicate<P, A, B>{p.name}); });
}

} // namespace meetc::generated_test

#endif
