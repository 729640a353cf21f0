// Real meshes, where the folder MEETC_DATA has them: the pairs of `certified` are those of `exact`, for every
// predicate, as stored, far from the origin, tiny, huge, and for each mesh against itself.
//
// Each mesh meets the next one, which is rotated and brought to its size and place. Segments are the first edges of
// faces, points their first corners, and spheres have a quarter of the edge as radius about the corner. All of this is
// rounded to float32 before either rung sees it.
#include "tests/catch.hpp"

#include "meet/core/query/collide.hpp"
#include "tests/runtime/real_bodies.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

using namespace meetc;

namespace {

using real_bodies::body, real_bodies::placed;

const std::vector<body> &bodies() {
  static const std::vector<body> all = real_bodies::load_all(MEETC_DATA);
  return all;
}

// Elements of a kind from at most `most` faces.
prepared elements(const body &b, const kind_info &kind, const pose &at, std::size_t most) {
  const std::size_t faces = std::min(most, b.corners.size() / 9), fields = static_cast<std::size_t>(kind.fields);
  std::vector<float> rows;
  for (std::size_t i = 0; i < faces; ++i) {
    const float *c = &b.corners[9 * i];
    if (lies_along_axes(kind)) { // the box around an edge
      for (const bool greater : {false, true})
        for (int k = 0; k < 3; ++k)
          rows.push_back(greater ? std::max(c[k], c[3 + k]) : std::min(c[k], c[3 + k]));
      continue;
    }
    rows.insert(rows.end(), c, c + (kind.points > 0 ? fields : 3));
    if (kind.points == 0)
      rows.push_back(0.25F * std::hypot(c[3] - c[0], c[4] - c[1], c[5] - c[2]));
  }
  REQUIRE(rows.size() == faces * fields); // point, segment, triangle, sphere or box
  pose there = at;
  if (lies_along_axes(kind)) // which is moved and scaled, and not turned
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        there.m[4 * i + k] = i == k ? at.length_scale : 0;
  return prepare({rows.data(), 0, fields * sizeof(float), nullptr, faces}, kind, there);
}

struct totals {
  std::uint64_t lists = 0, candidates = 0, pairs = 0, unsure[3] = {};
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  void print(const char *what) const {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    fmt::print("{:<34} {} lists, {} candidates, {} pairs compared; handed on: fp32 {}, fp64 {}, fp64x2 {}; "
               "{:.1f} s\n",
               what, lists, candidates, pairs, unsure[0], unsure[1], unsure[2], took.count());
  }
};

void same_pairs(const body &a, const pose &at_a, const body &b, const pose &at_b, std::size_t most_faces, totals &sum) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    const std::size_t most = p.a->points == 3 && p.b->points == 3 ? most_faces : 3000;
    const prepared x = elements(a, *p.a, at_a, most), y = elements(b, *p.b, at_b, most);
    const result exact = collide(x, y, p, rung::exact), certified = collide(x, y, p, rung::certified);
    INFO(p.name << ": " << a.name << ", " << b.name);
    CHECK(certified.candidates == exact.candidates);
    CHECK(std::equal(exact.pairs.begin(), exact.pairs.end(), certified.pairs.begin(), certified.pairs.end(),
                     [](index_pair s, index_pair t) { return s.a == t.a && s.b == t.b; }));
    ++sum.lists;
    sum.candidates += exact.candidates;
    sum.pairs += exact.count;
    for (std::size_t k = 0; k < 3; ++k)
      sum.unsure[k] += certified.rungs.unsure[k];
  }
}

constexpr std::array<double, 3> origin{0, 0, 0};

// Every mesh and the next one at a given size and place. The first rung may leave this many pairs unsure.
void neighbours(const char *what, double size, const std::array<double, 3> &place, std::uint64_t most_unsure) {
  totals sum;
  for (std::size_t i = 0; i < bodies().size(); ++i) {
    const body &a = bodies()[i], &b = bodies()[(i + 1) % bodies().size()];
    same_pairs(a, placed(a, size / a.size, false, place), b, placed(b, size / b.size, true, place), 400'000, sum);
  }
  sum.print(what);
  if (!bodies().empty()) {
    CHECK(sum.pairs > 10'000);
    CHECK(sum.unsure[0] <= most_unsure);
  }
}

} // namespace

TEST_CASE("each mesh with the next, as stored", "[data]") {
  if (bodies().empty())
    WARN("no meshes in " MEETC_DATA);
  totals sum;
  for (std::size_t i = 0; i < bodies().size(); ++i) {
    const body &a = bodies()[i], &b = bodies()[(i + 1) % bodies().size()];
    same_pairs(a, {}, b, placed(b, a.size / b.size, true, a.middle), 400'000, sum);
  }
  sum.print("as stored");
  CHECK((sum.pairs > 10'000 || bodies().empty()));
}

// Steps of float32 are 1/16 there, and edges of the finest mesh are a dozen steps long, so many faces are degenerate.
TEST_CASE("at 1e6 from the origin", "[data]") {
  neighbours("at +1e6", 200, {1e6, -1e6, 1e6}, 1000);
}

TEST_CASE("at 1e7 from the origin", "[data]") {
  neighbours("at +1e7", 2000, {1e7, 1e7, -1e7}, 1000);
}

TEST_CASE("scaled by 1e-15", "[data]") {
  neighbours("scaled by 1e-15", 1e-15, origin, 1000); // cubes of these leave float32's range
}

TEST_CASE("scaled by 1e12", "[data]") {
  neighbours("scaled by 1e12", 1e12, origin, 1000);
}

TEST_CASE("each mesh against itself", "[data]") {
  totals sum;
  for (const body &b : bodies())
    same_pairs(b, {}, b, {}, 70'000, sum);
  sum.print("against itself");
  CHECK((sum.pairs > 1'000'000 || bodies().empty()));
}

TEST_CASE("each mesh against itself, at 1e7 from the origin", "[data]") {
  totals sum;
  for (const body &b : bodies()) {
    const pose there = placed(b, 2000 / b.size, true, {1e7, 1e7, 1e7});
    same_pairs(b, there, b, there, 10'000, sum);
  }
  sum.print("against itself at +1e7");
  CHECK((sum.pairs > 1'000'000 || bodies().empty()));
}
