// The decision of a predicate over signs and over sets of signs, and the filter cascade of one pair of rows.
#ifndef MEETC_DECIDE_DECIDE_HPP
#define MEETC_DECIDE_DECIDE_HPP

#include <meetc/decide/exact.hpp>

MEETC_NAMESPACE(meetc) {

// Runs the stages in order and stops at the first one that decides.
template <class P, class Signs> MEETC_HD inline bool decide(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::reject_stage::atoms > 0) {
    signs.template get<typename P::reject_stage>(s);
    if (P::rejected(s))
      return false;
  }
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  if constexpr (P::rare_stage::atoms > 0)
    if (P::needs_rare(s)) {
      signs.template get<typename P::rare_stage>(s);
      return P::whole(s);
    }
  return P::usual(s);
}

// The same on sets of signs: the answer on which all choices of signs from the sets agree, or unsure.
template <class P, class Signs> MEETC_HD MEETC_INLINE answer decide_sets(const Signs &signs) {
  found_signs<P> f;
  if (const progress at = run_first_stages<P>(signs, f); at != progress::open)
    return to_answer(at == progress::hit);
  if constexpr (P::rare_stage::atoms > 0) {
    const truth rare = needs_rare_stage<P>(f);
    if (can_be_true(rare)) {
      if (points_settle<P>(signs, f))
        return answer::yes;
      if (can_be_false(rare)) // possibly: the next rung computes the rare stage
        return to_answer(P::open(f.sets));
      using stage = typename P::rare_stage;
      f.known = (signs.template by_bounds<stage>(f.sets) || zero_by_equal_points<P, stage>(f.equal, f.sets)) && f.known;
      if (f.known)
        known_signs<stage>(f.sets, f.s);
      return f.known ? to_answer(P::whole(f.s)) : to_answer(P::whole(f.sets));
    }
  }
  return common_answer<P>(f);
}

// The decision of the exact rung, in any environment. It compares the points first, which costs little beside it.
template <class P> MEETC_HD inline bool decide_exact(const float *row_a, const float *row_b) {
  if (standard_environment() && P::settled(equal_points<P>(after_check(row_a), after_check(row_b))))
    return true;
  return decide<P>(exact_signs<P>(row_a, row_b));
}

// One rung of `certified`, in an environment that is known to be the standard one. Its no and yes are proved.
template <class P, class A> MEETC_HD MEETC_INLINE answer certify_here(const float *row_a, const float *row_b) {
  if constexpr (std::is_same_v<A, in_fp64>)
    return decide_sets<P>(fp64_signs<P>(row_a, row_b));
  else
    return decide_sets<P>(bounded_signs<P, A>(row_a, row_b));
}
// The same in any environment. The answer is unsure unless the environment is the standard one.
template <class P, class A> MEETC_HD inline answer certify(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return answer::unsure;
  return before_return(certify_here<P, A>(after_check(row_a), after_check(row_b)));
}

// The rungs of `certified` after fp32, in the standard environment. Few pairs need them, so they stay out of line.
template <class P> MEETC_NOINLINE MEETC_HD inline bool decide_after_fp32(const float *row_a, const float *row_b) {
  const answer x = certify_here<P, in_fp64>(row_a, row_b);
  return x == answer::unsure ? decide<P>(exact_signs<P>(row_a, row_b)) : x == answer::yes;
}
// All rungs of `certified` for one pair: never wrong, for any valid operands and in any environment.
template <class P> MEETC_HD inline bool decide_certified(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide<P>(integer_signs<P>(row_a, row_b));
  row_a = after_check(row_a), row_b = after_check(row_b);
  const answer x = certify_here<P, in_fp32>(row_a, row_b);
  return before_return(x == answer::unsure ? decide_after_fp32<P>(row_a, row_b) : x == answer::yes);
}

// The value of a kernel that is a single sign.
template <class P, class Signs> MEETC_HD inline sign decide_sign(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  return P::value(s);
}

} // MEETC_NAMESPACE(meetc)

#endif
