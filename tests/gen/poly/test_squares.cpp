// Forms with completed squares: each is the polynomial that it was made of, exactly, and the squares that are known from
// geometry are found.
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"
#include "tests/gen/oracle/random.hpp"

#include "gen/poly/squares.hpp"

using namespace meetc;
using namespace meetc::compiler_test;
using oracle_test::random_numbers;
using polynomial = poly::poly;
using poly::made_symbol;
using poly::rational;

namespace {

// Two directions u, v of object A and a direction w and a number d of object B.
struct setting {
  poly::ring ring{{"ux", "uy", "uz", "vx", "vy", "vz", "wx", "wy", "wz", "d"}};
  poly::local_origin origin{ring, [] {
                              std::vector<poly::stored_number> all;
                              for (int i = 0; i < 9; ++i)
                                all.push_back({i / 6, i / 3 % 2, i % 3, false});
                              all.push_back({1, -1, 0, false});
                              return all;
                            }()};
  polynomial at(int v) const { return polynomial::variable(ring, v); }
  polynomial dot(int i, int j) const {
    return at(3 * i) * at(3 * j) + at(3 * i + 1) * at(3 * j + 1) + at(3 * i + 2) * at(3 * j + 2);
  }
  polynomial d() const { return at(9); }
};

std::vector<poly::form> forms_of(const setting &s, const polynomial &p) {
  std::vector<poly::form> out;
  for (const poly::vector_form &v : poly::vector_forms(s.origin, s.origin.lower(p)))
    for (poly::form &f : poly::squares(v))
      out.push_back(std::move(f));
  return out;
}

using vector = std::array<rational, 3>;
rational dot(const vector &x, const vector &y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
vector cross(const vector &x, const vector &y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

// The form at given numbers, from the definitions of its symbols alone.
rational value_at(const setting &s, const poly::form &f, const std::vector<rational> &numbers) {
  const auto vector_at = [&](int id) {
    vector out;
    for (std::size_t axis = 0; axis < 3; ++axis)
      out[axis] = numbers[static_cast<std::size_t>(s.origin.info(s.origin.vector(id)[axis]).minuend)];
    return out;
  };
  std::vector<rational> symbols;
  for (const poly::invariant &q : f.invariants)
    switch (q.kind) {
    case poly::invariant::type::number:
      symbols.push_back(numbers[static_cast<std::size_t>(q.i)]);
      break;
    case poly::invariant::type::dot:
      symbols.push_back(dot(vector_at(q.i), vector_at(q.j)));
      break;
    case poly::invariant::type::triple:
      symbols.push_back(dot(cross(vector_at(q.i), vector_at(q.j)), vector_at(q.k)));
      break;
    case poly::invariant::type::cross_squared: {
      const vector c = cross(vector_at(q.i), vector_at(q.j));
      symbols.push_back(dot(c, c));
      break;
    }
    }
  symbols.resize(static_cast<std::size_t>(f.symbols->size()));
  for (std::size_t i = 0; i < f.made.size(); ++i) {
    const made_symbol &m = f.made[i];
    const rational a = m.first.evaluate(symbols), b = m.second.evaluate(symbols);
    rational value = a;
    if (m.kind == made_symbol::type::length) {
      const vector u = vector_at(m.u), v = vector_at(m.v);
      value = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const rational x = a * u[axis] + b * v[axis];
        value += x * x;
      }
    }
    symbols[static_cast<std::size_t>(f.symbol(i))] = value;
  }
  return f.value.evaluate(symbols);
}

void check(const setting &s, const polynomial &p, std::size_t least_forms) {
  const auto all = forms_of(s, p);
  CHECK(all.size() >= least_forms);
  random_numbers random(3);
  for (int i = 0; i < 20; ++i) {
    std::vector<rational> numbers;
    for (int n = 0; n < s.ring.size(); ++n)
      numbers.push_back(random.fraction());
    const rational want = p.evaluate(numbers);
    for (const poly::form &f : all)
      CHECK(value_at(s, f, numbers) == want);
  }
}

std::size_t shortest(const std::vector<poly::form> &all) {
  std::size_t out = 1000;
  for (const poly::form &f : all)
    out = std::min(out, f.value.length());
  return out;
}

} // namespace

TEST_CASE("squares: a number that is subtracted from a dot product is found") {
  const setting s;
  // d^2 v^2 - (u.w - d)^2, expanded
  const polynomial shifted = s.dot(0, 2) - s.d();
  const polynomial p = s.dot(0, 0) * s.dot(1, 1) * s.d() * s.d() - shifted * shifted;
  check(s, p, 1);
  CHECK(shortest(forms_of(s, p)) == 2);
}

TEST_CASE("squares: the length of a sum of two vectors is found, with either sign") {
  const setting s;
  for (const int sign : {1, -1}) {
    // |(u.w) v + (v.w) u|^2 - d^2
    const polynomial a = s.dot(0, 2), b = s.dot(1, 2).scaled(sign);
    const polynomial p = a * a * s.dot(1, 1) + (a * b * s.dot(0, 1)).scaled(2) + b * b * s.dot(0, 0) - s.d() * s.d();
    check(s, p, 1);
    CHECK(shortest(forms_of(s, p)) == 2);
  }
}

TEST_CASE("squares: a polynomial without squares stays as it is") {
  const setting s;
  CHECK(forms_of(s, s.dot(0, 2) * s.dot(1, 2) - s.dot(0, 1)).empty());
  // The middle term is not twice the product of the outer ones.
  const polynomial a = s.dot(0, 2), b = s.dot(1, 2);
  for (const poly::form &f : forms_of(s, a * a * s.dot(1, 1) + a * b * s.dot(0, 1) + b * b * s.dot(0, 0)))
    for (const made_symbol &m : f.made)
      CHECK(m.kind == made_symbol::type::sum);
}

TEST_CASE("squares: every form of random sums of squares is its polynomial") {
  const setting s;
  random_numbers random(9);
  for (int i = 0; i < 15; ++i) { // random sums of products of invariants
    polynomial p(s.ring);
    for (int t = 0; t < 3; ++t) {
      const polynomial q = s.dot(random.integer(0, 2), random.integer(0, 2)) + s.d().scaled(random.integer(-2, 2));
      p = p + (q * q).scaled(random.integer(-2, 2));
    }
    if (!p.is_zero())
      check(s, p, 0);
  }
}

TEST_CASE("exact division and square roots of polynomials") {
  const setting s;
  const polynomial x = s.at(0), y = s.at(1), p = x * x - y * y;
  CHECK(*poly::quotient(p, x - y) == x + y);
  CHECK_FALSE(poly::quotient(p, x + y.scaled(2)).has_value());
  CHECK_FALSE(poly::quotient(p, polynomial(s.ring)).has_value());
  const auto root = poly::square_root(((x + y) * (x + y)).scaled(-12));
  REQUIRE(root.has_value());
  CHECK((root->second * root->second).scaled(root->first) == ((x + y) * (x + y)).scaled(-12));
  CHECK_FALSE(poly::square_root(p).has_value());
}
