// The generated kinds and blades for the oracle: numbers by name, and dense multivectors.
//
// The definitions are written here again, from the paper's conventions (docs/paper.md), not read from the spec, so that
// a mistake in the spec shows as well as one in the compiler.
#ifndef MEETC_TESTS_GENERATED_BLADES_HPP
#define MEETC_TESTS_GENERATED_BLADES_HPP

#include "gen/oracle/dense.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <cga/cga.hpp>
#include <utility>
#include <vector>

namespace meetc::generated_test {

using oracle::add;
using oracle::multivector;
using oracle::outer;
using oracle::subtract;

// Basis blades of e1, e2, e3, n, nb as bit masks.
enum mask : unsigned { e1 = 1, e2 = 2, e3 = 4, n = 8, nb = 16 };

template <class T> using entries = std::vector<std::pair<unsigned, T *>>;

// ---- the coefficients of a result, by blade ----

// A scalar result.
inline entries<exact> fields(exact &s) {
  return {{0U, &s}};
}
inline entries<error_count> fields(error_count &s) {
  return {{0U, &s}};
}
inline entries<double> fields(double &s) {
  return {{0U, &s}};
}
inline entries<float> fields(float &s) {
  return {{0U, &s}};
}

template <class T> entries<T> fields(cga::point_blade<T> &b) {
  return {{e1, &b.e1}, {e2, &b.e2}, {e3, &b.e3}, {n, &b.n}, {nb, &b.nb}};
}
template <class T> entries<T> fields(cga::point_pair_blade<T> &b) {
  return {{e1 | e2, &b.e1_e2}, {e1 | e3, &b.e1_e3}, {e1 | n, &b.e1_n}, {e1 | nb, &b.e1_nb}, {e2 | e3, &b.e2_e3},
          {e2 | n, &b.e2_n},   {e2 | nb, &b.e2_nb}, {e3 | n, &b.e3_n}, {e3 | nb, &b.e3_nb}, {n | nb, &b.n_nb}};
}
template <class T> entries<T> fields(cga::flat_point_blade<T> &b) {
  return {{e1 | n, &b.e1_n}, {e2 | n, &b.e2_n}, {e3 | n, &b.e3_n}, {n | nb, &b.n_nb}};
}
template <class T> entries<T> fields(cga::line_blade<T> &b) {
  return {{e1 | e2 | n, &b.e1_e2_n}, {e1 | e3 | n, &b.e1_e3_n}, {e1 | n | nb, &b.e1_n_nb},
          {e2 | e3 | n, &b.e2_e3_n}, {e2 | n | nb, &b.e2_n_nb}, {e3 | n | nb, &b.e3_n_nb}};
}
template <class T> entries<T> fields(cga::circle_blade<T> &b) {
  return {{e1 | e2 | e3, &b.e1_e2_e3}, {e1 | e2 | n, &b.e1_e2_n},   {e1 | e2 | nb, &b.e1_e2_nb},
          {e1 | e3 | n, &b.e1_e3_n},   {e1 | e3 | nb, &b.e1_e3_nb}, {e1 | n | nb, &b.e1_n_nb},
          {e2 | e3 | n, &b.e2_e3_n},   {e2 | e3 | nb, &b.e2_e3_nb}, {e2 | n | nb, &b.e2_n_nb},
          {e3 | n | nb, &b.e3_n_nb}};
}
template <class T> entries<T> fields(cga::plane_blade<T> &b) {
  return {{e1 | e2 | e3 | n, &b.e1_e2_e3_n},
          {e1 | e2 | n | nb, &b.e1_e2_n_nb},
          {e1 | e3 | n | nb, &b.e1_e3_n_nb},
          {e2 | e3 | n | nb, &b.e2_e3_n_nb}};
}
template <class T> entries<T> fields(cga::sphere_blade<T> &b) {
  return {{e1 | e2 | e3 | n, &b.e1_e2_e3_n},
          {e1 | e2 | e3 | nb, &b.e1_e2_e3_nb},
          {e1 | e2 | n | nb, &b.e1_e2_n_nb},
          {e1 | e3 | n | nb, &b.e1_e3_n_nb},
          {e2 | e3 | n | nb, &b.e2_e3_n_nb}};
}

template <class T> entries<T> fields(cga::meet_line_line_result<T> &b) {
  return {{n, &b.n}};
}

// A general element of a kind's support, as a dense multivector.
template <class B> multivector dense(B b) {
  multivector m(32);
  for (const auto &[blade, value] : fields(b))
    m[blade] = value->v;
  return m;
}

// ---- operands from a source of numbers, in store order ----

template <class T, class Next> void fill(cga::point<T> &k, Next &&next) {
  k.x = next(), k.y = next(), k.z = next();
}
template <class T, class Next> void fill(cga::direction<T> &k, Next &&next) {
  k.x = next(), k.y = next(), k.z = next();
}
template <class T, class Next> void fill(cga::point_pair<T> &k, Next &&next) {
  fill(k.p, next), fill(k.q, next);
}
template <class T, class Next> void fill(cga::flat_point<T> &k, Next &&next) {
  fill(k.p, next);
}
template <class T, class Next> void fill(cga::line<T> &k, Next &&next) {
  fill(k.p, next), fill(k.q, next);
}
template <class T, class Next> void fill(cga::circle<T> &k, Next &&next) {
  fill(k.c, next), fill(k.N, next), k.r = next();
}
template <class T, class Next> void fill(cga::plane<T> &k, Next &&next) {
  fill(k.N, next), k.d = next();
}
template <class T, class Next> void fill(cga::sphere<T> &k, Next &&next) {
  fill(k.c, next), k.r = next();
}
template <class B, class Next> void fill_blade(B &b, Next &&next) {
  for (const auto &[blade, value] : fields(b))
    *value = next();
}

// ---- the blades that they represent ----

// R(4,1) over e1, e2, e3, n, nb: n and nb are null, n . nb = 2.
inline const oracle::dense_algebra &space() {
  static const oracle::dense_algebra g(
      {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 0, 2}, {0, 0, 0, 2, 0}});
  return g;
}
// I = e1 e2 e3 e eb, and e ^ eb = -(n ^ nb)/2.
inline multivector I() {
  return oracle::scale(mpq_class(-1, 2), space().pseudoscalar());
}

