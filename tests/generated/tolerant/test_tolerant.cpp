// The rung tolerant, compiled: no answer is farther from right than it promises, and sets that it does not fit are refused.
#include "tests/catch.hpp"
#include "tests/generated/judge/effort.hpp"
#include "tests/generated/tolerant/campaign.hpp"

#include "meet/core/cascade/cascade.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/query/pairs.hpp"

#include <both/both_runtime.hpp>
#include <cfenv>
#include <cga/cga_runtime.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <probe/probe_runtime.hpp>
#include <probe/segment_triangle.hpp>
#include <spheres/spheres_runtime.hpp>
#include <tolerant/tolerant.hpp>
#include <tolerant/tolerant_runtime.hpp>

using namespace meetc;
using namespace meetc::tolerant_test;

namespace {

prepared prepare_rows(const kind_info &kind, const std::vector<float> &rows, double grid) {
  view v;
  v.data = rows.data();
  v.stride_bytes = static_cast<std::size_t>(kind.fields) * sizeof(float);
  v.elements = rows.size() / static_cast<std::size_t>(kind.fields);
  pose at;
  at.grid = grid;
  return prepare(v, kind, at, 1);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const result &r) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const index_pair &p : r.pairs)
    out.emplace_back(p.a, p.b);
  return out;
}

std::vector<float> rounded(const kind_info &kind, std::vector<float> rows, double grid) {
  pose at;
  at.grid = grid;
  for (std::size_t i = 0; i < rows.size(); i += static_cast<std::size_t>(kind.fields))
    move_rows(kind, at, rows.data() + i, 1);
  return rows;
}

} // namespace

TEST_CASE("no tolerant answer is farther from right than its rung promises, and the promise is not much too large") {
  double nearest_to_promise = 0;
  std::uint64_t differing = 0;
  for (const subject &s : subjects())
    for (const family f : families) {
      const tally t = compare(
          *s.tolerant, *s.exact,
          make(*s.exact, f, static_cast<std::size_t>(generated_test::effort(6000)), 11, s.tolerant->tolerance.reach));
      INFO(s.scene << ", " << s.tolerant->name << ", " << name_of(f) << ": " << t.differing << " of " << t.pairs
                   << " differ, the farthest by " << t.farthest);
      CHECK(t.farthest <= s.tolerant->tolerance.moves);
      CHECK(t.pairs > 100);
      if (s.scene == "tolerant")
        nearest_to_promise = std::max(nearest_to_promise, t.farthest / s.tolerant->tolerance.moves),
        differing += t.differing;
    }
  CHECK(differing > 100);
  // A quarter of the promise, or a grid four times as coarse, would be seen.
  CHECK(nearest_to_promise > 0.3);
}

TEST_CASE("rounding: the nearest multiple, of two the even one") {
  CHECK(nearest_multiple(0.3F, -2) == 0.25F);
  CHECK(nearest_multiple(-0.3F, -2) == -0.25F);
  CHECK(nearest_multiple(0.375F, -2) == 0.5F);
  CHECK(nearest_multiple(0.125F, -2) == 0);
  CHECK(std::signbit(nearest_multiple(-0.125F, -2)));
  CHECK(nearest_multiple(3, 3) == 0);
  CHECK(nearest_multiple(4.5F, 3) == 8);
  CHECK(nearest_multiple(0x1p-149F, -148) == 0);
  CHECK(nearest_multiple(0x3p-149F, -148) == 0x1p-147F);
  CHECK(nearest_multiple(0x1.fffffep127F, 127) == std::numeric_limits<float>::infinity());
  std::uint32_t word = 12345;
  for (int i = 0; i < 200'000; ++i) {
    word = word * 1664525U + 1013904223U;
    float v;
    std::memcpy(&v, &word, sizeof v);
    if (!std::isfinite(v))
      continue;
    const int low = static_cast<int>(word >> 11 & 0xff) - 145;
    const double in_steps = std::nearbyint(std::ldexp(static_cast<double>(v), -low));
    REQUIRE(nearest_multiple(v, low) == static_cast<float>(std::ldexp(in_steps, low)));
  }
}

