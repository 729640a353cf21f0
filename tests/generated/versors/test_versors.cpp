// The emitted code of motors that act on points, planes and lines, exactly, in rationals, against the dense product: on
// products of two and of four mirror images of a plane, whole and with the motor's matrix prepared.
#include "gen/oracle/dense.hpp"
#include "tests/catch.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <array>
#include <versors/versors.hpp>

using namespace meetc;
using namespace meetc::generated_test;
using oracle::multivector;

namespace {

const oracle::dense_algebra &space() {
  static const oracle::dense_algebra a = oracle::dense_algebra::diagonal({0, 1, 1, 1});
  return a;
}
// Masks of e0, e1, e2, e3.
enum mask : unsigned { e0 = 1, e1 = 2, e2 = 4, e3 = 8 };

mpq_class number(random_numbers &random) {
  mpq_class q(static_cast<long>(random.bits() % 19) - 9, static_cast<long>(random.bits() % 4) + 1);
  q.canonicalize();
  return q;
}

multivector plane(random_numbers &random) {
  multivector p = space().zero();
  for (const unsigned v : {e0, e1, e2, e3})
    p[v] = number(random);
  p[e1] += p[e1] == 0;
  return p;
}

multivector product(const std::vector<multivector> &all) {
  multivector out = space().scalar(1);
  for (const multivector &m : all)
    out = space().geometric(out, m);
  return out;
}

multivector unit_motor(random_numbers &random, int factors) {
  multivector out = space().scalar(1);
  for (int i = 0; i < factors; ++i) {
    const multivector p = plane(random);
    out = space().geometric(
        out, oracle::scale(1 / oracle::scalar_part(product({p, p})), product({p, space().vector(1), p})));
  }
  return out;
}

multivector reversed(const multivector &m) {
  multivector out = m;
  for (int k : {2, 3})
    out = oracle::subtract(out, oracle::scale(2, oracle::grade_part(m, k)));
  return out;
}

template <class Kind> Kind even(const multivector &m) {
  const auto at = [&](unsigned b, int sign = 1) { return exact(mpq_class(sign * m[b])); };
  return {at(0),       at(e2 | e3), at(e1 | e3, -1), at(e1 | e2),
          at(e0 | e1), at(e0 | e2), at(e0 | e3),     at(e0 | e1 | e2 | e3)};
}

using versors::line_blade;
using versors::plane_blade;
using versors::point_blade;
multivector value(const point_blade<exact> &b) {
  multivector m = space().zero();
  m[e0 | e1 | e2] = b.e0_e1_e2.v, m[e0 | e1 | e3] = b.e0_e1_e3.v;
  m[e0 | e2 | e3] = b.e0_e2_e3.v, m[e1 | e2 | e3] = b.e1_e2_e3.v;
  return m;
}
multivector value(const plane_blade<exact> &b) {
  multivector m = space().zero();
  m[e0] = b.e0.v, m[e1] = b.e1.v, m[e2] = b.e2.v, m[e3] = b.e3.v;
  return m;
}
multivector value(const line_blade<exact> &b) {
  multivector m = space().zero();
  m[e0 | e1] = b.e0_e1.v, m[e0 | e2] = b.e0_e2.v, m[e0 | e3] = b.e0_e3.v;
  m[e1 | e2] = b.e1_e2.v, m[e1 | e3] = b.e1_e3.v, m[e2 | e3] = b.e2_e3.v;
  return m;
}

// Struct: the one for many pairs.
template <class Struct, class Object> void check(const multivector &motor, const Object &object) {
  const auto m = blade(even<versors::motor<exact>>(motor));
  const auto x = blade(object);
  const multivector want = product({motor, value(x), reversed(motor)});
  CHECK(value(versors::sandwich(m, x)) == want);
  std::array<exact, Struct::fields_a + 1> a;
  std::array<exact, Struct::fields_b + 1> b;
  Struct::object_a(m, a.data());
  Struct::object_b(x, b.data());
  CHECK(value(Struct::pair(m, a.data(), x, b.data())) == want);
}

} // namespace

TEST_CASE("unit motors move points, planes and lines as the dense product does") {
  random_numbers random(17);
  const auto next = [&] { return exact(number(random)); };
  for (int i = 0; i < 40; ++i) {
    const multivector motor = unit_motor(random, i % 2 ? 4 : 2);
    REQUIRE(product({motor, reversed(motor)}) == space().scalar(1));
    check<versors::sandwich_motor_point>(motor, versors::point<exact>{next(), next(), next()});
    check<versors::sandwich_motor_plane>(motor, versors::plane<exact>{next(), next(), next(), next()});
    check<versors::sandwich_motor_line>(motor, versors::line<exact>{next(), next(), next(), next(), next(), next()});
  }
}

TEST_CASE("any even element moves lines as the dense product does") {
  random_numbers random(19);
  const auto next = [&] { return exact(number(random)); };
  for (int i = 0; i < 40; ++i) {
    multivector m = space().zero();
    for (const unsigned b : {0U, e2 | e3, e1 | e3, e1 | e2, e0 | e1, e0 | e2, e0 | e3, e0 | e1 | e2 | e3})
      m[b] = number(random);
    const auto x = blade(versors::line<exact>{next(), next(), next(), next(), next(), next()});
    CHECK(value(versors::sandwich(blade(even<versors::even<exact>>(m)), x)) == product({m, value(x), reversed(m)}));
  }
}
