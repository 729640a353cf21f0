// The winding number of closed chains of triangles on a small lattice, where most rays run through corners, along edges and in
// the planes of triangles, against tetrahedra that hold the point by integer determinants.
#include "tests/catch.hpp"

#include "meet/core/query/find.hpp"
#include "meet/core/sets/prepared.hpp"
#include "meet/core/sets/topology.hpp"

#include <cga/cga_runtime.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace meetc;

namespace {

using point = std::array<int, 3>;
using tetrahedron = std::array<point, 4>;

int volume(const point &a, const point &b, const point &c, const point &d) {
  int m[3][3];
  for (std::size_t k = 0; k < 3; ++k)
    m[0][k] = b[k] - a[k], m[1][k] = c[k] - a[k], m[2][k] = d[k] - a[k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// 1 inside, 0 outside, -1 on the surface; a tetrahedron without volume is all surface, wherever the point is in its plane.
int place_in(const tetrahedron &t, const point &p) {
  const int sides[] = {volume(t[1], t[2], t[3], p), -volume(t[0], t[2], t[3], p), volume(t[0], t[1], t[3], p),
                       -volume(t[0], t[1], t[2], p)};
  int positive = 0, negative = 0;
  for (const int s : sides)
    positive += s > 0, negative += s < 0;
  if (positive > 0 && negative > 0)
    return 0;
  return positive == 4 || negative == 4 ? 1 : -1;
}

} // namespace

TEST_CASE("winding numbers are right where rays meet corners, edges and flat faces") {
  const auto winding = find_predicate(cga::catalogue(), "triangle_triangle").winding;
  REQUIRE(winding);
  CHECK(find_predicate(cga::catalogue(), "segment_triangle").winding);
  CHECK(!find_predicate(cga::catalogue(), "ball_triangle").winding);
  std::mt19937 g(1);
  const auto drawn = [&](int n) {
    point p;
    for (int &x : p)
      x = static_cast<int>(g() % static_cast<unsigned>(n));
    return p;
  };
  int seen[7] = {};
  for (int i = 0; i < 200000; ++i) {
    const int n = i % 2 == 0 ? 3 : 5;
    const float scale = std::ldexp(1.0f, i % 3 == 0 ? 0 : i % 3 == 1 ? -149 : 124);
    const point p = drawn(n);
    float at[3];
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = static_cast<float>(p[k]) * scale;
    int want = 0;
    std::vector<float> rows;
    for (int t = 1 + static_cast<int>(g() % 3); t > 0; --t) {
      const tetrahedron one{drawn(n), drawn(n), drawn(n), drawn(n)};
      const int place = place_in(one, p), way = volume(one[0], one[1], one[2], one[3]) > 0 ? 1 : -1;
      if (place < 0)
        continue;
      want += place * way;
      for (const auto &face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}})
        for (const int corner : face)
          for (const int x : one[static_cast<std::size_t>(corner)])
            rows.push_back(static_cast<float>(x) * scale);
    }
    CAPTURE(i);
    REQUIRE(winding(at, rows.data(), rows.size() / 9) == want);
    ++seen[want + 3];
  }
  for (const int w : {-1, 0, 1})
    CHECK(seen[w + 3] > 500);
}

TEST_CASE("a set is closed where each edge has as many elements one way as the other, and parts share corners") {
  const kind_info &kind = *find_predicate(cga::catalogue(), "triangle_triangle").a;
  const auto of = [&](const std::vector<float> &rows, const pose &at = {}) {
    return prepare({rows.data(), 0, 0, nullptr, rows.size() / 9}, kind, at).topology();
  };
  // 0 and -0 are one coordinate.
  std::vector<float> tetra{0, 0, 0, 0, 1, 0, 1, 0, 0,     0, 0, 0, 1, 0, 0, 0, 0, 1,
                           0, 0, 0, 0, 0, 1, 0, 1, -0.0f, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  CHECK(!of(tetra).open);
  CHECK(of(tetra).parts.size() == 1);
  std::vector<float> pillow = tetra; // a face and its like the other way round, at a corner of the others
  pillow.insert(pillow.end(), {1, 0, 0, 5, 5, 5, 6, 5, 5, 1, 0, 0, 6, 5, 5, 5, 5, 5});
  CHECK(!of(pillow).open);
  CHECK(of(pillow).parts.size() == 1);
  std::vector<float> apart = pillow;
  apart[9 * 4] = apart[9 * 5] = 2;
  CHECK(!of(apart).open);
  CHECK(of(apart).parts.size() == 2);
  for (std::size_t face = 0; face < 4; ++face) {
    std::vector<float> turned = tetra, less = tetra;
    for (std::size_t k = 0; k < 3; ++k)
      std::swap(turned[9 * face + k], turned[9 * face + 3 + k]);
    CHECK(of(turned).open == 0U);
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(9 * face),
               less.begin() + static_cast<std::ptrdiff_t>(9 * face + 9));
    CHECK(of(less).open == 0U);
  }
  std::vector<float> twice = tetra; // a doubled face
  twice.insert(twice.end(), tetra.begin() + 27, tetra.end());
  CHECK(of(twice).open == 0U);
  std::vector<float> later = tetra;
  later.insert(later.end(), {7, 7, 7, 8, 7, 7, 7, 8, 7});
  CHECK(of(later).open == 4U);
  CHECK(of({}).parts.empty());
}
