// The affine filter: rules out pairs by the signs of a reject stage that are affine in one object's numbers, one object
// against tiles of others.
//
// Problem: where every pair of two sets is looked at, turning rows into lanes for each pair, and computing a bound for each
// pair, take most of the time. Yet on which side of one plane many points lie costs three multiply-adds a point.
// Method: the coefficients of such signs (affine_forms.hpp) are computed once for each object, in double with their error,
// and the other object's numbers lie field by field in tiles of 16, moved and scaled into [-1, 1]. The coefficients are
// divided by the bound of the error of the computed sum, so that a sum beyond 1 has a proved sign, and the decision over
// the signs needs one comparison (lane_margins.hpp). Signs with coefficients from a are looked at first, then, where these
// leave some element of a tile, those with coefficients from b.
//
// The bound. A sign's value, in units of the bound E, is p = sum c_k y_k + c, with |y_k| <= 1, at most 16 numbers, and each
// c_k within e_k of what was computed in double. Let S be the sum of the magnitudes of the computed ones, c included, and e
// the sum of the e_k, of coefficients that the layout takes for zero, and of differences to those that it takes for equal.
// A term is rounded when its coefficient becomes a float, when its number becomes one, in the product, and in at most 17
// sums: 20 roundings of at most 2^-24, or of 2^-23 if the environment rounds otherwise, so the sum is within
// 1.3 2^-19 S + e of p. E = 2^-18 S + 2 e is more by a factor that covers the roundings of E and of the division. What
// underflows in float adds less than 2^-100 to a sum of units. A pair is ruled out only where a sum exceeds 1.
#ifndef MEETC_AFFINE_FILTER_HPP
#define MEETC_AFFINE_FILTER_HPP

#include <meetc/lanes.hpp>

#include <meetc/affine_forms.hpp>
#include <meetc/table.hpp>
#include <meetc/table_entry.hpp>

