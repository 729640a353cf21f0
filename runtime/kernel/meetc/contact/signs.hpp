// The signs from which contacts are found, all of them from one emitted sign: on which side of a plane a point lies.
//
// det(a, b, c, d) = [b-a, c-a, d-a]. With d = a but for coordinate k it is (d-a)_k times component k of (b-a) x (c-a), which
// gives the turn of three points along an axis from the same sign, and without rounding.
#ifndef MEETC_CONTACT_SIGNS_HPP
#define MEETC_CONTACT_SIGNS_HPP

#include <meetc/contact/code.hpp>
#include <meetc/decide/first_stages.hpp>
#include <meetc/decide/later_rungs.hpp>

MEETC_NAMESPACE(meetc) {

// The value of an emitted sign, which is exact, under the standard word.
template <class Sign> MEETC_HD int exact_sign(const float *a, const float *b) {
  if (standard_environment()) {
    const sign_set known = certify_sign_here<Sign, in_fp32>(after_check(a), after_check(b));
    if (is_known(known))
      return before_return(static_cast<int>(known_sign(known)));
  }
#if !defined(__CUDA_ARCH__)
  return static_cast<int>(Sign::after_fp32(a, b));
#else
  return static_cast<int>(later_rungs_sign<Sign>(a, b));
#endif
}
// Its value for small integers, which tells its convention.
template <class Sign> MEETC_HD constexpr int sign_of_integers(const std::int64_t *a, const std::int64_t *b) {
  std::int64_t value[1] = {0};
  stage_values<typename Sign::common_stage>(a, b, value);
  const sign s[1] = {value[0] > 0 ? sign::positive : value[0] < 0 ? sign::negative : sign::zero};
  return static_cast<int>(Sign::value(s));
}

// How an emitted sign is told. `Side` is that of (triangle, point), a multiple of det.
//
// Exactly, under the standard word.
template <class Side> struct exact_sides {
  using side = Side;

  MEETC_HD static constexpr bool known() { return true; }
  MEETC_HD static int tell(const float *triangle, const float *d) { return exact_sign<Side>(triangle, d); }
};
// By floating-point numbers alone, which take few registers: what they leave unsure is told as 0, and no sign after it means
// anything.
template <class Side> class bounded_sides {
public:
  using side = Side;

  MEETC_HD bool known() const { return known_; }
  MEETC_HD int tell(const float *triangle, const float *d) {
    const sign_set s = known_ ? sides(triangle, d) : sign_set::all();
    known_ = is_known(s);
    return known_ ? static_cast<int>(known_sign(s)) : 0;
  }

private:
  bool known_ = true;

  // Many places ask for it. A device may call it, since no long integers are at work (bytecode.hpp).
#if defined(__CUDA_ARCH__)
  __noinline__
#else
  MEETC_NOINLINE
#endif
      MEETC_HD static sign_set
      sides(const float *triangle, const float *d) {
    using stage = typename Side::common_stage;
    sign_set s[1] = {sign_set::all()};
    if (!standard_environment())
      return s[0];
    triangle = after_check(triangle), d = after_check(d);
    if (!bounded_signs<Side, in_fp32>(triangle, d).template get<stage>(s) &&
        !fp64_signs<Side>(triangle, d).template get<stage>(s))
      bounded_signs<Side, in_fp64x2>(triangle, d).template get<stage>(s);
    const sign_set told = Side::value(s);
    return {static_cast<std::uint8_t>(before_return(int{told.bits}))};
  }
};

template <class Sides> class contact_signs {
  using emitted = typename Sides::side;
  static_assert(emitted::inputs_a == 9 && emitted::inputs_b == 3 && emitted::atoms == 1);

public:
  // Whether all signs so far are right.
  MEETC_HD bool known() const { return sides_.known(); }

  MEETC_HD int side(const float *triangle, const float *d) { return factor * sides_.tell(triangle, d); }
  MEETC_HD int det(const float *a, const float *b, const float *c, const float *d) {
    float row[9];
    for (int k = 0; k < 3; ++k)
      row[k] = a[k], row[3 + k] = b[k], row[6 + k] = c[k];
    return side(row, d);
  }
  MEETC_HD int turn(int axis, const float *a, const float *b, const float *c) {
    float d[3] = {a[0], a[1], a[2]};
    d[axis] = a[axis] == 0 ? 1.0F : 0.0F;
    return d[axis] > a[axis] ? det(a, b, c, d) : -det(a, b, c, d);
  }

private:
  Sides sides_;

  // The sign of the factor, by a tetrahedron with det = 1.
  MEETC_HD static constexpr int convention() {
    const std::int64_t triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, point[3] = {0, 0, 1};
    return sign_of_integers<emitted>(triangle, point);
  }
  static constexpr int factor = convention();
  static_assert(factor != 0, "the sign that tells contacts is not that of a plane and a point");
};

MEETC_HD constexpr int next_corner(int i) {
  return i == 2 ? 0 : i + 1;
}

// The carrier of a triangle by three signs, one for each edge, of a point or a line: none (-1) where both signs occur, and
// else the carrier on whose edges they are 0.
MEETC_HD constexpr int carrier_by_edges(int w0, int w1, int w2) {
  const bool above = w0 > 0 || w1 > 0 || w2 > 0, below = w0 < 0 || w1 < 0 || w2 < 0;
  if (above && below)
    return -1;
  if (w0 != 0 && w1 != 0 && w2 != 0)
    return open_face;
  if (w0 == 0)
    return w2 == 0 ? 0 : w1 == 0 ? 1 : first_edge;
  return w1 != 0 ? first_edge + 2 : w2 == 0 ? 2 : first_edge + 1;
}

} // MEETC_NAMESPACE(meetc)

#endif
