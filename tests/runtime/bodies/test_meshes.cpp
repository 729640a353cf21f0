// The built-in meshes: closed, oriented, of the right topology, free of zero-area triangles, and the same
// bytes everywhere.
#include "meet/bodies/meshes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>

using namespace meetc::bodies;

namespace {

struct facts {
  bool manifold = true; // every edge once in each direction, and one fan of triangles round every vertex
  long euler = 0;       // vertices - edges + triangles
  double volume = 0;    // positive: normals outwards
  double least_area = 1e300;
  bool on_grid = true; // multiples of 2^-16 in [-2, 2]
  bool all_used = true;
};

facts examine(const mesh &m) {
  facts f;
  std::map<std::array<std::uint32_t, 2>, int> edges;
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> link; // v: edge opposite to v, from -> to
  std::set<std::array<float, 3>> places;
  for (std::size_t v = 0; v < m.vertices(); ++v)
    places.insert({m.xyz[3 * v], m.xyz[3 * v + 1], m.xyz[3 * v + 2]});
  f.manifold = places.size() == m.vertices();
  for (std::size_t t = 0; t < m.triangles(); ++t) {
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = m.index[3 * t + k], w = m.index[3 * t + (k + 1) % 3], u = m.index[3 * t + (k + 2) % 3];
      f.manifold = f.manifold && v != w && ++edges[{v, w}] == 1 && link[v].emplace(w, u).second;
      for (std::size_t c = 0; c < 3; ++c)
        p[k][c] = m.xyz[3 * std::size_t{v} + c];
    }
    std::array<double, 3> a{}, b{}, n{};
    for (std::size_t c = 0; c < 3; ++c) {
      a[c] = p[1][c] - p[0][c];
      b[c] = p[2][c] - p[0][c];
    }
    for (std::size_t c = 0; c < 3; ++c)
      n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
    f.least_area = std::min(f.least_area, std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2);
    f.volume += (n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2]) / 6;
  }
  for (const auto &[e, n] : edges)
    f.manifold = f.manifold && edges.count({e[1], e[0]}) == 1;
  for (const auto &[v, ring] : link) {
    std::size_t steps = 0;
    std::uint32_t at = ring.begin()->first;
    do {
      const auto next = ring.find(at);
      if (next == ring.end())
        break;
      at = next->second;
      ++steps;
    } while (at != ring.begin()->first && steps <= ring.size());
    f.manifold = f.manifold && steps == ring.size();
  }
  f.all_used = link.size() == m.vertices();
  f.euler = static_cast<long>(m.vertices()) - static_cast<long>(edges.size() / 2) + static_cast<long>(m.triangles());
  for (const float v : m.xyz)
    f.on_grid = f.on_grid && std::floor(double{v} * 65536) == double{v} * 65536 && std::abs(v) <= 2;
  return f;
}

std::uint64_t hash(const mesh &m) { // FNV-1a over 32-bit words
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto add = [&h](std::uint32_t w) { h = (h ^ w) * 0x100000001b3u; };
  for (const float v : m.xyz) {
    std::uint32_t w;
    std::memcpy(&w, &v, sizeof w);
    add(w);
  }
  for (const std::uint32_t i : m.index)
    add(i);
  return h;
}

void check(const std::string &name, const mesh &m, long euler) {
  INFO(name);
  const facts f = examine(m);
  CHECK(f.manifold);
  CHECK(f.all_used);
  CHECK(f.euler == euler);
  CHECK(f.volume > 0);
  CHECK(f.least_area > 0x1p-40);
  CHECK(f.on_grid);
}

} // namespace

TEST_CASE("built-in meshes are closed oriented manifolds without zero-area triangles") {
  for (int s = 0; s <= 4; ++s) {
    const mesh m = icosphere(s);
    check("icosphere " + std::to_string(s), m, 2);
    CHECK(m.triangles() == std::size_t{20} << 2 * s);
  }
  check("torus least", torus(3, 3), 0);
  check("torus", torus(64, 32), 0);
  check("knot least", knot(48, 3), 0);
  check("knot", knot(300, 24), 0);
  CHECK(knot(300, 24).triangles() == 2 * 300 * 24);
  check("gear least", gear(5, 1), 0);
  check("gear", gear(17, 3), 0);
  check("gear many", gear(256, 1), 0);
  check("block least", block(1, 1, 1, 0), 2);
  check("block", block(7, 5, 3, 3), 2);
  CHECK(block(7, 5, 3, 3).triangles() == 4 * (35 + 15 + 21));
  for (const int resolution : {48, 53, 72}) {
    check("blob " + std::to_string(resolution), blob(resolution), 2);
    check("figure " + std::to_string(resolution), figure(resolution), 2);
  }
}

TEST_CASE("the volume of a sphere and the size of a block") {
  CHECK(std::abs(examine(icosphere(5)).volume - 4.18879) < 0.01);
  CHECK(std::abs(examine(block(8, 6, 4, 3)).volume - 0.375) < 1e-12);
}

TEST_CASE("subdivision cuts every triangle into four on the same surface") {
  for (const mesh &m : {icosphere(2), block(2, 3, 1, 2), gear(9, 1)}) {
    const mesh n = subdivide(m);
    const facts before = examine(m), after = examine(n);
    CHECK(n.triangles() == 4 * m.triangles());
    CHECK(after.manifold);
    CHECK(after.euler == before.euler);
    CHECK(std::abs(after.volume - before.volume) < 1e-9);
    CHECK(std::abs(after.least_area - before.least_area / 4) < 1e-12);
  }
  CHECK(subdivide(mesh{}).triangles() == 0);
}

TEST_CASE("the same bytes on every machine") {
  CHECK(hash(icosphere(3)) == 0xc72985a43e8f72d7u);
  CHECK(hash(torus(48, 24)) == 0xad5ecf3332dada25u);
  CHECK(hash(knot(200, 16)) == 0xfd25d3ba80f99c25u);
  CHECK(hash(gear(17, 2)) == 0xe2e51d11f2a16925u);
  CHECK(hash(block(5, 4, 3, 4)) == 0xa598f3b3bfece953u);
  CHECK(hash(blob(48)) == 0xb13dc790d2006262u);
  CHECK(hash(figure(48)) == 0x6e1c6a85754f13eau);
  CHECK(hash({sphere_cloud(500, 42, 0.01, 0.1), {}}) == 0x490d495e745a1965u);
  CHECK(hash({segment_cloud(500, 42, 0.25), {}}) == 0x721ed24c969a2485u);
}

TEST_CASE("clouds lie where they should") {
  const std::vector<float> s = sphere_cloud(1000, 1, 0, 0.1), t = segment_cloud(1000, 1, 0.5);
  REQUIRE(s.size() == 4000);
  REQUIRE(t.size() == 6000);
  for (std::size_t i = 0; i < s.size(); ++i)
    REQUIRE((i % 4 == 3 ? s[i] > 0 && s[i] <= 0.1f : std::abs(s[i]) <= 1));
  for (std::size_t i = 0; i < t.size(); i += 6)
    REQUIRE(std::abs(std::hypot(t[i] - t[i + 3], t[i + 1] - t[i + 4], t[i + 2] - t[i + 5]) - 0.5f) < 1e-4f);
  CHECK(sphere_cloud(10, 1, 0, 1) != sphere_cloud(10, 2, 0, 1));
}
