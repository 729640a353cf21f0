// The part of a decision that most pairs need: the reject stage and the common case, on sets of signs.
//
// While every sign is known, the logic of signs is used, which is several times faster than that of sets.
//
// Equal points settle some decisions: P::settled() says whether the polynomials of all signs, with these points put in,
// leave no decision but a hit (gen/lower/predicate/settled.hpp). The points are compared only if this can matter: if a sign of
// the reject stage may be zero, if a bound leaves a sign open, and before the rare stage.
#ifndef MEETC_DECIDE_FIRST_STAGES_HPP
#define MEETC_DECIDE_FIRST_STAGES_HPP

#include <meetc/decide/bounds.hpp>

MEETC_NAMESPACE(meetc) {

// Converts sets of one sign each to signs.
template <class Stage> MEETC_HD MEETC_INLINE void known_signs(const sign_set *sets, sign *s) {
  for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
    s[i] = known_sign(sets[i]);
}

// The signs that a bounded rung has computed so far.
template <class P> struct found_signs {
  sign_set sets[P::atoms + 1];
  sign s[P::atoms + 1]; // valid if all are known
  bool known = true;
  bool compared = false;   // whether the points have been compared
  std::uint32_t equal = 0; // the points that are equal, if they have been
};

// Whether the predicate has a rare stage, even if only declared.
template <class P> inline constexpr bool has_rare_stage = !std::is_same_v<typename P::rare_stage, no_stage>;

template <class Stage> MEETC_HD MEETC_INLINE bool some_zero(const sign_set *sets) {
  unsigned all = 0;
  for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
    all |= sets[i].bits;
  return (all & 2) != 0;
}

// Compares the points of the pair, if that has not been done. Returns whether they settle the decision.
template <class P, class Signs> MEETC_HD MEETC_INLINE bool points_settle(const Signs &signs, found_signs<P> &f) {
  if (P::coincidences == 0 || f.compared)
    return false;
  f.compared = true;
  f.equal = signs.equal();
  return P::settled(f.equal);
}

// Whether the reject stage, whose signs have been computed, proves a miss.
template <class P> MEETC_HD MEETC_INLINE bool surely_rejected(found_signs<P> &f) {
  if (!f.known)
    return !can_be_false(P::rejected(f.sets));
  known_signs<typename P::reject_stage>(f.sets, f.s);
  return P::rejected(f.s);
}

// The progress of a pair after the reject stage and the stage of the common case.
enum class progress : std::uint8_t { miss, hit, open };

// Runs the reject stage, which P must have.
template <class P, class Signs> MEETC_HD MEETC_INLINE progress try_to_reject(const Signs &signs, found_signs<P> &f) {
  using stage = typename P::reject_stage;
  f.known = signs.template by_bounds<stage>(f.sets);
  if (surely_rejected<P>(f))
    return progress::miss;
  if (some_zero<stage>(f.sets)) {
    if (points_settle<P>(signs, f))
      return progress::hit;
    if (!f.known) {
      f.known = zero_by_equal_points<P, stage>(f.equal, f.sets);
      if (surely_rejected<P>(f))
        return progress::miss;
    }
  }
  return progress::open;
}

// Runs the reject stage and the stage of the common case. An unsure reject stage does not stop it, since the decision is
// right without that stage.
template <class P, class Signs> MEETC_HD MEETC_INLINE progress run_first_stages(const Signs &signs, found_signs<P> &f) {
  if constexpr (P::reject_stage::atoms > 0)
    if (const progress at = try_to_reject<P>(signs, f); at != progress::open)
      return at;
  if constexpr (P::common_stage::atoms > 0) {
    using stage = typename P::common_stage;
    bool known = signs.template by_bounds<stage>(f.sets);
    if (!known) {
      if (points_settle<P>(signs, f))
        return progress::hit;
      known = zero_by_equal_points<P, stage>(f.equal, f.sets);
    }
    f.known = known && f.known;
    if (f.known)
      known_signs<stage>(f.sets, f.s);
  }
  return progress::open;
}
template <class P> MEETC_HD MEETC_INLINE truth needs_rare_stage(const found_signs<P> &f) {
  return f.known ? to_truth(P::needs_rare(f.s)) : to_truth(P::needs_rare(f.sets));
}
template <class P> MEETC_HD MEETC_INLINE answer common_answer(const found_signs<P> &f) {
  return f.known ? to_answer(P::usual(f.s)) : to_answer(P::usual(f.sets));
}

// The answer of a bounded rung without the rare stage; `rare` means that the rare stage must decide.
enum class first_answer : std::uint8_t { no, yes, unsure, rare };
template <class P, class A> MEETC_HD MEETC_INLINE first_answer look(const float *row_a, const float *row_b) {
  found_signs<P> f;
  const bounded_signs<P, A> signs(row_a, row_b);
  if (const progress at = run_first_stages<P>(signs, f); at != progress::open)
    return at == progress::hit ? first_answer::yes : first_answer::no;
  if constexpr (has_rare_stage<P>)
    if (can_be_true(needs_rare_stage<P>(f)))
      return points_settle<P>(signs, f) ? first_answer::yes : first_answer::rare;
  return static_cast<first_answer>(common_answer<P>(f));
}

// The set of signs of a kernel that is a single sign.
template <class P, class A> MEETC_HD MEETC_INLINE sign_set certify_sign_here(const float *row_a, const float *row_b) {
  sign_set s[P::atoms + 1];
  if constexpr (P::common_stage::atoms > 0)
    bounded_signs<P, A>(row_a, row_b).template get<typename P::common_stage>(s);
  return P::value(s);
}

} // MEETC_NAMESPACE(meetc)

#endif
