// core/views/vec.hpp: vectors of three doubles.
#ifndef MEETC_CORE_VIEWS_VEC_HPP
#define MEETC_CORE_VIEWS_VEC_HPP

#include <cmath>

namespace meetc {

struct vec {
  double x, y, z;
};
inline vec operator+(const vec &a, const vec &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec operator-(const vec &a, const vec &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec operator*(double s, const vec &a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const vec &a, const vec &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline vec cross(const vec &a, const vec &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double root(double v) {
  return std::sqrt(v);
}
inline vec normal(const vec &a) {
  return (1 / root(dot(a, a))) * a;
}

} // namespace meetc

#endif
