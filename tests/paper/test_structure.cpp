// The structure of each primitive: non-zero blades, independent ones, closed formulas; and B² as a Gram
// determinant.
#include "tests/catch.hpp"
#include "tests/paper/cga.hpp"

#include <bit>
#include <cstdlib>
#include <functional>
#include <utility>
#include <vector>

using namespace meetc::paper_test;
using meetc::oracle::matrix;

namespace {

std::size_t rank(matrix rows) {
  std::size_t r = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t c = 0; c < columns && r < rows.size(); ++c) {
    std::size_t pivot = r;
    while (pivot < rows.size() && rows[pivot][c] == 0)
      ++pivot;
    if (pivot == rows.size())
      continue;
    std::swap(rows[r], rows[pivot]);
    for (std::size_t i = r + 1; i < rows.size(); ++i)
      if (rows[i][c] != 0) {
        const rational f = rows[i][c] / rows[r][c];
        for (std::size_t j = c; j < columns; ++j)
          rows[i][j] -= f * rows[r][j];
      }
    ++r;
  }
  return r;
}

rational determinant(matrix m) {
  rational d = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < m.size() && m[pivot][k] == 0)
      ++pivot;
    if (pivot == m.size())
      return 0;
    if (pivot != k) {
      std::swap(m[pivot], m[k]);
      d = -d;
    }
    d *= m[k][k];
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const rational f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j)
        m[i][j] -= f * m[k][j];
    }
  }
  return d;
}

struct primitive {
  const char *name;
  std::function<multivector(random_numbers &)> draw;
  int blades, independent, null_blades, quadratic; // quadratic relations among the independent ones
};

std::vector<primitive> primitives() {
  const auto v = [](random_numbers &r) { return vec{r.integer(-4, 4), r.integer(-4, 4), r.integer(-4, 4)}; };
  return {
      {"point", [=](random_numbers &r) { return point(v(r)); }, 5, 5, 5, 1},
      {"point pair", [=](random_numbers &r) { return point_pair(v(r), v(r)); }, 10, 10, 10, 5},
      {"flat point", [=](random_numbers &r) { return flat_point(v(r)); }, 7, 4, 4, 0},
      {"line", [=](random_numbers &r) { return line(v(r), v(r)); }, 9, 6, 6, 1},
      {"circle", [=](random_numbers &r) { return circle(v(r), v(r), v(r)); }, 10, 10, 10, 5},
      {"plane", [=](random_numbers &r) { return plane(v(r), v(r), v(r)); }, 5, 4, 4, 0},
      {"sphere", [=](random_numbers &r) { return sphere(v(r), v(r), v(r), v(r)); }, 5, 5, 5, 0},
  };
}

// A random one that is not degenerate.
multivector drawn(const primitive &p, random_numbers &r) {
  multivector x = p.draw(r);
  while (meetc::oracle::is_zero(x))
    x = p.draw(r);
  return x;
}

// The coefficients on the blades of e1 e2 e3 n nb: substitute e = (n + nb)/2, eb = (n − nb)/2.
multivector in_null_basis(const multivector &x) {
  const auto &g = algebra(); // only its outer product is used, with n and nb in the places of e and eb
  const std::vector<multivector> images = {g.vector(0), g.vector(1), g.vector(2),
                                           rational(1, 2) * (g.vector(3) + g.vector(4)),
                                           rational(1, 2) * (g.vector(3) - g.vector(4))};
  multivector out = g.zero();
  for (std::size_t m = 0; m < x.size(); ++m) {
    multivector blade = g.scalar(x[m]);
    for (std::size_t i = 0; i < images.size(); ++i)
      if (m >> i & 1)
        blade = outer({blade, images[i]});
    out = out + blade;
  }
  return out;
}

// The coefficients that are not 0 in all of the samples.
matrix support(const std::vector<multivector> &samples) {
  matrix rows(samples.size());
  for (std::size_t m = 0; m < 32; ++m) {
    bool used = false;
    for (const multivector &x : samples)
      used = used || x[m] != 0;
    for (std::size_t i = 0; used && i < samples.size(); ++i)
      rows[i].push_back(samples[i][m]);
  }
  return rows;
}

