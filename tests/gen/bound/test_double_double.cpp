// Double-double arithmetic against integers of any size: transforms are exact, every operation is within 2^-102.
#include "tests/catch.hpp"
#include "tests/gen/bound/search.hpp"
#include "tests/generated/judge/effort.hpp"

#include <gmpxx.h>

using namespace meetc::bounds_test;
using meetc::double_double;
using meetc::double_words;

namespace {

// Doubles are multiples of 2^-1074; the values here are far above it.
constexpr int grid = 700;

mpz_class exact(double d, int g = grid) {
  int e;
  const double m = std::frexp(d, &e);
  mpz_class z(std::ldexp(m, 53));
  const int shift = e - 53 + g;
  if (shift >= 0)
    z <<= static_cast<mp_bitcnt_t>(shift);
  else
    z >>= static_cast<mp_bitcnt_t>(-shift); // exact: d is a multiple of the grid
  return z;
}
template <bool F> mpz_class exact(const double_words<F> &x) {
  return exact(x.hi) + exact(x.lo);
}

// |computed - truth| <= 2^-102 |truth|; `computed` on the grid, `truth` on a grid 2^shift finer.
template <bool F> bool is_near(const double_words<F> &computed, const mpz_class &truth, int shift) {
  mpz_class c = exact(computed);
  c <<= static_cast<mp_bitcnt_t>(shift);
  const mpz_class error = abs(c - truth);
  return (error << 102) <= abs(truth);
}
template <bool F> bool is_normal(const double_words<F> &x) {
  return x.hi + x.lo == x.hi;
}

double any_double(random_numbers &random, int span) {
  // Sometimes only a few bits: ties and trailing zeros.
  const int bits = random.one_in(4) ? static_cast<int>(random.integer(1, 52)) : 52;
  const std::int64_t top = std::int64_t{1} << bits;
  double d = static_cast<double>(random.integer(0, top - 1) + top);
  if (random.one_in(8))
    d = static_cast<double>(top) + static_cast<double>(random.integer(-1, 1));
  d = random.one_in(2) ? -d : d;
  return std::ldexp(d, static_cast<int>(random.integer(-span, span)));
}

double_double any_pair(random_numbers &random, int span) {
  const double hi = any_double(random, span);
  double lo = 0;
  if (!random.one_in(6)) {
    int e;
    std::frexp(hi, &e);
    lo = any_double(random, 0);
    lo = std::ldexp(lo, e - 53 - 53 - static_cast<int>(random.integer(0, random.one_in(3) ? 60 : 3)));
    if (random.one_in(6)) // half a unit in the last place
      lo = std::copysign(std::ldexp(1.0, e - 54), lo);
  }
  return meetc::fast_two_sum(hi, lo);
}
// Close to -x, so that the sum cancels by any number of bits.
double_double cancelling(const double_double &x, random_numbers &random) {
  double_double y = -x;
  int e;
  std::frexp(x.hi, &e);
  const int where = static_cast<int>(random.integer(0, 110));
  const double change = std::ldexp(any_double(random, 0), e - 53 - where);
  return random.one_in(2) ? meetc::fast_two_sum(y.hi, std::abs(change) < std::abs(y.hi) * 0x1p-53 ? change : y.lo)
                          : meetc::two_sum(y.hi, change);
}

constexpr int cases = meetc::generated_test::effort(300000);

template <bool F> void check_transforms() {
  random_numbers random(1);
  bool sums = true, fast = true, products = true;
  for (int i = 0; i < cases; ++i) {
    double a = any_double(random, i % 2 ? 60 : 2), b = any_double(random, i % 2 ? 60 : 2);
    if (i % 5 == 0)
      b = std::nextafter(-a, random.one_in(2) ? 0 : 2 * a);
    const double_words<F> s = meetc::two_sum<F>(a, b), p = meetc::two_product<F>(a, b);
    sums = sums && s.hi == a + b && exact(s) == exact(a) + exact(b);
    products = products && p.hi == a * b && exact(p) == (exact(a) * exact(b) >> grid);
    if (std::abs(a) < std::abs(b))
      std::swap(a, b);
    fast = fast && exact(meetc::fast_two_sum<F>(a, b)) == exact(a) + exact(b);
  }
  CHECK(sums);
  CHECK(fast);
  CHECK(products);
}
template <bool F> void check_operations() {
  random_numbers random(2);
  bool sums = true, with_double = true, differences = true, products = true, scaled = true, normal = true;
  for (int i = 0; i < cases; ++i) {
    const int span = i % 3 ? 2 : 40;
    const double_double first = any_pair(random, span);
    const double_double second = i % 2 ? any_pair(random, span) : cancelling(first, random);
    const double_words<F> x{first.hi, first.lo}, y{second.hi, second.lo};
    const double d = i % 2 ? any_double(random, span) : i % 4 ? -x.hi : std::nextafter(-x.hi, 0.0);
    const mpz_class ex = exact(x), ey = exact(y), ed = exact(d);
    const double_words<F> sum = x + y, difference = x - y, product = x * y;
    sums = sums && is_near(sum, ex + ey, 0);
    differences =
        differences && is_near(difference, ex - ey, 0) && is_near(x - d, ex - ed, 0) && is_near(d - x, ed - ex, 0);
    with_double = with_double && is_near(x + d, ex + ed, 0) && is_near(d + x, ex + ed, 0);
    products = products && is_near(product, ex * ey, grid);
    scaled = scaled && is_near(x * d, ex * ed, grid) && is_near(d * x, ex * ed, grid);
    normal =
        normal && is_normal(sum) && is_normal(difference) && is_normal(product) && is_normal(x + d) && is_normal(x * d);
  }
  CHECK(sums);
  CHECK(differences);
  CHECK(with_double);
  CHECK(products);
  CHECK(scaled);
  CHECK(normal);
}
template <bool F> void check_widening() {
  random_numbers random(4);
  bool wide = true, fused = true;
  for (int i = 0; i < cases / 10; ++i) {
    const double a = any_double(random, 8), b = any_double(random, 8);
    const double_double any = i % 2 ? any_pair(random, 8) : -meetc::two_product(a, b);
    const double_words<F> c{any.hi, any.lo};
    wide = wide && exact(meetc::times<double_words<F>>(a, b)) == (exact(a) * exact(b) >> grid);
    const mpz_class truth = (exact(a) * exact(b) >> grid) + exact(c);
    fused = fused && is_near(meetc::fma(a, b, c), truth, 0);
  }
  CHECK(wide);
  CHECK(fused);
}

} // namespace

TEST_CASE("double-double: the error-free transforms are exact") {
  check_transforms<true>();
  check_transforms<false>();
}

TEST_CASE("double-double: every operation is within 2^-102 of its result") {
  check_operations<true>();
  check_operations<false>();
}

// The check above can fail: it refuses a sum that drops the low words.
TEST_CASE("double-double: mutation: a sloppy sum is found") {
  random_numbers random(3);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const double_double x = any_pair(random, 2), y = cancelling(x, random);
    const double_double s = meetc::two_sum(x.hi, y.hi); // Dekker's sum, which forgets a rounding
    refused += !is_near(meetc::fast_two_sum(s.hi, s.lo + (x.lo + y.lo)), exact(x) + exact(y), 0);
  }
  CHECK(refused > 0);
}

// As emitted formulas write it: products of doubles widen, and sums of a product and a wide number stay wide.
TEST_CASE("double-double: times and fma widen exactly") {
  check_widening<true>();
  check_widening<false>();
}
