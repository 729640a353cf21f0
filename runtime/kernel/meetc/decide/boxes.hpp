// The static filter: signs of values, with an error bound from a box around all elements.
#ifndef MEETC_DECIDE_BOXES_HPP
#define MEETC_DECIDE_BOXES_HPP

#include <meetc/decide/stored_values.hpp>
#include <meetc/number/rounding.hpp>

MEETC_NAMESPACE(meetc) {

enum class box_form : std::uint8_t { per_object, whole_box };

// Signs in fp32 inside a box of side D, a power of two: every difference of two coordinates, every length and every
// coordinate outside a difference (P::axis) is at most D, exactly. per_object also uses the extents of both objects,
// which it computes for each pair; whole_box ("static") uses D for them. Stage::box_lowest <= log2 D <=
// Stage::box_highest must hold for every stage: see box_holds(). Pair is a row_pair, or a stored_pair, whose stored
// values are read.
template <class P, box_form F, class Pair = row_pair> struct boxed_signs {
  Pair pair;
  float d;
  MEETC_HD boxed_signs(const Pair &of, float side) : pair(of), d(side) {}
  MEETC_HD boxed_signs(const float *a, const float *b, float side) : pair{a, b}, d(side) {}

  MEETC_HD std::uint32_t equal() const { return equal_points<P>(pair.row_a, pair.row_b); }
  template <class Stage> MEETC_HD bool get(sign_set *all) const {
    return by_bounds<Stage>(all) || zero_by_equal_points<P, Stage>(equal(), all);
  }
  template <class Stage> MEETC_HD bool by_bounds(sign_set *all) const {
    if (!computes_as_bounded())
      return nothing_known<Stage>(all);
    in_fp32::value v[Stage::atoms];
    stage_values<P, Stage>(pair, v);
    float alpha = d, beta = d;
    if constexpr (F == box_form::per_object) {
      constexpr float least = power_of_two(Stage::box_lowest, 0.0F);
      // The extents are taken over the computed leaves: a difference slightly above a power of two may have been
      // rounded to it.
      alpha = power_over(Stage::extent_a(pair.row_a)), beta = power_over(Stage::extent_b(pair.row_b));
      alpha = alpha < least ? least : alpha > d ? d : alpha, beta = beta < least ? least : beta > d ? d : beta;
    }
    sign_set *s = all + Stage::first;
    int unsure = 0;
    for (int i = 0; i < Stage::atoms; ++i) {
      const box_factor f = in_fp32::box<Stage>(i);
      s[i] = within(v[i], f.c * power(alpha, f.a) * power(beta, f.b) * power(d, f.pair));
      unsure |= s[i].bits == 7;
    }
    return !unsure;
  }

private:
  MEETC_HD MEETC_INLINE static constexpr float power(float x, int n) {
    float r = 1;
    for (int i = 0; i < n; ++i)
      r *= x;
    return r;
  }
};

// Whether the bounds of the box form hold for a box of this side.
template <class P> MEETC_HD inline bool box_holds(float side) {
  bool holds = true;
  each_stage<P>([side, &holds](auto stage) {
    using Stage = decltype(stage);
    holds = holds && side >= power_of_two(Stage::box_lowest, 0.0F) &&
            side <= 1 / power_of_two(-Stage::box_highest, 0.0F) && power_above(side) == side;
  });
  return holds;
}

} // MEETC_NAMESPACE(meetc)

#endif
