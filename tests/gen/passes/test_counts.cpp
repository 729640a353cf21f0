// Exact operation counts: the counts that the compiler reaches, and the limits that it must keep.
//
// A count is {multiplications, additions}. A fused multiply-add counts as one of each. Negations, duals and products
// with powers of two are free (except those that a fusion has absorbed, so counts here are never too small).
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include "gen/bound/growth.hpp"
#include "gen/passes/fuse.hpp"
#include "gen/verify/verify.hpp"

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

// On blades; from stored numbers; and, where objects store what each alone decides: for an object A, for an object B, and
// for the pair.
struct formula_row {
  const char *name;
  ops blades, stored, a, b, pair;
};
const formula_row formulas[] = {
    {"meet_plane_line", {12, 8}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_plane_line", {4, 2}, {4, 5}, {0, 0}, {0, 3}, {4, 2}},
    {"meet_sphere_line", {18, 8}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_line", {20, 14}, {12, 14}, {1, 0}, {3, 5}, {8, 9}},
    {"meet_plane_plane", {12, 6}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_plane_plane", {9, 5}, {9, 5}, {3, 2}, {3, 2}, {5, 3}},
    {"meet_sphere_plane", {16, 6}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_plane", {13, 9}, {9, 6}, {1, 0}, {3, 2}, {5, 4}},
    {"meet_sphere_sphere", {20, 10}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_sphere_sphere", {15, 11}, {6, 9}, {1, 0}, {1, 0}, {5, 8}},
    {"meet_line_line", {6, 5}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_line_line", {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"meet_circle_line", {18, 13}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_line", {22, 16}, {18, 16}, {1, 0}, {0, 3}, {17, 13}},
    {"meet_circle_circle", {30, 25}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_circle", {34, 28}, {33, 23}, {4, 2}, {4, 2}, {25, 19}},
    {"meet_circle_plane", {24, 14}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_plane", {31, 20}, {18, 11}, {4, 2}, {3, 2}, {11, 7}},
    {"meet_circle_sphere", {30, 20}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_circle_sphere", {37, 26}, {16, 13}, {4, 2}, {1, 0}, {11, 11}},
    {"meet_point_pair_line", {6, 5}, {9, 14}, {0, 3}, {0, 3}, {9, 8}},
    {"norm2_meet_point_pair_line", {7, 5}, {10, 14}, {0, 3}, {0, 3}, {10, 8}},
    {"meet_point_pair_circle", {10, 9}, {18, 19}, {3, 5}, {1, 0}, {14, 14}},
    {"norm2_meet_point_pair_circle", {11, 9}, {19, 19}, {3, 5}, {1, 0}, {15, 14}},
    {"meet_point_pair_plane", {16, 11}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_point_pair_plane", {20, 14}, {11, 11}, {3, 5}, {0, 0}, {8, 6}},
    {"meet_point_pair_sphere", {20, 15}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    {"norm2_meet_point_pair_sphere", {24, 18}, {12, 17}, {3, 5}, {1, 0}, {8, 12}},
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
    {"box_box", none, {6, {0, 0}, {0, 0}, {0, 6}}, none},
    {"first_met_segment_triangle_pair", none, {3, {0, 3}, {30, 44}, {27, 23}}, none},
};

struct maker_row {
  const char *kind, *constructor;
  ops count;
};
const maker_row made[] = {
    {"point", "", {3, 2}},        {"direction", "", {0, 0}},
    {"point_pair", "", {18, 14}}, {"flat_point", "", {0, 0}},
    {"line", "", {6, 6}},         {"line", "direction", {6, 3}},
    {"circle", "", {19, 11}},     {"circle", "points", {45, 36}},
    {"plane", "", {0, 0}},        {"plane", "points", {15, 14}},
    {"sphere", "", {4, 3}},       {"sphere", "points", {64, 53}},
    {"segment", "", {6, 6}},      {"triangle", "", {15, 14}},
    {"box", "", {18, 14}},        {"triangle_pair", "", {156, 143}},
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

// B² of the twelve pairs: the best counts found by hand, from the best stored representation of each operand (centre,
// normal or direction, radius, and their squares), and the cost of a pair here when its objects store their own values.
// The best of the last two rows leave out the factor |p - q|², since only a sign is wanted. Here the sign takes two signs,
// whose product needs no arithmetic.
struct best_row {
  const char *name;
  ops best, have;
  bool as_sign = false;
};
const best_row best[] = {
    {"norm2_meet_plane_line", {4, 2}, {4, 2}},
    {"norm2_meet_plane_plane", {5, 3}, {5, 3}},
    {"norm2_meet_line_line", {0, 0}, {0, 0}},
    {"norm2_meet_sphere_line", {8, 9}, {8, 9}},
    {"norm2_meet_sphere_plane", {5, 4}, {5, 4}},
    {"norm2_meet_sphere_sphere", {6, 9}, {5, 8}},
    {"norm2_meet_circle_plane", {11, 7}, {11, 7}},
    {"norm2_meet_circle_sphere", {12, 11}, {11, 11}},
    {"norm2_meet_circle_line", {17, 13}, {17, 13}},
    {"norm2_meet_circle_circle", {35, 29}, {25, 19}},
    {"sign_norm2_meet_point_pair_plane", {7, 6}, {6, 6}, true},
    {"sign_norm2_meet_point_pair_sphere", {7, 12}, {6, 12}, true},
};

// The signs of B² of the scene criteria.toml: signs taken, and operations for an object A, for an object B and for a pair.
// Their forms are those with the least bound, so a row may cost more than the formula's.
struct criterion_row {
  const char *name;
  stage_row common;
};
const criterion_row criteria_rows[] = {
    {"sign_norm2_meet_plane_line", {1, {0, 0}, {0, 3}, {3, 2}}},
    {"sign_norm2_meet_plane_plane", {1, {0, 0}, {0, 0}, {9, 5}}},
    {"sign_norm2_meet_line_line", none},
    {"sign_norm2_meet_sphere_line", {1, {1, 0}, {3, 5}, {10, 9}}},
    {"sign_norm2_meet_sphere_plane", {1, {1, 0}, {4, 2}, {5, 5}}},
    {"sign_norm2_meet_sphere_sphere", {2, {0, 0}, {0, 0}, {5, 9}}},
    {"sign_norm2_meet_circle_plane", {1, {4, 2}, {1, 0}, {15, 10}}},
    {"sign_norm2_meet_circle_sphere", {1, {4, 2}, {1, 0}, {14, 13}}},
    {"sign_norm2_meet_circle_line", {1, {1, 0}, {3, 5}, {17, 14}}},
    {"sign_norm2_meet_circle_circle", {1, {4, 2}, {4, 2}, {36, 27}}},
    {"sign_norm2_meet_point_pair_plane", {2, {0, 0}, {0, 0}, {6, 6}}},
    {"sign_norm2_meet_point_pair_sphere", {2, {0, 0}, {1, 0}, {6, 12}}},
};

const compilation &criteria() {
  static const compilation compiled = [] {
    compilation c = load((source_folder() / "algebra_spec" / "scenes" / "criteria.toml").string());
    compile_all(c);
    return c;
  }();
  return compiled;
}
const lower::kernel &criterion(const std::string &name) {
  for (const lower::kernel &k : criteria().kernels)
    if (k.asked.name() == name)
      return k;
  throw std::logic_error("criteria.toml has no " + name);
}

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
    // The emitted functions leave nothing of one object for the pair.
    CHECK(plain(ir::count_object(f.for_pairs, residency::a)) == row.a);
    CHECK(plain(ir::count_object(f.for_pairs, residency::b)) == row.b);
    CHECK(plain(ir::count_pair(f.for_pairs)) == row.pair);
    CHECK(pair_of(f.for_pairs) == row.pair);
    CHECK(f.for_pairs.results.empty() == (row.a == ops{0, 0} && row.b == ops{0, 0}));
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

TEST_CASE("B squared of all twelve pairs costs at most the best count by hand, and is right") {
  for (const best_row &row : best) {
    INFO(row.name);
    const lower::kernel &k = row.as_sign ? criterion(row.name) : default_kernel(row.name);
    const ops have = row.as_sign ? pair_of(k.decision.common.code) : plain(ir::count_pair(k.value.for_pairs));
    CHECK(have == row.have);
    CHECK(within(have, row.best));
    // Against the dense product, in rationals.
    const lower::model &m = row.as_sign ? *criteria().model : *default_scene().model;
    const verify::report r = row.as_sign ? verify::verify_sign(m, k, 300, 1) : verify::verify_formula(m, k, 40, 1);
    CHECK(r.cases > 30);
    CHECK(r.wrong == 0);
  }
}

TEST_CASE("the counts of the signs of B squared") {
  CHECK(criteria().kernels.size() == std::size(criteria_rows));
  for (const criterion_row &row : criteria_rows) {
    INFO(row.name);
    const lower::kernel &k = criterion(row.name);
    CHECK(row_of(k.decision.common) == row.common);
    CHECK(verify::verify_sign(*criteria().model, k, 300, 2).wrong == 0);
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
