// The base of `meet trade`: distances from being right, pairs near a contact, and proved distances.
#include "tests/catch.hpp"

#include "meet/bench/baselines/paper_way.hpp"
#include "meet/bench/tables/trade/cells.hpp"
#include "meet/bench/tables/trade/maps.hpp"
#include "meet/bench/tables/trade/tables.hpp"
#include "meet/bench/truth/distance.hpp"
#include "meet/bench/truth/numbers.hpp"
#include "meet/bench/truth/proved_distance.hpp"
#include "meet/core/query/find.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace meetc;
using namespace meetc::bench;

namespace {

const predicate_info &named(const char *name) {
  return find_predicate(cga::catalogue(), name);
}

double change(const char *predicate, const std::vector<float> &a, const std::vector<float> &b, bool touch) {
  return distance_from_change(named(predicate), a.data(), b.data(), touch);
}

bool touches(const predicate_info &p, const std::vector<float> &a, const std::vector<float> &b) {
  const index_pair pair{0, 0};
  answer out{};
  p.decide[static_cast<int>(rung::exact)](a.data(), b.data(), &pair, 1, &out);
  return out == answer::yes;
}

// The element, moved, with lengths as they are.
std::vector<float> moved(const kind_info &kind, std::vector<float> row, const double (&by)[3]) {
  for (int p = 0; p < kind.hull; ++p)
    for (int k = 0; k < 3; ++k) {
      float &x = row[static_cast<std::size_t>(kind.hull_fields[3 * p + k])];
      x = static_cast<float>(static_cast<double>(x) + by[k]);
    }
  return row;
}

std::vector<float> row(const std::vector<float> &rows, const kind_info &kind, std::size_t i) {
  const auto n = static_cast<std::ptrdiff_t>(kind.fields), from = static_cast<std::ptrdiff_t>(i) * n;
  return {rows.begin() + from, rows.begin() + from + n};
}

// Elements that are so thin that they touch in places without an inside: no random motion makes them touch.
bool are_thin(const predicate_info &p) {
  return p.a->pad < 0 && p.b->pad < 0 && p.a->hull + p.b->hull < 5;
}

std::size_t different(const std::vector<answer> &x, const std::vector<answer> &y) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    n += x[i] != y[i];
  return n;
}

} // namespace

TEST_CASE("distance: known lengths") {
  const std::vector<float> flat{0, 0, 0, 4, 0, 0, 0, 4, 0}, above{1, 1, 0.5F, 9, 1, 7, 1, 9, 7};
  CHECK(change("triangle_triangle", flat, above, false) == Approx(0.5));
  const std::vector<float> below{1, 1, -0.25F, 9, 1, 7, 1, 9, 7};
  CHECK(change("triangle_triangle", flat, below, true) == Approx(0.25));
  CHECK(change("triangle_triangle", flat, flat, true) == 0); // any motion along the normal parts them
  CHECK(change("segment_triangle", {1, 1, -3, 1, 1, 2}, flat, true) == Approx(1)); // an edge is nearer than an end
  CHECK(change("segment_triangle", {-3, 0, 1, -3, 0, 9}, flat, false) == Approx(std::sqrt(10.0)));
  CHECK(change("segment_segment", {0, 0, 0, 2, 0, 0}, {1, 1, 5, 1, -1, 5}, false) == Approx(5));
  CHECK(change("point_triangle", {1, 1, 0}, flat, true) == 0);
  const std::vector<float> ball{0, 0, 0, 2};
  CHECK(change("ball_ball", ball, {5, 0, 0, 2}, false) == Approx(1));
  CHECK(change("ball_ball", ball, {1, 0, 0, 2}, true) == Approx(3));
  CHECK(change("sphere_sphere", ball, {0.25F, 0, 0, 1}, false) == Approx(0.75)); // nested
  CHECK(change("sphere_sphere", ball, {1.5F, 0, 0, 1}, true) == Approx(0.5));    // until it is nested
  CHECK(change("sphere_sphere", ball, {0.25F, 0, 0, 2}, true) == Approx(3.75));  // as large, so never nested
  CHECK(change("sphere_sphere", ball, ball, true) == Approx(4));
  CHECK(change("ball_triangle", ball, {1, -9, -9, 1, 9, -9, 1, 0, 9}, true) == Approx(1));
  CHECK(change("ball_segment", ball, {3, -1, 0, 3, 1, 0}, false) == Approx(1));
  CHECK(change("sphere_segment", ball, {0, 0, 0, 1.25F, 0, 0}, false) == Approx(0.75)); // within the surface
}

