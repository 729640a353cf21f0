// The integers of the exact rung against GMP: steps on limbs, the conversions from float32, the common grid.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <cmath>
#include <limits>
#include <meetc/decide/later_rungs.hpp>
#include <meetc/support.hpp>

using namespace meetc::generated_test;

namespace {

mpz_class value_of(const std::uint64_t *limbs, int n) {
  mpz_class z;
  mpz_import(z.get_mpz_t(), static_cast<std::size_t>(n), -1, sizeof(std::uint64_t), 0, 0, limbs);
  return limbs[n - 1] >> 63 ? mpz_class(z - (mpz_class(1) << (64U * static_cast<unsigned>(n)))) : z;
}
mpz_class value_of(meetc::int128 v) {
  const std::uint64_t limbs[2] = {static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(v >> 64)};
  return value_of(limbs, 2);
}
mpz_class value_of(std::int64_t v) {
  return mpz_class(static_cast<long>(v));
}

// z brought into the range of n limbs, two's complement.
mpz_class wrapped(const mpz_class &z, int n) {
  const mpz_class whole = mpz_class(1) << (64U * static_cast<unsigned>(n)), half = whole >> 1;
  mpz_class r;
  mpz_fdiv_r(r.get_mpz_t(), z.get_mpz_t(), whole.get_mpz_t());
  return r >= half ? mpz_class(r - whole) : r;
}

// Random limbs, long runs of ones and zeros (carries), numbers near 0 and near the ends of the range.
void draw(random_numbers &random, std::uint64_t *limbs, int n) {
  const int how = random.integer(0, 4);
  const std::uint64_t low = how == 0 ? static_cast<std::uint64_t>(random.integer(-3, 3)) : random.bits();
  for (int i = 0; i < n; ++i)
    limbs[i] = how <= 1                       ? (i == 0      ? low
                                                 : low >> 63 ? ~std::uint64_t{0}
                                                             : 0)
               : how == 2 || random.one_in(4) ? random.bits()
               : random.one_in(2)             ? 0
                                              : ~std::uint64_t{0};
  if (how == 4)
    limbs[n - 1] = std::uint64_t{1} << 63 | (random.one_in(2) ? 0 : ~std::uint64_t{0} >> 1);
}

int sign_of(const mpz_class &z) {
  return sgn(z);
}

constexpr int widest = 27;

void check_instructions(int n) {
  using enum meetc::opcode;
  INFO(n << " limbs");
  random_numbers random(static_cast<std::uint64_t>(n));
  bool same = true;
  for (int i = 0; i < effort(4000) && same; ++i) {
    std::uint64_t place[6][widest];
    meetc::sign signs[2];
    draw(random, place[0], n), draw(random, place[1], n);
    const mpz_class x = value_of(place[0], n), y = value_of(place[1], n);
    const auto run = [&](meetc::opcode kind, int r, int a, int b) {
      meetc::execute(
          {kind, static_cast<std::uint16_t>(r), static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b)}, n, place,
          signs);
      return value_of(place[r], n);
    };
    same = same && run(add, 2, 0, 1) == wrapped(x + y, n) && run(subtract, 2, 0, 1) == wrapped(x - y, n);
    same = same && run(multiply, 2, 0, 1) == wrapped(x * y, n) && run(multiply, 2, 0, 0) == wrapped(x * x, n);
    same = same && run(negate, 3, 0, 0) == wrapped(-x, n) && run(add, 2, 2, 0) == wrapped(x * x + x, n);
    same = same && run(negate, 3, 3, 0) == wrapped(x, n) && run(subtract, 3, 3, 3) == 0;
    const int low = random.integer(0, 0xffff), high = random.integer(0, 0xffff);
    mpz_class c = low + (mpz_class(high) << 16);
    same = same && run(constant, 4, low, high) == wrapped(c, n);
    c += mpz_class(low) << 32;
    same = same && run(raise, 4, low, 0) == wrapped(c, n);
    meetc::execute({take_sign, 1, 0, 0}, n, place, signs);
    same = same && static_cast<int>(signs[1]) == sign_of(x);
    meetc::execute({take_sign, 0, 3, 0}, n, place, signs);
    same = same && signs[0] == meetc::sign::zero;
  }
  CHECK(same);
}

