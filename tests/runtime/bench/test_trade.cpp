// What `meet trade` rests on: distances from being right, pairs near a contact, and proved distances.
#include "tests/catch.hpp"

#include "bench/distance.hpp"
#include "bench/numbers.hpp"
#include "bench/paper_way.hpp"
#include "bench/proved_distance.hpp"
#include "bench/trade_maps.hpp"
#include "bench/trade_measure.hpp"
#include "core/find.hpp"

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
