// Families of bodies that almost coincide: all within a few ulps of one point, or joined along an edge and
// bent there by one ulp.
#include "tests/extremes/families/families.hpp"

#include <cmath>
#include <limits>

namespace meetc::extremes_test {
namespace {

using generated_test::stepped;
constexpr float most = std::numeric_limits<float>::max();

// The step from |f| to the next number away from 0.
float ulp(float f) {
  const float m = std::min(std::abs(f), stepped(most, -1));
  return stepped(m, 1) - m;
}

// 24 random bits at this exponent, or what of them is left where numbers are subnormal.
float at_exponent(int e, random_numbers &random) {
  const float m = 1 + static_cast<float>(random.integer(0, 0x7fffff)) * 0x1p-23F;
  return std::ldexp(random.one_in(2) ? m : -m, e);
}

} // namespace

pair_of_rows cluster(shape a, shape b, random_numbers &random) {
  static constexpr int reaches[] = {1, 2, 6};
  const int reach = reaches[random.integer(0, 2)], exponent = random.integer(-149, 127);
  const bool alike = random.one_in(2);
  float centre[3];
  for (float &c : centre)
    c = random.one_in(8)
            ? 0
            : at_exponent(alike ? exponent : std::clamp(exponent + random.integer(-6, 6), -149, 127), random);
  pair_of_rows p;
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)}) {
    for (std::size_t i = 0; i < 3 * corners(kind); ++i)
      r->push_back(stepped(centre[i % 3], random.integer(-reach, reach)));
    if (padded(kind)) { // as large as the cluster
      const float step = ulp(centre[random.integer(0, 2)]);
      r->push_back(std::min(most, step * static_cast<float>(random.integer(0, 2 * reach))));
    }
  }
  if (padded(a) && random.one_in(3))
    graze(a, b, p, random);
  return p;
}

pair_of_rows bent(shape a, shape b, random_numbers &random) {
  const bool swapped = corners(a) < corners(b);
  const shape base = swapped ? b : a, other = swapped ? a : b;
  // Integers, so that joined triangles are coplanar exactly before they are bent: corners o, u, v on multiples of
  // 16, the neighbour's corners at o + (s (u - o) + t (v - o)) / 16, below 2^24.
  long corner[3][3];
  for (auto &c : corner)
    for (long &k : c)
      k = 16L * random.integer(0, (1 << 18) - 1);
  const int exponent = random.one_in(2) ? -22 : random.integer(-149, 100);
  pair_of_rows p;
  row &x = swapped ? p.b : p.a, &y = swapped ? p.a : p.b;
  const auto append = [&](row &r, long s, long t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const long o = corner[0][k], c = o + (s * (corner[1][k] - o) + t * (corner[2][k] - o)) / 16;
      r.push_back(std::ldexp(static_cast<float>(c), exponent));
    }
  };
  for (std::size_t i = 0; i < corners(base); ++i)
    append(x, i == 1 ? 16 : 0, i == 2 ? 16 : 0);
  // Joined at one corner or two, or not at all (a point, a centre); the rest lies across or on top of the
  // base.
  const std::size_t joined = corners(other) == 1 ? random.bits() % 2 : 1 + random.bits() % (corners(other) - 1);
  for (std::size_t i = 0; i < corners(other); ++i)
    if (i < joined) {
      append(y, i == 1 ? 16 : 0, 0);
    } else {
      const int s = random.integer(-16, 16), t = corners(base) == 2 && random.one_in(2) ? 0 : random.integer(-16, 16);
      append(y, s, t);
    }
  if (!random.one_in(8)) {
    // Now and then what is joined comes apart.
    const std::size_t first = corners(other) == joined || random.one_in(4) ? 0 : joined;
    float &c = y[3 * first + random.bits() % (3 * (corners(other) - first))];
    c = stepped(c, random.one_in(2) ? 1 : -1);
  }
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)})
    if (padded(kind))
      r->push_back(0);
  if (padded(a) && !random.one_in(8)) // up to the other's far or near side, to the ulp
    graze(a, b, p, random);
  return p;
}

} // namespace meetc::extremes_test
