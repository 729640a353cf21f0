// The functions in a runtime's table, for any predicate. They are compiled in the generated library, whose sources
// include this first (see lanes.hpp).
#ifndef MEETC_SIMD_TABLE_FUNCTIONS_HPP
#define MEETC_SIMD_TABLE_FUNCTIONS_HPP

#include <meetc/simd/lane_decide.hpp>

#include <meetc/decide/boxes.hpp>
#include <meetc/decide/decide.hpp>
#include <meetc/decide/later_rungs.hpp>
#include <meetc/decide/tolerant.hpp>
#include <meetc/simd/wide_decide.hpp>
#include <meetc/table/table.hpp>
#include <meetc/table/table_entry.hpp>

MEETC_NAMESPACE(meetc) {

// The highest degree of the stages before the rare one.
template <class P> constexpr int highest_degree() {
  int most = 0;
  if constexpr (P::reject_stage::atoms > 0)
    most = P::reject_stage::degree;
  if constexpr (P::common_stage::atoms > 0)
    most = P::common_stage::degree > most ? P::common_stage::degree : most;
  return most;
}

// Calls one(x) for each pair of rows x.
template <class P, class Decide>
void decide_each(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                 Decide &&one) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] =
        one(row_pair{a.rows + std::size_t{pairs[i].a} * P::inputs_a, b.rows + std::size_t{pairs[i].b} * P::inputs_b});
}
// Calls use(each), where each(i) is one(x) for the rows x of pair i, with stored values if the sets have them.
template <class P, class Decide, class Use>
void with_stored(const row_array &a, const row_array &b, const index_pair *pairs, Decide &&one, Use &&use) {
  constexpr std::size_t floats_a = stored_layout<P>::floats_a, floats_b = stored_layout<P>::floats_b;
  const auto rows = [&](std::size_t i) {
    return row_pair{a.rows + std::size_t{pairs[i].a} * P::inputs_a, b.rows + std::size_t{pairs[i].b} * P::inputs_b};
  };
  if constexpr (floats_a + floats_b > 0)
    if ((floats_a == 0 || a.stored) && (floats_b == 0 || b.stored))
      return use([&](std::size_t i) {
        const row_pair r = rows(i);
        return one(stored_pair{r.row_a, r.row_b, a.stored + pairs[i].a * floats_a, b.stored + pairs[i].b * floats_b});
      });
  use([&](std::size_t i) { return one(rows(i)); });
}
// The same as decide_each for the rungs in fp32, which read stored values.
template <class P, class Decide>
void decide_each_stored(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                        Decide &&one) {
  with_stored<P>(a, b, pairs, one, [&](const auto &each) {
    for (std::size_t i = 0; i < n; ++i)
      out[i] = each(i);
  });
}
// The same, in lanes as far as they decide. They find the answers of `one`.
template <class P, class Decide>
void decide_plain_lanes(const row_array &a, const row_array &b, const index_pair *pairs, std::size_t n, answer *out,
                        Decide &&one) {
  with_stored<P>(a, b, pairs, one,
                 [&](const auto &each) { decide_in_lanes<P, plain_lanes>(a, b, pairs, n, out, each); });
}

