#include "tests/extremes/mutants.hpp"

#include <stdexcept>
#include <type_traits>

namespace meetc::extremes_test {
namespace {

// A stage with one thing changed.
template <class Stage, mutation M> struct changed : Stage {
  // Without fma, a b - c d is right even where both products are rounded, if they are equal. So a window that is a few
  // bits too wide does little harm to stages in fp64 alone.
  static constexpr int window = Stage::window + (M != mutation::wider_window   ? 0
                                                 : Stage::mixed || MEETC_FUSES ? 4
                                                                               : 14);
  static meetc::factors factor(int i) { return changed_factors(Stage::factor(i)); }
  static meetc::factors factor_unfused(int i) { return changed_factors(Stage::factor_unfused(i)); }
  static meetc::box_factor box(int i) { return changed_box(Stage::box(i)); }
  static meetc::box_factor box_unfused(int i) { return changed_box(Stage::box_unfused(i)); }
  static unsigned zero_if(int i) { return M == mutation::equal_points ? ~0U : Stage::zero_if(i); }
  static int degree_of(int i) {
    return Stage::degree_of(i) + (M == mutation::degree_above) - (M == mutation::degree_below);
  }

private:
  static meetc::factors changed_factors(const meetc::factors &k) {
    return M == mutation::quarter_factor ? meetc::factors{k.fp32 / 4, k.fp64 / 4, k.fp64x2 / 4} : k;
  }
  static meetc::box_factor changed_box(meetc::box_factor f) {
    f.c = M == mutation::quarter_box ? f.c / 4 : f.c;
    return f;
  }
};
template <mutation M> struct changed<meetc::no_stage, M> : meetc::no_stage {};

template <class P, mutation M, bool = lone_sign<P>> struct mutant : P {
  using reject_stage = changed<typename P::reject_stage, M>;
  using common_stage = changed<typename P::common_stage, M>;
  using rare_stage = changed<typename P::rare_stage, M>;
};
template <class P, mutation M> struct mutant<P, M, true> : P {
  using common_stage = changed<typename P::common_stage, M>;
};

template <class P, mutation M> unsigned wrong_signs_of(const float *a, const float *b, float side) {
  using Q = mutant<P, M>;
  meetc::sign truth[P::atoms];
  all_signs<P>(meetc::integer_signs<P>(a, b), truth);
  constexpr bool all = M == mutation::none;
  constexpr bool by_degree = M == mutation::degree_above || M == mutation::degree_below;
  unsigned wrong = 0;
  if constexpr (all || M == mutation::quarter_factor || M == mutation::equal_points)
    wrong |= sets_hold<Q>(meetc::bounded_signs<Q, meetc::in_fp32>(a, b), truth) ? 0 : bit(fp32);
  if constexpr (all || M == mutation::quarter_factor || by_degree) {
    wrong |= sets_hold<Q>(meetc::bounded_signs<Q, meetc::in_fp64>(a, b), truth) ? 0 : bit(fp64);
    wrong |= sets_hold<Q>(meetc::bounded_signs<Q, meetc::in_fp64x2>(a, b), truth) ? 0 : bit(fp64x2);
  }
  if constexpr (all || M == mutation::quarter_box)
    if (box_covers<P>(side)) {
      using meetc::box_form;
      wrong |= sets_hold<Q>(meetc::boxed_signs<Q, box_form::per_object>(a, b, side), truth) ? 0 : bit(per_object);
      wrong |= sets_hold<Q>(meetc::boxed_signs<Q, box_form::whole_box>(a, b, side), truth) ? 0 : bit(whole_box);
    }
  if constexpr (all || M == mutation::wider_window) {
    wrong |= sets_hold<Q>(meetc::fp64_signs<Q>(a, b), truth) ? 0 : bit(fp64);
    wrong |= signs_hold<Q>(meetc::exact_signs<Q>(a, b), truth) ? 0 : bit(exact_rung);
  }
  return wrong;
}

using wrong_function = unsigned (*)(const float *, const float *, float);

} // namespace

const char *name_of(mutation m) {
  static constexpr const char *names[] = {"none",         "quarter_factor", "quarter_box", "equal_points",
                                          "degree_above", "degree_below",   "wider_window"};
  return names[static_cast<int>(m)];
}

unsigned wrong_signs(const subject &s, mutation m, const float *a, const float *b, float side) {
  const auto run = [&]<mutation M>(std::integral_constant<mutation, M>) {
    return for_type_of(s, []<class P>(P) -> wrong_function { return wrong_signs_of<P, M>; })(a, b, side);
  };
  switch (m) {
    using enum mutation;
  case none:
    return run(std::integral_constant<mutation, none>());
  case quarter_factor:
    return run(std::integral_constant<mutation, quarter_factor>());
  case quarter_box:
    return run(std::integral_constant<mutation, quarter_box>());
  case equal_points:
    return run(std::integral_constant<mutation, equal_points>());
  case degree_above:
    return run(std::integral_constant<mutation, degree_above>());
  case degree_below:
    return run(std::integral_constant<mutation, degree_below>());
  case wider_window:
    return run(std::integral_constant<mutation, wider_window>());
  }
  throw std::invalid_argument("mutation");
}

} // namespace meetc::extremes_test
