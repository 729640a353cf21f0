// Witnesses against exact numbers: each lies within the stated bound of both elements, and there is one where a pair touches.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/definition.hpp"
#include "tests/runtime/contacts/round_families.hpp"

#include <algorithm>
#include <cga/ball_ball.hpp>
#include <cga/ball_triangle.hpp>
#include <cga/sphere_sphere.hpp>
#include <cga/sphere_triangle.hpp>
#include <cmath>
#include <limits>
#include <meetc/contact/round_pair.hpp>
#include <meetc/contact/witness.hpp>

using namespace meetc::contacts_test;
using meetc::contact_code;

namespace {

mpq_class square(const exact_point &x) {
  return dot(x, x);
}
mpq_class power_of_two(int e) {
  mpz_class x;
  mpz_ui_pow_ui(x.get_mpz_t(), 2, static_cast<unsigned>(std::abs(e)));
  return e < 0 ? mpq_class(1, x) : mpq_class(x);
}

// Whether sqrt(square) <= reach.
bool within(const mpq_class &square_of, const mpq_class &reach) {
  return reach >= 0 && square_of <= reach * reach;
}

exact_point along(const exact_point &x, const mpq_class &t, const exact_point &d) {
  return {mpq_class(x[0] + t * d[0]), mpq_class(x[1] + t * d[1]), mpq_class(x[2] + t * d[2])};
}
// The square of the distance of a point from a triangle: the projections on its edges and on its plane.
mpq_class square_from_triangle(const exact_point &x, const float *row) {
  const exact_point corner = point_at(row);
  mpq_class least = square(x - corner);
  const auto take = [&](const exact_point &at) { least = std::min(least, square(x - at)); };
  for (std::size_t i = 0; i < 3; ++i) {
    const exact_point p = point_at(row + 3 * i), d = point_at(row + 3 * ((i + 1) % 3)) - p;
    if (!is_zero(d))
      take(along(p, std::clamp<mpq_class>(dot(x - p, d) / square(d), 0, 1), d));
  }
  const exact_point n = normal_of(row);
  if (is_zero(n))
    return least;
  const mpq_class height = dot(x - corner, n) / square(n);
  const exact_point foot = along(x, -height, n);
  for (std::size_t i = 0; i < 3; ++i) {
    const exact_point p = point_at(row + 3 * i), d = point_at(row + 3 * ((i + 1) % 3)) - p;
    if (dot(cross(d, foot - p), n) < 0)
      return least;
  }
  return std::min<mpq_class>(least, height * height * square(n));
}

struct judged {
  std::size_t wrong = 0, touching = 0, beyond = 0; // beyond the type's range
};
enum class mistake { none, other_radius, another_corner };

class judge {
public:
  judge(const round_rows &p, bool surfaces) : p_(p), surfaces_(surfaces) {}

  // Whether the point is within 2^-46 m and the rounding of its coordinates of both elements.
  template <class Real> bool takes(const Real *x) const {
    exact_point at;
    mpq_class rounding = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = x[k];
      rounding += abs(at[k]) * power_of_two(-std::numeric_limits<Real>::digits) +
                  power_of_two(std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits - 1);
    }
    const mpq_class bound = size() * power_of_two(-46) + rounding;
    if (!on_ball(at, p_.ball.data(), bound))
      return false;
    if (p_.other.size() == 4)
      return on_ball(at, p_.other.data(), bound);
    return within(square_from_triangle(at, p_.other.data()), bound);
  }

private:
  const round_rows &p_;
  bool surfaces_;

  bool on_ball(const exact_point &x, const float *ball, const mpq_class &bound) const {
    const mpq_class s = square(x - point_at(ball)), r = ball[3];
    return within(s, r + bound) && (!surfaces_ || r <= bound || s >= (r - bound) * (r - bound));
  }
  mpq_class size() const {
    mpq_class sum = p_.ball[3];
    if (p_.other.size() == 4)
      sum += p_.other[3];
    for (std::size_t k = 0; k < 3; ++k) {
      mpq_class low = p_.ball[k], high = low;
      for (std::size_t i = 0; 3 * i + 2 < p_.other.size(); ++i)
        low = std::min<mpq_class>(low, p_.other[3 * i + k]), high = std::max<mpq_class>(high, p_.other[3 * i + k]);
      sum += high - low;
    }
    return sum;
  }
};

template <class Touches, bool Surfaces, class Real>
judged compare(const round_family &f, int pairs, mistake planted = mistake::none) {
  std::mt19937 random(17);
  judged out;
  for (int i = 0; i < pairs; ++i) {
    const round_rows p = f.pair(random);
    const contact_code code = meetc::witness_code<Touches, Surfaces>(p.ball.data(), p.other.data());
    if (!code.has_witness())
      continue;
    ++out.touching;
    round_rows q = p;
    if (planted == mistake::other_radius)
      q.ball[3] *= 1.001F;
    if (planted == mistake::another_corner)
      std::copy_n(q.other.end() - 3, 3, q.other.begin());
    Real x[3];
    meetc::place_witness<Real>({q.ball.data(), 0}, {q.other.data(), q.other.size() == 9 ? 3 : 0}, code, x);
    const bool finite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
    out.beyond += !finite;
    out.wrong += finite && !judge(p, Surfaces).takes(x);
  }
  return out;
}

template <class Touches, bool Surfaces> void check(std::size_t numbers) {
  std::size_t touching = 0;
  for (const round_family &f : round_families(numbers)) {
    CAPTURE(f.name, numbers, Surfaces);
    const judged single = compare<Touches, Surfaces, float>(f, 300);
    const judged wide = compare<Touches, Surfaces, double>(f, 300);
    CHECK(single.wrong == 0);
    CHECK(wide.wrong == 0);
    touching += wide.touching;
    CHECK(wide.beyond == 0);
    if (!Surfaces || numbers == 9)
      CHECK(single.beyond == 0);
  }
  CHECK(touching > 1000);
}

} // namespace

TEST_CASE("witnesses of balls lie in both") {
  check<cga::ball_ball, false>(4);
  check<cga::sphere_sphere, true>(4);
}
TEST_CASE("witnesses of balls and triangles lie in both") {
  check<cga::ball_triangle, false>(9);
  check<cga::sphere_triangle, true>(9);
}

TEST_CASE("the judge of witnesses notices planted mistakes") {
  std::size_t by_radius = 0, by_corner = 0;
  for (const round_family &f : round_families(4))
    by_radius += compare<cga::sphere_sphere, true, double>(f, 100, mistake::other_radius).wrong;
  for (const round_family &f : round_families(9))
    by_corner += compare<cga::ball_triangle, false, double>(f, 100, mistake::another_corner).wrong;
  CHECK(by_radius > 0);
  CHECK(by_corner > 0);
}
