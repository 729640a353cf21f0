// Built-in meshes, segments and spheres: always there, and full of degenerate contact.
#include "tests/catch.hpp"
#include "tests/cgal/scenes.hpp"

using namespace meetc::cgal_test;
namespace bodies = meetc::bodies;

namespace {

body spheres(std::size_t n, std::uint64_t seed, double least = 0.02, double most = 0.15) {
  return spheres_of(bodies::sphere_cloud(n, seed, least, most));
}
body segments(std::size_t n, std::uint64_t seed, double length) {
  return segments_of(bodies::segment_cloud(n, seed, length));
}

} // namespace

TEST_CASE("built-in: meshes at several poses") {
  const body ball = triangles_of(bodies::icosphere(3)), ring = triangles_of(bodies::torus(48, 24)),
             rope = triangles_of(bodies::knot(200, 12)), wheel = triangles_of(bodies::gear(12, 2)),
             animal = triangles_of(bodies::blob(48));
  CHECK(same_pairs("icosphere on itself, turned", ball, placed(ball, {{1, 2, 3}, 20, 1, {0, 0, 0}})) > 1000);
  CHECK(same_pairs("icosphere x torus", ball, placed(ring, {{1, 0, 0}, 30, 1, {0.25, 0, 0.1}})) > 200);
  CHECK(same_pairs("torus x knot", ring, placed(rope, {{0, 1, 0}, 77, 0.9, {0.05, 0.1, 0}})) > 500);
  CHECK(same_pairs("gear x gear, meshing", wheel, placed(wheel, {{0, 0, 1}, 15, 1, {1.25, 0, 0}})) > 20);
  CHECK(same_pairs("gear x gear, slid along its coplanar sides", wheel,
                   placed(wheel, {{0, 0, 1}, 0, 1, {0.125, 0, 0}})) > 2000);
  CHECK(same_pairs("blob x knot", animal, placed(rope, {{1, 1, 0}, 40, 0.8, {0, 0.2, 0}})) > 200);
  CHECK(same_pairs("blob x gear", animal, placed(wheel, {{1, 0, 0}, 90, 0.7, {0, 0.3, 0}})) > 100);
  CHECK(same_pairs("apart", ball, placed(ball, {{0, 0, 1}, 0, 1, {5, 0, 0}})) == 0);
}

TEST_CASE("built-in: a mesh against itself, and moved by one last bit") {
  for (const body &b : {triangles_of(bodies::icosphere(3)), triangles_of(bodies::torus(40, 20)),
                        triangles_of(bodies::gear(8, 1)), triangles_of(bodies::block(6, 5, 4, 2))}) {
    CHECK(same_pairs("self", b, b) > 10 * b.size());
    body near = b;
    for (std::size_t i = 0; i < near.rows.size(); ++i)
      near.rows[i] = std::nextafter(near.rows[i], i % 2 ? 10.0F : -10.0F);
    CHECK(same_pairs("self, by one bit", b, near) > b.size());
  }
}

TEST_CASE("built-in: blocks that share faces, edges and corners") {
  const body block = triangles_of(bodies::block(8, 6, 4, 2));
  // Cells of 1/4: the block is 2 x 1.5 x 1. Exactly coplanar faces, in step and half a cell out of step.
  const double moves[][3] = {{2, 0, 0},      {2, 0.25, 0},      {2, 0.125, 0.125}, {0, 1.5, 0.0625}, {0, 0, 1},
                             {0.1, 0.2, 1},  {2, 1.5, 0},       {2, 1.5, 1},       {0.25, 0, 0},     {0.125, 0.125, 0},
                             {1, 0.75, 0.5}, {2.0000002, 0, 0}, {2, 1.5000001, 0}};
  std::size_t touching = 0;
  for (const auto &m : moves)
    touching += same_pairs("blocks", block, placed(block, {{0, 0, 1}, 0, 1, {m[0], m[1], m[2]}})) > 0;
  CHECK(touching == 11); // all but the two that are a last bit too far
  CHECK(same_pairs("blocks, turned by a quarter", block, placed(block, {{0, 0, 1}, 90, 1, {0.25, 0, 0}})) > 100);
  // An oblique pair of coplanar faces: both turned alike, so that rounding takes them a little apart.
  CHECK(same_pairs("blocks, oblique", placed(block, {{1, 2, 3}, 33, 1, {0, 0, 0}}),
                   placed(block, {{1, 2, 3}, 33, 1, {0.1, 0.05, -0.03}})) > 100);
}

