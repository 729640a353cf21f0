// Signs whose numbers have groups, each with a grid of its own: the emitted code against rationals, on numbers at the ends of
// float32 and on operands that touch but for one step of one number.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <array>
#include <cmath>
#include <groups/groups.hpp>
#include <meetc/decide/later_rungs.hpp>
#include <vector>

#include <groups/header_only.hpp>

using namespace meetc;
using namespace meetc::generated_test;

namespace {

struct pair_of_rows {
  std::vector<float> a, b;
  float &at(int i) {
    return i < static_cast<int>(a.size()) ? a[static_cast<std::size_t>(i)] : b[static_cast<std::size_t>(i) - a.size()];
  }
};

template <class P> constexpr int inputs = P::inputs_a + P::inputs_b;

// The power of two by which a number of the pair may be scaled: the sum of its weights times those of the groups.
template <class P> int scale_of(int i, const std::array<int, 8> &of_group) {
  if constexpr (grouped<P>) {
    int e = 0;
    for (int j = 0; j < P::groups; ++j)
      e += P::weight(i, j) * of_group[static_cast<std::size_t>(j)];
    return e;
  } else {
    return of_group[0];
  }
}

// Small whole numbers at scales of their groups, of which many make a sign zero; half of the time one is off by a step.
template <class P> pair_of_rows nearly_zero(random_numbers &random) {
  pair_of_rows out{std::vector<float>(P::inputs_a), std::vector<float>(P::inputs_b)};
  std::array<int, 8> scales{};
  for (int &s : scales)
    s = random.one_in(3) ? 0 : random.integer(-40, 40);
  const int most = random.integer(1, 3);
  for (int i = 0; i < inputs<P>; ++i)
    out.at(i) = std::ldexp(static_cast<float>(random.integer(-most, most)), scale_of<P>(i, scales));
  if (random.one_in(2)) {
    float &v = out.at(random.integer(0, inputs<P> - 1));
    v = std::nextafter(v, random.one_in(2) ? HUGE_VALF : -HUGE_VALF);
  }
  return out;
}

// The ends of float32 beside common numbers.
template <class P> pair_of_rows hostile(random_numbers &random) {
  constexpr float ends[] = {
      0.0F,     -0.0F, 0x1p-149F,     0x1.8p-148F,    0x1p-126F, 0x1.fffffcp-127F, 0x1.fffffep127F, 0x1p127F,
      0x1p-75F, 1.0F,  0x1.000002p0F, 0x1.fffffep-1F, 3.0F};
  pair_of_rows out{std::vector<float>(P::inputs_a), std::vector<float>(P::inputs_b)};
  const int way = random.integer(0, 4); // 3 and 4: whole numbers of the least and of large steps
  for (int i = 0; i < inputs<P>; ++i) {
    const float v = way == 0 ? random.pattern() : ends[static_cast<std::size_t>(random.integer(0, 12))];
    out.at(i) = random.one_in(2) ? v : -v;
    if (way > 2)
      out.at(i) = static_cast<float>(random.integer(-3, 3)) * (way == 3 ? 0x1p-149F : 0x1p126F);
    if (way == 2 && random.one_in(2))
      out.at(i) = static_cast<float>(random.integer(-2, 2));
  }
  return out;
}

template <class P, class Stage> std::vector<int> true_signs(const pair_of_rows &r) {
  exact a[P::inputs_a], b[P::inputs_b], v[Stage::atoms];
  for (std::size_t i = 0; i < r.a.size(); ++i)
    a[i] = exact(static_cast<double>(r.a[i]));
  for (std::size_t i = 0; i < r.b.size(); ++i)
    b[i] = exact(static_cast<double>(r.b[i]));
  stage_values<Stage>(a, b, v);
  std::vector<int> out;
  for (const exact &x : v)
    out.push_back(sgn(x.v));
  return out;
}

struct tally {
  long cases = 0, zeros = 0, known = 0, wrong_integers = 0, wrong_exact = 0, wrong_sets = 0;
};

template <class P, class Stage, class Signs>
void check_sets(const pair_of_rows &r, const std::vector<int> &want, tally &t) {
  sign_set s[P::atoms + 1];
  Signs(r.a.data(), r.b.data()).template get<Stage>(s);
  for (int i = 0; i < Stage::atoms; ++i) {
    const int bits = s[Stage::first + i].bits;
    t.wrong_sets += (bits >> (want[static_cast<std::size_t>(i)] + 1) & 1) == 0;
    t.known += bits != 7;
  }
}

// `Q` is P, or P with other weights.
template <class P, class Q = P> tally run(pair_of_rows (*draw)(random_numbers &), int cases) {
  tally t;
  random_numbers random(inputs<P>);
  for (int n = 0; n < cases; ++n) {
    const pair_of_rows r = draw(random);
    each_stage<P>([&](auto stage) {
      using S = decltype(stage);
      const std::vector<int> want = true_signs<P, S>(r);
      sign by_integers[P::atoms + 1], by_exact[P::atoms + 1];
      integer_signs<Q>(r.a.data(), r.b.data()).template get<S>(by_integers);
      exact_signs<Q>(r.a.data(), r.b.data()).template get<S>(by_exact);
      for (int i = 0; i < S::atoms; ++i) {
        const int truth = want[static_cast<std::size_t>(i)];
        ++t.cases;
        t.zeros += truth == 0;
        t.wrong_integers += static_cast<int>(by_integers[S::first + i]) != truth;
        t.wrong_exact += static_cast<int>(by_exact[S::first + i]) != truth;
      }
      check_sets<P, S, bounded_signs<P, in_fp32>>(r, want, t);
      check_sets<P, S, fp64_signs<P>>(r, want, t); // in doubles within the window
      check_sets<P, S, bounded_signs<P, in_fp64x2>>(r, want, t);
    });
  }
  return t;
}

template <class P> struct named {
  using type = P;
  const char *name;
};
template <class F> void each_kernel(F &&f) {
  f(named<groups::squared_plane_line_sign>{"plane, line"});
  f(named<groups::squared_sphere_line_sign>{"sphere, line"});
  f(named<groups::squared_plane_plane_sign>{"plane, plane"});
  f(named<groups::squared_sphere_plane_sign>{"sphere, plane"});
  f(named<groups::squared_sphere_sphere_sign>{"sphere, sphere"});
  f(named<groups::squared_circle_line_sign>{"circle, line"});
  f(named<groups::squared_circle_circle_sign>{"circle, circle"});
  f(named<groups::squared_circle_plane_sign>{"circle, plane"});
  f(named<groups::squared_circle_sphere_sign>{"circle, sphere"});
  f(named<groups::turning_point_pair_line_sign>{"point pair, line"});
  f(named<groups::turning_point_pair_circle_sign>{"point pair, circle"});
  f(named<groups::squared_point_pair_plane_sign>{"point pair, plane"});
  f(named<groups::squared_point_pair_sphere_sign>{"point pair, sphere"});
  f(named<groups::line_in_plane>{"line in plane"});
  f(named<groups::same_plane>{"same plane"});
  f(named<groups::circle_in_plane>{"circle in plane"});
  f(named<groups::circle_on_sphere>{"circle on sphere"});
  f(named<groups::pair_in_plane>{"pair in plane"});
  f(named<groups::touches>{"touches"});
}

// All numbers on one grid, as if no number were of two groups.
template <class P> struct on_one_grid : P {
  static constexpr int groups = 1;
  static constexpr int weight(int, int) { return 1; }
};

void check_right(const tally &t) {
  CHECK(t.wrong_integers == 0);
  CHECK(t.wrong_exact == 0);
  CHECK(t.wrong_sets == 0);
}

} // namespace

