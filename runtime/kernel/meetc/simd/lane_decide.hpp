// Decides pairs in lanes: the rungs in fp32, for the runtime's table.
//
// Problem: most pairs are decided by the reject stage or in the common case, by straight-line arithmetic that is the
// same for all pairs.
// Method: lane_count pairs at a time are brought into structure-of-arrays form. If few of them survive the reject
// stage, the survivors wait until they fill the lanes, and run it again together with the stage of the common case.
// Equal points are compared in lanes too, and before the reject stage while most pairs share some. Pairs that lanes
// leave open (rare cases, unsure signs) go to the caller's function, one by one. Lanes decide no pair that the
// functions for one pair (decide.hpp) would leave open, and none differently: their arithmetic is the same, operation
// by operation, and they know no more of a sign. In fp32 one bound for all values of a degree serves most pairs
// (power_bound.hpp). If it leaves a sign unsure, the bound of the functions for one pair decides, which is never
// larger.
#ifndef MEETC_SIMD_LANE_DECIDE_HPP
#define MEETC_SIMD_LANE_DECIDE_HPP

#include <meetc/simd/lanes.hpp>

#include <meetc/decide/first_stages.hpp>
#include <meetc/decide/stored_values.hpp>
#include <meetc/simd/back_off.hpp>
#include <meetc/simd/power_bound.hpp>
#include <meetc/table/table.hpp>

