// One sign in lanes of doubles by residues alone: the volume of four points whose coordinates are so long that fp64 leaves
// it unsure, and which is a chosen integer near the limit of residues.
#include <meetc/simd/wide_decide.hpp>

#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/judge/numbers.hpp"

#include <array>
#include <cga/cga.hpp>
#include <cga/header_only.hpp>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

using meetc::int128;
using meetc::generated_test::effort;
using meetc::generated_test::random_numbers;

namespace {

using P = cga::side_triangle_point_sign;
using stage = P::common_stage;
using vector = std::array<int128, 3>;

vector cross(const vector &b, const vector &c) {
  return {b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
}
int128 dot(const vector &x, const vector &y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
// Returns gcd(x, y) = x u + y v.
int128 gcd(int128 x, int128 y, int128 &u, int128 &v) {
  if (y == 0) {
    u = x < 0 ? -1 : 1, v = 0;
    return x < 0 ? -x : x;
  }
  int128 s, t;
  const int128 g = gcd(y, x % y, s, t);
  u = t, v = s - x / y * t;
  return g;
}

struct corners {
  vector b, c, d; // the first point is the origin
};
// Points with det(b, c, d) = n and coordinates below 2^bits, if the b and c that are drawn have such a d. Where the
// numbers of b x c have no common factor, all solutions d differ by sums of multiples of b and c; a short one is taken.
std::optional<corners> with_volume(int128 n, int bits, random_numbers &random) {
  corners r;
  const auto any = [&] { return static_cast<int128>(random.bits() % (2U << bits)) - (int128{1} << bits); };
  for (int k = 0; k < 3; ++k)
    r.b[static_cast<std::size_t>(k)] = any(), r.c[static_cast<std::size_t>(k)] = any();
  const vector normal = cross(r.b, r.c);
  int128 u, v, s, t;
  const int128 two = gcd(normal[0], normal[1], u, v);
  if (normal[1] == 0 || gcd(two, normal[2], s, t) != 1)
    return {};
  const int128 p = normal[0] / two, q = normal[1] / two; // p u + q v = 1
  const int128 third = n % two * (t % two) % two, rest = (n - third * normal[2]) / two;
  const int128 first = rest % q * (u % q) % q;
  r.d = {first, (rest - first * p) / q, third};
  // d = beta b + gamma c + a part along the normal.
  const auto real = [](int128 x) { return static_cast<long double>(x); };
  for (int step = 0; step < 3; ++step) {
    const long double bb = real(dot(r.b, r.b)), bc = real(dot(r.b, r.c)), cc = real(dot(r.c, r.c)),
                      db = real(dot(r.d, r.b)), dc = real(dot(r.d, r.c)), area = bb * cc - bc * bc;
    const auto beta = static_cast<int128>(std::round((db * cc - dc * bc) / area)),
               gamma = static_cast<int128>(std::round((dc * bb - db * bc) / area));
    for (std::size_t k = 0; k < 3; ++k)
      r.d[k] -= beta * r.b[k] + gamma * r.c[k];
  }
  REQUIRE(dot(normal, r.d) == n);
  for (const int128 x : r.d)
    if ((x < 0 ? -x : x) >= int128{1} << bits)
      return {};
  return r;
}

// The sign of the volume that P computes: that of -det(b, c, d).
meetc::proved_lanes without_residues(const meetc::wide_rows<P> &rows) {
  meetc::proved_lanes s[1];
  meetc::wide_signs<P, stage, meetc::residue_width<64, 0>>(rows).get(1, s);
  return s[0];
}
bool known(const meetc::proved_lanes &s) {
  return ((s.negative | s.zero | s.positive) & 1) != 0;
}
bool wrong(const meetc::proved_lanes &s, int128 det) {
  return ((det > 0 ? s.zero | s.positive : det < 0 ? s.negative | s.zero : s.negative | s.positive) & 1) != 0;
}
meetc::wide_rows<P> rows_of(const corners &c, double scale) {
  const auto number = [scale](int128 x) { return meetc::wide_lanes(static_cast<double>(x) * scale); };
  meetc::wide_rows<P> rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.a[axis] = number(0), rows.a[3 + axis] = number(c.b[axis]), rows.a[6 + axis] = number(c.c[axis]);
    rows.b[axis] = number(c.d[axis]);
  }
  rows.measure();
  return rows;
}

// Volumes around 2^14, 2^15 and 2^16, smaller ones, and zero, of points with coordinates below 2^bits.
std::vector<std::pair<corners, int128>> volumes(int bits) {
  random_numbers random(17);
  std::vector<std::pair<corners, int128>> out;
  while (static_cast<int>(out.size()) < effort(1500)) {
    const auto i = out.size();
    const int128 near = int128{1} << (14 + random.bits() % 3), less = random.bits() % (1U << 16);
    const int128 size = i % 2 == 0 ? near + static_cast<int128>(random.bits() % 5) - 2 : less, n = i % 5 == 0   ? 0
                                                                                                   : i % 3 == 0 ? -size
                                                                                                                : size;
    if (const std::optional<corners> c = with_volume(n, bits, random))
      out.emplace_back(*c, n);
  }
  return out;
}

struct tally {
  int wrong = 0, found = 0; // found: where bounds alone do not know the sign
};
template <class Width> tally by_residues(const std::vector<std::pair<corners, int128>> &of, double scale) {
  tally t;
  for (const auto &[c, det] : of) {
    const meetc::wide_rows<P> rows = rows_of(c, scale);
    meetc::proved_lanes s[1];
    meetc::wide_signs<P, stage, Width>(rows).get(1, s);
    t.wrong += wrong(s[0], det);
    t.found += known(s[0]) && !known(without_residues(rows));
  }
  return t;
}

} // namespace

TEST_CASE("volumes near the limit of residues: no sign is wrong, and a limit that is too high is seen") {
  int found = 0, too_high = 0;
  for (const int bits : {16, 18, 19, 20, 21, 22, 23, 24}) {
    const auto some = volumes(bits);
    int unknown = 0;
    for (const auto &[c, det] : some)
      unknown += !known(without_residues(rows_of(c, 1)));
    for (const double scale : {0x1p-30, 1.0, 0x1p30}) {
      INFO(bits << " bits times " << scale);
      CHECK(by_residues<meetc::residue_width<64>>(some, scale).wrong == 0);
      CHECK(by_residues<meetc::residue_width<64>>(some, scale).found == unknown);
      const auto few = [&]<int... Spare>(std::integer_sequence<int, Spare...>) {
        const tally of[] = {by_residues<meetc::residue_width<16, 14, 3 * Spare>>(some, scale)...};
        for (const tally &t : of) {
          CHECK(t.wrong == 0);
          found += t.found;
        }
        too_high += (by_residues<meetc::residue_width<16, 17, 3 * Spare>>(some, scale).wrong + ...);
      };
      few(std::integer_sequence<int, 16, 17, 18, 19, 20, 21, 22>());
    }
  }
  CHECK(found > 0);
  CHECK(too_high > 0);
}

// Signs of doubles where exact_lanes() says that they are exact, if those below 2^Limit are.
template <int Limit> tally by_exact_doubles(const std::vector<std::pair<corners, int128>> &of, double scale) {
  tally t;
  for (const auto &[c, det] : of) {
    const std::vector<meetc::wide_rows<P>> rows(meetc::vectors_of_eight, rows_of(c, scale));
    if (!(meetc::exact_lanes<P, Limit>(rows[0]) & 1))
      continue;
    meetc::proved_lanes s{};
    meetc::add_exact_signs<P, stage>(rows.data(), 0, &s);
    s.negative &= ~s.zero, s.positive = ~(s.negative | s.zero);
    t.wrong += wrong(s, det);
    ++t.found;
  }
  return t;
}

TEST_CASE("volumes in exact doubles: no sign is wrong, and a limit that is too high is seen") {
  int found = 0, too_high = 0;
  for (const int bits : {16, 17, 18, 20, 22, 24}) {
    const auto some = volumes(bits);
    for (const double scale : {0x1p-149, 1.0, 0x1p104}) {
      INFO(bits << " bits times " << scale);
      const tally t = by_exact_doubles<53>(some, scale);
      CHECK(t.wrong == 0);
      found += t.found;
      too_high += by_exact_doubles<80>(some, scale).wrong;
    }
  }
  CHECK(found > 0);
  CHECK(too_high > 0);
}

TEST_CASE("the largest volumes in exact doubles: no sign is wrong") {
  random_numbers random(18);
  int found = 0;
  for (int i = 0; i < effort(20000); ++i) {
    // Up to the most steps that differences may have.
    const auto highest = static_cast<int>(meetc::exact_steps<P>()) / 2;
    const int most = i % 2 == 0 ? highest : (1 << random.bits() % 16) - 1;
    corners c;
    for (vector *v : {&c.b, &c.c, &c.d})
      for (int128 &x : *v)
        x = random.bits() % 4 != 0 ? (random.bits() % 2 != 0 ? most : -most)
                                   : static_cast<int128>(random.bits() % (2U * static_cast<unsigned>(most) + 1)) - most;
    const tally t = by_exact_doubles<53>({{c, dot(cross(c.b, c.c), c.d)}}, 1);
    CHECK(t.wrong == 0);
    found += t.found;
  }
  CHECK(found == effort(20000));
}