multivector vector_of(random_numbers &r) {
  multivector v = algebra().zero();
  for (int i = 0; i < 5; ++i)
    v = v + rational(r.integer(-4, 4)) * algebra().vector(i);
  return v;
}

// The bits of one grade-k basis blade where x is not 0.
std::size_t some_blade(const multivector &x) {
  std::size_t m = 0;
  while (x.at(m) == 0)
    ++m;
  return m;
}

// Vectors whose outer product is the given blade: contract the blade with all but one of the (reciprocal)
// basis vectors of one of its non-zero coefficients.
std::vector<multivector> factors_of(const multivector &blade) {
  const auto &g = algebra();
  const std::size_t m = some_blade(blade);
  std::vector<multivector> factors;
  for (int i = 0; i < 5; ++i) {
    if ((m >> i & 1) == 0)
      continue;
    multivector rest = g.scalar(1);
    for (int j = 0; j < 5; ++j)
      if (j != i && (m >> j & 1))
        rest = outer({rest, rational(j == 4 ? -1 : 1) * g.vector(j)});
    factors.push_back(g.left_contraction(rest, blade));
  }
  multivector product = g.scalar(1);
  for (const multivector &f : factors)
    product = outer({product, f});
  factors[0] = rational(blade[m] / product[m]) * factors[0];
  return factors;
}

rational gram_determinant(const std::vector<multivector> &vectors) {
  matrix g(vectors.size(), std::vector<rational>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t j = 0; j < vectors.size(); ++j)
      g[i][j] = meetc::oracle::scalar_part(vectors[i] * vectors[j]);
  return determinant(g);
}

} // namespace

TEST_CASE("sparsity: non-zero blades, independent ones, blades in the null basis, quadratic relations") {
  for (const primitive &p : primitives()) {
    INFO(p.name);
    random_numbers r(1);
    std::vector<multivector> samples, null_samples;
    for (int t = 0; t < 64; ++t) {
      samples.push_back(drawn(p, r));
      null_samples.push_back(in_null_basis(samples.back()));
    }
    const matrix rows = support(samples), null_rows = support(null_samples);
    CHECK(rows[0].size() == static_cast<std::size_t>(p.blades));
    CHECK(rank(rows) == static_cast<std::size_t>(p.independent));
    CHECK(null_rows[0].size() == static_cast<std::size_t>(p.null_blades));
    // Quadratic relations: products of two coefficients that the samples do not tell apart.
    matrix products;
    for (const std::vector<rational> &row : null_rows) {
      products.emplace_back();
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = i; j < row.size(); ++j)
          products.back().push_back(row[i] * row[j]);
    }
    CHECK(products[0].size() - rank(products) == static_cast<std::size_t>(p.quadratic));
  }
}

TEST_CASE("sparsity: a point is affine, eb - e = 2, so 4 of its 5 blades are free") {
  random_numbers r(2);
  matrix differences;
  const multivector origin = point(random_vec(r));
  for (int t = 0; t < 30; ++t) {
    const multivector x = point(random_vec(r));
    CHECK(coefficient(x, "eb") - coefficient(x, "e") == 2);
    CHECK(norm2(x) == 0);
    differences.push_back(x - origin);
  }
  CHECK(rank(differences) == 4);
}

TEST_CASE("closed form: a line is 4 (v, p x q)") {
  random_numbers r(3);
  for (int t = 0; t < 50; ++t) {
    const vec p = random_vec(r), q = random_vec(r), v = q - p, moment = cross(p, q);
    const multivector l = line(p, q), e = algebra().vector(3), eb = algebra().vector(4);
    const multivector m = moment[0] * outer({algebra().vector(1), algebra().vector(2)}) +
                          moment[1] * outer({algebra().vector(2), algebra().vector(0)}) +
                          moment[2] * outer({algebra().vector(0), algebra().vector(1)});
    CHECK(l == rational(4) * (outer({euclidean(v), e, eb}) + outer({m, n()})));
    CHECK(dot(v, moment) == 0);
  }
}

TEST_CASE("closed form: the dual of a plane is 8 (N + (N.p) n) with N = (q - p) x (s - p)") {
  random_numbers r(4);
  for (int t = 0; t < 50; ++t) {
    const vec p = random_vec(r), q = random_vec(r), s = random_vec(r), normal = cross(q - p, s - p);
    CHECK(I() * plane(p, q, s) == rational(8) * (euclidean(normal) + dot(normal, p) * n()));
  }
}