MEETC_NAMESPACE(meetc) {

// Calls f(std::integral_constant<int, i>) for i < N, unrolled: f's indices are constants.
template <int N, class F> MEETC_INLINE void unrolled(F &&f) {
  [&f]<int... I>(std::integer_sequence<int, I...>) MEETC_INLINED_LAMBDA {
    (f(std::integral_constant<int, I>()), ...);
  }
  (std::make_integer_sequence<int, N>());
}

// Numbers of a range become (x - middle) / width, in [-1, 1]; the width is a power of two.
struct unit_range {
  double middle = 0, width = 1;

  unit_range() = default;
  unit_range(double lo, double hi) : middle(lo / 2 + hi / 2) {
    const double half = hi - middle > middle - lo ? hi - middle : middle - lo;
    if (half > 0) // a range without an end has no width, and nothing is proved of it
      width = half <= std::numeric_limits<double>::max() ? std::ldexp(1.0, std::ilogb(half) + 1) : 0;
  }
};
// The ranges of an operand's numbers. Coordinates of one axis have one range, so that a coefficient that they share in the
// program, such as one of a normal, stays shared.
template <class P, operand Of> struct unit_ranges {
  static constexpr int first = Of == operand::b ? P::inputs_a : 0,
                       numbers = Of == operand::b ? P::inputs_b : P::inputs_a;
  unit_range of[numbers];

  explicit unit_ranges(const field_ranges &fields) {
    for (int k = 0; k < numbers; ++k) {
      double lo = fields.lo[k], hi = fields.hi[k];
      for (int j = 0; j < numbers; ++j)
        if (P::axis(first + k) >= 0 && P::axis(first + j) == P::axis(first + k)) {
          lo = fields.lo[j] < lo ? fields.lo[j] : lo;
          hi = fields.hi[j] > hi ? fields.hi[j] : hi;
        }
      of[k] = unit_range(lo, hi);
    }
  }
};

// Bound: the power of two that bounds a sum's roundings; Errors: how often the coefficients' errors count. Tests use others.
template <class P, int Bound = -18, int Errors = 2> struct affine_kernel {
  template <operand Of> static constexpr affine_layout<P, Of> layout = affine_layout_of<P, Of>();
  static constexpr const affine_layout<P, operand::b> &in_b = layout<operand::b>; // their coefficients come from a
  static constexpr const affine_layout<P, operand::a> &in_a = layout<operand::a>;
  // A single object of a has its coefficients, then its numbers. A tile of b has numbers, then coefficients.
  static constexpr int single_floats = in_b.coefficients + in_a.columns;
  static constexpr int tile_floats = in_b.columns + in_a.coefficients;
  static constexpr bool exists =
      in_b.signs + in_a.signs > 0 && P::inputs_a <= field_ranges::most &&P::inputs_b <= field_ranges::most;

  // ---- the numbers of an object ----

  // The coefficients of the signs that are affine in the numbers of operand Of, from a row of the other operand.
  template <operand Of>
  static MEETC_INLINE void coefficients(const float *row, const unit_ranges<P, Of> &ranges, float *out) {
    constexpr const affine_layout<P, Of> &l = layout<Of>;
    constexpr int n = l.numbers;
    using form = tracked_form<n>;
    constexpr int inputs = Of == operand::b ? P::inputs_a : P::inputs_b;
    tracked constants[inputs];
    for (int i = 0; i < inputs; ++i)
      constants[i] = tracked(static_cast<double>(row[i]));
    form variables[n], beyond, v[P::reject_stage::atoms];
    for (int k = 0; k < n; ++k)
      variables[k].c[k] = tracked(ranges.of[k].width), variables[k].c[n] = tracked(ranges.of[k].middle);
    reject_forms<P, Of, form>(constants, variables, beyond, v);
    double c[l.coefficients + 1] = {};
    bool have[l.coefficients + 1] = {};
    double unit = 0;
    for (int i = 0; i < l.signs; ++i) {
      double size = 0, error = 0;
      for (int k = 0; k <= n; ++k) {
        const tracked x = l.turned[i] ? -v[l.sign[i]].c[k] : v[l.sign[i]].c[k];
        const int at = l.place[i][k] - 1;
        if (at >= 0 && !have[at])
          c[at] = x.v, have[at] = true;
        size += std::fabs(x.v);
        error += x.e + std::fabs(at < 0 ? x.v : x.v - c[at]);
      }
      const double bound = std::ldexp(size, Bound) + Errors * error;
      unit = bound > unit || bound != bound ? bound : unit;
    }
    bool known = unit < HUGE_VAL;
    for (int i = 0; i < l.coefficients; ++i)
      known &= std::fabs(c[i] / unit) <= std::ldexp(1.0, 1 - Bound);
    for (int i = 0; i < l.coefficients; ++i)
      out[i] = known ? static_cast<float>(c[i] / unit) : 0.0F; // zeros rule nothing out
  }
  // The numbers of operand Of that the signs affine in them read. Returns whether all its numbers are in their ranges.
  template <operand Of>
  static MEETC_INLINE bool columns(const float *row, const unit_ranges<P, Of> &ranges, float *out) {
    constexpr const affine_layout<P, Of> &l = layout<Of>;
    const auto in_unit = [&](int k) {
      return (static_cast<double>(row[k]) - ranges.of[k].middle) / ranges.of[k].width;
    };
    bool in_range = true;
    for (int k = 0; k < l.numbers; ++k)
      in_range &= in_unit(k) >= -1 && in_unit(k) <= 1;
    for (int i = 0; i < l.columns; ++i)
      out[i] = static_cast<float>(in_unit(l.column[i]));
    return in_range;
  }

  static bool singles(const field_ranges &a, const field_ranges &b, const float *rows, std::size_t n, float *out) {
    const unit_ranges<P, operand::a> of_a(a);
    const unit_ranges<P, operand::b> of_b(b);
    if (!standard_environment())
      return false;
    rows = after_check(rows);
    bool in_range = true;
    for (std::size_t i = 0; i < n && in_range; ++i) {
      const float *const row = rows + i * std::size_t{P::inputs_a};
      float *const to = out + i * std::size_t{single_floats};
      coefficients<operand::b>(row, of_b, to);
      in_range = columns<operand::a>(row, of_a, to + in_b.coefficients);
    }
    after_check(out);
    return in_range;
  }
  static bool tiles(const field_ranges &a, const field_ranges &b, const float *rows, std::size_t n, float *out) {
    const unit_ranges<P, operand::a> of_a(a);
    const unit_ranges<P, operand::b> of_b(b);
    if (!standard_environment())
      return false;
    rows = after_check(rows);
    bool in_range = true;
    for (std::size_t i = 0; i < (n + filter_tile - 1) / filter_tile * filter_tile && in_range; ++i) {
      const float *const row = rows + (i < n ? i : n - 1) * std::size_t{P::inputs_b};
      float numbers[tile_floats + 1];
      in_range = columns<operand::b>(row, of_b, numbers);
      coefficients<operand::a>(row, of_a, numbers + in_b.columns);
      for (std::size_t k = 0; k < tile_floats; ++k)
        out[(i / filter_tile * tile_floats + k) * filter_tile + i % filter_tile] = numbers[k];
    }
    after_check(out);
    return in_range;
  }

  // ---- in lanes ----

  // The values of the signs that are affine in the numbers of operand Of.
  template <operand Of, class Coefficient, class Column>
  static MEETC_INLINE void values(const Coefficient &coefficient, const Column &column, lanes *v) {
    unrolled<layout<Of>.signs>([&](auto i) MEETC_INLINED_LAMBDA {
      constexpr int constant = layout<Of>.place[i][layout<Of>.numbers];
      lanes sum = constant > 0 ? coefficient(constant - 1) : lanes(0.0F);
      unrolled<layout<Of>.columns>([&](auto j) MEETC_INLINED_LAMBDA {
        constexpr int at = layout<Of>.place[i][layout<Of>.column[j]];
        if constexpr (at > 0)
          sum = fma(coefficient(at - 1), column(j), sum);
      });
      v[i] = sum;
    });
  }
  template <operand Of> static MEETC_INLINE void put(const lanes *v, margin *s) {
    unrolled<layout<Of>.signs>([&](auto i) MEETC_INLINED_LAMBDA {
      s[P::reject_stage::first + layout<Of>.sign[i]] = {v[i], true, layout<Of>.turned[i]};
    });
  }

  // Whether all values with coefficients from a beyond 1, or all below -1, rule a pair out.
  static constexpr bool rejects_all(bool above) {
    sign_set s[P::reject_stage::first + P::reject_stage::atoms + 1] = {};
    for (sign_set &x : s)
      x = sign_set::all();
    for (int i = 0; i < in_b.signs; ++i)
      s[P::reject_stage::first + in_b.sign[i]] =
          sign_set::of(above != in_b.turned[i] ? sign::positive : sign::negative);
    return in_b.signs > 0 && !can_be_false(P::rejected(s));
  }
  static constexpr bool by_sides = rejects_all(true) && rejects_all(false);
};

// Finds the elements of tiles that one object of a leaves.
template <class P, class Kernel = affine_kernel<P>> class affine_finder {
  using kernel = Kernel;

public:
  MEETC_INLINE affine_finder(const float *single, const float *tiles, near_tile *out)
      : single_(single), tiles_(tiles), out_(out) {
    for (int k = 0; k < kernel::in_b.coefficients; ++k)
      coefficients_[k] = lanes(single[k]);
  }

  // Neighbours mostly lie on the same side, as those before did: one comparison for several tiles.
  MEETC_INLINE near_tile *look(std::size_t count) {
    std::size_t t = 0;
    if constexpr (kernel::by_sides) {
      constexpr std::size_t together = 4;
      for (; t + together <= count; t += together) {
        if (above_ ? all_above(t, t + together) : all_below(t, t + together))
          continue;
        for (std::size_t i = t; i < t + together; ++i)
          put(i);
      }
    }
    for (; t < count; ++t)
      put(t);
    return out_;
  }

private:
  static constexpr int parts = filter_tile / lane_count;
  static constexpr std::size_t floats = std::size_t{kernel::tile_floats} * filter_tile; // of a tile

  MEETC_INLINE void values_of_a(const float *part, lanes *v) const {
    kernel::template values<operand::b>([&](int k) MEETC_INLINED_LAMBDA { return coefficients_[k]; },
                                        [&](int k) MEETC_INLINED_LAMBDA { return lanes::from(part + k * filter_tile); },
                                        v);
  }
  template <class Join> MEETC_INLINE lanes joined(std::size_t t, std::size_t end, lanes start, const Join &join) const {
    for (; t < end; ++t)
      for (int p = 0; p < parts; ++p) {
        lanes v[kernel::in_b.signs + 1];
        values_of_a(tiles_ + t * floats + p * lane_count, v);
        unrolled<kernel::in_b.signs>([&](auto i) MEETC_INLINED_LAMBDA { start = join(start, v[i]); });
      }
    return start;
  }
  MEETC_INLINE bool all_above(std::size_t t, std::size_t end) const {
    const lanes least =
        joined(t, end, lanes(2.0F), [](lanes a, lanes b) MEETC_INLINED_LAMBDA { return smaller(a, b); });
    return greater(least, lanes(1.0F)) == every_lane;
  }
  MEETC_INLINE bool all_below(std::size_t t, std::size_t end) const {
    const lanes most = joined(t, end, lanes(-2.0F), [](lanes a, lanes b) MEETC_INLINED_LAMBDA { return larger(a, b); });
    return greater(lanes(-1.0F), most) == every_lane;
  }

  void put(std::size_t t) {
    *out_ = {static_cast<std::uint32_t>(t), left(tiles_ + t * floats)};
    out_ += out_->elements != 0;
  }
  // The elements of a tile that are not ruled out.
  std::uint32_t left(const float *tile) {
    margin s[P::reject_stage::first + P::reject_stage::atoms + 1];
    std::uint32_t elements = 0;
    for (int p = 0; p < parts; ++p) {
      const float *const part = tile + p * lane_count;
      for (margin &x : s)
        x = margin::none();
      lane_mask open = every_lane;
      if constexpr (kernel::in_b.signs > 0) {
        lanes v[kernel::in_b.signs];
        values_of_a(part, v);
        kernel::template put<operand::b>(v, s);
        open &= ~proved(to_truth_margin(P::rejected(s)));
        above_ = greater(v[0], lanes(0.0F)) != 0;
      }
      if constexpr (kernel::in_a.signs > 0)
        if (open != 0) {
          lanes v[kernel::in_a.signs];
          const float *const of_b = part + kernel::in_b.columns * filter_tile;
          const float *const of_a = single_ + kernel::in_b.coefficients;
          kernel::template values<operand::a>([&](int k)
                                                  MEETC_INLINED_LAMBDA { return lanes::from(of_b + k * filter_tile); },
                                              [&](int k) MEETC_INLINED_LAMBDA { return lanes(of_a[k]); }, v);
          kernel::template put<operand::a>(v, s);
          open &= ~proved(to_truth_margin(P::rejected(s)));
        }
      elements |= open << p * lane_count;
    }
    return elements;
  }

  lanes coefficients_[kernel::in_b.coefficients + 1];
  const float *single_, *tiles_;
  near_tile *out_;
  bool above_ = true; // the side of the last tile that was looked at
};

template <class P> near_tile *affine_near(const float *single, const float *tiles, std::size_t count, near_tile *out) {
  return affine_finder<P>(single, tiles, out).look(count);
}

template <class P>
inline constexpr affine_filter affine_filter_by{affine_kernel<P>::single_floats, affine_kernel<P>::tile_floats,
                                                guarded<affine_kernel<P>::singles>, guarded<affine_kernel<P>::tiles>,
                                                guarded<affine_near<P>>};
// Null where the predicate has no such sign.
template <class P> constexpr const affine_filter *affine_filter_of() {
  if constexpr (P::reject_stage::atoms > 0)
    if constexpr (affine_kernel<P>::exists)
      return &affine_filter_by<P>;
  return nullptr;
}

} // MEETC_NAMESPACE(meetc)

#endif
