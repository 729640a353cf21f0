// The terms of the proof: inner products of a few vectors, as polynomials of one ring.
//
// A segment is a + s d1 with 0 <= s <= 1; a triangle is a + s d1 + t d2 with 0 <= s, 0 <= t, s + t <= 1, d1 =
// b - a and d2 = c - a; w is the ball's centre minus a. Points do not occur otherwise: squared distances,
// heights and signs are polynomials in the six inner products of w, d1 and d2, and in R, the squared radius.
#ifndef MEETC_TESTS_DECISIONS_ROUND_GRAM_HPP
#define MEETC_TESTS_DECISIONS_ROUND_GRAM_HPP

#include "tests/decisions/round/emitted.hpp"

namespace meetc::decisions_round {

inline polynomial operator*(int k, const polynomial &p) {
  return p.scaled(k);
}
inline polynomial operator-(const polynomial &p) {
  return p.scaled(-1);
}
inline polynomial square(const polynomial &p) {
  return p * p;
}

class gram {
public:
  static const gram &ring();

  const poly::ring numbers;
  const polynomial zero, one;
  // w.w, w.d1, w.d2, d1.d1, d1.d2, d2.d2, the squared radius
  const polynomial ww, w1, w2, g11, g12, g22, R;
  // Two balls: the squared distance of the centres, the distance, the radii.
  const polynomial dd, d, r1, r2;
  // Unknowns of the cases: a point of the figure, a step from it to the foot of the perpendicular, the foot
  // itself.
  const polynomial s, t, tau, l1, l2;

  // The squared distances of the centre from b and c; for the edge from b to c: w'.d and d.d, with w' from b.
  const polynomial wb, wc, w3, g33;
  // |d1 x d2|^2; the foot's weights of a, b and c, times that; the squared volume (w, d1, d2).
  const polynomial area, ma, mb, mc, volume;

  // The squared distance of the centre from a + s d1 + t d2.
  polynomial reach(const polynomial &at_s, const polynomial &at_t) const;
  // |u d1 + v d2|^2
  polynomial length(const polynomial &u, const polynomial &v) const;

  // The value of each variable in the stored numbers of a predicate (row_names); unknowns are zero.
  std::vector<polynomial> images(const emitted &e, const poly::ring &stored) const;
  // Whether a polynomial contains only variables of operands, so that images() determines it.
  bool of_operands(const polynomial &p) const;

private:
  gram();
  polynomial variable(const char *name) const;
};

// Vectors of polynomials, for identities of vectors.
using vector3 = std::vector<polynomial>;
polynomial dot(const vector3 &u, const vector3 &v);
vector3 cross(const vector3 &u, const vector3 &v);
vector3 minus(const vector3 &u, const vector3 &v);
// Three numbers of a row, starting at `first`.
vector3 stored_point(const poly::ring &stored, int first);

} // namespace meetc::decisions_round

#endif
