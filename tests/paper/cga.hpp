// The paper's algebra R(4,1) on the dense oracle: its basis, its point, its primitives, its meet.
#ifndef MEETC_TESTS_PAPER_CGA_HPP
#define MEETC_TESTS_PAPER_CGA_HPP

#include "gen/oracle/convex.hpp"
#include "gen/oracle/dense.hpp"
#include "tests/gen/oracle/random.hpp"

#include <initializer_list>
#include <string>

namespace meetc::paper_test {

using oracle::multivector;
using oracle::rational;
using oracle_test::random_numbers;

// ---- plain Euclidean vectors ----
using vec = oracle::point;
vec operator+(const vec &a, const vec &b);
vec operator-(const vec &a, const vec &b);
vec operator*(const rational &k, const vec &a);
rational dot(const vec &a, const vec &b);
inline rational square(const vec &a) {
  return dot(a, a);
}
vec cross(const vec &a, const vec &b);
// The determinant [a, b, c].
inline rational det(const vec &a, const vec &b, const vec &c) {
  return dot(a, cross(b, c));
}
inline bool zero(const vec &a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

// A point with fractional coordinates, or one of the lattice {0..limit}^3, where degenerate cases abound.
vec random_vec(random_numbers &r, int limit = 9);
vec lattice_vec(random_numbers &r, int limit);

// ---- R(4,1): e1 e2 e3 e eb, squares + + + + −; n = e + eb, nb = e − eb ----
const oracle::dense_algebra &algebra();
multivector operator+(const multivector &a, const multivector &b);
multivector operator-(const multivector &a, const multivector &b);
multivector operator*(const rational &k, const multivector &a);
multivector operator*(const multivector &a, const multivector &b); // geometric
multivector outer(std::initializer_list<multivector> factors);

const multivector &I();
const multivector &n();
const multivector &nb();
multivector euclidean(const vec &a); // a1 e1 + a2 e2 + a3 e3

multivector point(const vec &x); // 2x + x² n − nb
multivector point_pair(const vec &p, const vec &q);
multivector flat_point(const vec &p);
multivector line(const vec &p, const vec &q);
multivector circle(const vec &p, const vec &q, const vec &s);
multivector plane(const vec &p, const vec &q, const vec &s);
multivector sphere(const vec &p, const vec &q, const vec &s, const vec &t);
multivector centred_sphere(const vec &centre, const rational &squared_radius); // −I (C − r² n)

multivector meet(const multivector &x, const multivector &y); // (2.3): (I X)·Y
rational norm2(const multivector &b);                         // the scalar part of B B

// The coefficient on a blade that is named with spaces, in any order: "e3 e1 eb".
rational coefficient(const multivector &b, const std::string &blade);
// How many of the 32 coefficients are not 0.
int nonzero_blades(const multivector &b);

// ---- circles in plain geometry ----
struct circle_shape {
  vec centre, normal; // normal: not of unit length
  rational squared_radius;
};
// The circle through three points that are not collinear.
circle_shape circumcircle(const vec &p, const vec &q, const vec &s);
// Three such points of the lattice, and their circle.
struct lattice_circle {
  vec p, q, s;
  circle_shape shape;
  multivector blade;
};
lattice_circle random_circle(random_numbers &r, int limit);

// How often each sign occurred, so that a test can require all of them.
struct sign_counts {
  int negative = 0, none = 0, positive = 0;
  void add(int s) { ++(s < 0 ? negative : s > 0 ? positive : none); }
};

} // namespace meetc::paper_test

#endif
