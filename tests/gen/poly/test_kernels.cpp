// Packed polynomials and what searches do with them: kernels, representatives modulo relations, changed variables. Each must
// keep the polynomials that it was given.
#include "gen/poly/change.hpp"
#include "gen/poly/kernels.hpp"
#include "gen/poly/modulo.hpp"
#include "tests/catch.hpp"

#include <map>
#include <random>

using namespace meetc::poly;

namespace {

const ring &numbers() {
  static const ring r({"s", "a", "b", "c", "x", "y", "z"});
  return r;
}

// Products of sums, so that there is something to find.
packed random_packed(std::mt19937 &random, int sums) {
  packed out;
  for (int i = 0; i < sums; ++i) {
    const int v = static_cast<int>(random() % 4), w = static_cast<int>(random() % 4);
    for (int u = 4; u < 7; ++u)
      out.push_back({times(times(factor(v), factor(w)), factor(u)), static_cast<std::int64_t>(random() % 3) - 1});
  }
  return joined(out);
}

// A system's polynomials in the leaves.
poly expanded(const packed &p, const packed_system &s) {
  poly sum(numbers());
  for (const packed_term &t : p) {
    poly product(numbers(), rational(static_cast<long>(t.coefficient)));
    for (product_of f = t.of; f != 0; f = rest_of(f)) {
      const int v = first_factor(f);
      product = product * (v < numbers().size() ? poly::variable(numbers(), v) : expanded(*s.definition(v), s));
    }
    sum = sum + product;
  }
  return sum;
}

packed packed_of(const poly &p) {
  return pack(p)->of;
}

} // namespace

TEST_CASE("a packed polynomial unpacks to itself, and products divide") {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const packed p = random_packed(random, 5);
    const poly whole = unpack(p, numbers());
    if (whole.is_zero())
      continue;
    const auto again = pack(whole);
    REQUIRE(again);
    CHECK(unpack(again->of, numbers()).scaled(again->content) == whole);
    for (const packed_term &t : p) {
      CHECK(degree(t.of) == 3);
      for (int v = 0; v < numbers().size(); ++v)
        if (divides(factor(v), t.of))
          CHECK(times(divided(t.of, factor(v)), factor(v)) == t.of);
    }
  }
  CHECK(common(times(factor(1), factor(2)), times(factor(2), factor(5))) == factor(2));
  // Too long, and too large.
  const poly x = poly::variable(numbers(), 4);
  CHECK_FALSE(pack(x * x * x * x * x * x * x * x * x));
  CHECK_FALSE(pack(x + poly(numbers(), rational(1L << 40))));
}

TEST_CASE("extracted kernels keep every output, and cost no more") {
  std::mt19937 random(7);
  int cheaper = 0;
  for (int i = 0; i < 40; ++i) {
    scheme_table table(std::vector<int>{1, 1, 1, 1, 2, 2, 2}, i % 2 ? price::pair : price::whole);
    packed_system s;
    for (int o = 0; o < 3; ++o)
      s.outputs.push_back(random_packed(random, 6));
    const packed_system found = extract_kernels(s, table, {});
    REQUIRE(found.outputs.size() == s.outputs.size());
    for (std::size_t o = 0; o < s.outputs.size(); ++o)
      CHECK(expanded(found.outputs[o], found) == unpack(s.outputs[o], numbers()));
    CHECK(estimated_cost(found, table) <= estimated_cost(s, table));
    cheaper += estimated_cost(found, table) < estimated_cost(s, table);
  }
  CHECK(cheaper > 20);
}

TEST_CASE("the cross product's kernel is found in both of its uses") {
  // u x q with q = s x + u x x, expanded: the three values of q are worth a symbol each.
  const auto v = [](int i) { return poly::variable(numbers(), i); };
  const std::array<poly, 3> u{v(1), v(2), v(3)}, x{v(4), v(5), v(6)};
  const auto cross = [](const std::array<poly, 3> &p, const std::array<poly, 3> &q) {
    return std::array<poly, 3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  };
  std::array<poly, 3> q = cross(u, x);
  for (std::size_t i = 0; i < 3; ++i)
    q[i] = q[i] + v(0) * x[i];
  packed_system s;
  for (std::size_t i = 0; i < 3; ++i)
    s.outputs.push_back(packed_of(x[i] + cross(u, q)[i].scaled(2)));
  scheme_table table(std::vector<int>(7, 0), price::whole);
  const packed_system found = extract_kernels(s, table, {4, 32, 3});
  CHECK(cost(found, table) == 15 + 12); // 15 multiplications and 12 additions
}

TEST_CASE("a short representative differs by the steps that it tells") {
  const auto v = [](int i) { return poly::variable(numbers(), i); };
  const poly one(numbers(), 1);
  const std::vector<packed> relations{packed_of(v(0) * v(0) + v(1) * v(1) + v(2) * v(2) + v(3) * v(3) - one)};
  // The first value of a rotated vector.
  const packed p =
      packed_of((v(0) * v(0) + v(1) * v(1) - v(2) * v(2) - v(3) * v(3)) * v(4) +
                (v(1) * v(2) - v(0) * v(3)).scaled(2) * v(5) + (v(1) * v(3) + v(0) * v(2)).scaled(2) * v(6));
  for (const unsigned seed : {0U, 1U, 2U, 9U}) {
    const reduced r = shortened(p, relations, seed);
    CHECK(r.of.size() < p.size());
    REQUIRE_FALSE(r.steps.empty());
    packed rest = p;
    for (const reduction &step : r.steps)
      rest = subtracted(rest, relations[step.relation], step.multiplier, step.factor);
    CHECK(rest == r.of);
  }
}

TEST_CASE("a change of variables is an identity, and is made where it shortens") {
  const auto v = [](int i) { return poly::variable(numbers(), i); };
  const packed p = packed_of((v(0) * v(0) - v(1) * v(1)) * v(4) + v(0) * v(2) * v(5) + v(1) * v(2) * v(5));
  const auto pairs = shortening_pairs({p}, {0, 0, 0, 0, -1, -1, -1}, 5);
  REQUIRE(pairs.size() == 1);
  CHECK((pairs[0].v == 0 && pairs[0].w == 1));
  // With s + a and s - a in place of y and z: y z x + y b y', where y' is the number that was v(5).
  const changed c = change(packed_of((v(0) * v(0) - v(1) * v(1)) * v(4)), {0, 1, 5, 6});
  CHECK(c.halvings == 2);
  CHECK(unpack(c.of, numbers()) == v(5) * v(6) * v(4).scaled(4));
  CHECK(shortening_pairs({p}, std::vector<int>(7, -1), 7).empty());
}