TEST_CASE("distance: tiny lengths keep their digits") {
  constexpr float tiny = 0x1p-70F;
  const std::vector<float> flat{0, 0, 0, 4, 0, 0, 0, 4, 0}, above{1, 1, tiny, 9, 1, 7, 1, 9, 7};
  CHECK(change("triangle_triangle", flat, above, false) == Approx(static_cast<double>(tiny)));
  CHECK(change("ball_ball", {0, 0, 0, 1}, {1 + 0x1p-20F, 0, 0, 0x1p-60F}, false) == Approx(0x1p-20).epsilon(1e-9));
  CHECK(change("ball_ball", {1e30F, 0, 0, 1e29F}, {1e30F, 3e29F, 0, 1e29F}, false) == Approx(1e29).epsilon(1e-6));
  CHECK(change("ball_ball", {0, 0, 0, 0x1p-140F}, {0x1p-138F, 0, 0, 0x1p-140F}, false) ==
        Approx(0x1p-139).epsilon(1e-9));
}

TEST_CASE("distance: a length that doubles cannot hold, and corners on one line") {
  // [r, s, t] = 1 for three rows of coordinates, so -t/4 lies 1 / (4 |r x s|) above the plane of r, s and -(r + s).
  const double r[] = {36569, 5957284, 600211}, s[] = {-10110, 2276334, 232673}, t[] = {39676, 6450463, 649889};
  std::vector<float> triangle, point;
  for (const double *corner : {r, s})
    for (int k = 0; k < 3; ++k)
      triangle.push_back(static_cast<float>(corner[k]));
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    triangle.push_back(static_cast<float>(-(r[k] + s[k])));
    point.push_back(static_cast<float>(-t[k] / 4));
    const double n = r[(k + 1) % 3] * s[(k + 2) % 3] - r[(k + 2) % 3] * s[(k + 1) % 3];
    square += n * n;
  }
  CHECK(change("point_triangle", point, triangle, false) == Approx(0.25 / std::sqrt(square)).epsilon(1e-9));
  // Corners of very different size on one line through the origin: the ball is left sideways, not lengthwise.
  const std::vector<float> ball{0x1.d1ba9p-3F, -0x1.daaffp-3F, -0x1.9417acp-3F, 1},
      line{-0x1.eb4p0F,    -0x1.d38p0F,      -0x1.a4cp0F,      0x1.f101cp-48F,  0x1.d8fa8p-48F,
           0x1.a9ae4p-48F, -0x1.9541dcp-74F, -0x1.81aa28p-74F, -0x1.5b1924p-74F};
  CHECK(change("ball_triangle", ball, line, true) < 0.7);
  CHECK(change("ball_triangle", ball, line, true) > 0.6);
}

