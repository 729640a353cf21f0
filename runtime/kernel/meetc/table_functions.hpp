// The functions in a runtime's table, for any predicate. They are compiled in the generated library.
#ifndef MEETC_TABLE_FUNCTIONS_HPP
#define MEETC_TABLE_FUNCTIONS_HPP

#include <meetc/boxes.hpp>
#include <meetc/decide.hpp>
#include <meetc/table.hpp>

namespace meetc {

template <class P, class Decide>
void decide_each(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out, Decide &&one) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = one(a + std::size_t{pairs[i].a} * P::inputs_a, b + std::size_t{pairs[i].b} * P::inputs_b);
}
template <class P, class T>
void decide_plain(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  decide_each<P>(a, b, pairs, n, out,
                 [](const float *x, const float *y) { return to_answer(decide<P>(plain_signs<P, T>(x, y))); });
}
template <class P>
void decide_exact(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  decide_each<P>(a, b, pairs, n, out,
                 [](const float *x, const float *y) { return to_answer(decide<P>(exact_signs<P>(x, y))); });
}
template <class P>
void decide_certified(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  decide_each<P>(a, b, pairs, n, out,
                 [](const float *x, const float *y) { return to_answer(decide_certified<P>(x, y)); });
}
inline void unsure_each(std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = answer::unsure;
}
template <class P, class A>
void certify_pairs(const float *a, const float *b, const index_pair *pairs, std::size_t n, answer *out) {
  if (!standard_environment())
    return unsure_each(n, out);
  decide_each<P>(after_check(a), after_check(b), pairs, n, out,
                 [](const float *x, const float *y) { return certify_here<P, A>(x, y); });
  after_check(out); // what is stored is computed before the call returns
}
template <class P>
void certify_pairs_in_box(float side, bool whole_box, const float *a, const float *b, const index_pair *pairs,
                          std::size_t n, answer *out) {
  if (!standard_environment())
    return unsure_each(n, out);
  a = after_check(a), b = after_check(b);
  if (!box_holds<P>(side))
    certify_pairs<P, in_fp32>(a, b, pairs, n, out);
  else if (whole_box)
    decide_each<P>(a, b, pairs, n, out, [side](const float *x, const float *y) {
      return decide_sets<P>(boxed_signs<P, box_form::whole_box>(x, y, side));
    });
  else
    decide_each<P>(a, b, pairs, n, out, [side](const float *x, const float *y) {
      return decide_sets<P>(boxed_signs<P, box_form::per_object>(x, y, side));
    });
}
// The sides of a box that the box form covers, for the stages of P.
template <class P> constexpr float least_box() {
  float least = 0;
  const auto take = [&](auto stage) {
    using Stage = decltype(stage);
    if constexpr (Stage::atoms > 0) {
      const float x = power_of_two(Stage::box_lowest, 0.0F);
      least = x > least ? x : least;
    }
  };
  take(typename P::reject_stage()), take(typename P::common_stage()), take(typename P::rare_stage());
  return least;
}
template <class P> constexpr float most_box() {
  float most = 0x1p127F;
  const auto take = [&](auto stage) {
    using Stage = decltype(stage);
    if constexpr (Stage::atoms > 0) {
      const float x = 1 / power_of_two(-Stage::box_highest, 0.0F);
      most = x < most ? x : most;
    }
  };
  take(typename P::reject_stage()), take(typename P::common_stage()), take(typename P::rare_stage());
  return most;
}

// The entry of a predicate, with the rungs that the scene asks for.
template <class P, rung... Rungs>
predicate_info info_of(const char *name, const char *mode, const kind_info *a, const kind_info *b) {
  constexpr auto asks = [](rung r) { return ((Rungs == r) || ...); };
  constexpr bool certified = asks(rung::certified);
  predicate_info p{name, mode, a, b, {}, {}, nullptr, 0, 0};
  const auto decide = [&p](rung r) -> decide_function & { return p.decide[static_cast<int>(r)]; };
  if constexpr (asks(rung::fp32))
    decide(rung::fp32) = decide_plain<P, float>;
  if constexpr (asks(rung::fp64))
    decide(rung::fp64) = decide_plain<P, double>;
  if constexpr (asks(rung::fp64x2))
    decide(rung::fp64x2) = decide_plain<P, double_double>;
  if constexpr (asks(rung::exact) || certified)
    decide(rung::exact) = decide_exact<P>;
  if constexpr (certified) {
    decide(rung::certified) = decide_certified<P>;
    p.certify[0] = certify_pairs<P, in_fp32>;
    p.certify[1] = certify_pairs<P, in_fp64>;
    p.certify[2] = certify_pairs<P, in_fp64x2>;
    p.certify_in_box = certify_pairs_in_box<P>;
    p.box_least = least_box<P>();
    p.box_most = most_box<P>();
  }
  return p;
}

} // namespace meetc

#endif
