#include "tests/paper/algorithms.hpp"

namespace meetc::paper_test {
namespace {

segment edge(const triangle &t, std::size_t from, std::size_t to) {
  return {t[from], t[to]};
}

// Whether the values of two lists overlap along axis k, as closed ranges.
template <class P, class Q> bool overlap(std::size_t k, const P &p, const Q &q) {
  bool below = false, above = false;
  for (const vec &a : p)
    for (const vec &b : q) {
      below = below || a[k] <= b[k];
      above = above || a[k] >= b[k];
    }
  return below && above;
}

bool agree(int a, int b, int c, bool strict) {
  if (strict)
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

multivector blade(const triangle &t) {
  return plane(t[0], t[1], t[2]);
}
multivector blade(const segment &s) {
  return line(s[0], s[1]);
}

} // namespace

int side(const triangle &t, const vec &p) {
  return sgn(meet(blade(t), point(p))[0]);
}
int twist(const segment &s, const segment &e) {
  return sgn(coefficient(meet(blade(s), blade(e)), "e"));
}
int turn(int k, const vec &a, const vec &b, const vec &c) {
  return sgn(outer({algebra().vector(k), point(a), point(b), point(c), n()}).back());
}
rational trivector(const vec &a, const vec &b, const vec &c) {
  return det(a, b, c);
}

bool segment_segment(const segment &s, const segment &e) {
  if (twist(s, e) != 0)
    return false;
  for (int k = 0; k < 3; ++k)
    if (turn(k, s[0], s[1], e[0]) * turn(k, s[0], s[1], e[1]) > 0 ||
        turn(k, e[0], e[1], s[0]) * turn(k, e[0], e[1], s[1]) > 0 || !overlap(static_cast<std::size_t>(k), s, e))
      return false;
  return true;
}

bool point_triangle(const vec &p, const triangle &t) {
  if (side(t, p) != 0)
    return false;
  for (int k = 0; k < 3; ++k)
    if (!agree(turn(k, t[0], t[1], p), turn(k, t[1], t[2], p), turn(k, t[2], t[0], p), false) ||
        !overlap(static_cast<std::size_t>(k), std::array<vec, 1>{p}, t))
      return false;
  return true;
}

bool parallel(const segment &s, const triangle &t) {
  return coefficient(meet(blade(t), blade(s)), "e eb") == 0;
}

bool taken_as_contained(const segment &s, const triangle &t, const algorithm_1_errata &errata) {
  if (errata.assignment)
    return false;
  const multivector b = meet(blade(t), blade(s));
  return errata.one_coefficient ? coefficient(b, "e3 eb") == 0 : oracle::is_zero(b);
}

bool algorithm_1(const segment &s, const triangle &t, const algorithm_1_errata &errata) {
  if (parallel(s, t)) {
    if (!taken_as_contained(s, t, errata))
      return false;
    if (segment_segment(edge(t, 2, 0), s) || segment_segment(edge(t, 0, 1), s) || segment_segment(edge(t, 2, 1), s))
      return true;
    return !errata.only_edges && point_triangle(s[0], t);
  }
  const rational sign1 = trivector(t[1] - t[0], t[2] - t[0], s[0] - t[0]);
  const rational sign2 = trivector(t[1] - t[0], t[2] - t[0], s[1] - t[0]);
  if (errata.raw_trivectors ? sign1 == sign2 : sgn(sign1) == sgn(sign2))
    return false;
  // The third edge is printed reversed, hence the pattern (+, +, −) or (−, −, +).
  const int ind1 = twist(edge(t, 2, 0), s), ind2 = twist(edge(t, 0, 1), s), ind3 = twist(edge(t, 2, 1), s);
  return agree(ind1, ind2, -ind3, errata.strict);
}

bool on_one_side(const triangle &other, const triangle &t) {
  return agree(side(other, t[0]), side(other, t[1]), side(other, t[2]), true);
}

bool algorithm_2(const triangle &a, const triangle &b, const algorithm_2_errata &errata) {
  const bool rejected = on_one_side(a, b) || on_one_side(b, a);
  if (errata.negated_side_test ? !rejected : rejected)
    return false;
  for (const auto &[edges, other] : {std::pair{b, a}, std::pair{a, b}}) {
    for (std::size_t i = 0; i < 3; ++i)
      if (algorithm_1(edge(edges, i, (i + 1) % 3), other))
        return true;
    if (errata.assignment)
      return true; // out3 = 1 is true
  }
  return false;
}

bool algorithm_3(const ball &a, const ball &b) {
  const multivector first = centred_sphere({0, 0, 0}, a.radius * a.radius);
  return norm2(meet(first, centred_sphere(b.centre - a.centre, b.radius * b.radius))) >= 0;
}

} // namespace meetc::paper_test
