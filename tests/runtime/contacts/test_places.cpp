// Coordinates of labels against rational numbers: each is the nearest number, and of two the even one.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/definition.hpp"
#include "tests/runtime/contacts/families.hpp"

#include <cga/side_triangle_point.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <meetc/contact/contact.hpp>
#include <meetc/contact/place.hpp>

using namespace meetc::contacts_test;

namespace {

template <class Real> bool is_even(Real x) {
  std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t> bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits & 1) == 0;
}

template <class Real> bool is_nearest(Real f, const mpq_class &x) {
  if (!std::isfinite(f) || (f == 0 && std::signbit(f)))
    return false;
  const mpq_class off = abs(mpq_class(f) - x);
  constexpr Real top = std::numeric_limits<Real>::infinity();
  for (const Real other : {std::nextafter(f, top), std::nextafter(f, -top)})
    if (std::isfinite(other))
      if (const mpq_class that = abs(mpq_class(other) - x); that < off || (that == off && !is_even(f)))
        return false;
  return true;
}

template <class Real> struct tally {
  std::size_t wrong = 0, checked = 0, zeros = 0, ties = 0;
  void take(Real f, const mpq_class &x) {
    ++checked;
    zeros += x == 0;
    wrong += !is_nearest(f, x);
    const mpq_class off = abs(mpq_class(f) - x);
    ties += off != 0 &&
            off * 2 ==
                abs(mpq_class(std::nextafter(f, x > mpq_class(f) ? Real(HUGE_VAL) : Real(-HUGE_VAL))) - mpq_class(f));
  }
};

template <class Real> tally<Real> compare(const family &f, int pairs) {
  std::mt19937 random(11);
  tally<Real> out;
  for (int i = 0; i < pairs; ++i) {
    const pair_rows p = f.pair(random);
    const int corners = static_cast<int>(p.a.size() / 3);
    for (const exact_label &l : labels_by_definition(p.a.data(), corners, p.b.data(), 3)) {
      Real x[3];
      meetc::place_label<Real>({p.a.data(), corners}, {p.b.data(), 3}, meetc::label_of(l.a, l.b), x);
      for (std::size_t k = 0; k < 3; ++k)
        out.take(x[k], l.at[k]);
    }
  }
  return out;
}

} // namespace

TEST_CASE("coordinates are the exact ones, rounded once") {
  std::size_t ties = 0;
  for (const int corners : {3, 2})
    for (const family &f : families(corners)) {
      CAPTURE(f.name, corners);
      const auto single = compare<float>(f, 200);
      const auto wide = compare<double>(f, 200);
      CHECK(single.checked > 0);
      CHECK(single.wrong == 0);
      CHECK(wide.wrong == 0);
      ties += single.ties;
    }
  CHECK(ties > 0);
}

// A planted mistake: the same formula, rounded at each step.
TEST_CASE("the judge of coordinates notices a second rounding") {
  std::mt19937 random(5);
  std::size_t wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    std::uniform_real_distribution<float> number(0, 1);
    const float p = number(random), q = number(random) + 1, hp = number(random), hq = number(random);
    const mpq_class x = (mpq_class(q) * hp + mpq_class(p) * hq) / (mpq_class(hp) + hq);
    wrong += !is_nearest(p + (q - p) * (hp / (hp + hq)), x);
  }
  CHECK(wrong > 0);
}

TEST_CASE("a coordinate that is zero, and a plane through the origin") {
  // The edge along x crosses the plane x = y at the origin.
  const float a[6] = {-1, -2, 0.5F, 2, 4, -1}, b[9] = {0, -1, -1, 0, 1, -1, 0, 0, 3};
  float x[3];
  meetc::place_label<float>({a, 2}, {b, 3}, meetc::label_of(3, 6), x);
  for (const float v : x) {
    CHECK(v == 0);
    CHECK(!std::signbit(v));
  }
}
