// Real meshes, where the folder MEETC_DATA has them.
#include "meet/io/read.hpp"
#include "tests/catch.hpp"
#include "tests/cgal/scenes.hpp"

#include <algorithm>
#include <cga/cga_runtime.hpp>
#include <filesystem>
#include <optional>

using namespace meetc::cgal_test;

namespace {

std::optional<body> load(const std::string &name) {
  const std::filesystem::path path = std::filesystem::path(MEETC_DATA) / (name + ".ply");
  if (!std::filesystem::exists(path))
    return std::nullopt;
  const meetc::catalogue &c = cga::catalogue();
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < c.kind_count; ++i)
    kinds.push_back(&c.kinds[i]);
  const meetc::io::element_set set = meetc::io::read(path, kinds);
  body b{shape::triangle, std::vector<float>(9 * set.elements)};
  for (std::size_t i = 0; i < set.elements; ++i)
    set.row(i, b.rows.data() + 9 * i);
  return b;
}

// The middle of the bounding box, and the box's largest side.
struct extent {
  std::array<double, 3> middle;
  double size;
};
extent extent_of(const body &b) {
  extent e{{0, 0, 0}, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    double lo = 1e300, hi = -1e300;
    for (std::size_t i = k; i < b.rows.size(); i += 3) {
      lo = std::min(lo, static_cast<double>(b.rows[i]));
      hi = std::max(hi, static_cast<double>(b.rows[i]));
    }
    e.middle[k] = (lo + hi) / 2;
    e.size = std::max(e.size, hi - lo);
  }
  return e;
}

// Turned about its middle, `share` of the other's size, its middle at the other's plus `off` times that size.
body beside(const body &b, const body &other, const placing &turn, double share, std::array<double, 3> off) {
  const extent own = extent_of(b), its = extent_of(other);
  body centred = placed(b, {{0, 0, 1}, 0, 1, {-own.middle[0], -own.middle[1], -own.middle[2]}});
  placing p = turn;
  p.scale = share * its.size / own.size;
  for (std::size_t k = 0; k < 3; ++k)
    p.move[k] = its.middle[k] + off[k] * its.size;
  return placed(centred, p);
}

#define NEED(variable, name)                                                                                           \
  const auto variable##_file = load(name);                                                                             \
  if (!variable##_file) {                                                                                              \
    WARN("skipped: no " name ".ply in " MEETC_DATA);                                                                   \
    return;                                                                                                            \
  }                                                                                                                    \
  const body &variable = *variable##_file

} // namespace

TEST_CASE("real: bunny and armadillo at several poses", "[data]") {
  NEED(bunny_1k, "bunny_1k");
  NEED(bunny_5k, "bunny_5k");
  NEED(armadillo_5k, "armadillo_5k");
  NEED(armadillo_20k, "armadillo_20k");
  const struct {
    placing turn;
    double share;
    std::array<double, 3> off;
  } poses[] = {{{{0, 1, 0}, 0}, 1, {0, 0, 0}},
               {{{1, 2, 3}, 50}, 0.7, {0.2, 0.1, 0}},
               {{{-1, 0, 2}, 140}, 0.4, {0, 0.3, 0.1}},
               {{{0, 0, 1}, 90}, 1.3, {-0.2, 0, 0.2}}};
  for (const auto &p : poses)
    for (const body *b : {&bunny_1k, &bunny_5k})
      for (const body *a : {&armadillo_5k, &armadillo_20k})
        CHECK(same_pairs("bunny x armadillo", beside(*b, *a, p.turn, p.share, p.off), *a) > 50);
  CHECK(same_pairs("bunny_5k on itself", bunny_5k, bunny_5k) > 10 * bunny_5k.size());
  // As stored the two are 0.15 and 150 wide: the bunny's middle on corners of the other.
  for (std::size_t i = 0; i < armadillo_5k.size(); i += 499) {
    const extent own = extent_of(bunny_1k);
    placing p;
    for (std::size_t k = 0; k < 3; ++k)
      p.move[k] = static_cast<double>(armadillo_5k.row(i)[k]) - own.middle[k];
    CHECK(same_pairs("as stored, on a corner", placed(bunny_1k, p), armadillo_5k) > 20);
  }
  // Tiny, huge, far away.
  const body near = beside(bunny_5k, armadillo_5k, {{1, 2, 3}, 50}, 0.7, {0.2, 0.1, 0});
  for (const auto &[factor, offset] :
       {std::pair(1e-15F, 0.0F), {1e12F, 0.0F}, {1.0F, 1e6F}, {1.0F, 1e7F}, {4.0F, 1e7F}})
    CHECK(same_pairs("bunny_5k x armadillo_5k, times " + std::to_string(factor) + " plus " + std::to_string(offset),
                     in_float32(near, factor, offset), in_float32(armadillo_5k, factor, offset)) > 100);
}

TEST_CASE("real: CAD parts, coplanar and slid", "[data]") {
  NEED(fandisk, "fandisk_13k");
  NEED(cycloidal, "cycloidal_43k");
  const double size = extent_of(fandisk).size;
  CHECK(same_pairs("fandisk on itself", fandisk, fandisk) > 100000);
  for (const std::array<double, 3> slide : {std::array<double, 3>{0.01, 0, 0}, {0, 0.02, 0}, {0, 0, 0.05}})
    CHECK(same_pairs("fandisk, slid", fandisk,
                     placed(fandisk, {{0, 0, 1}, 0, 1, {slide[0] * size, slide[1] * size, slide[2] * size}})) > 1000);
  CHECK(same_pairs("fandisk + 1e6", in_float32(fandisk, 64, 1e6F), in_float32(fandisk, 64, 1e6F)) > 100000);
  const double wheel = extent_of(cycloidal).size;
  CHECK(same_pairs("cycloidal, slid", cycloidal, placed(cycloidal, {{0, 0, 1}, 0, 1, {wheel / 64, 0, 0}})) > 1000);
  CHECK(same_pairs("cycloidal, turned", cycloidal, beside(cycloidal, cycloidal, {{0, 0, 1}, 20}, 1, {0, 0, 0})) > 1000);
}

TEST_CASE("real: a room and a robot of FCL", "[data]") {
  NEED(room, "fcl_env_2k");
  NEED(robot, "fcl_rob_216");
  std::size_t hits = 0;
  // The robot's middle on the middle of some of the room's triangles.
  for (std::size_t i = 0; i < room.size(); i += 109) {
    const float *t = room.row(i);
    placing p{{1, static_cast<double>(i % 7), 2}, static_cast<double>(i), 1, {0, 0, 0}};
    const extent own = extent_of(robot);
    body centred = placed(robot, {{0, 0, 1}, 0, 1, {-own.middle[0], -own.middle[1], -own.middle[2]}});
    for (std::size_t k = 0; k < 3; ++k)
      p.move[k] = static_cast<double>(t[k] + t[3 + k] + t[6 + k]) / 3;
    hits += same_pairs("robot in room", placed(centred, p), room);
  }
  CHECK(hits > 100);
  CHECK(same_pairs("room on itself", room, room) > room.size());
}

TEST_CASE("real: bunny_69k x armadillo_345k", "[data]") {
  NEED(bunny, "bunny_69k");
  NEED(armadillo, "armadillo_345k");
  const std::size_t pairs = same_pairs("bunny_69k x armadillo_345k",
                                       beside(bunny, armadillo, {{1, 2, 3}, 50}, 0.25, {0.05, 0.1, 0.1}), armadillo);
  CHECK(pairs > 1000);
  CHECK(pairs < 4000);
}