TEST_CASE("wrong answers are counted, and the farthest counts") {
  const predicate_info &p = named("ball_ball");
  element_pairs pairs{&p, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {3, 0, 0, 1, 2.5F, 0, 0, 1, 1.5F, 0, 0, 1}, 3};
  const std::vector<answer> exact = decide_all(pairs, p.decide[static_cast<int>(rung::exact)]);
  REQUIRE(exact == std::vector<answer>{answer::no, answer::no, answer::yes});
  const trade_method method{"mine", {}, rung::fp32};
  const wrongness all = wrongness_of(pairs, method, {answer::yes, answer::yes, answer::no}, exact);
  CHECK(all.differs.extra == 2);
  CHECK(all.differs.missed == 1);
  CHECK(all.farthest == Approx(1));
  CHECK(all.farthest_in_ulps == Approx(0x1p22)); // of 3
  REQUIRE(all.proved);
  CHECK(*all.proved > 0);
  const wrongness none = wrongness_of(pairs, method, exact, exact);
  CHECK(none.differs.wrong() == 0);
  CHECK(none.farthest == 0);
}

TEST_CASE("losers: methods slower everywhere and never less wrong, and never wrong loses to never wrong alone") {
  const predicate_info &p = named("ball_ball");
  const auto cell = [&p](const char *family, double fp32, double fp64, double fp64x2, double exact, double certified,
                         std::uint64_t wrong32) {
    trade_cell c{&p, family, family, 1, 10, {}};
    const double seconds[] = {fp32, fp64, fp64x2, exact, certified};
    for (const trade_method &m : methods_of(p)) {
      trade_point point{m, seconds[static_cast<int>(*m.precision)]};
      point.wrong.differs.missed = m.precision == rung::fp32 ? wrong32 : 0;
      c.result.points.push_back(point);
    }
    return c;
  };
  const table t = table_of_losers({cell("one", 1, 2, 5, 6, 3, 4), cell("two", 1, 2, 5, 6, 3, 0)});
  std::vector<std::string> lines;
  for (const auto &row : t.rows)
    lines.push_back(row[1].text + ": " + row[2].text);
  // fp32 is faster than all, and more often wrong in one family.
  CHECK(lines == std::vector<std::string>{"fp64x2: fp64, certified", "exact: certified"});
}

// The exact rung says whether a translation changes the answer. None that is shorter may do so.
TEST_CASE("distance: no shorter translation changes the answer") {
  for (const char *name : {"triangle_triangle", "segment_triangle", "segment_segment", "ball_ball", "sphere_sphere",
                           "ball_segment", "ball_triangle", "sphere_segment", "sphere_triangle"}) {
    const predicate_info &p = named(name);
    const element_pairs pairs = make_pairs(p, 60, {}, 5);
    numbers from(7);
    std::size_t changed_by_more = 0, tried = 0;
    for (std::size_t i = 0; i < pairs.count; ++i) {
      const std::vector<float> a = row(pairs.a, *p.a, i), b = row(pairs.b, *p.b, i);
      const bool touch = touches(p, a, b);
      const double length = distance_from_change(p, a.data(), b.data(), touch);
      for (int direction = 0; direction < 60; ++direction) {
        const double d[] = {static_cast<double>(from.place()), static_cast<double>(from.place()),
                            static_cast<double>(from.place())};
        const double norm = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const auto by = [&](double share) {
          const double s = share * length / norm;
          return touches(p, a, moved(*p.b, b, {s * d[0], s * d[1], s * d[2]}));
        };
        INFO(name << ", pair " << i);
        if (length > 1e-3)
          REQUIRE(by(0.999) == touch);
        ++tried;
        changed_by_more += by(1.2) != touch;
      }
    }
    INFO(name << ": " << changed_by_more << " of " << tried);
    CHECK((are_thin(p) || changed_by_more > tried / 200)); // so the length is not much too short either
  }
}

