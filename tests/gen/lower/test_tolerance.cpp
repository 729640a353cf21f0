// The plan for a scene's tolerance: the grid, the widths and the promises, the emitted code, and the refusals.
#include "gen/lower/tolerance.hpp"
#include "tests/catch.hpp"
#include "tests/gen/fixture.hpp"

#include <cmath>
#include <fmt/format.h>

using namespace meetc;
using namespace meetc::compiler_test;

namespace {

constexpr const char *scenes = "scenes/asked.toml";

struct scene_of : spec_copy {
  scene_of(const std::string &kernel, const std::string &lines) : spec_copy({kernel}) {
    replace(scenes, "[scene]\n", "[scene]\n" + lines + "\n");
  }
};

outcome planned(const spec_copy &spec) {
  return run_meetc("plan scenes/asked.toml", spec.folder());
}

lower::tolerance_plan plan_of(const spec_copy &spec) {
  compilation c = load(spec.scene().string());
  compile_all(c);
  return lower::plan_tolerance(*c.model, *c.scene, c.kernels, c.bounds);
}

// The files that a scene emits, by path.
std::map<std::string, std::string> emitted(const spec_copy &spec) {
  compilation c = load(spec.scene().string());
  compile_all(c);
  std::map<std::string, std::string> out;
  for (const target::file &f : emit_all(c))
    if (!f.path.starts_with("meetc/"))
      out.emplace(f.path, f.text);
  return out;
}

} // namespace

TEST_CASE("tolerance: the coarsest grid that keeps it, and integers as wide as the box needs") {
  const lower::tolerance_plan p = plan_of(scene_of("segment_triangle", "tolerance = 1e-5\nbox = 0.5"));
  REQUIRE(p.ways.size() == 1);
  REQUIRE(p.ways[0]);
  CHECK(p.low == -18); // sqrt(3) 2^-18 is 6.6e-6
  CHECK(p.ways[0]->low == -18);
  CHECK(p.ways[0]->bits == 18);
  CHECK(p.ways[0]->width == 64);
  CHECK_FALSE(p.ways[0]->by_distance);
  CHECK(p.ways[0]->moves.get_d() == Approx(std::sqrt(3.0) * 0x1p-18).epsilon(1e-6));
  CHECK(p.ways[0]->moves.get_d() >= std::sqrt(3.0) * 0x1p-18);
  CHECK(p.ways[0]->reach == lower::rational(1, 2));
  // A box that is no multiple of the step is rounded up, as its elements may be.
  const lower::tolerance_plan q = plan_of(scene_of("segment_triangle", "tolerance = 4\nbox = 9"));
  CHECK(q.low == 1);
  CHECK(q.ways[0]->reach == 10);
  CHECK(q.ways[0]->bits == 4); // 10 steps at most
  // No grid is coarser than a float32.
  CHECK(plan_of(scene_of("segment_triangle", "tolerance = 1e300\nbox = 0.5")).low == 127);
  // Finer: 128 bits.
  const lower::tolerance_plan r = plan_of(scene_of("segment_triangle", "tolerance = 1e-9\nbox = 0.5"));
  CHECK(r.ways[0]->width == 128);
  CHECK(r.ways[0]->bits == 31);
}

TEST_CASE("tolerance: a predicate that compares a distance is decided in plain fp32, if its error allows") {
  const scene_of coarse("ball_ball", "tolerance = 1e-4\nbox = 10");
  const lower::tolerance_plan p = plan_of(coarse);
  REQUIRE(p.ways[0]);
  CHECK(p.ways[0]->by_distance);
  CHECK_FALSE(p.low);
  // Five roundings of 2^-24, times the largest distance plus the largest sum of radii.
  CHECK(p.ways[0]->moves.get_d() == Approx(5 * 0x1p-24 * 80).epsilon(0.01));
  const lower::tolerance_plan fine = plan_of(scene_of("ball_ball", "tolerance = 1e-6\nbox = 10"));
  CHECK_FALSE(fine.ways[0]->by_distance);
  CHECK(fine.low);
  // Where squares overflow, integers decide: differences below 2^57 are in range (box_highest in detail/ball_ball_bounds.hpp).
  CHECK(plan_of(scene_of("ball_ball", "tolerance = 1e13\nbox = 7.2e16")).ways[0]->by_distance);
  CHECK_FALSE(plan_of(scene_of("ball_ball", "tolerance = 1e13\nbox = 7.3e16")).ways[0]->by_distance);
  CHECK_FALSE(plan_of(scene_of("ball_ball", "tolerance = 1e30\nbox = 1e34")).ways[0]->by_distance);
  // Another polynomial or another magnitude is no such comparison.
  const scene_of other("ball_ball", "tolerance = 1e-4\nbox = 10");
  other.replace("predicates/round.toml", "4*S.r*T.r) >= 0", "5*S.r*T.r) >= 0");
  CHECK_FALSE(plan_of(other).ways[0]->by_distance);
  // Two surfaces have two signs.
  CHECK_FALSE(plan_of(scene_of("sphere_sphere", "tolerance = 1e-4\nbox = 10")).ways[0]->by_distance);
}

