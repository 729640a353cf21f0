// The integers, by which all else is judged, judged themselves: every sign against GMP's rationals, and every
// answer against judges that know no signs at all.
#include "tests/extremes/families.hpp"
#include "tests/generated/catch.hpp"
#include "tests/generated/effort.hpp"
#include "tests/generated/judge.hpp"

#include <gmpxx.h>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

template <class F> void on_every_cell(int cases, std::uint64_t seed, F &&f) {
  for (const family &from : families())
    for (const subject &s : subjects()) {
      if (!from.applies(s.a, s.b))
        continue;
      random_numbers random(seed++);
      INFO(s.name << " on " << from.name);
      bool same = true;
      for (int i = 0; i < effort(cases) && same; ++i) {
        const pair_of_rows p = from.make(s.a, s.b, random);
        INFO(text(p));
        same = f(s, p);
        if (!same)
          CHECK(same);
      }
    }
}

using vec = std::array<mpq_class, 3>;
vec difference(const row &x, std::size_t i, const row &y, std::size_t j) {
  vec out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = mpq_class(static_cast<double>(x[3 * i + k])) - mpq_class(static_cast<double>(y[3 * j + k]));
  return out;
}
mpq_class determinant(const vec &a, const vec &b, const vec &c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// What a lone sign is of, up to the convention.
int lone_sign_of(const subject &s, const pair_of_rows &p) {
  if (padded(s.a)) { // in, on or out of a sphere
    const vec d = difference(p.b, 0, p.a, 0);
    const mpq_class r(static_cast<double>(p.a[3]));
    return sgn(mpq_class(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - r * r));
  }
  const vec u = difference(p.a, 1, p.a, 0);
  const bool triangle = s.a == shape::triangle;
  const vec v = triangle ? difference(p.a, 2, p.a, 0) : difference(p.b, 0, p.a, 0);
  return sgn(determinant(u, v, difference(p.b, triangle ? 0 : 1, p.a, 0)));
}

} // namespace

TEST_CASE("truth: the integers' signs are those of the rationals") {
  on_every_cell(60, 300, [](const subject &s, const pair_of_rows &p) {
    return s.integers_hold(p.a.data(), p.b.data());
  });
}

TEST_CASE("truth: the integers' answers are the oracle's") {
  on_every_cell(60, 600, [](const subject &s, const pair_of_rows &p) {
    using namespace meetc::generated_test;
    return s.sign || (s.truth(p.a.data(), p.b.data()) == 1) == touching(s.a, p.a, s.b, p.b, s.surface);
  });
}

TEST_CASE("truth: segments and triangles by separating axes, too") {
  on_every_cell(300, 900, [](const subject &s, const pair_of_rows &p) {
    using namespace meetc::generated_test;
    return s.sign || padded(s.a) ||
           (s.truth(p.a.data(), p.b.data()) == 1) == touching_by_axes(s.a, p.a, s.b, p.b);
  });
}

TEST_CASE("truth: lone signs are those of determinants and distances") {
  for (const subject &s : subjects()) {
    if (!s.sign)
      continue;
    int convention = 0, zeros = 0;
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      INFO(s.name << " on " << f.name);
      random_numbers random(41);
      bool same = true;
      for (int i = 0; i < effort(400); ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const int have = s.truth(p.a.data(), p.b.data()), want = lone_sign_of(s, p);
        if (convention == 0 && want != 0)
          convention = have * want;
        same = same && have == convention * want;
        zeros += want == 0;
      }
      CHECK(same);
    }
    CHECK(convention != 0);
    CHECK(zeros > effort(100));
  }
}
