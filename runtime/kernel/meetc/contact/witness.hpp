// A witness: one point of a ball and of another ball or a triangle that touch, or of the ball's surface and the other.
//
// Two balls: where the plane of points with equal powers cuts the line of centres, or the nearer centre where it does not cut
// between the centres; the point lies in both. Two surfaces: a point of their circle, in the direction at right angles to the
// line of centres that is nearest to the axis with the least difference of centres, towards the origin. A ball and a triangle:
// the triangle's point nearest to the centre; a surface: the first point at distance r on the way from there to the farthest
// corner.
//
// Numbers are double-double, and start from the exact differences of float32 numbers. Before it is rounded the witness lies
// within 2^-46 m of each element, with m the sum of the radii and, for each axis, of the greatest difference of coordinates.
// Each step is within some 2^-100 of its operands but one: in a triangle of which two sides enclose an angle of sine s the
// projection on the plane is off by up to 2^-97 m / s. There an edge has a point within m s of it, and the better of the two is
// within 2^-48 m. Nothing is fused but where it is written, so the bytes are the same on each device.
#ifndef MEETC_CONTACT_WITNESS_HPP
#define MEETC_CONTACT_WITNESS_HPP

#include <meetc/contact/code.hpp>
#include <meetc/contact/label_points.hpp>
#include <meetc/contact/square_root.hpp>

#include <cstddef>

