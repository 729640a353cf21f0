// The families have the properties that they claim: rows are valid, and each of the newer families is as hostile as the
// comment of its maker says.
#include "tests/catch.hpp"
#include "tests/extremes/families/families.hpp"
#include "tests/extremes/judges/geometry.hpp"
#include "tests/generated/judge/effort.hpp"

#include <cmath>
#include <cstring>
#include <limits>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

constexpr float most = std::numeric_limits<float>::max();

// Calls f(subject, pair) on this many cases of a family for each subject.
template <class F> void on_cases(const char *name, int cases, F &&f) {
  const family &from = family_named(name);
  for (const subject &s : subjects()) {
    random_numbers random(50);
    if (from.applies(s.a, s.b))
      for (int i = 0; i < effort(cases); ++i)
        f(s, from.make(s.a, s.b, random));
  }
}

// The numbers of both operands along an axis, without radii.
std::vector<float> along(const subject &s, const pair_of_rows &p, std::size_t axis) {
  std::vector<float> out;
  for (const auto &[kind, r] : {std::pair(s.a, &p.a), std::pair(s.b, &p.b)})
    for (std::size_t i = axis; i < 3 * corners(kind); i += 3)
      out.push_back((*r)[i]);
  return out;
}

// The position of a number among all float32, so that neighbours differ by 1.
std::int64_t place(float f) {
  std::int32_t bits;
  std::memcpy(&bits, &f, sizeof bits);
  return bits < 0 ? -static_cast<std::int64_t>(bits & 0x7fffffff) : bits;
}

} // namespace

TEST_CASE("families: every row is finite and every radius is 0 or more") {
  for (const family &f : families()) {
    bool allowed = true;
    on_cases(f.name, 1000, [&](const subject &s, const pair_of_rows &p) {
      for (const auto &[kind, r] : {std::pair(s.a, &p.a), std::pair(s.b, &p.b)}) {
        allowed = allowed && r->size() == static_cast<std::size_t>(meetc::generated_test::floats_of(kind));
        for (const float c : *r)
          allowed = allowed && std::isfinite(c);
        allowed = allowed && !(padded(kind) && r->back() < 0);
      }
    });
    INFO(f.name);
    CHECK(allowed);
  }
}

TEST_CASE("families: their numbers span every width of the exact rung") {
  for (const subject &s : subjects()) {
    INFO(s.name);
    int cases = 0, widest = 0, by_width[4] = {0, 0, 0, 0}; // up to 20, 60, 250 bits and more
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      random_numbers random(53);
      for (int i = 0; i < effort(200); ++i, ++cases) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        row all = p.a;
        all.insert(all.end(), p.b.begin(), p.b.end());
        const int bits = meetc::grid_of(all.data(), static_cast<int>(all.size())).bits();
        widest = std::max(widest, bits);
        ++by_width[bits <= 20 ? 0 : bits <= 60 ? 1 : bits <= 250 ? 2 : 3];
      }
    }
    CHECK(widest >= 270);
    for (const int count : by_width)
      CHECK(count > cases / 100);
  }
}

TEST_CASE("families: axis_magnitudes parts the axes by more than a mantissa") {
  int cases = 0, parted = 0;
  on_cases("axis_magnitudes", 300, [&](const subject &s, const pair_of_rows &p) {
    int low = 1000, high = -1000;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float largest = 0;
      for (const float c : along(s, p, axis))
        largest = std::max(largest, std::abs(c));
      if (largest > 0) {
        low = std::min(low, std::ilogb(largest));
        high = std::max(high, std::ilogb(largest));
      }
    }
    ++cases;
    parted += high - low > 24;
  });
  CHECK(parted > cases / 3);
}

