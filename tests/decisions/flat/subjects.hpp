// The four predicates of points, segments and triangles, each with its hand-written decision.
#ifndef MEETC_TESTS_DECISIONS_SUBJECTS_HPP
#define MEETC_TESTS_DECISIONS_SUBJECTS_HPP

#include "tests/decisions/flat/formulas.hpp"

#include <cga/cga.hpp>
#include <cga/header_only.hpp>

namespace meetc::decisions_test {

// written<P>: the number of points of each operand, and the parts of the decision; the labels of A's points
// come first.
template <class P> struct written;

template <> struct written<cga::segment_segment> {
  static constexpr const char *name = "segment_segment";
  static constexpr int of_a = 2, of_b = 2;
  template <class F> static auto whole(const F &f) { return f.segment_segment(0, 1, 2, 3); }
};
template <> struct written<cga::point_triangle> {
  static constexpr const char *name = "point_triangle";
  static constexpr int of_a = 1, of_b = 3;
  template <class F> static auto whole(const F &f) { return f.point_triangle(0, 1, 2, 3); }
};
template <> struct written<cga::segment_triangle> {
  static constexpr const char *name = "segment_triangle";
  static constexpr int of_a = 2, of_b = 3;
  template <class F> static auto rejected(const F &f) { return f.segment_triangle_rejected(0, 1, 2, 3, 4); }
  template <class F> static auto rare(const F &f) { return f.segment_triangle_rare(0, 1, 2, 3, 4); }
  template <class F> static auto usual(const F &f) { return f.segment_triangle_usual(0, 1, 2, 3, 4); }
  template <class F> static auto whole(const F &f) { return f.segment_triangle(0, 1, 2, 3, 4); }
};
template <> struct written<cga::triangle_triangle> {
  static constexpr const char *name = "triangle_triangle";
  static constexpr int of_a = 3, of_b = 3;
  template <class F> static auto rejected(const F &f) { return f.triangle_triangle_rejected(); }
  template <class F> static auto rare(const F &f) {
    return f.each_edge([&](auto... of) { return f.segment_triangle_rare(of...); });
  }
  template <class F> static auto usual(const F &f) {
    return f.each_edge([&](auto... of) { return f.segment_triangle_usual(of...); });
  }
  template <class F> static auto whole(const F &f) {
    return f.each_edge([&](auto... of) { return f.segment_triangle(of...); });
  }
};

// Whether the predicate has stages before and after the usual one.
template <class P> constexpr bool staged = P::rare_stage::atoms > 0;

template <class F> void for_each_subject(F &&f) {
  f(cga::segment_segment());
  f(cga::point_triangle());
  f(cga::segment_triangle());
  f(cga::triangle_triangle());
}

} // namespace meetc::decisions_test

#endif