MEETC_NAMESPACE(meetc) {

template <> struct leaf_magnitude<lanes> {
  lanes floor;
  MEETC_INLINE lanes operator()(lanes difference) const { return leaf_at_least(difference, floor); }
};

// Two ways to take signs from values: with the bounds of fp32, and as they are.
struct bounded_lanes {
  template <class Stage> static MEETC_INLINE void sort_out(const lanes *v, const lanes *m, sign_lanes *s) {
    lanes largest(0.0F);
    for (int i = 0; i < Stage::atoms; ++i)
      largest = larger(magnitude_of(v[i]), largest);
    // If a value is not finite, or the compilation is not sound, only zero magnitudes prove a sign, or nothing does.
    const lane_mask finite = ~greater(largest, lanes(largest_finite(0.0F))),
                    sound = computes_as_bounded() ? all_bits : 0;
    for (int i = 0; i < Stage::atoms; ++i) {
      const proved_lanes p = proved(v[i], lanes(in_fp32::factor<Stage>(i)) * m[i], m[i]);
      s[i] = possible({p.negative & finite & sound, p.zero & sound, p.positive & finite & sound});
    }
  }
  static constexpr bool bounded = true;
};
struct plain_lanes {
  template <class Stage> static MEETC_INLINE void sort_out(const lanes *v, const lanes *, sign_lanes *s) {
    for (int i = 0; i < Stage::atoms; ++i) {
      const lane_mask positive = greater(v[i], lanes(0.0F)), negative = greater(lanes(0.0F), v[i]);
      s[i] = {negative, ~(positive | negative) & every_lane, positive}; // NaN counts as zero, as in sign_of()
    }
  }
  static constexpr bool bounded = false;
};

// The numbers of lane_count pairs by lane, with the values that sets store: read, or computed if the sets lack them.
template <class P> struct lane_tile {
  static constexpr int floats_a = stored_layout<P>::floats_a, floats_b = stored_layout<P>::floats_b;
  lanes row_a[P::inputs_a], row_b[P::inputs_b], stored_a[floats_a + 1], stored_b[floats_b + 1];

  // Lanes from n on repeat the last pair.
  MEETC_INLINE void load_rows(const row_array &a, const row_array &b, const index_pair *pairs, int n) {
    one_a = true;
    for (int k = 0; k < lane_count; ++k) {
      const index_pair p = pairs[k < n ? k : n - 1];
      at_a[k] = p.a, at_b[k] = p.b;
      one_a &= p.a == at_a[0];
    }
    if (one_a) // one object against many, as candidates come
      repeat<P::inputs_a>(a.rows, at_a[0], row_a);
    else
      gather_rows<P::inputs_a>(a.rows, at_a, row_a);
    gather_rows<P::inputs_b>(b.rows, at_b, row_b);
  }
  // If the sets do not store them, the values are computed here and the magnitudes by compute_magnitudes().
  MEETC_INLINE void load_stored(const row_array &a, const row_array &b) {
    if constexpr (floats_a > 0) {
      if (!a.stored)
        store_a<P, lanes>::values_from(row_a, stored_a);
      else if (one_a)
        repeat<floats_a>(a.stored, at_a[0], stored_a);
      else
        gather_rows<floats_a>(a.stored, at_a, stored_a);
    }
    if constexpr (floats_b > 0) {
      if (b.stored)
        gather_rows<floats_b>(b.stored, at_b, stored_b);
      else
        store_b<P, lanes>::values_from(row_b, stored_b);
    }
  }
  template <class Stage> MEETC_INLINE void compute_magnitudes(const row_array &a, const row_array &b) {
    if constexpr (floats_a > 0)
      if (!a.stored)
        store_a<P, lanes>::template magnitudes_of<Stage>(row_a, stored_a);
    if constexpr (floats_b > 0)
      if (!b.stored)
        store_b<P, lanes>::template magnitudes_of<Stage>(row_b, stored_b);
  }

private:
  std::uint32_t at_a[lane_count], at_b[lane_count];
  bool one_a; // all pairs are of one row of A

  template <int N> static MEETC_INLINE void repeat(const float *from, std::uint32_t at, lanes *to) {
    for (int i = 0; i < N; ++i)
      to[i] = lanes(from[std::size_t{at} * N + static_cast<std::size_t>(i)]);
  }
};

// The values of a stage before the rare one.
template <class P, class Stage> MEETC_INLINE void lane_values(const lane_tile<P> &t, lanes *v) {
  using layout = stored_layout<P>;
  Stage::template pair<lanes, lanes>(t.row_a, t.stored_a + layout::template first_a<Stage>, t.row_b,
                                     t.stored_b + layout::template first_b<Stage>, v);
}
// Their signs.
template <class P, class Stage, class How> MEETC_INLINE void lane_signs(const lane_tile<P> &t, sign_lanes *all) {
  using layout = stored_layout<P>;
  lanes v[Stage::atoms], m[Stage::atoms];
  lane_values<P, Stage>(t, v);
  if constexpr (How::bounded)
    Stage::magnitudes(t.row_a, t.stored_a + layout::template first_a<Stage> + stored_values_a<Stage>(), t.row_b,
                      t.stored_b + layout::template first_b<Stage> + stored_values_b<Stage>(),
                      fp32_leaf<Stage, lanes>(), m);
  How::template sort_out<Stage>(v, m, all + Stage::first);
}

template <class P, class How, class Open> class lane_decider {
public:
  // `open(i)` decides pair i alone.
  lane_decider(const row_array &a, const row_array &b, const index_pair *pairs, answer *out, const Open &open)
      : a_(a), b_(b), pairs_(pairs), out_(out), open_(open) {}

  void run(std::size_t n) {
    for (std::size_t at = 0; at < n; at += lane_count) {
      const int here = static_cast<int>(n - at < lane_count ? n - at : lane_count);
      first([at](int k) { return at + static_cast<std::size_t>(k); }, pairs_ + at, here);
    }
    if (waiting_ > 0)
      second_of_waiting();
  }

private:
  static constexpr lane_mask first_lanes(int n) { return every_lane >> (lane_count - n); }

  // The reject stage. number(k) is the number of the pair in lane k.
  template <class Number> MEETC_INLINE void first(const Number &number, const index_pair *pairs, int n) {
    if constexpr (P::reject_stage::atoms == 0) {
      second(number, pairs, n);
    } else {
      lane_tile<P> t;
      t.load_rows(a_, b_, pairs, n);
      if (points_first_) {
        const lane_mask hits = settled(t) & first_lanes(n);
        points_first_ = mostly(hits);
        if (points_first_) {
          for (int k = 0; k < n; ++k)
            out_[number(k)] = answer::yes;
          return wait(number, pairs, first_lanes(n) & ~hits);
        }
      }
      t.load_stored(a_, b_);
      sign_lanes s[P::atoms + 1];
      const lanes extent = begin(t);
      const lane_mask left = reject(t, extent, s, first_lanes(n));
      for (int k = 0; k < n; ++k)
        out_[number(k)] = answer::no;
      if (mostly(left))
        common_case(t, extent, s, left, number);
      else
        wait(number, pairs, left);
    }
  }
  static MEETC_INLINE bool mostly(lane_mask m) {
    // Without an instruction that counts bits, gcc calls a function; four lanes have a table of three bits or more.
    return lane_count == 4 ? (0xe880U >> m & 1) != 0 : 2 * __builtin_popcount(m) > lane_count;
  }

  template <class Number> MEETC_INLINE void wait(const Number &number, const index_pair *pairs, lane_mask these) {
    for (; these != 0; these &= these - 1) {
      const int k = __builtin_ctz(these);
      waiting_numbers_[waiting_] = number(k), waiting_pairs_[waiting_] = pairs[k];
      if (++waiting_ == lane_count)
        second_of_waiting();
    }
  }
  // Both stages, of pairs that have waited.
  MEETC_NOINLINE void second_of_waiting() {
    second([this](int k) { return waiting_numbers_[k]; }, waiting_pairs_, waiting_);
    waiting_ = 0;
  }
  template <class Number> MEETC_INLINE void second(const Number &number, const index_pair *pairs, int n) {
    lane_tile<P> t;
    t.load_rows(a_, b_, pairs, n);
    t.load_stored(a_, b_);
    sign_lanes s[P::atoms + 1];
    const lanes extent = begin(t);
    lane_mask left = first_lanes(n);
    if constexpr (P::reject_stage::atoms > 0) {
      left = reject(t, extent, s, left);
      for (int k = 0; k < n; ++k)
        out_[number(k)] = answer::no;
    }
    common_case(t, extent, s, left, number);
  }
  // The stage of the common case, for the lanes of `left`; the others are misses.
  template <class Number>
  MEETC_INLINE void common_case(lane_tile<P> &t, lanes extent, sign_lanes *s, lane_mask left, const Number &number) {
    if (const lane_mask hits = settled(t, s, left); hits != 0) {
      points_first_ = mostly(hits);
      for (lane_mask more = hits; more != 0; more &= more - 1)
        out_[number(__builtin_ctz(more))] = answer::yes;
      left &= ~hits;
      if (left == 0)
        return;
    }
    if constexpr (P::common_stage::atoms > 0)
      signs<typename P::common_stage>(t, extent, s);
    lane_mask open, yes;
    for (lane_mask hits = 0;;) {
      const truth_lanes hit = to_truth_lanes(P::usual(s));
      open = hit.can_be_true & hit.can_be_false, yes = hit.can_be_true | hits;
      if constexpr (has_rare_stage<P>)
        open |= to_truth_lanes(P::needs_rare(s)).can_be_true;
      open &= left & ~hits;
      if (open == 0)
        break;
      if (hits == 0) {
        hits = settled(t);
        open &= ~hits, yes |= hits;
      }
      if (open == 0 || !by_power_)
        break;
      signs_by_leaves<typename P::reject_stage>(t, s);
      signs_by_leaves<typename P::common_stage>(t, s);
    }
    for (int k = 0; k < lane_count; ++k)
      if (left >> k & 1)
        out_[number(k)] = open >> k & 1 ? open_(number(k)) : to_answer((yes >> k & 1) != 0);
  }

  // The lanes of `wanted` that the reject stage leaves.
  MEETC_INLINE lane_mask reject(lane_tile<P> &t, lanes extent, sign_lanes *s, lane_mask wanted) {
    using stage = typename P::reject_stage;
    signs<stage>(t, extent, s);
    truth_lanes rejected = to_truth_lanes(P::rejected(s));
    if (by_power_ && (rejected.can_be_false & rejected.can_be_true & wanted) != 0) {
      signs_by_leaves<stage>(t, s);
      rejected = to_truth_lanes(P::rejected(s));
    }
    return rejected.can_be_false & wanted;
  }
  // The signs of a stage.
  template <class Stage> MEETC_INLINE void signs(lane_tile<P> &t, lanes extent, sign_lanes *s) {
    if constexpr (!How::bounded) {
      lane_signs<P, Stage, How>(t, s);
    } else {
      if constexpr (has_power)
        if (by_power_) {
          lanes v[Stage::atoms];
          lane_values<P, Stage>(t, v);
          proved_lanes p[Stage::atoms];
          signs_by_power<P, Stage, in_fp32>(v, extent, p);
          for (int i = 0; i < Stage::atoms; ++i)
            s[Stage::first + i] = possible(p[i]);
          return;
        }
      signs_by_leaves<Stage>(t, s);
    }
  }
  // The same by the magnitude of each value, if the bound by a power left a sign unsure or was not tried.
  template <class Stage> MEETC_NOINLINE void signs_by_leaves(lane_tile<P> &t, sign_lanes *s) {
    if constexpr (Stage::atoms > 0) {
      t.template compute_magnitudes<Stage>(a_, b_);
      lane_signs<P, Stage, How>(t, s);
    }
    by_power_ = false;
  }
  // Begins a tile.
  MEETC_INLINE lanes begin(const lane_tile<P> &t) {
    if constexpr (has_power) {
      if (tried_)
        power_.went(by_power_);
      by_power_ = tried_ = power_.tries();
      if (by_power_)
        return extent_of<P>(t.row_a, t.row_b);
    }
    return lanes(0.0F);
  }

  static constexpr bool has_power =
      How::bounded && has_power_bound<P, typename P::reject_stage>() && has_power_bound<P, typename P::common_stage>();

  // The pairs that equal points settle. Plain rungs do not look at them.
  static constexpr bool compares_points = How::bounded && P::settled_by != 0;
  static MEETC_INLINE lane_mask settled(const lane_tile<P> &t) {
    if constexpr (compares_points)
      return computes_as_bounded() ? P::settled_lanes(t.row_a, t.row_b) : 0;
    return 0;
  }
  // Those of `left`. As in run_first_stages(), points matter where a sign of the reject stage may be zero.
  static MEETC_INLINE lane_mask settled(const lane_tile<P> &t, const sign_lanes *s, lane_mask left) {
    lane_mask zero = 0;
    if constexpr (compares_points && P::reject_stage::atoms > 0)
      for (int i = 0; i < P::reject_stage::atoms; ++i)
        zero |= s[P::reject_stage::first + i].zero;
    return left & zero ? left & settled(t) : 0;
  }

  const row_array &a_, &b_;
  const index_pair *pairs_;
  answer *out_;
  const Open &open_;
  bool points_first_ = false; // most pairs share points, as far as the last tile tells
  bool by_power_ = false;     // whether the bound by a power gives the signs of this tile
  bool tried_ = false;        // whether it was tried for this tile
  back_off power_;            // when to try it
  int waiting_ = 0;
  std::size_t waiting_numbers_[lane_count];
  index_pair waiting_pairs_[lane_count];
};

// Decides n pairs in lanes; open(i) decides pair i if lanes do not.
template <class P, class How, class Open>
void decide_in_lanes(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                     const Open &open) {
  lane_decider<P, How, Open>(a, b, pairs, out, open).run(n);
}

} // MEETC_NAMESPACE(meetc)

#endif