TEST_CASE("families: palette has the ends of float32 and numbers between them") {
  int cases = 0, zeros = 0, least = 0, subnormal = 0, normal = 0, ordinary = 0, largest = 0, negative = 0;
  on_cases("palette", 300, [&](const subject &, const pair_of_rows &p) {
    for (const row *r : {&p.a, &p.b})
      for (const float c : *r) {
        const float m = std::abs(c);
        ++cases;
        zeros += m == 0;
        least += m == 0x1p-149F;
        subnormal += m > 0x1p-149F && m < 0x1p-126F;
        normal += m == 0x1p-126F;
        ordinary += m >= 1 && m <= 9;
        largest += m >= 0x1.fffffap127F;
        negative += std::signbit(c);
      }
  });
  CHECK(subnormal > cases / 10);
  for (const int n : {zeros, least, normal, ordinary, largest})
    CHECK(n > cases / 50);
  CHECK(negative > cases / 3);
}

TEST_CASE("families: elements placed on corners, edges and faces touch there, exactly") {
  for (const subject &s : subjects()) {
    random_numbers random(51);
    int cases = 0, exact = 0, off = 0;
    for (; cases < effort(1000); ++cases) {
      exact += truth_by_geometry(s, placed_exactly(s.a, s.b, random)) == (s.sign ? 0 : 1);
      off += truth_by_geometry(s, placed(s.a, s.b, random)) != (s.sign ? 0 : 1);
    }
    INFO(s.name);
    CHECK(exact == cases);
    CHECK(off > cases / 20); // an ulp makes a difference
  }
}

TEST_CASE("families: near_overflow overflows") {
  int cases = 0, overflow = 0, small = 0;
  on_cases("near_overflow", 300, [&](const subject &s, const pair_of_rows &p) {
    bool over = false;
    float largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const float c : along(s, p, axis)) {
        largest = std::max(largest, std::abs(c));
        for (const float d : along(s, p, axis))
          over = over || static_cast<double>(c) - static_cast<double>(d) > static_cast<double>(most);
      }
    for (const auto &[kind, r] : {std::pair(s.a, &p.a), std::pair(s.b, &p.b)})
      largest = padded(kind) ? std::max(largest, r->back()) : largest;
    ++cases;
    overflow += over;
    small += largest < most / 4;
  });
  CHECK(overflow > cases / 2);
  CHECK(small < cases / 50);
}

TEST_CASE("families: a cluster is a few ulps wide, at any exponent") {
  int subnormal = 0, normal = 0, highest = -1000;
  std::int64_t widest = 0;
  on_cases("cluster", 300, [&](const subject &s, const pair_of_rows &p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<float> c = along(s, p, axis);
      const auto [low, high] = std::minmax_element(c.begin(), c.end());
      widest = std::max(widest, place(*high) - place(*low));
      if (place(*low) > 1000) { // not about 0
        (*high < 0x1p-126F ? subnormal : normal) += 1;
        highest = std::max(highest, std::ilogb(*high));
      }
    }
  });
  CHECK(widest <= 12);
  CHECK(widest >= 6);
  CHECK(subnormal > normal / 50);
  CHECK(highest >= 120);
}

TEST_CASE("families: flat_subnormal is flat, and subnormal across its plane") {
  int cases = 0, flat = 0, subnormal = 0;
  on_cases("flat_subnormal", 300, [&](const subject &s, const pair_of_rows &p) {
    ++cases;
    bool one_height = false, small = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<float> c = along(s, p, axis);
      const auto [low, high] = std::minmax_element(c.begin(), c.end());
      one_height = one_height || (*low == *high && std::abs(*low) < 0x1p-126F);
      small = small || (std::abs(*low) < 0x1p-126F && std::abs(*high) < 0x1p-126F);
    }
    flat += one_height, subnormal += small;
  });
  CHECK(subnormal > cases * 9 / 10);
  CHECK(flat > cases / 3);
}