mpq_class on_grid(float v, int low) {
  const mpq_class want(static_cast<double>(v));
  return low < 0 ? mpq_class(want << static_cast<unsigned>(-low)) : mpq_class(want >> static_cast<unsigned>(low));
}

bool converts_to_limbs(float v, int low, int n) {
  std::uint64_t limbs[widest];
  meetc::to_limbs(v, low, n, limbs);
  return on_grid(v, low) == mpq_class(value_of(limbs, n));
}

// v = integer * 2^low, exactly.
template <class I> bool converts(float v, int low) {
  I out{};
  meetc::to_integer(v, low, out);
  return on_grid(v, low) == mpq_class(value_of(out));
}

} // namespace

TEST_CASE("integers: steps on limbs are GMP's arithmetic, modulo their width") {
  for (const int n : {1, 2, 3, 4, 5, 9, 14, 18, widest})
    check_instructions(n);
}

TEST_CASE("integers: every shift of a mantissa lands in the right limbs") {
  random_numbers random(1);
  bool same = true;
  for (int low = -149; low <= 104; ++low)
    for (int exponent = low; exponent <= 104; ++exponent)
      for (const int m : {1, 0xffffff, random.integer(1, 0xffffff)}) {
        const float v = std::ldexp(static_cast<float>(random.one_in(2) ? m : -m), exponent);
        const int bits = 24 + exponent - low;
        same = same && converts_to_limbs(v, low, 5) && converts_to_limbs(v, low, widest);
        same = same && (bits > 254 || converts_to_limbs(v, low, 4));
        same = same && (bits > 126 || converts<meetc::int128>(v, low));
        same = same && (bits > 62 || converts<std::int64_t>(v, low));
      }
  CHECK(same);
}

TEST_CASE("integers: the common grid holds every number and is the coarsest") {
  random_numbers random(2);
  bool same = true;
  for (int i = 0; i < effort(100000) && same; ++i) {
    float v[9];
    const int count = random.integer(0, 9), around = random.integer(-140, 100);
    for (float &f : v)
      f = random.one_in(4)   ? (random.one_in(2) ? 0.0F : -0.0F)
          : random.one_in(3) ? random.pattern()
          : random.one_in(5) ? std::numeric_limits<float>::denorm_min() * static_cast<float>(random.integer(-9, 9))
                             : std::ldexp(random.unit(), around + random.integer(-3, 3));
    const meetc::grid g = meetc::grid_of(v, count);
    bool any = false, odd = false, top = false;
    for (int k = 0; k < count; ++k) {
      if (v[k] == 0)
        continue;
      any = true;
      // An integer on the grid, below 2^bits: some odd, some with the top bit.
      const mpq_class q = mpq_class(static_cast<double>(v[k]));
      const mpq_class on =
          g.low < 0 ? mpq_class(q << static_cast<unsigned>(-g.low)) : mpq_class(q >> static_cast<unsigned>(g.low));
      same = same && on.get_den() == 1;
      const mpz_class z = abs(on.get_num());
      same = same && mpz_sizeinbase(z.get_mpz_t(), 2) <= static_cast<std::size_t>(g.bits());
      odd = odd || mpz_odd_p(z.get_mpz_t()) != 0;
      top = top || mpz_sizeinbase(z.get_mpz_t(), 2) == static_cast<std::size_t>(g.bits());
    }
    same = same && (any ? odd && top && g.bits() <= 277 : g.bits() == 0);
  }
  CHECK(same);
}

TEST_CASE("integers: a zero converts on any grid") {
  CHECK(converts<std::int64_t>(0.0F, 1000));
  CHECK(converts<std::int64_t>(-0.0F, 1000));
  CHECK(converts<meetc::int128>(-0.0F, 1000));
  CHECK(converts_to_limbs(-0.0F, 1000, 4));
}
