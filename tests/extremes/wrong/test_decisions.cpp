// Wrong decisions (decisions.toml), each compiled by meetc and put through the same check as the right ones. Judged by
// their own signs they are right on every rung; judged by geometry, each is caught.
#include "tests/extremes/judges/geometry.hpp"

#include "tests/catch.hpp"
#include "tests/extremes/families/families.hpp"
#include "tests/generated/judge/effort.hpp"

#include <fmt/format.h>
#include <wrong/header_only.hpp>
#include <wrong/wrong.hpp>

using namespace meetc::extremes_test;
using meetc::generated_test::effort;

namespace {

struct wrong_decision {
  const char *name, *of; // what it takes itself for
  outcome (*check)(const float *a, const float *b, float side, const int *known);
};

template <class P> outcome check_wrong(const float *a, const float *b, float side, const int *known) {
  return check<P>(a, b, side, known,
                  [](const float *x, const float *y) { return static_cast<int>(meetc::decide_certified<P>(x, y)); });
}
template <class P> wrong_decision make(const char *name, const char *of) {
  return {name, of, check_wrong<P>};
}

const wrong_decision all[] = {
    make<wrong::strict_sides>("strict_sides", "segment_triangle"),
    make<wrong::no_coplanar_case>("no_coplanar_case", "segment_triangle"),
    make<wrong::coplanar_corner_only>("coplanar_corner_only", "segment_triangle"),
    make<wrong::edge_turned>("edge_turned", "segment_triangle"),
    make<wrong::two_axes>("two_axes", "segment_segment"),
    make<wrong::no_overlap>("no_overlap", "segment_segment"),
    make<wrong::no_side_test>("no_side_test", "point_triangle"),
    make<wrong::edges_of_one>("edges_of_one", "triangle_triangle"),
    make<wrong::nested_spheres_touch>("nested_spheres_touch", "sphere_sphere"),
    make<wrong::nested_balls_miss>("nested_balls_miss", "ball_ball"),
    make<wrong::no_ends>("no_ends", "ball_segment"),
    make<wrong::no_walls>("no_walls", "ball_segment"),
    make<wrong::no_edges>("no_edges", "ball_triangle"),
    make<wrong::no_corners>("no_corners", "ball_triangle"),
    make<wrong::inside_is_touching>("inside_is_touching", "sphere_triangle"),
};

} // namespace

TEST_CASE("wrong decisions: no check by signs sees them, and geometry does") {
  for (const wrong_decision &w : all) {
    const subject &s = subject_named(w.of);
    int seen_by_signs = 0, caught = 0, right_caught = 0;
    std::string by;
    for (const family &f : families()) {
      if (!f.applies(s.a, s.b))
        continue;
      random_numbers random(90);
      int here = 0;
      for (int i = 0; i < effort(1000); ++i) {
        const pair_of_rows p = f.make(s.a, s.b, random);
        const float side = box_side(s.a, p.a, s.b, p.b);
        const int known = truth_by_geometry(s, p);
        seen_by_signs += w.check(p.a.data(), p.b.data(), side, nullptr).wrong != 0;
        const unsigned wrong = w.check(p.a.data(), p.b.data(), side, &known).wrong;
        // The decision on true signs is wrong, and so are the certified answers.
        here += (wrong & bit(on_signs)) && (wrong & bit(certified));
        right_caught += s.check(p.a.data(), p.b.data(), side, &known).wrong != 0;
      }
      caught += here;
      if (here > 0)
        by += fmt::format(" {} {}", f.name, here);
    }
    fmt::print("{:<20} for {:<17} is caught by:{}\n", w.name, w.of, by);
    INFO(w.name);
    CHECK(seen_by_signs == 0);
    CHECK(caught > 0);
    CHECK(right_caught == 0);
  }
}