// The signs of a pair in the plain rung in fp32.
template <class P> plain_signs<P, float> plain_fp32(const row_pair &p) {
  return {p.row_a, p.row_b};
}
template <class P> stored_plain_signs<P> plain_fp32(const stored_pair &p) {
  return {p};
}
template <class P, class T>
void decide_plain(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  const auto by_float = [](const auto &p) { return to_answer(decide<P>(plain_fp32<P>(p))); };
  if constexpr (std::is_same_v<T, float> && MEETC_FUSES)
    decide_plain_lanes<P>(a, b, pairs, n, out, by_float);
  else if constexpr (std::is_same_v<T, float>)
    decide_each_stored<P>(a, b, pairs, n, out, by_float);
  else
    decide_each<P>(a, b, pairs, n, out,
                   [](const row_pair &p) { return to_answer(decide<P>(plain_signs<P, T>(p.row_a, p.row_b))); });
}
// The exact rung: signs that doubles prove by their running errors, in lanes; then each pair that these leave by itself.
template <class P> void decide_exact(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  const auto one = [](const row_pair &p) { return to_answer(decide_exact<P>(p.row_a, p.row_b)); };
  if constexpr (highest_degree<P>() > tracked_number<wide_lanes>::highest_degree) {
    decide_each<P>(a, b, pairs, n, out, one);
  } else {
    if (!standard_environment())
      return decide_each<P>(a, b, pairs, n, out, one);
    a = {after_check(a.rows)}, b = {after_check(b.rows)};
    decide_in_wide_lanes<P, residue_width<64>, running_errors>(a, b, pairs, n, out, [&](std::size_t i) {
      return one({a.rows + std::size_t{pairs[i].a} * P::inputs_a, b.rows + std::size_t{pairs[i].b} * P::inputs_b});
    });
    after_check(out); // keeps the computation before the return
  }
}
// The exact rung for pairs that the bounded rungs left unsure.
template <class P> void decide_last(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  decide_each<P>(a, b, pairs, n, out,
                 [](const row_pair &p) { return to_answer(decide<P>(exact_signs<P>(p.row_a, p.row_b, true))); });
}
inline void unsure_each(std::size_t n, answer *out) {
  for (std::size_t i = 0; i < n; ++i)
    out[i] = answer::unsure;
}
template <class P, class A>
void certify_pairs(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  if (!standard_environment())
    return unsure_each(n, out);
  a = {after_check(a.rows), a.stored}, b = {after_check(b.rows), b.stored};
  if constexpr (std::is_same_v<A, in_fp32>)
    decide_in_lanes<P, bounded_lanes>(a, b, pairs, n, out, [](std::size_t) { return answer::unsure; });
  else if constexpr (std::is_same_v<A, in_fp64>)
    decide_in_wide_lanes<P>(a, b, pairs, n, out, [&](std::size_t i) {
      return certify_here<P, in_fp64>(a.rows + std::size_t{pairs[i].a} * P::inputs_a,
                                      b.rows + std::size_t{pairs[i].b} * P::inputs_b);
    });
  else
    decide_each<P>(a, b, pairs, n, out, [](const row_pair &p) { return certify_here<P, A>(p.row_a, p.row_b); });
  after_check(out); // keeps the computation before the return
}
template <class P>
void certify_pairs_in_box(float side, row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  if (!standard_environment())
    return unsure_each(n, out);
  a = {after_check(a.rows), a.stored}, b = {after_check(b.rows), b.stored};
  if (!box_holds<P>(side))
    certify_pairs<P, in_fp32>(a, b, pairs, n, out);
  else
    decide_each_stored<P>(a, b, pairs, n, out, [side](const auto &p) {
      return decide_sets<P>(boxed_signs<P, box_form::per_object, std::remove_cvref_t<decltype(p)>>(p, side));
    });
}

// The rung tolerant by distance, of at most lane_count pairs. The arithmetic is that of by_distance::number.
template <class P>
MEETC_INLINE void decide_by_distance(const row_array &a, const row_array &b, const index_pair *pairs, int n,
                                     answer *out) {
  using stage = typename P::common_stage;
  static_assert(stage::atoms == 1 && stage::fields_a + stage::fields_b == 0);
  using number = unfused<lanes>;
  lane_tile<P> t;
  t.load_rows(a, b, pairs, n);
  number row_a[P::inputs_a], row_b[P::inputs_b], v[1];
  for (int i = 0; i < P::inputs_a; ++i)
    row_a[i] = number(t.row_a[i]);
  for (int i = 0; i < P::inputs_b; ++i)
    row_b[i] = number(t.row_b[i]);
  stage::template pair<number, number>(row_a, nullptr, row_b, nullptr, v);
  const lanes value = v[0];
  sign_lanes s[1];
  plain_lanes::sort_out<stage>(&value, nullptr, s);
  const lane_mask hits = to_truth_lanes(P::usual(s)).can_be_true;
  for (int k = 0; k < n; ++k)
    out[k] = to_answer((hits >> k & 1) != 0);
}

// The rung tolerant. Rows have been rounded where it rounds.
template <class P> void decide_tolerant(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out) {
  const auto rest = [](const row_pair &p) { return to_answer(tolerant_later_rungs<P>(p.row_a, p.row_b)); };
  if (!standard_environment())
    return decide_each<P>(a, b, pairs, n, out, rest);
  if constexpr (P::tolerance::rounds) {
    certify_pairs<P, in_fp32>(a, b, pairs, n, out);
    for (std::size_t i = 0; i < n; ++i)
      if (out[i] == answer::unsure)
        decide_each<P>(a, b, pairs + i, 1, out + i, rest);
  } else {
    a = {after_check(a.rows)}, b = {after_check(b.rows)};
    for (std::size_t at = 0; at < n; at += lane_count)
      decide_by_distance<P>(a, b, pairs + at, static_cast<int>(n - at < lane_count ? n - at : lane_count), out + at);
    after_check(out); // keeps the computation before the return
  }
}

