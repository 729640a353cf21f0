// Common parts, overlaps and containment against known values, and against distances where these say as much.
#include "gen/oracle/bodies.hpp"
#include "tests/catch.hpp"
#include "tests/gen/oracle/random.hpp"

#include <algorithm>

using namespace meetc::oracle;
using meetc::oracle_test::random_numbers;

namespace {

hull cube(const rational &low, const rational &high) {
  hull h;
  for (int corner = 0; corner < 8; ++corner)
    h.push_back(at(corner & 1 ? high : low, corner & 2 ? high : low, corner & 4 ? high : low));
  return h;
}
body solid(hull points, const rational &pad = 0) {
  return {std::move(points), pad, 3};
}
hull random_hull(random_numbers &r) {
  hull h;
  for (int n = r.integer(1, 3); n > 0; --n)
    h.push_back(at(r.integer(0, 4), r.integer(0, 4), r.integer(0, 4)));
  return h;
}

} // namespace

TEST_CASE("the common part of two hulls is the hull of its points") {
  const hull t = {at(0, 0), at(4, 0), at(0, 4)};
  CHECK(common_part(t, {at(1, 1, -1), at(1, 1, 1)}) == std::vector<point>{at(1, 1)});
  CHECK(common_part(t, {at(3, 3)}).empty());
  CHECK(meets_beyond(t, {at(0, 0), at(0, 0, 5)}, {at(0, 0)}) == false);
  CHECK(meets_beyond(t, {at(0, 0), at(1, 1)}, {at(0, 0)}));
  CHECK(meets_beyond(t, {at(0, 0), at(4, 0), at(0, -4)}, {at(0, 0), at(4, 0)}) == false);
  CHECK(meets_beyond(t, {at(0, 0), at(4, 0), at(5, 5)}, {at(0, 0), at(4, 0)}));
  random_numbers r(3);
  for (int i = 0; i < 2000; ++i) {
    const hull a = random_hull(r), b = random_hull(r);
    const std::vector<point> common = common_part(a, b);
    CHECK(common.empty() == (squared_distance(a, b) != 0));
    for (const point &p : common) // each lies in both, and the order does not matter
      CHECK((squared_distance({p}, a) == 0 && squared_distance({p}, b) == 0 &&
             squared_distance({p}, common_part(b, a)) == 0));
    for (const hull *const h : {&a, &b}) // a corner that lies in the other is in the hull of these points
      for (const point &p : *h)
        if (squared_distance({p}, h == &a ? b : a) == 0)
          CHECK(squared_distance({p}, common) == 0);
  }
}

TEST_CASE("bodies overlap if no short translation parts them") {
  CHECK(overlaps(solid(cube(0, 2)), solid(cube(1, 3))));
  CHECK_FALSE(overlaps(solid(cube(0, 2)), solid(cube(2, 3))));
  CHECK(overlaps(solid(cube(0, 2)), solid({at(1, 1, 1)})));
  CHECK_FALSE(overlaps(solid(cube(0, 2)), solid({at(1, 1, 2)})));
  CHECK(overlaps(solid({at(0, 0)}, 2), solid({at(3, 0)}, 2)));
  CHECK_FALSE(overlaps(solid({at(0, 0)}, 2), solid({at(4, 0)}, 2)));
  CHECK_FALSE(overlaps(solid({at(0, 0)}), solid({at(0, 0)})));
  const hull t = {at(0, 0), at(4, 0), at(0, 4)};
  CHECK(overlaps(solid(t), solid({at(1, 1, -1), at(1, 1, 1)})));
  CHECK_FALSE(overlaps(solid(t), solid({at(1, 1), at(1, 1, 1)})));
  CHECK_FALSE(overlaps(solid(t), solid({at(0, 1, -1), at(0, 1, 1)})));
  CHECK_FALSE(overlaps(solid(t), solid(t)));
  CHECK(overlaps({t, 0, 2}, {t, 0, 2}));
  CHECK_FALSE(overlaps({t, 0, 2}, {{at(2, 2), at(4, 4)}, 0, 2}));
}

TEST_CASE("a body contains another if it holds all of it") {
  CHECK(contains(solid(cube(0, 2)), solid(cube(0, 2))));
  CHECK(contains(solid(cube(0, 2)), solid({at(1, 1, 1)}, 1)));
  CHECK_FALSE(contains(solid(cube(0, 2)), solid({at(1, 1, 1)}, rational(9, 8))));
  CHECK_FALSE(contains(solid(cube(0, 2)), solid({at(3, 1, 1)}, rational(1, 8))));
  CHECK(contains(solid({at(0, 0)}, 3), solid({at(1, 0)}, 2)));
  CHECK_FALSE(contains(solid({at(1, 0)}, 2), solid({at(0, 0)}, 3)));
  CHECK_FALSE(contains(solid({at(0, 0), at(4, 0), at(0, 4)}), solid({at(1, 1)}, rational(1, 8))));
  CHECK(contains({{at(0, 0), at(4, 0), at(0, 4)}, 0, 2}, {{at(1, 1)}, 1, 2}));
  CHECK_FALSE(contains({{at(0, 0), at(4, 0), at(0, 4)}, 0, 2}, {{at(1, 1)}, rational(9, 8), 2}));
}
