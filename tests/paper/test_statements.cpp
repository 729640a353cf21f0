// The paper's statements in words: its definitions, its Table 1, the number of tests of two triangles, and Normalize.
#include "tests/catch.hpp"
#include "tests/paper/algorithms.hpp"

#include <bit>
#include <cmath>
#include <set>

using namespace meetc::paper_test;

namespace {

// A vector of R(4,1) with five fractional coefficients.
multivector random_vector(random_numbers &r) {
  const vec v = random_vec(r), w = random_vec(r);
  return euclidean(v) + w[0] * n() + w[1] * nb();
}
// The bivectors and trivectors that Table 1 lists, and its quadvectors.
std::vector<std::string> listed_in_table_1() {
  return {"e1 e2",   "e2 e3",       "e3 e1",      "e1 eb",      "e2 eb",      "e3 eb",     "e1 e",    "e3 e",
          "eb e",    "e1 e2 e3",    "e1 e2 eb",   "e1 e2 e",    "e2 e3 eb",   "e2 e3 e",   "e1 eb e", "e2 eb e",
          "e3 e1 e", "e1 e2 e3 eb", "e1 e2 e3 e", "e1 e2 eb e", "e3 e1 eb e", "e2 e3 eb e"};
}

// The blade's place among the 32: bit i for the i-th of e1 e2 e3 e eb.
unsigned place(const std::string &blade) {
  unsigned bits = 0;
  for (const auto &[name, bit] : {std::pair{" e1 ", 1u}, {" e2 ", 2u}, {" e3 ", 4u}, {" e ", 8u}, {" eb ", 16u}})
    if ((" " + blade + " ").find(name) != std::string::npos)
      bits |= bit;
  return bits;
}
std::set<unsigned> unlisted(int grade) {
  std::set<unsigned> missing;
  for (unsigned b = 0; b < 32; ++b)
    if (std::popcount(b) == grade)
      missing.insert(b);
  for (const std::string &blade : listed_in_table_1())
    missing.erase(place(blade));
  return missing;
}

} // namespace

TEST_CASE("D1: the geometric product of two vectors is anticommutative only where they are orthogonal") {
  random_numbers r(1);
  int orthogonal = 0, others = 0;
  for (int t = 0; t < 200; ++t) {
    const vec v = lattice_vec(r, 2), w = lattice_vec(r, 2);
    const multivector a = euclidean(v), b = euclidean(w);
    CHECK((a * b == rational(-1) * (b * a)) == (dot(v, w) == 0));
    ++(dot(v, w) == 0 ? orthogonal : others);
    CHECK(outer({a, b}) == rational(-1) * outer({b, a})); // the outer product is, always
  }
  CHECK(orthogonal > 20);
  CHECK(others > 20);
}

TEST_CASE("D2: I commutes with everything, so I X and X I are no two rotations") {
  random_numbers r(2);
  for (int t = 0; t < 50; ++t) {
    const multivector a = random_vector(r), b = random_vector(r);
    CHECK(I() * a == a * I());
    CHECK(I() * (a * b) == (a * b) * I());
    CHECK(I() * (I() * a) == rational(-1) * a); // twice the same is -1, as of a turn by a right angle
  }
}

TEST_CASE("D2: I^2 = -1 holds in R(4,1), and not in each R(n,m)") {
  const auto square = [](const std::vector<rational> &squares) {
    const meetc::oracle::dense_algebra g = meetc::oracle::dense_algebra::diagonal(squares);
    return g.geometric(g.pseudoscalar(), g.pseudoscalar())[0];
  };
  CHECK(square({1, 1, 1, 1, -1}) == -1);
  CHECK(square({1, 1, 1}) == -1);
  CHECK(square({1, 1, 1, 1}) == 1);
  CHECK(square({1, 1, 1, -1}) == -1);
  CHECK(square({1, 1, 1, -1, -1}) == 1);
}

TEST_CASE("D3: B^2 is no square of a norm, since it is negative for two spheres apart") {
  const multivector b = meet(centred_sphere({0, 0, 0}, 1), centred_sphere({3, 0, 0}, 1));
  CHECK(norm2(b) == -4 * (9 - 4) * 9);
  // The sum of the squares of its coefficients is a norm, and says nothing of the sign.
  rational sum = 0;
  for (const rational &c : b)
    sum += c * c;
  CHECK(sum > 0);
}

TEST_CASE("T1: Table 1 lacks three of the 32 blades, of which two are named by letters of (3.1)") {
  CHECK(unlisted(2) == std::set{place("e2 e")});
  CHECK(unlisted(3) == std::set{place("e3 e1 eb"), place("e3 eb e")});
  CHECK(unlisted(4).empty());
  CHECK(listed_in_table_1().size() + 3 == 10 + 10 + 5);
}

TEST_CASE("B1: three tests of the edges of one triangle miss hits, and Algorithm 2 has six") {
  const triangle large = {vec{0, 0, 0}, vec{9, 0, 0}, vec{0, 9, 0}},
                 small = {vec{1, 1, -1}, vec{1, 1, 1}, vec{2, 1, 1}};
  const auto edges_hit = [](const triangle &edges, const triangle &other) {
    int hits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      hits += algorithm_1({edges[i], edges[(i + 1) % 3]}, other);
    return hits;
  };
  CHECK(algorithm_2(large, small));
  CHECK(edges_hit(large, small) == 0);
  CHECK(edges_hit(small, large) == 2);
}

TEST_CASE("N: Normalize changes no sign, a degenerate triangle has no norm, and rounding moves the plane") {
  random_numbers r(3);
  for (int t = 0; t < 100; ++t) {
    const multivector x = plane(random_vec(r), random_vec(r), random_vec(r)), y = line(random_vec(r), random_vec(r));
    const rational k = rational(1 + t % 7) / 3, m = rational(5) / (1 + t % 5);
    CHECK(meet(k * x, m * y) == k * m * meet(x, y));
    CHECK(norm2(meet(k * x, m * y)) == k * k * m * m * norm2(meet(x, y)));
  }
  CHECK(norm2(plane({0, 0, 0}, {1, 1, 1}, {2, 2, 2})) == 0);
  // A plane of length 1 in float32 leaves out its own corners.
  int moved = 0;
  for (int t = 0; t < 100; ++t) {
    const vec a = lattice_vec(r, 4), b = lattice_vec(r, 4), c = lattice_vec(r, 4), normal = cross(b - a, c - a);
    const rational offset = dot(normal, a);
    const float length = std::sqrt(static_cast<float>(square(normal).get_d()));
    if (length == 0)
      continue;
    const auto rounded = [&](const rational &x) { return rational(static_cast<float>(x.get_d()) / length); };
    moved += dot({rounded(normal[0]), rounded(normal[1]), rounded(normal[2])}, a) != rounded(offset);
  }
  CHECK(moved > 10);
}
