// Stored values: the values of one object that a predicate reads, kept by sets beside their rows in float.
//
// Problem: a triangle's normal, or its magnitude in an error bound, is the same for every pair that the triangle is in.
// Method: the compiler selects the values of one object that cost more to compute than to load (Stage::fields_a, _b for
// values, Stage::magnitudes_of_a, _b for magnitudes). A set stores them in the order of its rows, and the rungs in fp32
// read them. The other rungs do not, since they compute in other types and decide few pairs. A stored value equals the
// one that the pair would compute, bit for bit, so every bound covers it.
//
// The values of an object are stored stage by stage, each stage's values before its magnitudes. The rare stage stores
// nothing.
#ifndef MEETC_DECIDE_STORED_VALUES_HPP
#define MEETC_DECIDE_STORED_VALUES_HPP

#include <meetc/decide/bounds.hpp>

MEETC_NAMESPACE(meetc) {

template <class Stage> MEETC_HD constexpr int stored_values_a() {
  if constexpr (Stage::atoms > 0)
    return Stage::fields_a;
  return 0;
}
template <class Stage> MEETC_HD constexpr int stored_values_b() {
  if constexpr (Stage::atoms > 0)
    return Stage::fields_b;
  return 0;
}
template <class Stage> MEETC_HD constexpr int stored_magnitudes_a() {
  if constexpr (requires { Stage::magnitudes_of_a; })
    return Stage::magnitudes_of_a;
  return 0;
}
template <class Stage> MEETC_HD constexpr int stored_magnitudes_b() {
  if constexpr (requires { Stage::magnitudes_of_b; })
    return Stage::magnitudes_of_b;
  return 0;
}

// The offsets of the stages' values, in floats from an object's first one.
template <class P> struct stored_layout {
  using reject = typename P::reject_stage;
  using common = typename P::common_stage;
  static constexpr int reject_a = stored_values_a<reject>() + stored_magnitudes_a<reject>();
  static constexpr int reject_b = stored_values_b<reject>() + stored_magnitudes_b<reject>();
  // The number of floats for each object.
  static constexpr int floats_a = reject_a + stored_values_a<common>() + stored_magnitudes_a<common>();
  static constexpr int floats_b = reject_b + stored_values_b<common>() + stored_magnitudes_b<common>();
  template <class Stage> static constexpr int first_a = std::is_same_v<Stage, reject> ? 0 : reject_a;
  template <class Stage> static constexpr int first_b = std::is_same_v<Stage, reject> ? 0 : reject_b;
};

// The magnitude of a leaf in fp32.
template <class Stage, class V> MEETC_HD MEETC_INLINE leaf_magnitude<V> fp32_leaf() {
  constexpr float floor = power_of_two(Stage::floor_fp32, 0.0F);
  return {V(floor)};
}

// Computes the stored values of an object of P, with the arithmetic of V: stored_layout<P>::floats_a or floats_b numbers.
template <class P, class V = float> struct store_a {
  static constexpr int inputs = P::inputs_a, floats = stored_layout<P>::floats_a;
  MEETC_HD static void compute(const float *row, float *out) {
    V numbers[inputs], values[floats + 1];
    for (int i = 0; i < inputs; ++i)
      numbers[i] = V(row[i]);
    compute_from(numbers, values);
    for (int i = 0; i < floats; ++i)
      out[i] = float(values[i]);
  }
  MEETC_HD MEETC_INLINE static void compute_from(const V *numbers, V *out) {
    values_from(numbers, out);
    magnitudes_of<typename P::reject_stage>(numbers, out);
    magnitudes_of<typename P::common_stage>(numbers, out);
  }
  // The values alone, at their places among the stored ones.
  MEETC_HD MEETC_INLINE static void values_from(const V *numbers, V *out) {
    values<typename P::reject_stage>(numbers, out);
    values<typename P::common_stage>(numbers, out + stored_layout<P>::reject_a);
  }
  template <class Stage> MEETC_HD MEETC_INLINE static void magnitudes_of(const V *numbers, V *out) {
    if constexpr (stored_magnitudes_a<Stage>() > 0)
      Stage::magnitudes_a(numbers, fp32_leaf<Stage, V>(),
                          out + stored_layout<P>::template first_a<Stage> + stored_values_a<Stage>());
  }

private:
  template <class Stage> MEETC_HD MEETC_INLINE static void values(const V *row, V *out) {
    if constexpr (stored_values_a<Stage>() > 0)
      Stage::object_a(row, out);
  }
};
template <class P, class V = float> struct store_b {
  static constexpr int inputs = P::inputs_b, floats = stored_layout<P>::floats_b;
  MEETC_HD static void compute(const float *row, float *out) {
    V numbers[inputs], values[floats + 1];
    for (int i = 0; i < inputs; ++i)
      numbers[i] = V(row[i]);
    compute_from(numbers, values);
    for (int i = 0; i < floats; ++i)
      out[i] = float(values[i]);
  }
  MEETC_HD MEETC_INLINE static void compute_from(const V *numbers, V *out) {
    values_from(numbers, out);
    magnitudes_of<typename P::reject_stage>(numbers, out);
    magnitudes_of<typename P::common_stage>(numbers, out);
  }
  // The values alone, at their places among the stored ones.
  MEETC_HD MEETC_INLINE static void values_from(const V *numbers, V *out) {
    values<typename P::reject_stage>(numbers, out);
    values<typename P::common_stage>(numbers, out + stored_layout<P>::reject_b);
  }
  template <class Stage> MEETC_HD MEETC_INLINE static void magnitudes_of(const V *numbers, V *out) {
    if constexpr (stored_magnitudes_b<Stage>() > 0)
      Stage::magnitudes_b(numbers, fp32_leaf<Stage, V>(),
                          out + stored_layout<P>::template first_b<Stage> + stored_values_b<Stage>());
  }

private:
  template <class Stage> MEETC_HD MEETC_INLINE static void values(const V *row, V *out) {
    if constexpr (stored_values_b<Stage>() > 0)
      Stage::object_b(row, out);
  }
};

// A pair of rows, and a pair of rows with stored values. The pointer of an object that stores nothing is not read.
struct row_pair {
  const float *row_a, *row_b;
};
struct stored_pair {
  const float *row_a, *row_b, *stored_a, *stored_b;
};

// A pair's numbers and its stored values in V, the float of plain or of bounded rungs.
template <class P, class V> struct pair_numbers {
  V row_a[P::inputs_a], row_b[P::inputs_b];
  V stored_a[stored_layout<P>::floats_a + 1], stored_b[stored_layout<P>::floats_b + 1];

  MEETC_HD MEETC_INLINE explicit pair_numbers(const stored_pair &p) {
    copy<P::inputs_a>(p.row_a, row_a), copy<P::inputs_b>(p.row_b, row_b);
    copy<stored_layout<P>::floats_a>(p.stored_a, stored_a), copy<stored_layout<P>::floats_b>(p.stored_b, stored_b);
  }

private:
  template <int N> MEETC_HD MEETC_INLINE static void copy(const float *from, V *to) {
    for (int i = 0; i < N; ++i)
      to[i] = V(from[i]);
  }
};

// The values of a stage.
template <class P, class Stage, class V> MEETC_HD MEETC_INLINE void stage_values(const row_pair &p, V *v) {
  const rows_in<P, V> rows(p.row_a, p.row_b);
  stage_values<Stage>(rows.a, rows.b, v);
}
template <class P, class Stage, class V> MEETC_HD MEETC_INLINE void stage_values(const stored_pair &p, V *v) {
  const pair_numbers<P, V> n(p);
  if constexpr (std::is_same_v<Stage, typename P::rare_stage>)
    stage_values<Stage>(n.row_a, n.row_b, v);
  else
    Stage::template pair<V, V>(n.row_a, n.stored_a + stored_layout<P>::template first_a<Stage>, n.row_b,
                               n.stored_b + stored_layout<P>::template first_b<Stage>, v);
}

// The same signs as plain_signs in float.
template <class P> struct stored_plain_signs {
  stored_pair pair;
  template <class Stage> MEETC_HD void get(sign *s) const {
    float v[Stage::atoms];
    stage_values<P, Stage>(pair, v);
    for (int i = 0; i < Stage::atoms; ++i)
      s[Stage::first + i] = sign_of(v[i]);
  }
};

} // MEETC_NAMESPACE(meetc)

#endif