// Computes the stored values of n rows by Store (store_a<P, V> or store_b<P, V>).
template <class Store> bool store_each(const float *rows, std::size_t n, float *out) {
  if (!standard_environment())
    return false;
  rows = after_check(rows);
  for (std::size_t i = 0; i < n; ++i)
    Store::compute(rows + i * Store::inputs, out + i * Store::floats);
  after_check(out);
  return true;
}
template <class Store> constexpr stored_values stored_by(int number) {
  if constexpr (Store::floats > 0)
    return {number, Store::floats, guarded<store_each<Store>>};
  return {};
}

// The number of the values that plain rungs store, for the number of those that the bounded ones do.
inline int plain_number(int number, const kind_info *of) {
  return number < 0 || MEETC_FUSES ? number : number + of->stored / 2;
}

// The sides of the boxes for which the box form holds in all stages of P.
template <class P> constexpr float least_box() {
  float least = 0;
  each_stage<P>([&least](auto stage) {
    const float x = power_of_two(decltype(stage)::box_lowest, 0.0F);
    least = x > least ? x : least;
  });
  return least;
}
template <class P> constexpr float most_box() {
  float most = 0x1p127F;
  each_stage<P>([&most](auto stage) {
    const float x = 1 / power_of_two(-decltype(stage)::box_highest, 0.0F);
    most = x < most ? x : most;
  });
  return most;
}

// The bits of differences up to which every value of P fits 128 bits; 0 where its growth is not known.
template <class P> constexpr int longest_differences() {
  int least = 126;
  each_stage<P>([&least](auto stage) {
    if constexpr (!grouped<P> && requires { decltype(stage)::growth; }) {
      const int bits = (126 - decltype(stage)::growth) / decltype(stage)::degree;
      least = bits < least ? bits : least;
    } else {
      least = 0;
    }
  });
  return least;
}

// A rung as the table holds it.
template <decide_function Decide> inline constexpr decide_function table_rung = guarded<Decide>;

// The entry of a predicate, with the rungs that the scene asks for; number_a and number_b are the numbers of its stored
// values.
template <class P, rung... Rungs>
predicate_info info_of(const char *name, const char *mode, const kind_info *a, const kind_info *b, int number_a,
                       int number_b) {
  constexpr auto asks = [](rung r) { return ((Rungs == r) || ...); };
  constexpr bool certified = asks(rung::certified);
  predicate_info p{name, mode, a, b, {}, {}, nullptr, 0, 0};
  const auto decide = [&p](rung r) -> decide_function & { return p.decide[static_cast<int>(r)]; };
  if constexpr (asks(rung::fp32))
    decide(rung::fp32) = table_rung<decide_plain<P, float>>;
  if constexpr (asks(rung::fp64))
    decide(rung::fp64) = table_rung<decide_plain<P, double>>;
  if constexpr (asks(rung::fp64x2))
    decide(rung::fp64x2) = table_rung<decide_plain<P, double_double>>;
  if constexpr (asks(rung::exact) || certified)
    decide(rung::exact) = table_rung<decide_exact<P>>;
  if constexpr (certified) {
    p.certify[0] = table_rung<certify_pairs<P, in_fp32>>;
    p.certify[1] = table_rung<certify_pairs<P, in_fp64>>;
    p.certify[2] = table_rung<certify_pairs<P, in_fp64x2>>;
    p.decide_last = table_rung<decide_last<P>>;
    if constexpr (!grouped<P>) { // otherwise there is no box form
      p.certify_in_box = guarded<certify_pairs_in_box<P>>;
      p.box_least = least_box<P>();
      p.box_most = most_box<P>();
    }
  }
  p.longest_differences = longest_differences<P>();
  p.symmetric = P::symmetric;
  p.scales = !grouped<P>; // otherwise only when each group is multiplied by one of its own
  if constexpr (asks(rung::tolerant)) {
    decide(rung::tolerant) = table_rung<decide_tolerant<P>>;
    p.tolerance = {P::tolerance::moves, P::tolerance::step(), P::tolerance::rounds, P::tolerance::reach};
  }
  if constexpr (asks(rung::fp32) || asks(rung::tolerant) || certified)
    p.stored_a = stored_by<store_a<P, in_fp32::value>>(number_a),
    p.stored_b = stored_by<store_b<P, in_fp32::value>>(number_b),
    p.plain_stored_a = stored_by<store_a<P, float>>(plain_number(number_a, a)),
    p.plain_stored_b = stored_by<store_b<P, float>>(plain_number(number_b, b));
  return p;
}

} // MEETC_NAMESPACE(meetc)

#endif
