// One pair of rows, one predicate, every rung: the answers of each, compared with the integers.
//
// True signs are integer_signs: pure integers, no rounding anywhere. The true answer is the decision on them, or one
// that is known from elsewhere, and then the decision on them is compared with it as well. Every bounded rung is
// checked twice: each set of signs, stage by stage, must contain the true sign, and the answer must be unsure or true.
// A wrong sign thus shows even where the decision does not read it.
#ifndef MEETC_TESTS_EXTREMES_CHECK_HPP
#define MEETC_TESTS_EXTREMES_CHECK_HPP

#include <meetc/decide/boxes.hpp>
#include <meetc/decide/later_rungs.hpp>
#include <meetc/support.hpp>

#include <cmath>

namespace meetc::extremes_test {

// Those that can be unsure come first. The last is no rung, but the decision on the true signs.
enum rung { fp32, fp64, fp64x2, per_object, whole_box, exact_rung, certified, on_signs, rungs };
inline constexpr int bounded = 5;
constexpr unsigned bit(int r) {
  return 1U << r;
}

struct outcome {
  bool hit = false;    // the truth; of a lone sign: not zero
  bool boxed = false;  // the box forms were run
  unsigned unsure = 0; // bits of rungs
  unsigned wrong = 0;
};

// ---- for decisions and lone signs ----

template <class P> constexpr bool lone_sign = !requires {
  typename P::reject_stage;
};

// Every sign of every stage, whether or not the decision needs it.
template <class P, class Signs, class S> void all_signs(const Signs &signs, S *s) {
  each_stage<P>([&](auto stage) { signs.template get<decltype(stage)>(s); });
}

// The answer as a number: 0 or 1, or -1, 0 or 1 for a lone sign.
template <class P> int answer_of(const meetc::sign *s) {
  if constexpr (lone_sign<P>)
    return static_cast<int>(P::value(s));
  else
    return P::needs_rare(s) ? P::whole(s) : P::usual(s);
}
template <class P, class Signs> int decided(const Signs &signs) {
  if constexpr (lone_sign<P>)
    return static_cast<int>(meetc::decide_sign<P>(signs));
  else
    return meetc::decide<P>(signs);
}
template <class P> int truth_of(const float *a, const float *b) {
  meetc::sign s[P::atoms];
  all_signs<P>(meetc::integer_signs<P>(a, b), s);
  return answer_of<P>(s);
}

// Whether the box form covers a box of this side; 0: there is none.
template <class P> bool box_covers(float side) {
  bool covers = side > 0;
  each_stage<P>([&](auto stage) {
    using Stage = decltype(stage);
    covers = covers && side >= std::ldexp(1.0F, Stage::box_lowest) && side <= std::ldexp(1.0F, Stage::box_highest);
  });
  if constexpr (!lone_sign<P>)
    covers = covers && meetc::box_holds<P>(side);
  return covers;
}

// ---- checks ----

// Whether each set contains its true sign.
template <class P, class Signs> bool sets_hold(const Signs &signs, const meetc::sign *truth) {
  meetc::sign_set sets[P::atoms];
  all_signs<P>(signs, sets);
  unsigned missed = 0;
  for (int i = 0; i < P::atoms; ++i)
    missed |= meetc::sign_set::of(truth[i]).bits & ~static_cast<unsigned>(sets[i].bits);
  return missed == 0;
}

// The same where a single sign is claimed.
template <class P, class Signs> bool signs_hold(const Signs &signs, const meetc::sign *truth) {
  meetc::sign s[P::atoms];
  all_signs<P>(signs, s);
  bool same = true;
  for (int i = 0; i < P::atoms; ++i)
    same = same && s[i] == truth[i];
  return same;
}

template <class P, class Signs>
void check_bounded(const Signs &signs, const meetc::sign *truth, int want, rung r, outcome &out) {
  bool right = sets_hold<P>(signs, truth), sure;
  if constexpr (lone_sign<P>) {
    meetc::sign_set s[P::atoms];
    all_signs<P>(signs, s);
    const unsigned value = P::value(s).bits;
    sure = value == 1 || value == 2 || value == 4;
    right = right && (value & meetc::sign_set::of(static_cast<meetc::sign>(want)).bits);
  } else {
    const meetc::answer x = meetc::decide_sets<P>(signs);
    sure = x != meetc::answer::unsure;
    right = right && (!sure || (x == meetc::answer::yes) == (want == 1));
  }
  out.unsure |= sure ? 0 : bit(r);
  out.wrong |= right ? 0 : bit(r);
}

// side: the side of a box that holds the pair, a power of two; 0: there is none. known: the true answer, if it is known
// other than by the signs. Hit: the predicate's public entry point.
template <class P, class Hit> outcome check(const float *a, const float *b, float side, const int *known, Hit &&hit) {
  outcome out;
  meetc::sign truth[P::atoms];
  all_signs<P>(meetc::integer_signs<P>(a, b), truth);
  const int by_signs = answer_of<P>(truth), want = known ? *known : by_signs;
  out.hit = want != 0;
  check_bounded<P>(meetc::bounded_signs<P, meetc::in_fp32>(a, b), truth, want, fp32, out);
  check_bounded<P>(meetc::bounded_signs<P, meetc::in_fp64>(a, b), truth, want, fp64, out);
  check_bounded<P>(meetc::fp64_signs<P>(a, b), truth, want, fp64, out);
  check_bounded<P>(meetc::bounded_signs<P, meetc::in_fp64x2>(a, b), truth, want, fp64x2, out);
  bool exact = signs_hold<P>(meetc::exact_signs<P>(a, b), truth);
  exact = exact && decided<P>(meetc::exact_signs<P>(a, b)) == want;
  const bool right = hit(a, b) == want; // through decide_certified
  if constexpr (!lone_sign<P>)          // A reject stage that holds proves a no; where nothing is rare the usual
                                        // decides.
    exact = exact && !(P::rejected(truth) && want == 1) && (P::needs_rare(truth) || P::whole(truth) == (want == 1));
  if (out.boxed = box_covers<P>(side); out.boxed) {
    using meetc::box_form;
    check_bounded<P>(meetc::boxed_signs<P, box_form::per_object>(a, b, side), truth, want, per_object, out);
    check_bounded<P>(meetc::boxed_signs<P, box_form::whole_box>(a, b, side), truth, want, whole_box, out);
  }
  out.wrong |= (exact ? 0 : bit(exact_rung)) | (right ? 0 : bit(certified)) | (by_signs == want ? 0 : bit(on_signs));
  return out;
}

} // namespace meetc::extremes_test

#endif