TEST_CASE("built-in: segments and spheres against meshes and each other") {
  const body ring = triangles_of(bodies::torus(48, 24)), block = triangles_of(bodies::block(8, 6, 4, 2)),
             animal = triangles_of(bodies::blob(48));
  const body rods = segments(4000, 5, 0.4), balls = spheres(1500, 6);
  CHECK(same_pairs("segments x torus", rods, ring) > 500);
  CHECK(same_pairs("segments x blob", rods, animal) > 500);
  CHECK(same_pairs("segments x block", rods, block) > 200);
  body edges{shape::segment, {}}; // a mesh's own edges: every corner and edge is shared
  for (std::size_t i = 0; i < block.size(); ++i)
    edges.rows.insert(edges.rows.end(), block.row(i), block.row(i) + 6);
  CHECK(same_pairs("a block's edges x the block", edges, block) > 1000);
  for (const bool surface : {false, true}) {
    CHECK(same_pairs("spheres x torus", balls, ring, surface) > 2000);
    CHECK(same_pairs("spheres x block", balls, block, surface) > 1000);
    CHECK(same_pairs("spheres x segments", balls, rods, surface) > 3000);
    CHECK(same_pairs("spheres x spheres", balls, spheres(1500, 7), surface) > 3000);
    CHECK(same_pairs("spheres x themselves", balls, balls, surface) >= balls.size());
    CHECK(same_pairs("large spheres x torus", spheres(60, 8, 0.3, 0.9), ring, surface) > 1000);
  }
  // Tangent to the block's faces, edges and corners: centres and radii on its half cells.
  body tangent{shape::sphere, {}};
  for (int x = -10; x <= 10; x += 2)
    for (int y = -8; y <= 8; y += 2)
      for (int z = -6; z <= 6; ++z)
        for (const float c : {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
                              1.0F + static_cast<float>((x + y + z) & 3)})
          tangent.rows.push_back(c / 8);
  for (const bool surface : {false, true}) {
    CHECK(same_pairs("tangent spheres x block", tangent, block, surface) > 1000);
    CHECK(same_pairs("tangent spheres x themselves", tangent, tangent, surface) > 1000);
    CHECK(same_pairs("tangent spheres x the block's edges", tangent, edges, surface) > 1000);
  }
}

TEST_CASE("built-in: tiny, huge and far from the origin, in float32") {
  const body ring = triangles_of(bodies::torus(32, 16)),
             rope = placed(triangles_of(bodies::knot(96, 8)), {{0, 1, 0}, 77, 0.9, {0.05, 0.1, 0}}),
             rods = segments(1500, 5, 0.4), balls = spheres(500, 6);
  struct {
    float factor, offset;
  } const settings[] = {{1e-15F, 0}, {1e12F, 0}, {0x1p-140F, 0}, {0x1p120F, 0}, {64, 1e6F}, {64, 1e7F}, {256, 1e7F}};
  for (const auto &s : settings) {
    INFO("times " << s.factor << ", plus " << s.offset);
    const auto at = [&](const body &b) { return in_float32(b, s.factor, s.offset); };
    CHECK(same_pairs("torus x knot", at(ring), at(rope)) > 100);
    CHECK(same_pairs("torus on itself", at(ring), at(ring)) > ring.size());
    CHECK(same_pairs("segments x torus", at(rods), at(ring)) > 50);
    for (const bool surface : {false, true}) {
      CHECK(same_pairs("spheres x torus", at(balls), at(ring), surface) > 500);
      CHECK(same_pairs("spheres x segments", at(balls), at(rods), surface) > 500);
      CHECK(same_pairs("spheres x spheres", at(balls), at(balls), surface) > balls.size() - 1);
    }
  }
}
