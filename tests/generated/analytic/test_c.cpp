// Readings and functions of motions through the C header: the bits of C++, in both types, on blades and on stored operands.
#include "tests/catch.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <given/given.h>
#include <given/given.hpp>
#include <motors/motors.h>
#include <motors/motors.hpp>
#include <random>
#include <rotors/rotors.h>
#include <rotors/rotors.hpp>

namespace {

template <class Number> class source {
public:
  // A struct of numbers of C: random, and in every fourth case small whole numbers, of which many are 0.
  template <class C> C next() {
    std::array<Number, sizeof(C) / sizeof(Number)> numbers;
    const bool whole = ++count_ % 4 == 0;
    for (Number &n : numbers)
      n = static_cast<Number>(whole ? std::floor(2 * normal_(random_)) : std::ldexp(normal_(random_), count_ % 9 - 4));
    return std::bit_cast<C>(numbers);
  }

private:
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
  int count_ = 0;
};

// Two structs, or numbers, of `numbers` equal numbers.
template <class Number, class C, class Cpp>
bool same(const C &c, const Cpp &cpp, std::size_t numbers = sizeof(C) / sizeof(Number)) {
  return std::memcmp(&c, &cpp, numbers * sizeof(Number)) == 0;
}

constexpr int cases = 2000;

// f of C and g of C++ on the same operands; some of the values are no zeros.
template <class Number, class C, class Cpp, class F, class G> void check(const F &f, const G &g) {
  source<Number> random;
  int told_apart = 0;
  for (int i = 0; i < cases; ++i) {
    const C x = random.template next<C>();
    const auto have = f(&x);
    const auto want = g(std::bit_cast<Cpp>(x));
    static_assert(sizeof have == sizeof want);
    if (!same<Number>(have, want))
      FAIL("case " << i << " differs");
    told_apart += !same<Number>(have, decltype(want){});
  }
  CHECK(told_apart > cases / 2);
}

template <class Number, class C, class Cpp, class F, class G> void check_pose(const F &f, const G &g) {
  source<Number> random;
  for (int i = 0; i < cases; ++i) {
    const C x = random.template next<C>();
    double have[12], want[12];
    f(&x, have);
    g(std::bit_cast<Cpp>(x), want);
    if (std::memcmp(have, want, sizeof have) != 0)
      FAIL("case " << i << " differs");
  }
}

// The geometry of a blade; the numbers lie before the two answers.
template <class Number, class C, class Cpp, class F> void check_given(const F &f) {
  source<Number> random;
  int without = 0;
  for (int i = 0; i < cases; ++i) {
    const C x = random.template next<C>();
    const auto have = f(&x);
    const auto want = gives(std::bit_cast<Cpp>(x));
    static_assert(sizeof have == sizeof want && offsetof(decltype(have), exists) == offsetof(decltype(want), exists));
    if (!same<Number>(have, want, offsetof(decltype(have), exists) / sizeof(Number)))
      FAIL("case " << i << " differs");
    CHECK((have.exists == want.exists && have.is_real == want.is_real));
    without += !have.exists;
  }
  CHECK(without < cases / 2);
}

const auto exp_of = [](const auto &x) { return exp(x); };
const auto log_of = [](const auto &x) { return log(x); };
const auto sqrt_of = [](const auto &x) { return sqrt(x); };
const auto norm_of = [](const auto &x) { return norm(x); };
const auto normalise_of = [](const auto &x) { return normalise(x); };
const auto pose_of = [](const auto &x, double (&m)[12]) { pose(x, m); };

} // namespace

TEST_CASE("motions in C have the bits of C++") {
  check<double, motors_bivector, motors::bivector<double>>(motors_exp_bivector, exp_of);
  check<float, motors_bivector_bladef, motors::bivector_blade<float>>(motors_exp_bivector_bladesf, exp_of);
  check<double, motors_motor_blade, motors::motor_blade<double>>(motors_log_motor_blades, log_of);
  check<float, motors_motorf, motors::motor<float>>(motors_log_motorf, log_of);
  check<double, motors_motor, motors::motor<double>>(motors_sqrt_motor, sqrt_of);
  check<float, motors_motor_bladef, motors::motor_blade<float>>(motors_sqrt_motor_bladesf, sqrt_of);
  check<double, motors_motor, motors::motor<double>>(motors_norm_motor, norm_of);
  check<float, motors_motorf, motors::motor<float>>(motors_norm_motorf, norm_of);
  check<double, motors_motor_blade, motors::motor_blade<double>>(motors_normalise_motor_blades, normalise_of);
  check<float, motors_motorf, motors::motor<float>>(motors_normalise_motorf, normalise_of);
  check<double, motors_translator, motors::translator<double>>(motors_log_translator, log_of);
  check_pose<double, motors_motor, motors::motor<double>>(motors_pose_motor, pose_of);
  check_pose<float, motors_motor_bladef, motors::motor_blade<float>>(motors_pose_motor_bladesf, pose_of);
  check_pose<float, motors_translatorf, motors::translator<float>>(motors_pose_translatorf, pose_of);
}

TEST_CASE("rotors in C have the bits of C++") {
  check<double, rotors_bivector, rotors::bivector<double>>(rotors_exp_bivector, exp_of);
  check<float, rotors_rotorf, rotors::rotor<float>>(rotors_log_rotorf, log_of);
  check<double, rotors_rotor_blade, rotors::rotor_blade<double>>(rotors_sqrt_rotor_blades, sqrt_of);
  check_pose<double, rotors_rotor, rotors::rotor<double>>(rotors_pose_rotor, pose_of);
}

TEST_CASE("the geometry of a blade in C has the bits of C++") {
  check_given<double, given_point_blade, given::point_blade<double>>(given_gives_point_blades);
  check_given<double, given_sphere_blade, given::sphere_blade<double>>(given_gives_sphere_blades);
  check_given<float, given_sphere_bladef, given::sphere_blade<float>>(given_gives_sphere_bladesf);
  check_given<double, given_plane_blade, given::plane_blade<double>>(given_gives_plane_blades);
  check_given<float, given_line_bladef, given::line_blade<float>>(given_gives_line_bladesf);
  check_given<double, given_circle_blade, given::circle_blade<double>>(given_gives_circle_blades);
  check_given<float, given_circle_bladef, given::circle_blade<float>>(given_gives_circle_bladesf);
  check_given<double, given_point_pair_blade, given::point_pair_blade<double>>(given_gives_point_pair_blades);
  check_given<float, given_flat_point_bladef, given::flat_point_blade<float>>(given_gives_flat_point_bladesf);
}
