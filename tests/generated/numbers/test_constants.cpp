// Formulas in constants: what they are, that their bits are those of the program, and that they throw nothing.
#include "tests/catch.hpp"

#include <cga/meet_sphere_sphere.hpp>
#include <cga/norm2_meet_circle_circle.hpp>
#include <cga/norm2_meet_sphere_plane.hpp>
#include <cmath>
#include <cstring>
#include <gmpxx.h>
#include <random>

namespace {

constexpr cga::sphere<float> ball{{1, -2, 3}, 5};
constexpr cga::plane<float> wall{{2, 1, -3}, 4};
static_assert(cga::norm2_meet(ball, wall) == 4 * (25 * 14 - 13 * 13));
static_assert(cga::norm2_meet(blade(ball), blade(wall)) == 4 * (25 * 14 - 13 * 13));
static_assert(cga::norm2_meet_sphere_plane::fields_a == 1);

static_assert(noexcept(cga::norm2_meet(ball, wall)));
static_assert(noexcept(cga::meet(ball, ball)));
static_assert(noexcept(blade(ball)));
static_assert(!noexcept(cga::norm2_meet(cga::sphere<mpq_class>(), cga::plane<mpq_class>())));

// Numbers that round in each operation.
template <class T> constexpr cga::circle<T> circle_of(int k) {
  const auto number = [&](int i) { return T(k * 7 + i * 5 + 1) / T(3 + 2 * i); };
  return {{number(0), number(1), number(2)}, {number(3), number(4), number(5)}, number(6)};
}
template <class T> constexpr T square_of(const cga::circle<T> &x, const cga::circle<T> &y) {
  return cga::norm2_meet(blade(x), blade(y)) + cga::norm2_meet(x, y);
}
template <class T> void check_bits() {
  constexpr T at_compile_time = square_of(circle_of<T>(1), circle_of<T>(2));
  volatile int one = 1, two = 2;
  const T here = square_of(circle_of<T>(one), circle_of<T>(two));
  CHECK(std::memcmp(&at_compile_time, &here, sizeof here) == 0);
}

// Any bits, in a quarter of the cases with exponents near each other, and sums that cancel.
template <class T, class Bits> void check_fma(int exponent_bits) {
  std::mt19937_64 random(5);
  const int fraction_bits = 8 * static_cast<int>(sizeof(T)) - exponent_bits - 1;
  const Bits exponents = ((Bits{1} << exponent_bits) - 1) << fraction_bits;
  int subnormal = 0, cancelled = 0, compared = 0;
  for (int turn = 0; turn < 200000; ++turn) {
    T x[3];
    for (T &v : x) {
      Bits bits = static_cast<Bits>(random());
      if (turn % 4)
        bits = (bits & ~exponents) | ((Bits{1} << (exponent_bits - 1)) - 20 + static_cast<Bits>(random() % 40))
                                         << fraction_bits;
      std::memcpy(&v, &bits, sizeof v);
    }
    if (turn % 4 == 2)
      x[2] = std::nextafter(-x[0] * x[1], T(0));
    if (turn % 4 == 3) { // near the least positive number
      x[0] = std::ldexp(x[0], -(1 << (exponent_bits - 2)));
      x[1] = std::ldexp(x[1], -(1 << (exponent_bits - 2)) + turn % 60 - 30);
      x[2] = std::ldexp(x[2], -(1 << (exponent_bits - 1)) + turn % 50 - 30);
    }
    const T want = std::fma(x[0], x[1], x[2]), have = meetc::constant_fma(x[0], x[1], x[2]);
    if (std::isnan(want)) {
      REQUIRE(std::isnan(have));
      continue;
    }
    REQUIRE(std::memcmp(&want, &have, sizeof want) == 0);
    ++compared;
    subnormal += want != 0 && std::abs(want) < std::numeric_limits<T>::min();
    cancelled += std::abs(want) < std::abs(x[2]) * T(0x1p-20);
  }
  CHECK(compared > 190000);
  CHECK(subnormal > 1000);
  CHECK(cancelled > 1000);
}

} // namespace

TEST_CASE("a formula in a constant has the bits of the program") {
  check_bits<float>();
  check_bits<double>();
}

TEST_CASE("a b + c in a constant is rounded once, for any numbers") {
  check_fma<float, std::uint32_t>(8);
  check_fma<double, std::uint64_t>(11);
  static_assert(meetc::constant_fma(1 + 0x1p-12F, 1 + 0x1p-12F, 0x1p-100F) == 1 + 0x1p-11F + 0x1p-23F);
  static_assert(meetc::constant_fma(1 + 0x1p-52, 1 + 0x1p-52, -1 - 0x1p-51) == 0x1p-104);
}