inline multivector vector_of(const mpq_class &x, const mpq_class &y, const mpq_class &z) {
  multivector m(32);
  m[e1] = x, m[e2] = y, m[e3] = z;
  return m;
}
inline multivector infinity() {
  return space().vector(3);
}

inline multivector defined(const cga::point<exact> &p) {
  multivector m = vector_of(2 * p.x.v, 2 * p.y.v, 2 * p.z.v);
  m[n] = p.x.v * p.x.v + p.y.v * p.y.v + p.z.v * p.z.v;
  m[nb] = -1;
  return m;
}
inline multivector defined(const cga::direction<exact> &v) {
  return vector_of(v.x.v, v.y.v, v.z.v);
}
inline multivector defined(const cga::point_pair<exact> &k) {
  return outer(defined(k.p), defined(k.q));
}
inline multivector defined(const cga::flat_point<exact> &k) {
  return outer(defined(k.p), infinity());
}
inline multivector defined(const cga::line<exact> &k) {
  return outer(outer(defined(k.p), defined(k.q)), infinity());
}
// Spheres, planes and circles by their duals, from centre, normal and radius.
inline multivector undual(const multivector &m) {
  return oracle::scale(-1, space().geometric(I(), m));
}
inline multivector defined(const cga::sphere<exact> &k) {
  return undual(subtract(defined(k.c), oracle::scale(k.r.v * k.r.v, infinity())));
}
inline multivector defined(const cga::plane<exact> &k) {
  return undual(add(defined(k.N), oracle::scale(k.d.v, infinity())));
}
inline multivector defined(const cga::circle<exact> &k) {
  const multivector c = defined(k.c), normal = defined(k.N);
  const mpq_class along = oracle::scalar_part(space().left_contraction(normal, c)); // N | c, with c twice the position
  return undual(
      outer(subtract(c, oracle::scale(k.r.v * k.r.v, infinity())), add(normal, oracle::scale(along / 2, infinity()))));
}

} // namespace meetc::generated_test

#endif
