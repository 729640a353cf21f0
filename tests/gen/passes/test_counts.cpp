// Exact operation counts: the counts that the compiler reaches, and the limits that it must keep.
//
// A count is {multiplications, additions}. A fused multiply-add counts as one of each. Negations, duals and products
// with powers of two are free (except those that a fusion has absorbed, so counts here are never too small).
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/bound/growth.hpp"
#include "gen/passes/fuse.hpp"

#include <ostream>

using namespace meetc;
using namespace meetc::compiler_test;
using poly::residency;

namespace {

struct ops {
  int multiplications, additions;
  bool operator==(const ops &) const = default;
};
std::ostream &operator<<(std::ostream &out, const ops &n) {
  return out << n.multiplications << '/' << n.additions;
}
ops plain(const ir::counts &c) {
  return {c.multiplications + c.fused, c.additions + c.fused};
}
ops all(const ir::program &p) {
  return plain(ir::count(p.nodes, p.results));
}
ops part(const ir::program &p, residency r) {
  return plain(ir::count(p, r));
}
bool within(const ops &have, const ops &limit) {
  return have.multiplications <= limit.multiplications && have.additions <= limit.additions;
}

// On blades; from stored numbers: all operations, and those left for the pair when objects keep their own values.
struct formula_row {
  const char *name;
  ops blades, stored, pair;
};
const formula_row formulas[] = {
    {"meet_plane_line", {12, 8}, {0, 0}, {0, 0}},
    {"norm2_meet_plane_line", {4, 2}, {4, 5}, {4, 2}},
    {"meet_sphere_line", {18, 8}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_line", {25, 14}, {12, 14}, {8, 9}},
    {"meet_plane_plane", {12, 6}, {0, 0}, {0, 0}},
    {"norm2_meet_plane_plane", {9, 5}, {9, 5}, {9, 5}},
    {"meet_sphere_plane", {16, 6}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_plane", {23, 12}, {10, 7}, {5, 5}},
    {"meet_sphere_sphere", {20, 10}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_sphere", {27, 16}, {6, 9}, {6, 9}},
    {"meet_line_line", {6, 5}, {0, 0}, {0, 0}},
    {"norm2_meet_line_line", {0, 0}, {0, 0}, {0, 0}},
    {"meet_circle_line", {18, 13}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_line", {22, 16}, {21, 19}, {17, 14}},
    {"meet_circle_circle", {30, 25}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_circle", {34, 28}, {40, 32}, {32, 28}},
    {"meet_circle_plane", {24, 14}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_plane", {31, 20}, {19, 12}, {12, 8}},
    {"meet_circle_sphere", {30, 20}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_sphere", {37, 26}, {19, 15}, {14, 13}},
    {"meet_point_pair_line", {6, 5}, {9, 14}, {9, 8}},
    {"norm2_meet_point_pair_line", {7, 5}, {10, 14}, {10, 8}},
    {"meet_point_pair_circle", {10, 9}, {18, 19}, {14, 14}},
    {"norm2_meet_point_pair_circle", {11, 9}, {19, 19}, {15, 14}},
    {"meet_point_pair_plane", {16, 11}, {0, 0}, {0, 0}},
    {"norm2_meet_point_pair_plane", {20, 14}, {14, 14}, {8, 6}},
    {"meet_point_pair_sphere", {20, 15}, {0, 0}, {0, 0}},
    {"norm2_meet_point_pair_sphere", {24, 18}, {12, 20}, {8, 15}},
};

// Signs, then operations for an object A, for an object B, and for a pair.
struct stage_row {
  int signs;
  ops a, b, pair;
  bool operator==(const stage_row &) const = default;
};
std::ostream &operator<<(std::ostream &out, const stage_row &s) {
  return out << s.signs << " signs: " << s.a << ", " << s.b << ", " << s.pair;
}
const stage_row none{0, {0, 0}, {0, 0}, {0, 0}};
struct predicate_row {
  const char *name;
  stage_row reject, common, rare;
};
const predicate_row predicates[] = {
    {"side_triangle_point", none, {1, {6, 9}, {0, 0}, {3, 5}}, none},
    {"side_sphere_point", none, {1, {1, 0}, {0, 0}, {3, 6}}, none},
    {"twist_segment_segment", none, {1, {0, 3}, {0, 3}, {9, 8}}, none},
    {"segment_segment", none, {25, {0, 3}, {0, 3}, {33, 29}}, none},
    {"point_triangle", none, {19, {0, 0}, {6, 12}, {21, 20}}, none},
    {"segment_triangle", {2, {0, 0}, {6, 9}, {6, 10}}, {3, {0, 3}, {0, 9}, {27, 21}}, {45, {0, 3}, {0, 9}, {54, 45}}},
    {"triangle_triangle",
     {6, {6, 9}, {6, 9}, {18, 27}},
     {9, {0, 9}, {0, 9}, {81, 57}},
     {81, {0, 9}, {0, 9}, {108, 81}}},
    {"sphere_sphere", none, {2, {0, 0}, {0, 0}, {5, 9}}, none},
    {"ball_ball", none, {1, {0, 0}, {0, 0}, {4, 7}}, none},
    {"ball_segment", none, {5, {1, 0}, {3, 5}, {19, 21}}, none},
    {"sphere_segment", none, {5, {1, 0}, {3, 5}, {19, 21}}, none},
    {"ball_triangle", none, {16, {1, 0}, {21, 24}, {59, 52}}, none},
    {"sphere_triangle", none, {16, {1, 0}, {21, 24}, {59, 52}}, none},
};

struct maker_row {
  const char *kind, *constructor;
  ops count;
};
const maker_row made[] = {
    {"point", "", {3, 2}},         {"direction", "", {0, 0}},      {"point_pair", "", {18, 14}},
    {"flat_point", "", {0, 0}},    {"line", "", {6, 6}},           {"line", "direction", {6, 3}},
    {"circle", "", {19, 11}},      {"circle", "points", {45, 36}}, {"plane", "", {0, 0}},
    {"plane", "points", {15, 14}}, {"sphere", "", {4, 3}},         {"sphere", "points", {64, 53}},
    {"segment", "", {6, 6}},       {"triangle", "", {15, 14}},
};

// The structural counts for B, never to be exceeded.
struct limit_row {
  const char *name;
  ops limit;
};
const limit_row structural[] = {
    {"meet_plane_line", {12, 8}},     {"meet_plane_plane", {12, 6}},       {"meet_line_line", {6, 5}},
    {"meet_sphere_line", {18, 8}},    {"meet_sphere_plane", {16, 6}},      {"meet_sphere_sphere", {20, 10}},
    {"meet_circle_plane", {24, 14}},  {"meet_circle_sphere", {30, 20}},    {"meet_circle_line", {18, 13}},
    {"meet_circle_circle", {30, 25}}, {"meet_point_pair_plane", {16, 11}}, {"meet_point_pair_sphere", {20, 15}},
    {"meet_point_pair_line", {6, 5}}, {"meet_point_pair_circle", {10, 9}},
};

// The best known counts for B², against what a pair costs here once objects keep their own values. `met` records the
// present state: a row that becomes met fails the test, so that the table is updated. These are not met: plane–plane
// (9/5: with kept squares |N|² |M|² - (N.M)² would cost the pair 5/3 but the whole 11/7, and forms are chosen by the
// whole), sphere–plane (5/5), circle–plane (12/8), circle–sphere (14/13), circle–line (17/14), point pair–plane (8/6)
// and point pair–sphere (8/15). The table's last two rows drop the positive factor |p - q|².
struct best_row {
  const char *name;
  ops best;
  bool met;
};
const best_row best[] = {
    {"norm2_meet_plane_line", {4, 2}, true},        {"norm2_meet_plane_plane", {5, 3}, false},
    {"norm2_meet_line_line", {0, 0}, true},         {"norm2_meet_sphere_line", {8, 9}, true},
    {"norm2_meet_sphere_plane", {5, 4}, false},     {"norm2_meet_sphere_sphere", {6, 9}, true},
    {"norm2_meet_circle_plane", {11, 7}, false},    {"norm2_meet_circle_sphere", {12, 11}, false},
    {"norm2_meet_circle_line", {17, 13}, false},    {"norm2_meet_circle_circle", {35, 29}, true},
    {"norm2_meet_point_pair_plane", {7, 6}, false}, {"norm2_meet_point_pair_sphere", {7, 12}, false},
};

ops pair_of(const ir::program &p) {
  return part(p, residency::pair);
}
stage_row row_of(const lower::stage &s) {
  if (s.atoms.empty())
    return none;
  return {static_cast<int>(s.atoms.size()), part(s.code, residency::a), part(s.code, residency::b), pair_of(s.code)};
}

} // namespace

TEST_CASE("the counts of every formula of the default scene") {
  CHECK(default_kernels(want::formulas).size() == std::size(formulas));
  for (const formula_row &row : formulas) {
    INFO(row.name);
    const lower::formula &f = default_kernel(row.name).value;
    CHECK(all(f.from_blades) == row.blades);
    if (f.stored_inputs.empty()) {
      CHECK(row.stored == ops{0, 0});
      continue;
    }
    CHECK(all(f.from_stored) == row.stored);
    CHECK(pair_of(f.from_stored) == row.pair);
  }
}

TEST_CASE("the counts of every predicate of the default scene, by stage and residency") {
  CHECK(default_kernels(want::made_of_signs).size() == std::size(predicates));
  for (const predicate_row &row : predicates) {
    INFO(row.name);
    const lower::predicate &p = default_kernel(row.name).decision;
    CHECK(row_of(p.reject) == row.reject);
    CHECK(row_of(p.common) == row.common);
    CHECK(row_of(p.rare) == row.rare);
  }
}

TEST_CASE("the counts of every blade's makers") {
  const lower::model &m = *default_scene().model;
  std::size_t row = 0;
  for (const lang::kind &k : m.spec().kinds)
    for (const lower::blade_maker &maker : lower::makers(m, k)) {
      REQUIRE(row < std::size(made));
      INFO(k.name << ' ' << maker.name);
      CHECK(k.name == made[row].kind);
      CHECK(maker.name == made[row].constructor);
      CHECK(all(maker.code) == made[row].count);
      ++row;
    }
  CHECK(row == std::size(made));
}

TEST_CASE("B costs no more than the structural table") {
  for (const limit_row &row : structural) {
    INFO(row.name);
    const ops have = all(default_kernel(row.name).value.from_blades);
    CHECK((within(have, row.limit) ? row.limit : have) == row.limit);
  }
}

TEST_CASE("circle-circle B squared beats 35/29") {
  const lower::formula &f = default_kernel("norm2_meet_circle_circle").value;
  CHECK(within(all(f.from_blades), {34, 28}));
  CHECK(within(pair_of(f.from_stored), {34, 28}));
}

TEST_CASE("B squared against the best known, as documented") {
  for (const best_row &row : best) {
    INFO(row.name);
    const ops have = pair_of(default_kernel(row.name).value.from_stored);
    CHECK(within(have, row.best) == row.met);
  }
}

TEST_CASE("triangle-triangle shares its signs: 6 + 9, of degree 3") {
  const lower::predicate &p = default_kernel("triangle_triangle").decision;
  CHECK(p.reject.atoms.size() == 6);
  CHECK(p.common.atoms.size() == 9);
  CHECK(default_bounds("triangle_triangle").reject.degree == 3);
  CHECK(default_bounds("triangle_triangle").common.degree == 3);
  CHECK(default_bounds("ball_triangle").common.degree == 6);
}

TEST_CASE("fusing changes no count but the number of instructions") {
  for (const lower::kernel *k : default_kernels(want::formulas)) {
    INFO(k->asked.text);
    const ir::program &p = k->value.from_blades;
    CHECK(all(passes::fuse(p)) == all(p));
  }
}