TEST_CASE("closed form: the sphere through four points") {
  random_numbers r(5);
  for (int t = 0; t < 50; ++t) {
    const vec p = random_vec(r), a = random_vec(r) - p, b = random_vec(r) - p, c = random_vec(r) - p;
    const rational k = det(a, b, c);
    const vec v = square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b);
    const multivector expected =
        rational(8) * (euclidean(rational(2 * k) * p + v) + rational(k * square(p) + dot(p, v)) * n() - k * nb());
    CHECK(I() * sphere(p, a + p, b + p, c + p) == expected);
    // The same sphere from centre p + v/2k and r² = v²/4k², 8k times as long.
    if (k != 0)
      CHECK(sphere(p, a + p, b + p, c + p) ==
            rational(8 * k) * centred_sphere(p + rational(1 / (2 * k)) * v, square(v) / (4 * k * k)));
  }
}

TEST_CASE("B^2 is the Gram determinant of all dual vectors: + for 2 or 3 of them, - for 4 or 5") {
  random_numbers r(6);
  for (std::size_t first = 1; first <= 3; ++first)
    for (std::size_t second = 1; first + second <= 5; ++second)
      for (int t = 0; t < 40; ++t) {
        std::vector<multivector> vectors;
        multivector dual[2] = {algebra().scalar(1), algebra().scalar(1)};
        for (std::size_t i = 0; i < first + second; ++i) {
          vectors.push_back(vector_of(r));
          multivector &d = dual[i < first ? 0 : 1];
          d = outer({d, vectors.back()});
        }
        // X = −I x, so that I X = x.
        const multivector b = meet(rational(-1) * (I() * dual[0]), rational(-1) * (I() * dual[1]));
        const rational g = gram_determinant(vectors);
        CHECK(norm2(b) == (first + second <= 3 ? g : rational(-g)));
      }
}

TEST_CASE("B^2 is plus or minus the Gram determinant for every pair of real primitives") {
  random_numbers r(7);
  const std::vector<primitive> all = primitives();
  int pairs = 0;
  for (const primitive &first : all)
    for (const primitive &second : all)
      for (int t = 0; t < 8; ++t) {
        const multivector x = drawn(first, r), y = drawn(second, r);
        if (std::popcount(some_blade(x)) + std::popcount(some_blade(y)) < 5)
          continue;
        std::vector<multivector> duals = factors_of(I() * x);
        const std::vector<multivector> others = factors_of(I() * y);
        duals.insert(duals.end(), others.begin(), others.end());
        INFO(first.name << ", " << second.name);
        const rational g = gram_determinant(duals);
        CHECK(norm2(meet(x, y)) == (duals.size() <= 3 ? g : rational(-g)));
        ++pairs;
      }
  CHECK(pairs == 8 * 36); // ordered pairs: grades 4+4 (4), 4+3 (8), 3+3 (4), 4+2 (8), 3+2 (8), 4+1 (4)
}

TEST_CASE("where grades add to 5 or more, left contraction, fat dot and Hestenes' inner product agree") {
  random_numbers r(8);
  const std::vector<primitive> all = primitives();
  int lost = 0;
  for (const primitive &first : all)
    for (const primitive &second : all) {
      const multivector x = drawn(first, r), y = drawn(second, r), ix = I() * x;
      const int gx = std::popcount(some_blade(x)), gy = std::popcount(some_blade(y));
      const multivector fat = meetc::oracle::grade_part(ix * y, std::abs(5 - gx - gy));
      INFO(first.name << ", " << second.name);
      if (gx + gy >= 5) {
        CHECK(meet(x, y) == fat); // no operand is a scalar, so Hestenes' product is the fat dot
        const multivector other = meet(y, x);
        CHECK((other == meet(x, y) || other == rational(-1) * meet(x, y)));
      } else {
        // The contraction gives nothing; the fat dot may give something.
        CHECK(meetc::oracle::is_zero(meet(x, y)));
        lost += !meetc::oracle::is_zero(fat);
      }
    }
  CHECK(lost > 0);
}