TEST_CASE("a call on two operands answers as a set of one, in any rounding direction") {
  const predicate_info &p = find_predicate(probe::catalogue(), "segment_triangle");
  const predicate_info &exact = find_predicate(cga::catalogue(), "segment_triangle");
  const rows r = make(exact, family::near, 3000, 5, p.tolerance.reach);
  const std::vector<answer> truth = tolerant_answers(p, r);
  for (const int direction : {FE_TONEAREST, FE_UPWARD, FE_TOWARDZERO}) {
    std::fesetround(direction);
    std::size_t different = 0;
    for (std::size_t i = 0; i < r.count; ++i) {
      const float *const a = r.a.data() + 6 * i, *const b = r.b.data() + 9 * i;
      const probe::segment<float> s{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
      const probe::triangle<float> t{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, {b[6], b[7], b[8]}};
      different += probe::segment_triangle::tolerant(s, t) != (truth[i] == answer::yes);
    }
    std::fesetround(FE_TONEAREST);
    INFO(direction);
    CHECK(different == 0);
  }
}

TEST_CASE("sets: the answers are the exact ones of the rounded numbers, by a call that owns memory and by one that "
          "does not") {
  for (const subject &s : subjects()) {
    const predicate_info &p = *s.tolerant, &exact = *s.exact;
    const rows r = make(exact, family::near, 300, 21, p.tolerance.reach);
    const double step = p.tolerance.step;
    const auto found = collide(prepare_rows(*p.a, r.a, step), prepare_rows(*p.b, r.b, step), p, rung::tolerant);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> truth;
    if (p.tolerance.rounds) {
      truth = pairs_of(collide(prepare_rows(*exact.a, rounded(*p.a, r.a, step), 0),
                               prepare_rows(*exact.b, rounded(*p.b, r.b, step), 0), exact, rung::certified));
    } else {
      truth =
          pairs_of(collide(prepare_rows(*exact.a, r.a, step), prepare_rows(*exact.b, r.b, step), exact, rung::fp32));
    }
    INFO(s.scene << ", " << p.name);
    CHECK(truth.size() > 20);
    CHECK(pairs_of(found) == truth);
  }
}

TEST_CASE("sets that are not on the grid, or leave the box, are refused") {
  const predicate_info &p = find_predicate(probe::catalogue(), "segment_triangle");
  CHECK(p.tolerance.step == 0x1p-18);
  CHECK(p.tolerance.reach == 0.5);
  CHECK(p.tolerance.moves <= 1e-5);
  CHECK(cascade(p, rung::certified).count == 0);
  const std::vector<float> segment{0, 0, 0, 0.5F, 0, 0},
      triangle{0.25F, -0.5F, -0.5F, 0.25F, 0.5F, -0.5F, 0.25F, 0, 0.5F},
      outside{0.25F, -0.5F, -0.5F, 0.25F, 0.500002F, -0.5F, 0.25F, 0, 0.5F};
  const auto collided = [&p](const std::vector<float> &a, double grid_a, const std::vector<float> &b, double grid_b) {
    return collide(prepare_rows(*p.a, a, grid_a), prepare_rows(*p.b, b, grid_b), p, rung::tolerant).count;
  };
  const double step = p.tolerance.step;
  CHECK(collided(segment, step, triangle, step) == 1);
  CHECK_THROWS_WITH(collided(segment, 2 * step, triangle, step), test::contains("poses have its grid")); // coarser
  CHECK_THROWS_WITH(collided(segment, 0, triangle, step), test::contains("poses have its grid"));
  CHECK_THROWS_WITH(collided(segment, step, triangle, step / 2), test::contains("poses have its grid"));
  CHECK_THROWS_WITH(collided(segment, step, outside, step), test::contains("leaves the box"));
  CHECK_THROWS_WITH(prepare_rows(*p.a, segment, 0.3), test::contains("power of two"));
  CHECK_THROWS_WITH(prepare_rows(*p.a, segment, -1), test::contains("power of two"));
  CHECK_THROWS_WITH(collide(prepare_rows(*p.a, segment, step), prepare_rows(*p.b, triangle, step), p, rung::certified),
                    test::contains("not generated for this rung"));
  std::uint64_t count = 0;
  const auto no_memory = [&](const std::vector<float> &b, double grid) {
    const view of_a{segment.data(), 0, 6 * sizeof(float), nullptr, 1}, of_b{b.data(), 0, 9 * sizeof(float), nullptr, 1};
    std::vector<std::byte> work(workspace(p, 1, 1, 1) + 64);
    pose at;
    at.grid = grid;
    pairs_options o;
    o.threads = 1;
    pairs_out out;
    out.count = &count;
    const auto start = reinterpret_cast<std::uintptr_t>(work.data());
    return pairs(p, rung::tolerant, of_a, at, of_b, at, out,
                 {work.data() + (64 - start % 64) % 64, workspace(p, 1, 1, 1)}, o);
  };
  CHECK(no_memory(triangle, step) == status::ok);
  CHECK(count == 1);
  CHECK(no_memory(triangle, 0) == status::not_on_grid);
  CHECK(no_memory(outside, step) == status::left_box);
  CHECK(no_memory(triangle, 3) == status::bad_grid);
}

TEST_CASE("sets that leave the box are decided by certified, if the scene has it, and the report says so") {
  const predicate_info &p = find_predicate(both::catalogue(), "sphere_sphere");
  CHECK(find_predicate(both::catalogue(), "sphere_segment").decide[static_cast<int>(rung::tolerant)] == nullptr);
  CHECK(cascade(find_predicate(both::catalogue(), "sphere_segment"), rung::certified).count > 0);
  const std::vector<float> in{0, 0, 0, 1, 0.5F, 0, 0, 0.125F}, out{3, 0, 0, 2, 1.5F, 0, 0, 2.5F};
  const double step = p.tolerance.step;
  for (const float box : {0.0F, 1.0F, 100.0F}) {
    collide_options o;
    o.box = box;
    const result r = collide(prepare_rows(*p.a, in, step), prepare_rows(*p.b, out, step), p, rung::tolerant, o);
    INFO(box);
    CHECK(pairs_of(r) == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0}, {0, 1}});
    CHECK_FALSE(r.rungs.left_box_a);
    CHECK(r.rungs.left_box_b);
  }
  CHECK_THROWS_WITH(collide(prepare_rows(*p.a, in, 0), prepare_rows(*p.b, out, step), p, rung::tolerant),
                    test::contains("poses have its grid"));
}

