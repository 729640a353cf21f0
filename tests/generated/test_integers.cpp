// The integers of the exact rung against GMP: wide<W>, the conversions from float32, the common grid.
#include "tests/generated/catch.hpp"
#include "tests/generated/effort.hpp"
#include "tests/generated/numbers.hpp"

#include <cmath>
#include <limits>
#include <meet/support.hpp>

using namespace meetc::generated_test;

namespace {

template <int W> mpz_class value_of(const meet::wide<W> &v) {
  mpz_class z;
  mpz_import(z.get_mpz_t(), W, -1, sizeof(std::uint64_t), 0, 0, v.limb);
  return v.limb[W - 1] >> 63 ? mpz_class(z - (mpz_class(1) << (64 * W))) : z;
}
mpz_class value_of(meet::int128 v) {
  meet::wide<2> w(0);
  w.limb[0] = static_cast<std::uint64_t>(v);
  w.limb[1] = static_cast<std::uint64_t>(v >> 64);
  return value_of(w);
}
mpz_class value_of(std::int64_t v) {
  return mpz_class(static_cast<long>(v));
}

// z brought into the range of 64*W bits, two's complement.
template <int W> mpz_class wrapped(const mpz_class &z) {
  const mpz_class whole = mpz_class(1) << (64 * W), half = whole >> 1;
  mpz_class r;
  mpz_fdiv_r(r.get_mpz_t(), z.get_mpz_t(), whole.get_mpz_t());
  return r >= half ? mpz_class(r - whole) : r;
}

// Random limbs, long runs of ones and zeros (carries), numbers near 0 and near the ends of the range.
template <int W> meet::wide<W> draw(random_numbers &random) {
  meet::wide<W> v(0);
  const int how = random.integer(0, 4);
  if (how == 0)
    return meet::wide<W>(static_cast<std::int64_t>(random.integer(-3, 3)));
  if (how == 1)
    return meet::wide<W>(static_cast<std::int64_t>(random.bits()));
  for (std::uint64_t &l : v.limb)
    l = how == 2 || random.one_in(4) ? random.bits() : random.one_in(2) ? 0 : ~std::uint64_t{0};
  if (how == 4)
    v.limb[W - 1] = std::uint64_t{1} << 63 | (random.one_in(2) ? 0 : ~std::uint64_t{0} >> 1);
  return v;
}

int sign_of(const mpz_class &z) {
  return sgn(z);
}

template <int W> void check_wide() {
  INFO("wide<" << W << ">");
  random_numbers random(W);
  bool same = true;
  for (int i = 0; i < effort(4000) && same; ++i) {
    const meet::wide<W> a = draw<W>(random), b = draw<W>(random), c = draw<W>(random);
    const mpz_class x = value_of(a), y = value_of(b), z = value_of(c);
    same = same && value_of(a + b) == wrapped<W>(x + y);
    same = same && value_of(a - b) == wrapped<W>(x - y);
    same = same && value_of(a * b) == wrapped<W>(x * y);
    same = same && value_of(-a) == wrapped<W>(-x);
    same = same && value_of(meet::fma(a, b, c)) == wrapped<W>(x * y + z);
    same = same && static_cast<int>(meet::sign_of(a)) == sign_of(x);
    const auto k = static_cast<std::int64_t>(random.bits());
    same = same && value_of(meet::wide<W>(k)) == value_of(k);
  }
  CHECK(same);
}

// v = integer * 2^low, exactly.
template <class I> bool converts(float v, int low) {
  I out{};
  meet::to_integer(v, low, out);
  mpq_class want(static_cast<double>(v));
  want = low < 0 ? mpq_class(want << static_cast<unsigned>(-low))
                 : mpq_class(want >> static_cast<unsigned>(low));
  return want == mpq_class(value_of(out));
}

} // namespace

TEST_CASE("integers: wide arithmetic is GMP's, modulo its width") {
  check_wide<1>();
  check_wide<2>();
  check_wide<3>();
  check_wide<4>();
  check_wide<5>();
  check_wide<9>();
  check_wide<14>();
  check_wide<18>();
  check_wide<27>();
}

TEST_CASE("integers: every shift of a mantissa lands in the right limbs") {
  random_numbers random(1);
  bool same = true;
  for (int low = -149; low <= 104; ++low)
    for (int exponent = low; exponent <= 104; ++exponent)
      for (const int m : {1, 0xffffff, random.integer(1, 0xffffff)}) {
        const float v = std::ldexp(static_cast<float>(random.one_in(2) ? m : -m), exponent);
        const int bits = 24 + exponent - low;
        same = same && converts<meet::wide<5>>(v, low) && converts<meet::wide<27>>(v, low);
        same = same && (bits > 254 || converts<meet::wide<4>>(v, low));
        same = same && (bits > 126 || converts<meet::int128>(v, low));
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
          : random.one_in(5)
              ? std::numeric_limits<float>::denorm_min() * static_cast<float>(random.integer(-9, 9))
              : std::ldexp(random.unit(), around + random.integer(-3, 3));
    const meet::grid g = meet::grid_of(v, count);
    bool any = false, odd = false, top = false;
    for (int k = 0; k < count; ++k) {
      if (v[k] == 0)
        continue;
      any = true;
      // An integer on the grid, below 2^bits: some odd, some with the top bit.
      const mpq_class q = mpq_class(static_cast<double>(v[k]));
      const mpq_class on = g.low < 0 ? mpq_class(q << static_cast<unsigned>(-g.low))
                                     : mpq_class(q >> static_cast<unsigned>(g.low));
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
  CHECK(converts<meet::int128>(-0.0F, 1000));
  CHECK(converts<meet::wide<4>>(-0.0F, 1000));
}