TEST_CASE("groups: signs are those of rationals where operands touch, but for one step") {
  each_kernel([](auto k) {
    using P = typename decltype(k)::type;
    INFO(k.name);
    const tally t = run<P>(nearly_zero<P>, effort(4000));
    check_right(t);
    CHECK(t.zeros > t.cases / 100); // they occur
    CHECK(t.known > 0);
  });
}

TEST_CASE("groups: signs are those of rationals at the ends of float32") {
  each_kernel([](auto k) {
    using P = typename decltype(k)::type;
    INFO(k.name);
    check_right(run<P>(hostile<P>, effort(4000)));
  });
}

TEST_CASE("groups: on one grid for all numbers, signs are wrong") {
  using P = groups::squared_sphere_plane_sign;
  static_assert(P::groups == 2);
  CHECK(run<P, on_one_grid<P>>(nearly_zero<P>, effort(4000)).wrong_integers > 0);
}

// Numbers of weight w have w b bits.
TEST_CASE("groups: no value of a stage is wider than it claims, and some are nearly as wide") {
  each_kernel([](auto k) {
    using P = typename decltype(k)::type;
    if constexpr (grouped<P>) {
      INFO(k.name);
      random_numbers random(7);
      std::size_t widest_share = 0;
      each_stage<P>([&](auto stage) {
        using S = decltype(stage);
        for (const unsigned bits : {1U, 2U, 3U, 24U, 62U}) {
          const std::size_t most = static_cast<std::size_t>(S::degree) * bits + S::growth;
          std::size_t seen = 0;
          for (int n = 0; n < effort(400); ++n) {
            counted_integer a[P::inputs_a], b[P::inputs_b], v[S::atoms];
            for (int i = 0; i < inputs<P>; ++i) {
              const mpz_class top = (mpz_class(1) << (static_cast<unsigned>(weight_of<P>(i)) * bits)) - 1;
              (i < P::inputs_a ? a[i] : b[i - P::inputs_a]) = counted_integer(mpz_class(random.integer(-1, 1) * top));
            }
            counted_integer::widest = 0;
            stage_values<S>(a, b, v);
            seen = std::max(seen, counted_integer::widest);
          }
          CHECK(seen <= most);
          // With one degree less the claim would be wrong.
          if (bits >= 24)
            widest_share += seen > static_cast<std::size_t>(S::degree - 1) * bits + S::growth;
        }
      });
      CHECK(widest_share > 0);
    }
  });
}

TEST_CASE("groups: the entry points decide a plane that a sphere touches") {
  const groups::plane<float> p{{0, 0, 0x1p40F}, 0x1p41F}; // z = 2
  const groups::sphere<float> s{{0x1p-100F, 0, 1}, 1}, lower{{0, 0, 1}, 0x1.fffffep-1F},
      upper{{0, 0, 0x1.000002p0F}, 1};
  CHECK(groups::squared(s, p) == sign::zero);
  CHECK(groups::squared(lower, p) == sign::negative);
  CHECK(groups::squared(upper, p) == sign::positive);
  CHECK(groups::touches::hit(s, p));
  CHECK_FALSE(groups::touches::hit(lower, p));
  CHECK_FALSE(groups::touches::hit(upper, p));
}