TEST_CASE("a call on operands beyond the reach takes the nearest numbers within it") {
  constexpr float big = 3e38F, nan = std::numeric_limits<float>::quiet_NaN(), infinite = HUGE_VALF;
  const probe::triangle<float> t{{0.25F, -0.5F, -0.5F}, {0.25F, 0.5F, -0.5F}, {0.25F, 0, 0.5F}},
      wide{{0.25F, -big, -big}, {0.25F, infinite, -7}, {0.25F, nan, 1e6F}};
  for (const probe::triangle<float> &x : {t, wide}) {
    CHECK(probe::segment_triangle::tolerant({{-big, 0, 0}, {big, 0, 0}}, x));
    CHECK_FALSE(probe::segment_triangle::tolerant({{-big, 0, 0}, {0.125F, 0, 0}}, x));
    CHECK_FALSE(probe::segment_triangle::tolerant({{0.375F, nan, 0}, {infinite, 0, 0}}, x));
  }
}

TEST_CASE("the least motion: known kinds, and none for a surface around more than one point") {
  const auto of = [](const char *name) -> const predicate_info & { return find_predicate(cga::catalogue(), name); };
  CHECK(moved_by_grid(of("triangle_triangle"), 1) == Approx(std::sqrt(3.0)).epsilon(1e-6));
  CHECK(moved_by_grid(of("triangle_triangle"), 1) > std::sqrt(3.0));
  CHECK(moved_by_grid(of("sphere_sphere"), 2) == Approx(2 * std::sqrt(3.0) + 2).epsilon(1e-6));
  CHECK(moved_by_grid(of("sphere_segment"), 1) == 0);
  CHECK(moved_by_grid(of("sphere_triangle"), 1) == 0);
  CHECK(grid_within(of("triangle_triangle"), 1e-5) == 0x1p-18);
  CHECK(grid_within(of("triangle_triangle"), 0) == 0);
  CHECK(grid_within(of("sphere_triangle"), 1) == 0);
  CHECK(grid_within(of("triangle_triangle"), 1e-46) == 0);
  for (int e = -140; e < 120; e += 7)
    for (const double share : {1.0, 1.5, 1.7320508, 1.7320511, 1.9999}) {
      const double tolerance = std::ldexp(share, e), grid = grid_within(of("segment_triangle"), tolerance);
      CHECK(moved_by_grid(of("segment_triangle"), grid) <= tolerance);
      CHECK(moved_by_grid(of("segment_triangle"), 2 * grid) > tolerance);
    }
}

// Both ends on the sphere around the middle: rounding takes them in, and no short move does. Such predicates keep no
// tolerance.
TEST_CASE("a surface around a segment: rounding may change an answer that no short move changes") {
  const predicate_info &p = find_predicate(cga::catalogue(), "sphere_segment");
  const auto touches = [&p](const std::vector<float> &a, const std::vector<float> &b) {
    const index_pair pair{0, 0};
    answer out{};
    p.decide[static_cast<int>(rung::exact)](a.data(), b.data(), &pair, 1, &out);
    return out == answer::yes;
  };
  const std::vector<float> sphere{0, 0, 0, 0.875F}, segment{-0.875F, 0, 0, 0.875F, 0, 0};
  CHECK(touches(sphere, segment));
  // One unit of rounding takes both ends in.
  const std::vector<float> inside{-0.87499994F, 0, 0, 0.87499994F, 0, 0};
  CHECK_FALSE(touches(sphere, inside));
  for (int direction = 0; direction < 64; ++direction) {
    const float x = std::cos(static_cast<float>(direction)), y = std::sin(static_cast<float>(direction)), by = 0.25F;
    CHECK(touches(sphere, {-0.875F + by * x, by * y, 0, 0.875F + by * x, by * y, 0}));
  }
}
