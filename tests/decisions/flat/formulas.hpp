// The four decisions, written independently by hand in determinants, turns and differences; and each of them with one
// mistake, to test that the enumeration finds it.
//
// The proof in docs/decisions.md is about these. The tests show that the emitted functions agree with them for all
// signs, so neither the spec language nor the compiler is trusted.
#ifndef MEETC_TESTS_DECISIONS_FORMULAS_HPP
#define MEETC_TESTS_DECISIONS_FORMULAS_HPP

#include "tests/decisions/flat/atoms.hpp"

#include <array>
#include <utility>

namespace meetc::decisions_test {

enum class change {
  none,
  // segment_segment
  ss_off_the_plane,    // the twist is not tested
  ss_one_way_crossing, // only the ends of the first must be on both sides of the second
  ss_other_way_crossing,
  ss_open_crossing, // an end on the other's line does not count
  ss_no_overlap,
  ss_open_overlap, // ranges must share more than an end
  ss_two_axes,     // turns along the third axis are not tested
  ss_two_ranges,   // the overlap along the third axis is not tested
  // point_triangle
  pt_off_the_plane,
  pt_open, // the edges do not count
  pt_two_edges,
  pt_no_overlap,
  pt_two_axes,
  pt_two_ranges,
  // segment_triangle
  st_open_ends, // an end in the plane does not count
  st_no_sides,
  st_open_twists, // edges do not count
  st_no_twists,
  st_two_twists,
  st_no_end,       // coplanar: only edges are tested
  st_two_edges,    // coplanar: only two edges are tested
  st_no_rare,      // coplanar pairs are treated like others
  st_rare_no,      // coplanar pairs miss
  st_two_rejected, // reject: one end off the plane suffices
  // triangle_triangle
  tt_edges_of_one,     // the edges of B are not tested
  tt_closed_rejection, // reject: touching the plane from one side is a miss
  tt_hasty_rejection,  // reject: two corners on one side suffice
  tt_rare_no,          // a coplanar edge is a miss
  count
};

template <class S> class formulas {
public:
  using truth = decltype(meetc::in<2>(std::declval<S>()));

  formulas(const atom_table &table, const S *signs, change c = change::none)
      : table_(table), signs_(signs), change_(c) {}

  truth segment_segment(int p, int q, int u, int v) const {
    truth t = meetc::in<2>(twist(p, q, u, v));
    if (is(change::ss_off_the_plane))
      t = meetc::in<7>(twist(p, q, u, v));
    for (int k = 0; k < 3; ++k) {
      const S first = turn(k, p, q, u) * turn(k, p, q, v), second = turn(k, u, v, p) * turn(k, u, v, q);
      if (!(is(change::ss_two_axes) && k == 2)) {
        if (!is(change::ss_one_way_crossing))
          t = meetc::both(t, is(change::ss_open_crossing) ? meetc::in<1>(first) : meetc::in<3>(first));
        if (!is(change::ss_other_way_crossing))
          t = meetc::both(t, meetc::in<3>(second));
      }
      if (!is(change::ss_no_overlap) && !(is(change::ss_two_ranges) && k == 2))
        t = meetc::both(t, overlap(k, {p, q}, {u, v}, is(change::ss_open_overlap)));
    }
    return t;
  }

  truth point_triangle(int p, int a, int b, int c) const {
    truth t = is(change::pt_off_the_plane) ? meetc::in<7>(side(a, b, c, p)) : meetc::in<2>(side(a, b, c, p));
    for (int k = 0; k < 3; ++k) {
      const S ab = turn(k, a, b, p), bc = turn(k, b, c, p), ca = turn(k, c, a, p);
      if (!(is(change::pt_two_axes) && k == 2))
        t = meetc::both(t, is(change::pt_open)        ? inside(ab, bc, ca)
                           : is(change::pt_two_edges) ? agree(ab, bc, bc)
                                                      : agree(ab, bc, ca));
      if (!is(change::pt_no_overlap) && !(is(change::pt_two_ranges) && k == 2))
        t = meetc::both(t, overlap(k, {p}, {a, b, c}, false));
    }
    return t;
  }

  truth segment_triangle_rare(int p, int q, int a, int b, int c) const {
    return meetc::both(meetc::in<2>(side(a, b, c, p)), meetc::in<2>(side(a, b, c, q)));
  }
  truth segment_triangle_usual(int p, int q, int a, int b, int c) const {
    const S sides = side(a, b, c, p) * side(a, b, c, q);
    const S ab = twist(p, q, a, b), bc = twist(p, q, b, c), ca = twist(p, q, c, a);
    const truth crosses = is(change::st_open_ends)  ? meetc::in<1>(sides)
                          : is(change::st_no_sides) ? meetc::in<7>(sides)
                                                    : meetc::in<3>(sides);
    if (is(change::st_no_twists))
      return crosses;
    return meetc::both(crosses, is(change::st_open_twists)  ? inside(ab, bc, ca)
                                : is(change::st_two_twists) ? agree(ab, bc, bc)
                                                            : agree(ab, bc, ca));
  }
  truth segment_triangle(int p, int q, int a, int b, int c) const {
    const truth rare = segment_triangle_rare(p, q, a, b, c), usual = segment_triangle_usual(p, q, a, b, c);
    if (is(change::st_no_rare))
      return usual;
    if (is(change::st_rare_no) || is(change::tt_rare_no))
      return meetc::both(meetc::negate(rare), usual);
    truth flat = meetc::either(segment_segment(p, q, a, b), segment_segment(p, q, b, c));
    if (!is(change::st_two_edges))
      flat = meetc::either(flat, segment_segment(p, q, c, a));
    if (!is(change::st_no_end))
      flat = meetc::either(flat, point_triangle(p, a, b, c));
    return meetc::either(meetc::both(rare, flat), meetc::both(meetc::negate(rare), usual));
  }
  truth segment_triangle_rejected(int p, int q, int a, int b, int c) const {
    if (is(change::st_two_rejected))
      return meetc::negate(segment_triangle_rare(p, q, a, b, c));
    return meetc::in<4>(side(a, b, c, p) * side(a, b, c, q));
  }

  // The corners are 0, 1, 2 and 3, 4, 5. each_edge(f) joins `f` of every edge of one triangle and all of the other
  // by "or".
  template <class F> truth each_edge(F &&f) const {
    truth t = meetc::either(meetc::either(f(0, 1, 3, 4, 5), f(1, 2, 3, 4, 5)), f(2, 0, 3, 4, 5));
    if (!is(change::tt_edges_of_one))
      t = meetc::either(t, meetc::either(meetc::either(f(3, 4, 0, 1, 2), f(4, 5, 0, 1, 2)), f(5, 3, 0, 1, 2)));
    return t;
  }
  truth triangle_triangle_rejected() const {
    return meetc::either(apart({3, 4, 5}, {0, 1, 2}), apart({0, 1, 2}, {3, 4, 5}));
  }

private:
  const atom_table &table_;
  const S *signs_;
  change change_;

  bool is(change c) const { return change_ == c; }
  S side(int a, int b, int c, int p) const { return twist(a, b, c, p); }
  S twist(int p, int q, int u, int v) const { return table_.read(signs_, shape::determinant, 0, {p, q, u, v}); }
  S turn(int k, int a, int b, int c) const { return table_.read(signs_, shape::turn, k, {a, b, c}); }

  static truth inside(const S &a, const S &b, const S &c) {
    return meetc::either(meetc::both(meetc::both(meetc::in<4>(a), meetc::in<4>(b)), meetc::in<4>(c)),
                         meetc::both(meetc::both(meetc::in<1>(a), meetc::in<1>(b)), meetc::in<1>(c)));
  }
  static truth agree(const S &a, const S &b, const S &c) {
    return meetc::either(meetc::both(meetc::both(meetc::in<6>(a), meetc::in<6>(b)), meetc::in<6>(c)),
                         meetc::both(meetc::both(meetc::in<3>(a), meetc::in<3>(b)), meetc::in<3>(c)));
  }
  truth apart(const std::array<int, 3> &of, const std::array<int, 3> &corners) const {
    const S a = side(of[0], of[1], of[2], corners[0]), b = side(of[0], of[1], of[2], corners[1]);
    const S c = side(of[0], of[1], of[2], corners[2]);
    if (is(change::tt_hasty_rejection))
      return inside(a, b, b);
    if (is(change::tt_closed_rejection)) // at least one corner off the plane
      return meetc::both(agree(a, b, c),
                         meetc::negate(meetc::both(meetc::both(meetc::in<2>(a), meetc::in<2>(b)), meetc::in<2>(c))));
    return inside(a, b, c);
  }
  truth overlap(int k, std::initializer_list<int> some, std::initializer_list<int> others, bool open) const {
    const auto any = [&](auto &&passes) {
      const auto of = [&](int p, int q) { return passes(table_.read(signs_, shape::difference, k, {p, q})); };
      truth t = of(*some.begin(), *others.begin());
      for (const int p : some)
        for (const int q : others)
          t = meetc::either(t, of(p, q));
      return t;
    };
    return meetc::both(any([&](const S &s) { return open ? meetc::in<1>(s) : meetc::in<3>(s); }),
                       any([&](const S &s) { return open ? meetc::in<4>(s) : meetc::in<6>(s); }));
  }
};

} // namespace meetc::decisions_test

#endif
