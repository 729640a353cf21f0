// Decides pairs in lanes of doubles: the rung fp64 of `certified`, and the first part of `exact`, for the runtime's
// table.
//
// Problem: pairs that fp32 leaves unsure are often degenerate: many of their signs are zero, which no bound can tell
// from a small number.
// Method: if the numbers of a pair are multiples of a step, and differ by so few steps that every value is below 2^53,
// doubles are exact, and the signs are those of the values. Otherwise signs come from values in fp64 with their bound.
// If some are unsure, the same program runs on integers modulo 2^64: on a common grid the value is an integer n, and
// the bound says |n| < 2^62, so that the residue of n is n. This needs neither wide products nor exact values in fp64.
// Doubles that are exact come first, since integers modulo 2^64 are slow in lanes without an instruction that
// multiplies them. The comparison is |v| + E < 2^62 g^k, for values of degree k on a grid of g. Its right side is a
// power of two and exact, unless it underflows to less, which proves nothing. E leaves out the last rounding of v, and
// the sum is rounded too; the factor of two between 2^62 and 2^63 has room for both. A value of degree 3 of differences
// that span 34 bits qualifies, since its bound is about 2^-48 of the largest one. `exact` uses no error bound of the
// compiler, so that it can judge the bounds of the other rungs: it counts roundings (counted_roundings.hpp), and if
// that does not suffice its values carry their own errors (tracked.hpp). It compares equal points first, takes doubles
// that are exact too, and leaves the rare stage open. The caller's function decides the pairs that are left open, one
// by one. A pair's answer does not depend on those that share the lanes with it.
#ifndef MEETC_SIMD_WIDE_DECIDE_HPP
#define MEETC_SIMD_WIDE_DECIDE_HPP

#include <meetc/simd/lanes.hpp>

#include <meetc/decide/counted_roundings.hpp>
#include <meetc/simd/back_off.hpp>
#include <meetc/simd/lane_decide.hpp>
#include <meetc/simd/power_bound.hpp>
#include <meetc/simd/tracked.hpp>

