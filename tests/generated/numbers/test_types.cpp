// Formulas on types with +, - and *: exact rationals with expression templates, dual numbers, vectors of the compiler, and a
// ring without a quotient.
#include "tests/catch.hpp"

#include <cga/detail/columns.hpp>
#include <cstring>
#include <Eigen/Core>
#include <gmpxx.h>
#include <random>
#include <unsupported/Eigen/AutoDiff>

namespace columns = cga::detail::columns;

namespace {

// Calls f with each of these formulas, as functions of a row of numbers.
template <class F> void each_formula(F f) {
  f(columns::meet_circle_circle());
  f(columns::meet_plane_line());
  f(columns::meet_point_pair_sphere());
  f(columns::meet_sphere_plane());
  f(columns::norm2_meet_circle_circle());
  f(columns::norm2_meet_circle_plane());
  f(columns::norm2_meet_circle_line());
  f(columns::norm2_meet_point_pair_line());
  f(columns::norm2_meet_sphere_plane());
  f(columns::norm2_meet_sphere_sphere());
}

// Exact rationals as plain values, on which no expression has a type of its own.
struct plain {
  mpq_class v;
  plain() = default;
  explicit plain(mpq_class x) : v(std::move(x)) {}
  explicit plain(int k) : v(k) {}
};
plain operator-(const plain &a) {
  return plain(mpq_class(-a.v));
}
plain operator+(const plain &a, const plain &b) {
  return plain(mpq_class(a.v + b.v));
}
plain operator-(const plain &a, const plain &b) {
  return plain(mpq_class(a.v - b.v));
}
plain operator*(const plain &a, const plain &b) {
  return plain(mpq_class(a.v * b.v));
}
plain operator/(const plain &a, const plain &b) {
  return plain(mpq_class(a.v / b.v));
}

typedef float four_floats __attribute__((vector_size(16)));
typedef double two_doubles __attribute__((vector_size(16)));

template <class V> void check_vectors() {
  using number = meetc::lane_of<V>;
  constexpr unsigned lanes = sizeof(V) / sizeof(number);
  std::mt19937 random(3);
  each_formula([&]<class F>(F) {
    for (int turn = 0; turn < 100; ++turn) {
      V in[F::numbers], out[F::results];
      for (V &x : in)
        for (unsigned k = 0; k < lanes; ++k)
          x[k] = static_cast<number>(static_cast<std::int32_t>(random())) * static_cast<number>(0x1p-29);
      F::values(in, out);
      for (unsigned k = 0; k < lanes; ++k) {
        number row[F::numbers], values[F::results];
        for (int i = 0; i < F::numbers; ++i)
          row[i] = in[i][k];
        F::values(row, values);
        for (int i = 0; i < F::results; ++i) {
          const number here = out[i][k];
          REQUIRE(std::memcmp(&here, &values[i], sizeof here) == 0);
        }
      }
    }
  });
}

// Integers modulo the prime 2^31 - 1: a type with +, - and * alone.
struct residue {
  std::uint64_t v = 0;
  residue() = default;
  explicit residue(std::int64_t k) : v(static_cast<std::uint64_t>((k % prime + prime) % prime)) {}
  static constexpr std::int64_t prime = 0x7fffffff;
};
residue made(std::uint64_t v) {
  return residue(static_cast<std::int64_t>(v % residue::prime));
}
residue operator-(residue a) {
  return made(residue::prime - a.v);
}
residue operator+(residue a, residue b) {
  return made(a.v + b.v);
}
residue operator-(residue a, residue b) {
  return made(a.v + residue::prime - b.v);
}
residue operator*(residue a, residue b) {
  return made(a.v * b.v);
}

} // namespace

namespace own {
// A type whose namespace has its own a b + c.
struct counted {
  double v = 0;
  counted() = default;
  explicit counted(double x) : v(x) {}
};
int fused = 0;
counted operator-(counted a) {
  return counted(-a.v);
}
counted operator+(counted a, counted b) {
  return counted(a.v + b.v);
}
counted operator-(counted a, counted b) {
  return counted(a.v - b.v);
}
counted operator*(counted a, counted b) {
  return counted(a.v * b.v);
}
counted multiply_add(counted a, counted b, counted c) {
  ++fused;
  return counted(a.v * b.v + c.v);
}
} // namespace own

TEST_CASE("formulas on mpq_class have the exact values") {
  std::mt19937 random(1);
  each_formula([&]<class F>(F) {
    bool any = false;
    for (int turn = 0; turn < 40; ++turn) {
      mpq_class in[F::numbers], out[F::results];
      plain row[F::numbers], values[F::results];
      for (int i = 0; i < F::numbers; ++i) {
        in[i] = mpq_class(static_cast<int>(random() % 41) - 20, 1 + random() % 7);
        in[i].canonicalize();
        row[i] = plain(in[i]);
      }
      F::values(in, out);
      F::values(row, values);
      for (int i = 0; i < F::results; ++i) {
        REQUIRE(out[i] == values[i].v);
        any = any || out[i] != 0;
      }
    }
    CHECK(any);
  });
}

