// Tests whether a kind may hold a number: it is finite and obeys the kind's `where`. The tests use bits alone, so their
// answers depend neither on flags nor on the control word (which can make a negative subnormal number compare as zero).
#ifndef MEETC_ENVIRONMENT_VALID_HPP
#define MEETC_ENVIRONMENT_VALID_HPP

#include <meetc/environment/environment.hpp>

#include <cstring>

MEETC_NAMESPACE(meetc) {

struct number_parts {
  std::uint64_t magnitude, infinity; // without the sign bit
  bool negative;
};
MEETC_HD inline number_parts parts_of(float x) {
  std::uint32_t b;
  std::memcpy(&b, &x, sizeof b);
  return {b & 0x7fffffff, 0x7f800000, b >> 31 != 0};
}
MEETC_HD inline number_parts parts_of(double x) {
  std::uint64_t b;
  std::memcpy(&b, &x, sizeof b);
  return {b & 0x7fffffffffffffff, 0x7ff0000000000000, b >> 63 != 0};
}

template <class T> MEETC_HD inline bool is_finite(T x) {
  const number_parts b = parts_of(x);
  return b.magnitude < b.infinity;
}
// x >= 0 and x > 0; both are false for NaN.
template <class T> MEETC_HD inline bool not_negative(T x) {
  const number_parts b = parts_of(x);
  return b.magnitude <= b.infinity && (!b.negative || b.magnitude == 0);
}
template <class T> MEETC_HD inline bool is_positive(T x) {
  return not_negative(x) && parts_of(x).magnitude != 0;
}
template <class T> MEETC_HD inline bool is_not_zero(T x) {
  return parts_of(x).magnitude != 0;
}
// x != y; 0 and -0 do not differ.
template <class T> MEETC_HD inline bool differ(T x, T y) {
  const number_parts a = parts_of(x), b = parts_of(y);
  return a.magnitude != b.magnitude || (a.negative != b.negative && a.magnitude != 0);
}
// x <= y for numbers that are not NaN; 0 and -0 are equal.
template <class T> MEETC_HD inline bool not_above(T x, T y) {
  const number_parts a = parts_of(x), b = parts_of(y);
  if (a.negative != b.negative)
    return a.negative || (a.magnitude == 0 && b.magnitude == 0);
  return a.negative ? a.magnitude >= b.magnitude : a.magnitude <= b.magnitude;
}

} // MEETC_NAMESPACE(meetc)

#endif
