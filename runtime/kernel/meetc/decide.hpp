// The decision of a predicate over signs and over sets of signs, and the filter cascade of one pair of rows.
#ifndef MEETC_DECIDE_HPP
#define MEETC_DECIDE_HPP

#include <meetc/exact.hpp>

namespace meetc {

// Runs the stages in order and stops at the first that decides.
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

// The same on sets of signs: the answer that every choice of signs from the sets gives, or unsure. A reject stage
// that is unsure is no reason to stop, since the decision is right without it. While every sign is known the logic
// of signs is taken, which is several times faster than that of sets.
template <class P, class Signs> MEETC_HD MEETC_INLINE answer decide_sets(const Signs &signs) {
  sign_set sets[P::atoms + 1];
  sign s[P::atoms + 1];
  bool known = true;
  if constexpr (P::reject_stage::atoms > 0) {
    known = signs.template get<typename P::reject_stage>(sets);
    if (known) {
      known_signs<typename P::reject_stage>(sets, s);
      if (P::rejected(s))
        return answer::no;
    } else if (!can_be_false(P::rejected(sets))) {
      return answer::no;
    }
  }
  if constexpr (P::common_stage::atoms > 0) {
    known = signs.template get<typename P::common_stage>(sets) && known;
    if (known)
      known_signs<typename P::common_stage>(sets, s);
  }
  if constexpr (P::rare_stage::atoms > 0) {
    const truth rare = known ? to_truth(P::needs_rare(s)) : to_truth(P::needs_rare(sets));
    if (can_be_true(rare)) {
      if (can_be_false(rare)) { // perhaps: the next rung will know
        for (int i = 0; i < P::rare_stage::atoms; ++i)
          sets[P::rare_stage::first + i] = sign_set::all();
        known = false;
      } else {
        known = signs.template get<typename P::rare_stage>(sets) && known;
        if (known)
          known_signs<typename P::rare_stage>(sets, s);
      }
      return known ? to_answer(P::whole(s)) : to_answer(P::whole(sets));
    }
  }
  return known ? to_answer(P::usual(s)) : to_answer(P::usual(sets));
}

// One rung of `certified` where the environment is known to be the standard one: no and yes are proved.
template <class P, class A> MEETC_HD MEETC_INLINE answer certify_here(const float *row_a, const float *row_b) {
  return decide_sets<P>(bounded_signs<P, A>(row_a, row_b));
}
// The same anywhere: unsure in any other environment.
template <class P, class A> MEETC_HD inline answer certify(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return answer::unsure;
  return before_return(certify_here<P, A>(after_check(row_a), after_check(row_b)));
}

// The rungs of `certified` after fp32, in the standard environment. What few pairs need stays out of line.
template <class P> MEETC_NOINLINE MEETC_HD inline bool decide_after_fp32(const float *row_a, const float *row_b) {
  const answer x = certify_here<P, in_fp64>(row_a, row_b);
  return x == answer::unsure ? decide<P>(exact_signs<P>(row_a, row_b)) : x == answer::yes;
}
// All rungs of `certified` for one pair: never wrong, for any valid operands, in any environment.
template <class P> MEETC_HD inline bool decide_certified(const float *row_a, const float *row_b) {
  if (!standard_environment())
    return decide<P>(integer_signs<P>(row_a, row_b));
  row_a = after_check(row_a), row_b = after_check(row_b);
  const answer x = certify_here<P, in_fp32>(row_a, row_b);
  return before_return(x == answer::unsure ? decide_after_fp32<P>(row_a, row_b) : x == answer::yes);
}

// One sign, for kernels that are nothing else.
template <class P, class Signs> MEETC_HD inline sign decide_sign(const Signs &signs) {
  sign s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    signs.template get<typename P::common_stage>(s);
  return P::value(s);
}
template <class P, class A> MEETC_HD MEETC_INLINE sign_set certify_sign_here(const float *row_a, const float *row_b) {
  sign_set s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    bounded_signs<P, A>(row_a, row_b).template get<typename P::common_stage>(s);
  return P::value(s);
}

} // namespace meetc

#endif