TEST_CASE("families: plane_binades spans 26 binades, and points lie on planes exactly") {
  const subject &s = subject_named("side_triangle_point");
  random_numbers random(53);
  int cases = 0, wide = 0, on_plane = 0, off = 0;
  for (; cases < effort(2000); ++cases) {
    const pair_of_rows p = plane_binades(s.a, s.b, random);
    int low = 1000, high = -1000;
    for (const row *r : {&p.a, &p.b})
      for (const float f : *r)
        if (f != 0)
          low = std::min(low, std::ilogb(f)), high = std::max(high, std::ilogb(f));
    wide += high - low >= 20;
    const int side = truth_by_geometry(s, p);
    on_plane += side == 0, off += side != 0;
  }
  CHECK(wide > cases / 4);
  CHECK(on_plane > cases / 10);
  CHECK(off > cases / 10);
}

TEST_CASE("families: at_exact_steps has differences within three steps of each limit") {
  for (const subject &s : subjects()) {
    random_numbers random(54);
    const std::span<const double> limits = exact_limits(s.a, s.b);
    std::vector<int> near(limits.size());
    int cases = 0;
    for (; cases < effort(500); ++cases) {
      const pair_of_rows p = at_exact_steps(s.a, s.b, random);
      double longest = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<float> c = along(s, p, axis);
        const auto [low, high] = std::minmax_element(c.begin(), c.end());
        longest = std::max(longest, static_cast<double>(*high) - static_cast<double>(*low));
      }
      for (std::size_t i = 0; i < limits.size(); ++i) {
        const double limit = std::min(limits[i], 0x1p24);
        for (int e = -149; e <= 100; ++e)                       // in the pair's own steps
          if (std::abs(std::ldexp(longest, -e) - limit) <= 5) { // and a step or two off the plane
            ++near[i];
            break;
          }
      }
    }
    INFO(s.name);
    for (const int n : near)
      CHECK(n > cases / (3 * static_cast<int>(limits.size())));
  }
}

TEST_CASE("families: long_lattice has edges of 2^18 cells, with corners on and beside their lattice points") {
  const subject &s = subject_named("segment_segment");
  random_numbers random(55);
  int cases = 0, on = 0, off = 0, long_ones = 0;
  for (; cases < effort(2000); ++cases) {
    const pair_of_rows p = long_lattice(s.a, s.b, random);
    double longest = 0, least = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, std::abs(static_cast<double>(p.a[k]) - static_cast<double>(p.a[3 + k])));
    for (const row *r : {&p.a, &p.b}) // the lattice's step: the largest power of two of which all numbers are multiples
      for (const float f : *r)
        for (int e = -149; f != 0 && e <= 122; ++e)
          if (std::fmod(static_cast<double>(f), std::ldexp(1.0, e + 1)) != 0) {
            least = std::min(least, std::ldexp(1.0, e));
            break;
          }
    long_ones += longest >= 0x1p17 * least;
    (truth_by_geometry(s, p) ? on : off) += 1;
  }
  CHECK(long_ones > cases * 9 / 10);
  CHECK(on > cases / 5);
  CHECK(off > cases / 5);
}

TEST_CASE("families: bent neighbours share corners bit for bit and are all but coplanar") {
  const subject &s = subject_named("triangle_triangle"), &side = subject_named("side_triangle_point");
  random_numbers random(52);
  int cases = 0, shared[4] = {}, off_by_a_hair = 0;
  for (; cases < effort(2000); ++cases) {
    const pair_of_rows p = bent(s.a, s.b, random);
    int same = 0, off = 0;
    for (std::size_t j = 0; j < 9; j += 3) {
      for (std::size_t i = 0; i < 9; i += 3)
        same += std::memcmp(&p.a[i], &p.b[j], 3 * sizeof(float)) == 0;
      off += truth_by_geometry(side, {p.a, row(&p.b[j], &p.b[j] + 3)}) != 0;
    }
    ++shared[std::min(same, 3)];
    off_by_a_hair += off == 1; // one number was moved, so no other corner is off the plane
    CHECK(off <= 1);
  }
  CHECK(shared[1] > cases / 4);
  CHECK(shared[2] > cases / 4);
  CHECK(off_by_a_hair > cases * 3 / 4);
}
