// Pairs with an equal point that settles the decision: every certified way answers yes, the first rung alone too, and
// integers, which do not compare points, say the same. A point that differs in one bit settles nothing.
#include <meetc/simd/table_functions.hpp> // before any header of a predicate

#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"
#include "tests/generated/judge/predicates.hpp"

#include <cmath>

using namespace meetc::generated_test;
using meetc::answer;

namespace {

// Numbers of every scale, many of them zeros of either sign.
float draw(random_numbers &random, int lowest, int highest) {
  if (random.one_in(8))
    return random.one_in(2) ? 0.0F : -0.0F;
  const auto m = static_cast<float>(random.integer(-0xffffff, 0xffffff));
  return std::ldexp(m, random.integer(lowest, highest) - 24);
}

// The same coordinates, with the other zero where one is zero.
void copy_point(const row &from, int i, row &to, int j) {
  for (std::size_t k = 0; k < 3; ++k) {
    const float v = from[static_cast<std::size_t>(3 * i) + k];
    to[static_cast<std::size_t>(3 * j) + k] = v == 0 ? -v : v;
  }
}

template <class P> bool by_integers(const row &a, const row &b) {
  return meetc::decide<P>(meetc::integer_signs<P>(a.data(), b.data()));
}

} // namespace

TEST_CASE("settled: an equal point is a hit on every certified path") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    if (p.a == shape::box) // one point in common settles nothing, since nothing is said of the others
      return;
    INFO(p.name);
    random_numbers random(11);
    int settled = 0;
    for (int n = 0; n < 400; ++n) {
      const bool wide = n % 4 == 3; // to the ends of float32
      const int lowest = wide ? -148 : -4, highest = wide ? 127 : 4;
      row a(P::inputs_a), b(P::inputs_b);
      for (row *r : {&a, &b})
        for (float &v : *r)
          v = draw(random, lowest, highest);
      if (padded(p.a))
        a[3] = std::abs(a[3]);
      if (padded(p.b))
        b[3] = std::abs(b[3]);
      copy_point(a, random.integer(0, points_of(p.a) - 1), b, random.integer(0, points_of(p.b) - 1));
      CAPTURE(a, b);
      const meetc::row_array rows_a(a.data()), rows_b(b.data());
      const meetc::index_pair pair{0, 0};
      const bool truth = by_integers<P>(a, b);
      answer exact, bounded;
      meetc::decide_exact<P>(rows_a, rows_b, &pair, 1, &exact);
      CHECK(exact == meetc::to_answer(truth));
      meetc::certify_pairs<P, meetc::in_fp64>(rows_a, rows_b, &pair, 1, &bounded);
      CHECK((bounded == exact || bounded == answer::unsure));
      CHECK(meetc::decide_certified<P>(a.data(), b.data()) == truth);
      CHECK(p.hit(a, b) == truth);
      if (!P::settled(P::coincident(a.data(), b.data())))
        continue;
      ++settled;
      CHECK(truth);
      CHECK(P::filter(decltype(p)::kind_a::in(a.data()), decltype(p)::kind_b::in(b.data())) == answer::yes);
      meetc::certify_pairs<P, meetc::in_fp32>(rows_a, rows_b, &pair, 1, &bounded);
      CHECK(bounded == answer::yes);
    }
    CHECK(settled == (p.surface ? 0 : 400));
  });
}

TEST_CASE("settled: a point that differs in one bit settles nothing") {
  for_each_predicate([](auto p) {
    using P = typename decltype(p)::type;
    if (p.a == shape::box)
      return;
    INFO(p.name);
    random_numbers random(12);
    int misses = 0;
    for (int n = 0; n < 400; ++n) {
      row a(P::inputs_a), b(P::inputs_b);
      for (row *r : {&a, &b})
        for (float &v : *r)
          v = std::ldexp(1 + std::abs(draw(random, -1, -1)), random.integer(-1, 1));
      if (padded(p.a))
        a[3] = 0;
      if (padded(p.b))
        b[3] = 0;
      const int j = random.integer(0, points_of(p.b) - 1);
      copy_point(a, random.integer(0, points_of(p.a) - 1), b, j);
      float &moved = b[static_cast<std::size_t>(3 * j + random.integer(0, 2))];
      moved = std::nextafter(moved, random.one_in(2) ? 0.0F : 9.0F);
      CAPTURE(a, b);
      CHECK(P::coincident(a.data(), b.data()) == 0);
      CHECK(p.hit(a, b) == by_integers<P>(a, b));
      misses += !by_integers<P>(a, b);
    }
    CHECK(misses > 0);
  });
}
