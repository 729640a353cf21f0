// The same points mirrored, scaled by a power of two or moved give the same answer. (In another order: tests/extremes.)
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/operands.hpp"

#include <algorithm>
#include <array>
#include <gmpxx.h>

using namespace meetc::generated_test;

namespace {

// One of the 48 signed permutations of the axes.
row mirrored(shape kind, const row &r, int which) {
  static constexpr std::array<std::array<std::size_t, 3>, 6> axes = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  row out = r;
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(points_of(kind)); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const float c = r[i + axes[static_cast<std::size_t>(which / 8)][k]];
      out[i + k] = which >> k & 1 ? -c : c;
    }
  put_in_order(kind, out);
  return out;
}

bool exactly_moved(shape kind, const row &r, const float t[3], const row &to) {
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(points_of(kind)); ++i)
    if (mpq_class(static_cast<double>(r[i])) + mpq_class(static_cast<double>(t[i % 3])) !=
        mpq_class(static_cast<double>(to[i])))
      return false;
  return true;
}

// Runs f on some pairs of every family for every predicate.
template <class F> void on_all(int cases, F &&f) {
  for_each_predicate([&](auto p) {
    std::uint64_t seed = 500;
    for (const family &from : families()) {
      random_numbers random(seed++);
      INFO(p.name << " on " << from.name);
      bool same = true;
      for (int i = 0; i < effort(cases) && same; ++i)
        same = f(p, from.make(p.a, p.b, random), random);
      CHECK(same);
    }
  });
}

} // namespace

TEST_CASE("invariance: axes swapped and mirrored") {
  on_all(60, [](auto p, const pair_of_rows &rows, random_numbers &) {
    const bool want = p.hit(rows.a, rows.b);
    for (int which = 1; which < 48; ++which)
      if (p.hit(mirrored(p.a, rows.a, which), mirrored(p.b, rows.b, which)) != want)
        return false;
    return true;
  });
}

TEST_CASE("invariance: exact scaling by powers of two") {
  long exact_cases = 0;
  on_all(300, [&](auto p, const pair_of_rows &rows, random_numbers &random) {
    const bool want = p.hit(rows.a, rows.b);
    for (int t = 0; t < 4; ++t) {
      const int k = random.integer(-200, 200);
      const row a = scaled(rows.a, k), b = scaled(rows.b, k);
      if (scaled(a, -k) != rows.a || scaled(b, -k) != rows.b)
        continue; // scaling or moving was not exact
      ++exact_cases;
      if (p.hit(a, b) != want)
        return false;
    }
    return true;
  });
  CHECK(exact_cases > effort(20000));
}

TEST_CASE("invariance: exact translation") {
  long exact_cases = 0;
  on_all(300, [&](auto p, const pair_of_rows &rows, random_numbers &random) {
    const bool want = p.hit(rows.a, rows.b);
    for (int i = 0; i < 4; ++i) {
      float t[3];
      for (float &c : t)
        c = static_cast<float>(random.integer(-64, 64)) * static_cast<float>(1 << random.integer(0, 12));
      const row a = moved(p.a, rows.a, t), b = moved(p.b, rows.b, t);
      if (!exactly_moved(p.a, rows.a, t, a) || !exactly_moved(p.b, rows.b, t, b))
        continue;
      ++exact_cases;
      if (p.hit(a, b) != want)
        return false;
    }
    return true;
  });
  CHECK(exact_cases > effort(10000));
}
