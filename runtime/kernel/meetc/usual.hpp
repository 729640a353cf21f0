// The part of a decision that most pairs need: the reject stage and the usual case, on sets of signs.
//
// While every sign is known, the logic of signs is used, which is several times faster than that of sets.
#ifndef MEETC_USUAL_HPP
#define MEETC_USUAL_HPP

#include <meetc/bounds.hpp>

MEETC_NAMESPACE(meetc) {

// Converts sets of one sign each to signs.
template <class Stage> MEETC_HD inline void known_signs(const sign_set *sets, sign *s) {
  for (int i = Stage::first; i < Stage::first + Stage::atoms; ++i)
    s[i] = known_sign(sets[i]);
}

// The signs that a bounded rung has computed so far.
template <class P> struct found_signs {
  sign_set sets[P::atoms + 1];
  sign s[P::atoms + 1]; // valid if all are known
  bool known = true;
};

// Whether the predicate has a rare stage, even if only declared.
template <class P> inline constexpr bool has_rare_stage = !std::is_same_v<typename P::rare_stage, no_stage>;

// Runs the reject stage and the stage of the usual case. Returns false if the pair is a miss. An unsure reject stage
// does not stop it, since the decision is right without that stage.
template <class P, class Signs> MEETC_HD MEETC_INLINE bool find_usual(const Signs &signs, found_signs<P> &f) {
  if constexpr (P::reject_stage::atoms > 0) {
    f.known = signs.template get<typename P::reject_stage>(f.sets);
    if (f.known) {
      known_signs<typename P::reject_stage>(f.sets, f.s);
      if (P::rejected(f.s))
        return false;
    } else if (!can_be_false(P::rejected(f.sets))) {
      return false;
    }
  }
  if constexpr (P::common_stage::atoms > 0) {
    f.known = signs.template get<typename P::common_stage>(f.sets) && f.known;
    if (f.known)
      known_signs<typename P::common_stage>(f.sets, f.s);
  }
  return true;
}
template <class P> MEETC_HD MEETC_INLINE truth needs_rare_stage(const found_signs<P> &f) {
  return f.known ? to_truth(P::needs_rare(f.s)) : to_truth(P::needs_rare(f.sets));
}
template <class P> MEETC_HD MEETC_INLINE answer usual_answer(const found_signs<P> &f) {
  return f.known ? to_answer(P::usual(f.s)) : to_answer(P::usual(f.sets));
}

// The answer of a bounded rung without the rare stage; `rare` means that the rare stage must decide.
enum class first_answer : std::uint8_t { no, yes, unsure, rare };
template <class P, class A> MEETC_HD MEETC_INLINE first_answer look(const float *row_a, const float *row_b) {
  found_signs<P> f;
  if (!find_usual<P>(bounded_signs<P, A>(row_a, row_b), f))
    return first_answer::no;
  if constexpr (has_rare_stage<P>)
    if (can_be_true(needs_rare_stage<P>(f)))
      return first_answer::rare;
  return static_cast<first_answer>(usual_answer<P>(f));
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
