// bench/baselines/vectors.hpp: the linear algebra that the classic tests need, on host and device.
#ifndef MEETC_BENCH_BASELINES_VECTORS_HPP
#define MEETC_BENCH_BASELINES_VECTORS_HPP

#include <meetc/support.hpp>

#include <cstddef>

MEETC_NAMESPACE(meetc::baselines) {

template <class T> struct vec { T x, y, z; };
template <class T> MEETC_HD inline vec<T> operator-(const vec<T> &a, const vec<T> &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> MEETC_HD inline T dot(const vec<T> &a, const vec<T> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> MEETC_HD inline vec<T> cross(const vec<T> &a, const vec<T> &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> MEETC_HD inline T magnitude(T x) {
  return x < 0 ? -x : x;
}
// Point i of a row.
template <class T> MEETC_HD inline vec<T> corner(const T *row, int i) {
  const T *const at = row + std::ptrdiff_t{3} * i;
  return {at[0], at[1], at[2]};
}

// The axis 0, 1, 2 along which v is longest.
template <class T> MEETC_HD inline int longest_axis(const vec<T> &v) {
  const T x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
  return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}
// Selects instead of indexing, since the device's compiler does not know the index.
template <class T> MEETC_HD inline T along(const vec<T> &v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// A point of the plane that is left when an axis is dropped. The order of axes keeps the orientation.
template <class T> struct flat { T x, y; };
template <class T> MEETC_HD inline flat<T> dropped(const vec<T> &v, int axis) {
  return {axis == 0 ? v.y : axis == 1 ? v.z : v.x, axis == 0 ? v.z : axis == 1 ? v.x : v.y};
}
// Twice the signed area of a, b, c: positive anticlockwise.
template <class T> MEETC_HD inline T area(const flat<T> &a, const flat<T> &b, const flat<T> &c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

} // MEETC_NAMESPACE(meetc::baselines)

#endif