TEST_CASE("tolerance: nothing is emitted that it does not need") {
  const auto tolerant = emitted(scene_of("segment_triangle", "tolerance = 1e-5\nbox = 0.5"));
  const auto certified = emitted(scene_of("segment_triangle", "rungs = ['certified']\nbox = 0.5"));
  std::size_t bytes = 0, bytes_certified = 0;
  for (const auto &[path, text] : tolerant) {
    bytes += text.size();
    INFO(path);
    for (const char *absent : {"bytecode", "box_factor", "certified", "whole_filter", "after_fp32(", "extent_a"})
      CHECK(text.find(absent) == std::string::npos);
    CHECK_FALSE(path.ends_with(".gappa"));
  }
  for (const auto &[path, text] : certified)
    bytes_certified += path.ends_with(".gappa") ? 0 : text.size();
  CHECK(bytes < bytes_certified * 7 / 10);
  const auto balls = emitted(scene_of("ball_ball", "tolerance = 1e-4\nbox = 10"));
  CHECK(balls.count("asked/detail/ball_ball_bounds.hpp") == 0);
  CHECK(balls.at("asked/ball_ball.hpp").find("meetc::by_distance") != std::string::npos);
  // Both, if the scene asks for both.
  const auto both =
      emitted(scene_of("segment_triangle", "tolerance = 1e-5\nbox = 0.5\nrungs = ['certified', 'tolerant']"));
  const std::string &header = both.at("asked/segment_triangle.hpp");
  CHECK(header.find("bool hit(") != std::string::npos);
  CHECK(header.find("bool tolerant(") != std::string::npos);
}

TEST_CASE("tolerance: plan says what decides, and why") {
  outcome o = planned(scene_of("segment_triangle", "tolerance = 1e-5\nbox = 0.5"));
  INFO(o.out << o.err);
  REQUIRE(o.code == 0);
  CHECK(o.out.find("rounded to multiples of 2^-18") != std::string::npos);
  CHECK(o.out.find("fp32 with its bound, then int64") != std::string::npos);
  o = planned(scene_of("segment_triangle", ""));
  CHECK(o.out.find("states no tolerance") != std::string::npos);
  o = planned(scene_of("segment_triangle", "tolerance = 1e-5\nrungs = ['fp32']"));
  CHECK(o.out.find("plain rungs") != std::string::npos);
  CHECK(o.out.find("does not ask for the rung tolerant") != std::string::npos);
  // A predicate that cannot keep the tolerance is certified, if the scene asks for that too.
  o = planned(scene_of("sphere_triangle", "tolerance = 1e-2\nbox = 1\nrungs = ['certified', 'tolerant']"));
  INFO(o.out << o.err);
  CHECK(o.code == 0);
  CHECK(o.out.find("no short move is proved") != std::string::npos);
}

TEST_CASE("tolerance: a missing statement is one line, and nothing is written") {
  struct row {
    const char *kernel, *lines, *message;
  };
  const row rows[] = {
      {"segment_triangle", "tolerance = -1\nbox = 1", "scene.tolerance must be a number above 0"},
      {"segment_triangle", "tolerance = 0\nbox = 1", "scene.tolerance must be a number above 0"},
      {"segment_triangle", "tolerance = inf\nbox = 1", "scene.tolerance must be a number above 0"},
      {"segment_triangle", "tolerance = nan\nbox = 1", "scene.tolerance must be a number above 0"},
      {"segment_triangle", "tolerance = '1'\nbox = 1", "scene.tolerance must be a number above 0"},
      {"segment_triangle", "tolerance = 1e-5",
       "cannot be proved without scene.box, the largest coordinate: for this "
       "tolerance state one of at most"},
      {"segment_triangle", "tolerance = 1e-30\nbox = 1",
       "needs integers of more than 128 bits for a tolerance of 1e-30 "
       "in a box of 1: state a box of at most"},
      {"segment_triangle", "tolerance = 1e-46\nbox = 1", "below the spacing of float32"},
      {"segment_triangle", "rungs = ['tolerant']\nbox = 1", "the rung tolerant needs scene.tolerance"},
      {"sphere_triangle", "tolerance = 1\nbox = 1", "no short move is proved to take an element into a surface"},
      {"side(triangle, point)", "tolerance = 1\nbox = 1", "is one sign, and nothing says which move changes it"},
      {"segment_triangle", "tolerance = 1\nbox = 1\nbackends = ['c']", "carries no answers within a tolerance"},
  };
  // The proof is about predicates that say whether their operands touch.
  const scene_of crossing("segment_triangle", "tolerance = 1e-3\nbox = 1");
  crossing.replace("predicates/flat.toml", "else sp*sq <= 0 and agree(each(e in t.edges: twist(s, e)))",
                   "else sp*sq <= 0");
  CHECK_THAT(planned(crossing).err, contains("since it does not say whether its operands touch"));
  for (const row &r : rows) {
    const scene_of spec(r.kernel, r.lines);
    for (const std::string command : {"plan scenes/asked.toml", "generate scenes/asked.toml -o out"}) {
      if (command.starts_with("plan") && std::string(r.message).find("carries") == 0)
        continue; // nothing is emitted
      const outcome o = run_meetc(command, spec.folder());
      INFO(r.lines << ": " << o.out << o.err);
      CHECK(o.code == 2);
      CHECK(o.out.empty());
      CHECK(o.err.find(r.message) != std::string::npos);
      CHECK_FALSE(fs::exists(spec.folder() / "out"));
    }
  }
}