MEETC_NAMESPACE(meetc) {

template <> struct leaf_magnitude<wide_lanes> {
  wide_lanes floor;
  MEETC_INLINE wide_lanes operator()(wide_lanes difference) const { return leaf_at_least(difference, floor); }
};

// The numbers of wide_count pairs.
template <class P> struct wide_rows {
  wide_lanes a[P::inputs_a], b[P::inputs_b];
  wide_lanes extent; // extent_of(a, b)

  MEETC_INLINE void measure() { extent = extent_of<P>(a, b); }
  // Calls f(number) for each number.
  template <class F> MEETC_INLINE void each(F &&f) const {
    for (const wide_lanes x : a)
      f(x);
    for (const wide_lanes x : b)
      f(x);
  }
};

// The pairs' numbers as integers, if they are multiples of a step and their differences are below 2^Span steps.
template <class P> struct whole_rows {
  whole_lanes a[P::inputs_a], b[P::inputs_b];
  wide_lanes step;   // a power of two
  lane_mask on_grid; // the lanes in which they are

  template <int Span> MEETC_INLINE void take(const wide_rows<P> &r) {
    constexpr double least_step = power_of_two(1 - Span, 0.0);
    wide_lanes largest(0x1p-149);
    r.each([&](wide_lanes x) { largest = larger(magnitude_of(x), largest); });
    step = larger(power_below(r.extent) * wide_lanes(least_step), power_below(largest) * wide_lanes(0x1p-49));
    // If the numbers are much larger than their differences, the step is larger too, so the span is less.
    on_grid = compiled_as_written() ? all_bits : 0;
    // 1 / step, a power of two as well: the exponents of the two add up to twice the bias.
    const wide_lanes steps = with_bits(wide_bits{} + (std::int64_t{2046} << 52) - bits_of(step));
    for (int i = 0; i < P::inputs_a && on_grid != 0; ++i) // most pairs off the grid are found by the first numbers
      a[i] = integer(r.a[i] * steps);
    for (int i = 0; i < P::inputs_b && on_grid != 0; ++i)
      b[i] = integer(r.b[i] * steps);
  }

private:
  // A double from 2^52 to 2^53 is an integer plus its last bits.
  MEETC_INLINE whole_lanes integer(wide_lanes x) {
    const wide_lanes beyond(0x1.8p52), sum = x + beyond;
    on_grid &= (sum - beyond == x) & greater(wide_lanes(0x1p51), magnitude_of(x)); // the second is for infinities
    return whole_lanes(reinterpret_cast<whole_lanes::vector>(bits_of(sum) - bits_of(beyond)));
  }
};

// Residues have `bits` bits and are read as signed integers. An integer below 2^limit in magnitude is its own residue.
// A bound in fp64 is about 2^-spare of the largest value. Tests use fewer bits, so that a wrong limit shows, and more
// to spare, so that bounds do exceed the limit.
template <int Bits, int Limit = Bits - 2, int Spare = 48, int Exact = 53> struct residue_width {
  static constexpr int bits = Bits, limit = Limit, spare = Spare;
  static constexpr int exact = Exact; // doubles below 2^exact hold every integer
  static MEETC_INLINE whole_lanes read(whole_lanes n) {
    if constexpr (bits == 64)
      return n;
    n.v <<= 64 - bits;
    return whole_lanes(reinterpret_cast<whole_lanes::vector>(reinterpret_cast<wide_bits>(n.v) >> (64 - bits)));
  }
};

// The span of differences for which a stage's bounds are below 2^limit steps to the power of its degree. A longer span
// is no less safe, since each bound is compared with the limit.
inline constexpr int longest_span = 50;
template <class Stage, class Width> constexpr int bounded_span() {
  const int span = (Width::limit + Width::spare - Stage::growth) / Stage::degree;
  return span < longest_span ? span : longest_span;
}

// The most steps by which numbers can differ, if values below 2^Limit are exact; 0 if that is not known.
template <class P, int Limit = 53> constexpr double exact_steps() {
  double most = 0x1p50;
  each_stage<P>([&most](auto stage) {
    using S = decltype(stage);
    // A product of more than six differences of floats may be subnormal.
    const double here = S::degree > 6 ? 0 : unit_magnitudes<P, S>().highest(Limit);
    most = here < most ? here : most;
  });
  return most;
}
// The lanes in which doubles compute all stages without an error.
template <class P, int Limit = 53> MEETC_INLINE lane_mask exact_lanes(const wide_rows<P> &r) {
  constexpr double most = exact_steps<P, Limit>();
  if (most < 1 || !compiled_as_written())
    return 0;
  const wide_lanes step = wide_lanes(2.0) * power_below(r.extent * wide_lanes((1 + 0x1p-50) / most)),
                   beyond = wide_lanes(0x1.8p52) * step; // a double from 2^52 steps to 2^53 is whole
  wide_bits beside{};                                    // a float of 2^24 steps or more is whole too
  r.each([&](wide_lanes x) { beside |= bits_of((x + beyond) - beyond - x); });
  return zero(whole_lanes(reinterpret_cast<whole_lanes::vector>(beside)));
}
// Adds the signs of eight pairs from bit `from` on, where doubles are exact. Zeros may be marked as negative too, and
// positive signs are not marked.
template <class P, class Stage>
MEETC_NOINLINE void add_exact_signs(const wide_rows<P> *rows, int from, proved_lanes *s) {
  wide_lanes v[vectors_of_eight][Stage::atoms];
  for (int k = 0; k < vectors_of_eight; ++k)
    stage_values<Stage>(rows[k].a, rows[k].b, v[k]);
  for (int i = 0; i < Stage::atoms; ++i) {
    const eight_signs here = signs_of_eight(&v[0][i], Stage::atoms);
    s[i].negative |= here.negative << from;
    s[i].zero |= here.zero << from;
  }
}

// Two sources of errors: v[i] is within error[i] of the truth, and a magnitude of zero proves zero.
struct emitted_bounds {
  static constexpr bool is_exact = false, by_power = true; // the power form comes first, in this arithmetic
  template <class P> using power = in_fp64;
  template <class P, class Stage>
  static MEETC_INLINE void values(const wide_rows<P> &rows, wide_lanes *v, wide_lanes *error, wide_lanes *magnitude) {
    stage_values<Stage>(rows.a, rows.b, v);
    constexpr double floor = power_of_two(Stage::floor_fp64, 0.0);
    stage_magnitudes<Stage>(rows.a, rows.b, leaf_magnitude<wide_lanes>{wide_lanes(floor)}, magnitude);
    for (int i = 0; i < Stage::atoms; ++i)
      error[i] = wide_lanes(in_fp64::factor<Stage>(i)) * magnitude[i];
  }
};
struct running_errors {
  static constexpr bool is_exact = true, by_power = true;
  template <class P> using power = counted_roundings<P>;
  template <class P, class Stage>
  static MEETC_INLINE void values(const wide_rows<P> &rows, wide_lanes *v, wide_lanes *error, wide_lanes *magnitude) {
    using number = tracked_number<wide_lanes>;
    static_assert(Stage::degree <= number::highest_degree);
    number a[P::inputs_a], b[P::inputs_b], found[Stage::atoms];
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = number(rows.a[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = number(rows.b[i]);
    stage_values<Stage>(a, b, found);
    for (int i = 0; i < Stage::atoms; ++i)
      v[i] = found[i].v, error[i] = found[i].e, magnitude[i] = larger(magnitude_of(v[i]), error[i]);
  }
};

template <class P, class Stage, class Width, class How = emitted_bounds> class wide_signs {
public:
  MEETC_INLINE explicit wide_signs(const wide_rows<P> &rows) : rows_(rows) {}

  // The stage's signs as far as they are proved; for pairs outside `wanted` that may be less. It is out of line, as
  // add_exact_signs() is, since gcc 12 miscompiles the caller's loop over masks for AVX-512 if it can merge the two
  // (unless -fno-tree-ter is given; tests/extremes sees it).
  MEETC_NOINLINE void get(lane_mask wanted, proved_lanes *s) const {
    if constexpr (How::by_power && has_power_bound<P, Stage>()) {
      wide_lanes v[Stage::atoms];
      stage_values<Stage>(rows_.a, rows_.b, v);
      signs_by_power<P, Stage, typename How::template power<P>>(v, rows_.extent, s);
      if (known(s, wanted))
        return;
    }
    by_errors(wanted, s);
  }

private:
  static MEETC_INLINE bool known(const proved_lanes *s, lane_mask wanted) {
    lane_mask all = wanted;
    for (int i = 0; i < Stage::atoms; ++i)
      all &= s[i].negative | s[i].zero | s[i].positive;
    return all == wanted;
  }
  MEETC_NOINLINE void by_errors(lane_mask wanted, proved_lanes *s) const {
    wide_lanes v[Stage::atoms], error[Stage::atoms], m[Stage::atoms];
    How::template values<P, Stage>(rows_, v, error, m);
    const lane_mask finite = finite_lanes(v),
                    sound = computes_as_bounded() ? all_bits : 0; // otherwise values prove nothing
    for (int i = 0; i < Stage::atoms; ++i) {
      const proved_lanes p = proved(v[i], error[i], m[i]);
      s[i] = {p.negative & finite & sound, p.zero & sound, p.positive & finite & sound};
    }
    if constexpr (!grouped<P>) // which lie on one grid
      if (!known(s, wanted))
        by_residues(v, error, s);
  }
  // The lanes in which every value is finite. Numbers are below 2^128.
  static MEETC_INLINE lane_mask finite_lanes(const wide_lanes *v) {
    if constexpr (128 * Stage::degree + Stage::growth < 1024)
      return all_bits;
    wide_lanes largest(0.0);
    for (int i = 0; i < Stage::atoms; ++i)
      largest = larger(magnitude_of(v[i]), largest);
    return ~greater(largest, wide_lanes(largest_finite(0.0)));
  }
  MEETC_NOINLINE void by_residues(const wide_lanes *v, const wide_lanes *error, proved_lanes *s) const
      requires(!grouped<P>) {
    whole_rows<P> r;
    r.template take<bounded_span<Stage, Width>()>(rows_);
    if (r.on_grid == 0) // not all integers have been computed
      return;
    whole_lanes n[Stage::atoms];
    stage_values<Stage>(r.a, r.b, n);
    wide_lanes limit[Stage::degree + 1]; // by degree, in the numbers' unit
    constexpr double most = 1 / power_of_two(-Width::limit, 0.0);
    limit[0] = wide_lanes(most);
    for (int k = 0; k < Stage::degree; ++k)
      limit[k + 1] = limit[k] * r.step;
    for (int i = 0; i < Stage::atoms; ++i) {
      const lane_mask unknown = r.on_grid & ~(s[i].negative | s[i].zero | s[i].positive) &
                                greater(limit[Stage::degree_of(i)], magnitude_of(v[i]) + error[i]);
      const whole_lanes value = Width::read(n[i]);
      const lane_mask below = unknown & negative(value), none = unknown & zero(value);
      s[i].negative |= below;
      s[i].zero |= none;
      s[i].positive |= unknown & ~(below | none);
    }
  }

  const wide_rows<P> &rows_;
};

template <class P, class Width, class How, class Open> class wide_decider {
public:
  // `open(i)` decides pair i alone.
  wide_decider(const row_array &a, const row_array &b, const index_pair *pairs, answer *out, const Open &open)
      : a_(a), b_(b), pairs_(pairs), out_(out), open_(open) {}

  void run(std::size_t n) {
    for (std::size_t at = 0; at < n; at += block) {
      const int here = static_cast<int>(n - at < block ? n - at : block);
      load(pairs_ + at, here);
      decide(at, here);
    }
  }

private:
  // Decisions over signs are made for as many pairs as a mask has bits, since they cost as much for fewer.
  static constexpr int block = 32;

  void load(const index_pair *pairs, int n) {
    settled_ = 0;
    const bool tries = doubles_.tries();
    exact_ = 0;
    const int filled = (n + 7) / 8 * 8; // the signs of eight pairs are found at a time
    for (int from = 0; from < filled; from += lane_count) {
      std::uint32_t at_a[lane_count], at_b[lane_count];
      for (int k = 0; k < lane_count; ++k) { // lanes from n on repeat the last pair
        const index_pair p = pairs[from + k < n ? from + k : n - 1];
        at_a[k] = p.a, at_b[k] = p.b;
      }
      lanes a[P::inputs_a], b[P::inputs_b];
      gather_rows<P::inputs_a>(a_.rows, at_a, a);
      gather_rows<P::inputs_b>(b_.rows, at_b, b);
      if constexpr (How::is_exact && P::settled_by != 0)
        if (computes_as_bounded())
          settled_ |= (P::settled_lanes(a, b) & every_lane) << from;
      for (int half = 0; half < lane_count; half += wide_count) {
        wide_rows<P> &to = rows_[(from + half) / wide_count];
        take<P::inputs_a>(a, half, to.a);
        take<P::inputs_b>(b, half, to.b);
        to.measure();
        if (tries)
          exact_ |= (exact_lanes<P, Width::exact>(to) & all_bits >> (block - wide_count)) << (from + half);
      }
    }
    if (tries)
      doubles_.went(exact_ != 0);
  }
  template <int N> static MEETC_INLINE void take(const lanes *turned, int from, wide_lanes *to) {
    for (int i = 0; i < N; ++i) {
      float numbers[lane_count];
      __builtin_memcpy(numbers, &turned[i], sizeof numbers);
      to[i] = wide_lanes::from(numbers + from);
    }
  }

  void decide(std::size_t at, int n) {
    lane_mask left = ~lane_mask{0} >> (block - n) & ~settled_, rare = 0;
    sign_lanes s[P::atoms + 1];
    if constexpr (P::reject_stage::atoms > 0) {
      signs<typename P::reject_stage>(left, s);
      left &= to_truth_lanes(P::rejected(s)).can_be_false;
    }
    if constexpr (P::common_stage::atoms > 0)
      signs<typename P::common_stage>(left, s);
    truth_lanes hit = to_truth_lanes(P::usual(s));
    if constexpr (P::rare_stage::atoms > 0) {
      rare = left & to_truth_lanes(P::needs_rare(s)).can_be_true;
      if constexpr (How::is_exact) {
        hit = {hit.can_be_false | rare, hit.can_be_true | rare};
      } else if (rare != 0) {
        signs<typename P::rare_stage>(rare, s);
        const truth_lanes whole = to_truth_lanes(P::whole(s));
        hit = {(hit.can_be_false & ~rare) | (rare & whole.can_be_false),
               (hit.can_be_true & ~rare) | (rare & whole.can_be_true)};
      }
    }
    const lane_mask open = left & hit.can_be_false & hit.can_be_true, yes = (left & ~hit.can_be_false) | settled_;
    for (int k = 0; k < n; ++k) {
      const std::size_t i = at + static_cast<std::size_t>(k);
      out_[i] = open >> k & 1 ? open_(i) : to_answer((yes >> k & 1) != 0);
    }
  }

  // Adds the signs of the pairs of one vector, from bit `from` on.
  template <class Stage> MEETC_INLINE void add_signs(lane_mask wanted, int from, proved_lanes *to) const {
    constexpr lane_mask every = all_bits >> (block - wide_count);
    const lane_mask here = wanted >> from & every;
    if (here == 0)
      return;
    proved_lanes s[Stage::atoms];
    wide_signs<P, Stage, Width, How>(rows_[from / wide_count]).get(here, s);
    for (int i = 0; i < Stage::atoms; ++i) {
      to[i].negative |= (s[i].negative & every) << from;
      to[i].zero |= (s[i].zero & every) << from;
      to[i].positive |= (s[i].positive & every) << from;
    }
  }
  // The signs of a stage, of all rows with a pair in `wanted`.
  template <class Stage> MEETC_NOINLINE void signs(lane_mask wanted, sign_lanes *all) const {
    proved_lanes together[Stage::atoms] = {};
    lane_mask exact = 0;
    for (int from = 0; from < block; from += 8) {
      const lane_mask eight = lane_mask{0xff} << from;
      if ((wanted & eight) == 0)
        continue;
      if ((wanted & eight & ~exact_) == 0) {
        add_exact_signs<P, Stage>(rows_ + from / wide_count, from, together);
        exact |= eight;
      } else {
        for (int k = from; k < from + 8; k += wide_count)
          add_signs<Stage>(wanted, k, together);
      }
    }
    for (int i = 0; i < Stage::atoms; ++i) {
      proved_lanes &p = together[i];
      p.negative &= ~p.zero;
      p.positive |= exact & ~(p.zero | p.negative);
      all[Stage::first + i] = possible(p);
    }
  }

  const row_array &a_, &b_;
  const index_pair *pairs_;
  answer *out_;
  const Open &open_;
  wide_rows<P> rows_[block / wide_count];
  lane_mask settled_ = 0; // pairs that equal points settle
  lane_mask exact_ = 0;   // pairs whose values are exact in doubles
  back_off doubles_;      // when to look for such pairs
};

// Decides n pairs in lanes of doubles; open(i) decides pair i if these do not.
template <class P, class Width = residue_width<64>, class How = emitted_bounds, class Open>
void decide_in_wide_lanes(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                          const Open &open) {
  wide_decider<P, Width, How, Open>(a, b, pairs, out, open).run(n);
}

} // MEETC_NAMESPACE(meetc)

#endif
