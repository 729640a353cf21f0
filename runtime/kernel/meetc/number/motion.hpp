// Motions of space as dual quaternions: their exponentials, logarithms, roots, norms and matrices.
//
// V = s + u + J (p + w), where u and w are vectors of quaternion units and J commutes with them and squares to 0. Emitted code
// reads these numbers off the blades of rotors and motors, whatever their basis is.
//
// Method: a vector is its length times its direction l, computed at a scale of its own, and a dual vector splits into its
// part along l and the rest. Each factor of these parts is a quotient without cancellation, so that no series is needed near 0
// or pi.
//
// Errors: u is the unit roundoff of T; the library's sin, cos and atan2 are taken to err by at most one unit in the last place.
// Each function states a bound in the Euclidean length of the numbers' parts, against the exact value at the stored numbers,
// barring under- and overflow. tests/generated/analytic measures them against 200 bits, and holds them for all numbers of a few
// bits.
#ifndef MEETC_NUMBER_MOTION_HPP
#define MEETC_NUMBER_MOTION_HPP

#include <meetc/environment/environment.hpp>

#include <cmath>
#include <cstddef>

MEETC_NAMESPACE(meetc) {

template <class T> struct motion { T s, u[3], p, w[3]; };

namespace motions {

template <class T> MEETC_HD inline T dot(const T *a, const T *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T> MEETC_HD inline T largest(T most, const T *of, int count) {
  for (int i = 0; i < count; ++i) {
    const T size = of[i] < T(0) ? -of[i] : of[i];
    most = most < size ? size : most;
  }
  return most;
}

// A vector as its length and its direction, which is 0 where the length is.
template <class T> struct polar { T length, l[3]; };
template <class T> MEETC_HD inline polar<T> polar_of(const T *u) {
  using std::ilogb, std::scalbn, std::sqrt;
  const T most = largest(T(0), u, 3);
  if (!(most > T(0)))
    return {most, {T(0), T(0), T(0)}};
  const int scale = ilogb(most);
  const T v[3] = {scalbn(u[0], -scale), scalbn(u[1], -scale), scalbn(u[2], -scale)};
  const T length = sqrt(dot(v, v));
  return {scalbn(length, scale), {v[0] / length, v[1] / length, v[2] / length}};
}

// V at the scale at which the largest of s and u is in [1, 2), and that scale. All numbers become NaN where s and u are 0,
// since V is no versor then.
template <class T> MEETC_HD inline int scale_to_one(motion<T> &v) {
  using std::ilogb, std::scalbn;
  const T most = largest(largest(T(0), &v.s, 1), v.u, 3);
  if (!(most > T(0))) {
    v.s = v.p = T(NAN); // of which a device has the macro, and no function
    for (int i = 0; i < 3; ++i)
      v.u[i] = v.w[i] = v.s;
    return 0;
  }
  const int scale = ilogb(most);
  v.s = scalbn(v.s, -scale);
  v.p = scalbn(v.p, -scale);
  for (int i = 0; i < 3; ++i) {
    v.u[i] = scalbn(v.u[i], -scale);
    v.w[i] = scalbn(v.w[i], -scale);
  }
  return scale;
}

// The part of w along l is k l; the rest of it times `across`, plus `along` l.
template <class T>
MEETC_HD inline void combine(const T *w, const T *l, const T &k, const T &across, const T &along, T *out) {
  for (int i = 0; i < 3; ++i)
    out[i] = (w[i] - k * l[i]) * across + along * l[i];
}

// The exponential of a bivector u + J w; s and p are not read. Rotation: within (8 + 4 |u|) u of 1. Dual part: within
// (16 + 4 |u|) u of |w|.
template <class T> MEETC_HD inline motion<T> exp(const motion<T> &b) {
  using std::cos, std::sin;
  const polar<T> a = polar_of(b.u);
  const T c = cos(a.length), n = sin(a.length), k = dot(a.l, b.w);
  motion<T> out{c, {n * a.l[0], n * a.l[1], n * a.l[2]}, -(n * k), {}};
  combine(b.w, a.l, k, a.length > T(0) ? T(n / a.length) : T(1), T(c * k), out.w);
  return out;
}

// The bivector u + J w with the least |u| <= pi whose exponential is V / |V|, or -V / |V| where V has no u and a negative s,
// since all directions would do. Rotation: within 12 u of |u|. Dual part: within 24 u of |dual part of V| |log V| / |u|.
template <class T> MEETC_HD inline motion<T> log(motion<T> v) {
  using std::atan2;
  scale_to_one(v);
  const polar<T> a = polar_of(v.u);
  const T angle = a.length > T(0) ? T(atan2(a.length, v.s)) : a.length;
  const T k = dot(a.l, v.w), square = v.s * v.s + a.length * a.length;
  motion<T> out{T(0), {angle * a.l[0], angle * a.l[1], angle * a.l[2]}, T(0), {}};
  combine(v.w, a.l, k, a.length > T(0) ? T(angle / a.length) : T(T(1) / v.s), T((v.s * k - a.length * v.p) / square),
          out.w);
  return out;
}

// V / |V|, where |V|^2 = V ~V is a number plus a multiple of J: the result is a versor even where V is none for its dual part.
// Rotation: within 8 u of 1. Dual part: within 16 u of |dual part of V| / |V|.
template <class T> MEETC_HD inline motion<T> normalise(motion<T> v) {
  using std::sqrt;
  scale_to_one(v);
  const T square = v.s * v.s + dot(v.u, v.u), length = sqrt(square);
  const T off = (v.s * v.p + dot(v.u, v.w)) / square;
  motion<T> out{v.s / length, {}, (v.p - v.s * off) / length, {}};
  for (int i = 0; i < 3; ++i) {
    out.u[i] = v.u[i] / length;
    out.w[i] = (v.w[i] - v.u[i] * off) / length;
  }
  return out;
}

// The square root with s >= 0 of V / |V|, or of -V / |V| where V has no u and a negative s. Rotation: within 8 u of 1. Dual
// part: within 12 u of |dual part of V| / (|V| s), for the s of the root.
template <class T> MEETC_HD inline motion<T> sqrt(const motion<T> &of) {
  using std::sqrt;
  motion<T> v = normalise(of);
  const polar<T> a = polar_of(v.u);
  if (v.s < T(0) && !(a.length > T(0))) {
    v.s = -v.s;
    v.p = -v.p;
    for (int i = 0; i < 3; ++i)
      v.w[i] = -v.w[i];
  }
  const bool wide = v.s < T(0);
  const T more = sqrt((wide ? T(1) - v.s : T(1) + v.s) * T(0.5)), less = a.length / (more * T(2));
  const T c = wide ? less : more, n = wide ? more : less, k = dot(a.l, v.w);
  const T half = (v.s * k - a.length * v.p) * T(0.5);
  motion<T> out{c, {n * a.l[0], n * a.l[1], n * a.l[2]}, -(n * half), {}};
  combine(v.w, a.l, k, T(T(0.5) / c), T(c * half), out.w);
  return out;
}

// |V|, the root of the number in V ~V. Within 4 u of it.
template <class T> MEETC_HD inline T norm(motion<T> v) {
  using std::scalbn, std::sqrt;
  const int scale = scale_to_one(v);
  return v.s == v.s ? T(scalbn(sqrt(v.s * v.s + dot(v.u, v.u)), scale)) : T(0);
}

// The motion of points by V / |V| as a matrix of three rows and four columns, row by row: the rotation by the quaternion s + u,
// and the translation shift (s w - p u + u x w) / (s^2 + u.u). Rotation: within 16 u of 1. Translation: within 16 u of |shift|
// |dual part of V| / |V|.
template <class T> MEETC_HD inline void pose(const motion<T> &of, double shift, double (&m)[12]) {
  motion<double> v{double(of.s),
                   {double(of.u[0]), double(of.u[1]), double(of.u[2])},
                   double(of.p),
                   {double(of.w[0]), double(of.w[1]), double(of.w[2])}};
  scale_to_one(v);
  const double square = v.s * v.s + dot(v.u, v.u);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    m[5 * i] = ((v.s * v.s + v.u[i] * v.u[i]) - (v.u[j] * v.u[j] + v.u[k] * v.u[k])) / square;
    m[4 * i + j] = 2 * (v.u[i] * v.u[j] - v.s * v.u[k]) / square;
    m[4 * j + i] = 2 * (v.u[i] * v.u[j] + v.s * v.u[k]) / square;
    m[4 * i + 3] = shift * ((v.s * v.w[i] - v.p * v.u[i]) + (v.u[j] * v.w[k] - v.u[k] * v.w[j])) / square;
  }
}

} // namespace motions

} // MEETC_NAMESPACE(meetc)

#endif
