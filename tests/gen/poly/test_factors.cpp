// Factors: polynomials that are seen at once to have none, and others that only look like that.
#include "gen/poly/poly.hpp"
#include "tests/catch.hpp"
#include "tests/gen/oracle/random.hpp"

using namespace meetc;
using poly::rational;

namespace {

const poly::ring &letters() {
  static const poly::ring r({"a", "b", "c", "d", "e", "f"});
  return r;
}
poly::poly v(int i) {
  return poly::poly::variable(letters(), i);
}
std::size_t parts(const poly::poly &p) {
  std::size_t n = 0;
  for (const auto &[part, exponent] : p.factors().parts)
    n += static_cast<std::size_t>(exponent);
  return n;
}

} // namespace

TEST_CASE("polynomials with a variable in one term alone have as many factors as they should") {
  const poly::poly a = v(0), b = v(1), c = v(2), d = v(3), e = v(4), f = v(5);
  CHECK(parts(a * b + c * d) == 1);
  CHECK(parts((a * b - c * d).scaled(rational(-3, 2))) == 1);
  CHECK(parts(a + b * b * c) == 1);
  CHECK(parts(a * b + a * c) == 2);         // b is in one term, and a in both
  CHECK(parts(a * a * b + a * c * d) == 2); // the same
  CHECK(parts(a * a - b * b) == 2);         // each in one term, but squared
  CHECK(parts((a + b) * (c + d)) == 2);     // each in two terms
  CHECK(parts(a * b * c) == 3);             // one term
  CHECK(parts((a + b) * (c + d) + e * f) == 1);
  CHECK((a * b - c * d).scaled(rational(-3, 2)).factors().content == rational(-3, 2));
}

TEST_CASE("a product of factors is the polynomial, and has at least the factors that it was made of") {
  oracle_test::random_numbers random(5);
  for (int round = 0; round < 300; ++round) {
    const auto some = [&] {
      poly::poly out(letters(), 0);
      for (int t = random.integer(1, 3); t > 0; --t) {
        poly::poly term(letters(), random.integer(1, 3));
        for (int i = random.integer(1, 2); i > 0; --i)
          term = term * v(random.integer(0, 5));
        out = out + term;
      }
      return out;
    };
    const poly::poly x = some(), y = some(), p = x * y;
    const poly::poly::factor found = p.factors();
    poly::poly product(letters(), found.content);
    for (const auto &[part, exponent] : found.parts)
      for (int i = 0; i < exponent; ++i)
        product = product * part;
    CHECK(product == p);
    CHECK(parts(p) >= 2);
    CHECK(parts(p) == parts(x) + parts(y));
  }
}