TEST_CASE("pairs near a contact are near it, on both sides") {
  for (int i = 0; i < cga::catalogue().predicate_count; ++i) {
    const predicate_info &p = cga::catalogue().predicates[i];
    if (!can_make_pairs(p)) {
      CHECK(std::string(p.name) == "box_box"); // its hull has more points than a distance is computed for
      continue;
    }
    for (const int bits : {3, 12, 20}) {
      const element_pairs pairs = make_pairs(p, 300, {0, 0, true, bits, bits}, 3);
      const std::vector<answer> exact = decide_all(pairs, p.decide[static_cast<int>(rung::exact)]);
      const auto hits = std::count(exact.begin(), exact.end(), answer::yes);
      INFO(p.name << ", " << bits << " bits: " << hits << " hits");
      CHECK((are_thin(p) || hits > 20));
      CHECK(hits < 240);
      for (std::size_t k = 0; k < pairs.count; ++k)
        REQUIRE(distance_from_change(p, row(pairs.a, *p.a, k).data(), row(pairs.b, *p.b, k).data(),
                                     exact[k] == answer::yes) <= std::ldexp(2.0, -bits));
    }
  }
}

TEST_CASE("the same seed makes the same pairs") {
  const predicate_info &p = named("ball_triangle");
  const element_pairs one = make_pairs(p, 50, {-20, 100, true, 0, 60}, 9),
                      same = make_pairs(p, 50, {-20, 100, true, 0, 60}, 9);
  CHECK(one.a == same.a);
  CHECK(one.b == same.b);
  CHECK(make_pairs(p, 50, {-20, 100, true, 0, 60}, 10).a != one.a);
}

TEST_CASE("the paper's way is right near the origin, and far from it wrong") {
  for (const char *name : {"triangle_triangle", "segment_triangle", "sphere_sphere"}) {
    const predicate_info &p = named(name);
    const auto wrong = [&](double offset) {
      const element_pairs pairs = make_pairs(p, 2000, {0, offset}, 11);
      return different(decide_all(pairs, paper_way(name)), decide_all(pairs, p.decide[static_cast<int>(rung::exact)]));
    };
    INFO(name);
    CHECK(wrong(0) <= 2);
    CHECK(wrong(1e5) > 400);
  }
  CHECK(paper_way("ball_ball") == nullptr);
}

// The proved distance is a bound, and not one that nothing could reach.
TEST_CASE("wrong answers are never farther from being right than is proved") {
  for (const char *name : {"ball_ball", "sphere_sphere"})
    for (const trade_maps::axis across : {trade_maps::axis::scale, trade_maps::axis::offset}) {
      const trade_maps maps = map_trade(named(name), across, 200);
      INFO(name << ": " << maps.seen_of_proved << " of the proved distance");
      CHECK(maps.seen_of_proved <= 1);
      CHECK(maps.seen_of_proved > 0.03);
      CHECK(maps.maps.size() == 5);
    }
  // The bounds of the other rungs are those of their unit roundoff, 2^-53 and 2^-102 in the place of 2^-24.
  for (const char *name : {"ball_ball", "sphere_sphere"}) {
    const float a[] = {0.1F, 0.2F, 0.3F, 0.4F}, b[] = {0.7F, -0.2F, 0.9F, 0.5F};
    const double single = proved_distance_of(name, rung::fp32)(a, b),
                 twice = proved_distance_of(name, rung::fp64)(a, b),
                 four_times = proved_distance_of(name, rung::fp64x2)(a, b);
    INFO(name << ": " << single << ", " << twice << ", " << four_times);
    CHECK((single > 0x1p-24 && single < 0x1p-18));
    CHECK((twice / single > 0x1p-30 && twice / single < 0x1p-28));
    CHECK((four_times / twice > 0x1p-51 && four_times / twice < 0x1p-47));
  }
  CHECK(proved_distance_of("triangle_triangle", rung::fp32) == nullptr);
  CHECK(proved_distance_of("ball_ball", rung::exact) == nullptr);
}

TEST_CASE("maps are the same in each run") {
  const auto shares = [] {
    std::vector<double> all;
    for (const trade_map &m : map_trade(named("segment_segment"), trade_maps::axis::offset, 10).maps)
      all.insert(all.end(), m.share.begin(), m.share.end());
    return all;
  };
  const std::vector<double> once = shares();
  CHECK(once == shares());
  CHECK(*std::max_element(once.begin(), once.end()) > 0);
}
