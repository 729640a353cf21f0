// The dense product against known values, the laws of the algebra, and a product that is computed in another way.
#include "gen/oracle/dense.hpp"
#include "tests/catch.hpp"
#include "tests/gen/oracle/random.hpp"

#include <stdexcept>

using namespace meetc::oracle;
using meetc::oracle_test::random_numbers;

namespace {

multivector random_multivector(const dense_algebra &g, random_numbers &r) {
  multivector m = g.zero();
  for (rational &c : m)
    c = r.integer(0, 2) == 0 ? rational(0) : r.fraction(5);
  return m;
}

matrix random_metric(std::size_t n, random_numbers &r) {
  matrix g(n, std::vector<rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      g[i][j] = g[j][i] = r.integer(-2, 2);
  return g;
}

// The product in another way, which needs no orthogonal basis: a vector times b is v ^ b + v ⌋ b, and a blade is taken
// apart by v ^ R = v R − v ⌋ R.
class chevalley {
public:
  explicit chevalley(matrix g) : g_(std::move(g)) {}
  // v_i ⌋ b, an antiderivation.
  [[nodiscard]] multivector contract(std::size_t i, const multivector &b) const {
    multivector r(b.size());
    for (std::size_t m = 0; m < b.size(); ++m) {
      int before = 0;
      for (std::size_t j = 0; j < g_.size(); ++j)
        if (m >> j & 1) {
          const rational t = b[m] * g_[i][j];
          r[m ^ std::size_t{1} << j] += before % 2 != 0 ? rational(-t) : t;
          ++before;
        }
    }
    return r;
  }
  [[nodiscard]] multivector vector_times(std::size_t i, const multivector &b) const {
    multivector v(b.size());
    v[std::size_t{1} << i] = 1;
    return add(outer(v, b), contract(i, b));
  }
  [[nodiscard]] multivector blade_times(std::size_t m, const multivector &b) const {
    if (m == 0)
      return b;
    std::size_t i = 0;
    while ((m >> i & 1) == 0)
      ++i;
    const std::size_t rest = m ^ std::size_t{1} << i;
    // blade m = v_i ^ rest = v_i rest − v_i ⌋ rest
    multivector blade(b.size());
    blade[rest] = 1;
    return subtract(vector_times(i, blade_times(rest, b)), times(contract(i, blade), b));
  }
  [[nodiscard]] multivector times(const multivector &a, const multivector &b) const {
    multivector r(b.size());
    for (std::size_t m = 0; m < a.size(); ++m)
      if (a[m] != 0)
        r = add(r, scale(a[m], blade_times(m, b)));
    return r;
  }

private:
  matrix g_;
};

void check_laws(const dense_algebra &g, random_numbers &r) {
  const multivector a = random_multivector(g, r), b = random_multivector(g, r), c = random_multivector(g, r);
  CHECK(g.geometric(g.geometric(a, b), c) == g.geometric(a, g.geometric(b, c)));
  CHECK(outer(outer(a, b), c) == outer(a, outer(b, c)));
  CHECK(g.left_contraction(outer(a, b), c) == g.left_contraction(a, g.left_contraction(b, c)));
  CHECK(g.geometric(a, add(b, c)) == add(g.geometric(a, b), g.geometric(a, c)));
  // The outer product and the left contraction are grade parts of the geometric product, grade by grade.
  multivector wedge = g.zero(), contraction = g.zero();
  for (int i = 0; i <= g.dimension(); ++i)
    for (int j = 0; j <= g.dimension(); ++j) {
      const multivector p = g.geometric(grade_part(a, i), grade_part(b, j));
      wedge = add(wedge, grade_part(p, i + j));
      contraction = add(contraction, grade_part(p, j - i));
    }
  CHECK(wedge == outer(a, b));
  CHECK(contraction == g.left_contraction(a, b));
}

} // namespace

TEST_CASE("dense: hand-known products of space, R(3)") {
  const dense_algebra g = dense_algebra::diagonal({1, 1, 1});
  const multivector e1 = g.vector(0), e2 = g.vector(1), e3 = g.vector(2);
  CHECK(g.geometric(e1, e1) == g.scalar(1));
  CHECK(g.geometric(e2, e1) == scale(-1, g.geometric(e1, e2)));
  const multivector i = g.geometric(e2, e3), j = g.geometric(e3, e1), k = g.geometric(e1, e2);
  CHECK(g.geometric(i, i) == g.scalar(-1));
  CHECK(g.geometric(i, j) == scale(-1, k)); // (e2 e3)(e3 e1) = e2 e1
  CHECK(g.geometric(g.geometric(i, j), k) == g.scalar(1));
  CHECK(g.left_contraction(e1, k) == e2);
  CHECK(g.left_contraction(e2, k) == scale(-1, e1));
  CHECK(g.left_contraction(k, e1) == g.zero());
  CHECK(g.left_contraction(g.scalar(3), k) == scale(3, k));
  CHECK(g.pseudoscalar() == outer(e1, outer(e2, e3)));
  // The cross product as the dual of the outer product: −I (a ^ b) = a × b.
  const multivector a = add(e1, scale(2, e2)), b = add(scale(3, e2), scale(-1, e3));
  CHECK(scale(-1, g.geometric(g.pseudoscalar(), outer(a, b))) ==
        add(add(scale(-2, e1), e2), scale(3, e3))); // (1,2,0) × (0,3,−1)
}

TEST_CASE("dense: R(4,1) has a central I with square −1") {
  const dense_algebra g = dense_algebra::diagonal({1, 1, 1, 1, -1});
  const multivector I = g.pseudoscalar();
  CHECK(g.geometric(I, I) == g.scalar(-1));
  random_numbers r(1);
  for (int t = 0; t < 20; ++t) {
    const multivector a = random_multivector(g, r);
    CHECK(g.geometric(I, a) == g.geometric(a, I));
  }
}

TEST_CASE("dense: the laws hold for diagonal metrics") {
  random_numbers r(2);
  for (int t = 0; t < 10; ++t) {
    check_laws(dense_algebra::diagonal({1, 1, 1, 1, -1}), r);
    check_laws(dense_algebra::diagonal({1, 1, 1, 0}), r);
    check_laws(dense_algebra::diagonal({rational(2, 3), -5, 0}), r);
  }
}

TEST_CASE("dense: the laws and the defining relations hold for any metric") {
  random_numbers r(3);
  for (int t = 0; t < 40; ++t) {
    const matrix metric = random_metric(1 + static_cast<std::size_t>(t) % 4, r);
    const dense_algebra g(metric);
    for (int i = 0; i < g.dimension(); ++i)
      for (int j = 0; j < g.dimension(); ++j) {
        const multivector v = g.vector(i), w = g.vector(j);
        const rational inner = metric[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        CHECK(add(g.geometric(v, w), g.geometric(w, v)) == g.scalar(2 * inner));
        CHECK(g.left_contraction(v, w) == g.scalar(inner));
        CHECK(subtract(g.geometric(v, w), g.scalar(inner)) == outer(v, w));
      }
    check_laws(g, r);
  }
}

TEST_CASE("dense: any metric agrees with the product by outer product and contraction") {
  random_numbers r(4);
  for (int t = 0; t < 40; ++t) {
    const matrix metric = random_metric(2 + static_cast<std::size_t>(t) % 4, r);
    const dense_algebra g(metric);
    const chevalley other(metric);
    const multivector a = random_multivector(g, r), b = random_multivector(g, r);
    CHECK(g.geometric(a, b) == other.times(a, b));
  }
}

TEST_CASE("dense: metrics without a diagonal, and degenerate ones") {
  random_numbers r(5);
  for (const matrix &metric :
       {matrix{{0, 1}, {1, 0}}, matrix{{0, 0}, {0, 0}}, matrix{{1, 1}, {1, 1}}, matrix{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}},
        matrix{{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, matrix{{0, 1}, {1, -2}}, matrix{{0, 1}, {1, 2}}}) {
    const dense_algebra g(metric);
    const multivector a = random_multivector(g, r), b = random_multivector(g, r);
    CHECK(g.geometric(a, b) == chevalley(metric).times(a, b));
    check_laws(g, r);
  }
}

TEST_CASE("dense: the null basis n, nb is a change of basis of e, eb") {
  const dense_algebra g = dense_algebra::diagonal({1, 1, 1, 1, -1});
  // n = e + eb, nb = e − eb: n² = nb² = 0, n·nb = 2.
  const dense_algebra h(matrix{{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 0, 2}, {0, 0, 0, 2, 0}});
  const std::vector<multivector> images = {g.vector(0), g.vector(1), g.vector(2), add(g.vector(3), g.vector(4)),
                                           subtract(g.vector(3), g.vector(4))};
  const auto translate = [&](const multivector &m) {
    multivector out = g.zero();
    for (std::size_t k = 0; k < m.size(); ++k) {
      multivector blade = g.scalar(m[k]);
      for (std::size_t i = 0; i < 5; ++i)
        if (k >> i & 1)
          blade = outer(blade, images[i]);
      out = add(out, blade);
    }
    return out;
  };
  CHECK(translate(h.pseudoscalar()) == scale(-2, g.pseudoscalar()));
  const multivector I = scale(rational(-1, 2), h.pseudoscalar());
  random_numbers r(6);
  for (int t = 0; t < 15; ++t) {
    const multivector a = random_multivector(h, r), b = random_multivector(h, r);
    CHECK(translate(h.geometric(a, b)) == g.geometric(translate(a), translate(b)));
    CHECK(translate(outer(a, b)) == outer(translate(a), translate(b)));
    CHECK(translate(h.left_contraction(a, b)) == g.left_contraction(translate(a), translate(b)));
    CHECK(translate(h.meet(a, b, I)) == g.meet(translate(a), translate(b)));
  }
}

TEST_CASE("dense: eight vectors") {
  const dense_algebra g = dense_algebra::diagonal({1, 1, 1, 1, -1, -1, -1, -1});
  CHECK(g.geometric(g.pseudoscalar(), g.pseudoscalar()) == g.scalar(1));
  CHECK(g.meet(g.pseudoscalar(), g.vector(7)) == g.vector(7)); // (I I) ⌋ v
  matrix all_ones(8, std::vector<rational>(8, 1));
  all_ones[0][0] = 0;
  const dense_algebra h(all_ones);
  CHECK(h.geometric(h.vector(0), h.vector(0)) == h.zero());
  CHECK(h.geometric(h.vector(7), h.vector(7)) == h.scalar(1));
  CHECK(h.geometric(h.vector(2), h.vector(7)) == add(h.scalar(1), outer(h.vector(2), h.vector(7))));
}

TEST_CASE("dense: bad input is refused") {
  CHECK_THROWS_AS(dense_algebra(matrix{}), std::invalid_argument);
  CHECK_THROWS_AS(dense_algebra(matrix(9, std::vector<rational>(9))), std::invalid_argument);
  CHECK_THROWS_AS(dense_algebra(matrix{{1, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(dense_algebra(matrix{{1, 2}, {3, 4}}), std::invalid_argument);
  const dense_algebra g = dense_algebra::diagonal({1, 1});
  CHECK_THROWS_AS(g.vector(2), std::invalid_argument);
  CHECK_THROWS_AS(g.geometric(g.zero(), multivector(8)), std::invalid_argument);
  CHECK_THROWS_AS(add(g.zero(), multivector(8)), std::invalid_argument);
}