TEST_CASE("formulas on Eigen's dual numbers have the derivative") {
  // norm2(meet(sphere, plane)) = 4 (r^2 N.N - (c.N - d)^2).
  using dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 8, 1>>;
  const double c[] = {1, -2, 3}, N[] = {2, 1, -3}, r = 5, d = 4;
  const auto variable = [](double v, int i) { return dual(v, 8, i); };
  const cga::sphere<dual> S{{variable(c[0], 0), variable(c[1], 1), variable(c[2], 2)}, variable(r, 3)};
  const cga::plane<dual> P{{variable(N[0], 4), variable(N[1], 5), variable(N[2], 6)}, variable(d, 7)};
  const double s = c[0] * N[0] + c[1] * N[1] + c[2] * N[2] - d, NN = N[0] * N[0] + N[1] * N[1] + N[2] * N[2];
  for (const dual &have : {dual(cga::norm2_meet(S, P)), dual(cga::norm2_meet(blade(S), blade(P)))}) {
    CHECK(have.value() == 4 * (r * r * NN - s * s));
    for (int i = 0; i < 3; ++i) {
      CHECK(have.derivatives()[i] == -8 * s * N[i]);
      CHECK(have.derivatives()[4 + i] == 8 * (r * r * N[i] - s * c[i]));
    }
    CHECK(have.derivatives()[3] == 8 * r * NN);
    CHECK(have.derivatives()[7] == 8 * s);
  }
  // A value with many names: a coefficient of the meet of two circles, which is linear in each of them.
  const auto circle_of = [&](int first, bool varies) {
    std::mt19937 random(static_cast<unsigned>(first));
    cga::circle_blade<dual> C;
    for (dual &x : reinterpret_cast<dual(&)[sizeof C / sizeof(dual)]>(C))
      x = dual(static_cast<double>(random() % 9) - 4);
    if (varies)
      C.e1_e2_e3 = variable(C.e1_e2_e3.value(), 0);
    return C;
  };
  const auto moved = [](cga::circle_blade<dual> C) {
    C.e1_e2_e3 = C.e1_e2_e3 + 1;
    return C;
  };
  const cga::circle_blade<dual> X = circle_of(1, true), Y = circle_of(2, false);
  const auto B = cga::meet(X, Y), after = cga::meet(moved(X), Y);
  constexpr std::size_t results = sizeof B / sizeof(dual);
  const auto &of_B = reinterpret_cast<const dual(&)[results]>(B);
  const auto &of_after = reinterpret_cast<const dual(&)[results]>(after);
  bool any = false;
  for (std::size_t i = 0; i < results; ++i) {
    CHECK(of_B[i].derivatives()[0] == of_after[i].value() - of_B[i].value());
    any = any || of_B[i].derivatives()[0] != 0;
  }
  CHECK(any);
}

TEST_CASE("formulas on vectors of the compiler have the bits of each lane") {
  check_vectors<four_floats>();
  check_vectors<two_doubles>();
}

TEST_CASE("formulas without fractions ask for no quotient") {
  const cga::sphere<residue> S{{residue(1), residue(-2), residue(3)}, residue(5)};
  const cga::plane<residue> P{{residue(2), residue(1), residue(-3)}, residue(4)};
  CHECK(cga::norm2_meet(S, P).v == 4 * (25 * 14 - 13 * 13));
}

TEST_CASE("formulas take a type's own multiply_add") {
  const cga::sphere<own::counted> S{{own::counted(1), own::counted(-2), own::counted(3)}, own::counted(5)};
  const cga::plane<own::counted> P{{own::counted(2), own::counted(1), own::counted(-3)}, own::counted(4)};
  own::fused = 0;
  CHECK(cga::norm2_meet(S, P).v == 4 * (25 * 14 - 13 * 13));
  CHECK(own::fused == 5);
}

TEST_CASE("integers of any sort hold no half") {
  typedef int four_ints __attribute__((vector_size(16)));
  __extension__ typedef __int128 wide;
  CHECK_FALSE(meetc::holds_half<int>);
  CHECK_FALSE(meetc::holds_half<wide>);
  CHECK_FALSE(meetc::holds_half<four_ints>);
  CHECK_FALSE(meetc::holds_half<mpz_class>);
  CHECK(meetc::holds_half<float>);
  CHECK(meetc::holds_half<two_doubles>);
  CHECK(meetc::holds_half<mpq_class>);
  CHECK(meetc::holds_half<plain>);
}
