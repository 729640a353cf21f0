// Runs the stages of a predicate on rows of any number type.
//
// A predicate P has stages (reject, common, rare; absent ones are no_stage), each a program from stored numbers to
// values. object_a and object_b compute the fields_a and fields_b values of one object that sets store (stored.hpp);
// pair() reads them and computes the rest. P::rejected, P::usual, P::needs_rare and P::whole are its decision, for sign
// and for sign_set alike; P::open is the decision as far as it is known without the rare stage. Signs are numbered over
// all stages; a stage's own begin at Stage::first.
#ifndef MEETC_DECIDE_STAGES_HPP
#define MEETC_DECIDE_STAGES_HPP

#include <meetc/number/double_double.hpp>
#include <meetc/number/logic.hpp>

MEETC_NAMESPACE(meetc) {

struct no_stage {
  static constexpr int atoms = 0, first = 0;
};

// Calls f(Stage()) for each stage that P has, in order. A lone sign has only the common stage.
template <class P, class F> MEETC_HD constexpr void each_stage(F &&f) {
  const auto one = [&f](auto stage) {
    if constexpr (decltype(stage)::atoms > 0)
      f(stage);
  };
  if constexpr (requires { typename P::reject_stage; })
    one(typename P::reject_stage());
  one(typename P::common_stage());
  if constexpr (requires { typename P::rare_stage; })
    one(typename P::rare_stage());
}

// The values of one object that a stage reads, computed from its row.
template <class Stage, class T> MEETC_HD MEETC_INLINE constexpr void stage_fields_a(const T *row, T *f) {
  if constexpr (Stage::fields_a > 0)
    Stage::object_a(row, f);
}
template <class Stage, class T> MEETC_HD MEETC_INLINE constexpr void stage_fields_b(const T *row, T *f) {
  if constexpr (Stage::fields_b > 0)
    Stage::object_b(row, f);
}

// The stage's values for rows of T; those of degree 3 and more in W.
template <class Stage, class T, class W>
MEETC_HD MEETC_INLINE constexpr void stage_values(const T *a, const T *b, W *v) {
  T fields_a[Stage::fields_a + 1], fields_b[Stage::fields_b + 1];
  fields_a[Stage::fields_a] = fields_b[Stage::fields_b] = T(0); // the spare elements are for stages that store nothing
  stage_fields_a<Stage>(a, fields_a);
  stage_fields_b<Stage>(b, fields_b);
  Stage::template pair<T, W>(a, fields_a, b, fields_b, v);
}

template <class Stage, class T, class W = T> MEETC_HD MEETC_INLINE void stage_signs(const T *a, const T *b, sign *s) {
  W v[Stage::atoms];
  stage_values<Stage>(a, b, v);
  for (int i = 0; i < Stage::atoms; ++i)
    s[Stage::first + i] = sign_of(v[i]);
}

// The rows of a pair in another number type.
template <class P, class T> struct rows_in {
  T a[P::inputs_a], b[P::inputs_b];
  MEETC_HD MEETC_INLINE rows_in(const float *row_a, const float *row_b) {
    for (int i = 0; i < P::inputs_a; ++i)
      a[i] = static_cast<T>(row_a[i]);
    for (int i = 0; i < P::inputs_b; ++i)
      b[i] = static_cast<T>(row_b[i]);
  }
};

// ---- plain ----

// A plain rung takes the sign of the computed value, whose error is not bounded.
//
// A source of signs, such as this, has get<Stage>(s), which computes the signs of one stage. stored.hpp has the sources
// that read stored values.
template <class P, class T> struct plain_signs {
  rows_in<P, T> rows;
  MEETC_HD plain_signs(const float *row_a, const float *row_b) : rows(row_a, row_b) {}
  template <class Stage> MEETC_HD void get(sign *s) const { stage_signs<Stage>(rows.a, rows.b, s); }
};

} // MEETC_NAMESPACE(meetc)

#endif