MEETC_NAMESPACE(meetc) {

class witness_point {
  using number = double_double;

public:
  // b has three corners, or none if it is a ball. A ball's row is its centre and its radius.
  MEETC_HD witness_point(const contact_element &a, const contact_element &b, bool of_surfaces) : centre_(a.row) {
    if (b.corners != 0) {
      at_ = nearest(a.row, b.row);
      if (of_surfaces)
        go_to_surface(a.row, b.row);
    } else if (!of_surfaces) {
      at_ = between_centres(a.row, b.row);
    } else if (a.row[3] <= b.row[3]) {
      at_ = on_circle(a.row, b.row);
    } else {
      centre_ = b.row;
      at_ = on_circle(b.row, a.row);
    }
  }

  // A coordinate that the type does not reach is infinite; that occurs for two surfaces alone.
  template <class Real> MEETC_HD void write(Real *out) const {
    for (int k = 0; k < 3; ++k)
      out[k] = static_cast<Real>((at_.k[k] + double{centre_[k]}).hi) + Real(0);
  }

private:
  struct vector {
    number k[3];
  };
  const float *centre_;
  vector at_; // seen from the centre

  MEETC_HD static number whole(double x) { return number(x); }
  MEETC_HD static vector from_to(const float *x, const float *y) {
    return {{two_sum(double{y[0]}, -double{x[0]}), two_sum(double{y[1]}, -double{x[1]}),
             two_sum(double{y[2]}, -double{x[2]})}};
  }
  // x + t y
  MEETC_HD static vector along(const vector &x, const number &t, const vector &y) {
    return {{x.k[0] + t * y.k[0], x.k[1] + t * y.k[1], x.k[2] + t * y.k[2]}};
  }
  MEETC_HD static number dot(const vector &x, const vector &y) {
    return x.k[0] * y.k[0] + x.k[1] * y.k[1] + x.k[2] * y.k[2];
  }
  MEETC_HD static number quotient(const number &x, const number &y) {
    const double first = x.hi / y.hi;
    const number rest = x - y * first;
    return fast_two_sum(first, rest.hi / y.hi);
  }
  MEETC_HD static bool less(const number &x, const number &y) { return x.hi != y.hi ? x.hi < y.hi : x.lo < y.lo; }
  MEETC_HD static number within(const number &low, const number &x, const number &high) {
    return less(x, low) ? low : less(high, x) ? high : x;
  }
  MEETC_HD static number not_below_zero(const number &x) { return x.hi > 0 ? x : whole(0); }

  MEETC_HD static vector between_centres(const float *a, const float *b) {
    const vector line = from_to(a, b), start{{whole(0), whole(0), whole(0)}};
    const number square = dot(line, line), ra = whole(a[3]), rb = whole(b[3]);
    if (!(square.hi > 0))
      return start;
    const number half = quotient(square + (ra - rb) * (ra + rb), square + square);
    return along(start, within(whole(0), half, whole(1)), line);
  }

  // The first surface is no larger than the second, so that an error along the line of centres does not grow.
  MEETC_HD static vector on_circle(const float *a, const float *b) {
    const vector line = from_to(a, b), start{{whole(0), whole(0), whole(0)}};
    const number reach = square_root(dot(line, line)), ra = whole(a[3]), rb = whole(b[3]);
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      axis = magnitude_of(line.k[k]) < magnitude_of(line.k[axis]) ? k : axis;
    vector middle = start, aside = start; // aside: of any length
    aside.k[axis] = whole(1);
    number across = ra;
    if (reach.hi > 0) {
      const number beside = quotient((reach - rb) * (reach + rb) + ra * ra, reach + reach);
      const number ahead = within(-ra, beside, ra);
      across = square_root(not_below_zero((ra - ahead) * (ra + ahead)));
      middle = along(start, quotient(ahead, reach), line);
      aside = along(aside, -quotient(quotient(line.k[axis], reach), reach), line);
      across = quotient(across, square_root(dot(aside, aside)));
    }
    return along(middle, (middle.k[axis] + double{a[axis]}).hi > 0 ? -across : across, aside);
  }

  MEETC_HD static vector nearest(const float *ball, const float *triangle) {
    vector best = from_to(ball, triangle);
    number least = dot(best, best);
    const auto take = [&](const vector &x) {
      const number square = dot(x, x);
      if (less(square, least))
        best = x, least = square;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const float *const p = triangle + 3 * i, *const q = triangle + 3 * ((i + 1) % 3);
      const vector start = from_to(ball, p), edge = from_to(p, q);
      const number square = dot(edge, edge);
      if (square.hi > 0)
        take(along(start, within(whole(0), quotient(-dot(start, edge), square), whole(1)), edge));
    }
    // The projection on the plane, by an edge and what another edge has at right angles to it.
    const vector start = from_to(ball, triangle), edge = from_to(triangle, triangle + 3),
                 other = from_to(triangle, triangle + 6);
    const number square = dot(edge, edge);
    if (!(square.hi > 0))
      return best;
    const number common = dot(other, edge);
    const vector height = along(other, -quotient(common, square), edge);
    const number height_square = dot(height, height);
    if (!(height_square.hi > 0))
      return best;
    const number t = quotient(-dot(start, height), height_square);
    const number s = quotient(-dot(start, edge) - t * common, square);
    if (t.hi >= 0 && s.hi >= 0 && !less(whole(1), s + t))
      take(along(along(start, s, edge), t, other));
    return best;
  }

  // From the triangle's point nearest to the centre, no farther from it than r, towards a corner at least as far as r.
  MEETC_HD void go_to_surface(const float *ball, const float *triangle) {
    vector corner = from_to(ball, triangle);
    for (std::size_t i = 1; i < 3; ++i)
      if (const vector x = from_to(ball, triangle + 3 * i); less(dot(corner, corner), dot(x, x)))
        corner = x;
    const vector way = along(corner, whole(-1), at_);
    const number length = square_root(dot(way, way)), r = whole(ball[3]), from = square_root(dot(at_, at_));
    if (!(length.hi > 0))
      return;
    // s^2 + 2 b s = (r - from) (r + from)
    const number b = not_below_zero(quotient(dot(at_, way), length)), power = not_below_zero((r - from) * (r + from));
    const number whole_way = b + square_root(b * b + power);
    if (whole_way.hi > 0)
      at_ = along(at_, quotient(within(whole(0), quotient(power, whole_way), length), length), way);
  }
};

// The witness of a pair with such a code.
template <class Real>
MEETC_HD void place_witness(const contact_element &a, const contact_element &b, contact_code code, Real *out) {
  witness_point(a, b, code.of_surfaces()).write(out);
}

} // MEETC_NAMESPACE(meetc)

#endif
