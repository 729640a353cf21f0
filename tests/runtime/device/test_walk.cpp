// How a warp walks down a tree, against every pair looked at: the device's own code, with a stand-in for the warp.
#include "tests/runtime/device/host/host_warp.hpp"

#include "meet/core/device/walk/warp_walk.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

using namespace meetc;
using namespace meetc::cuda;

namespace {

using pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// Elements whose hull has two points: rows x y z, x y z, radius.
struct set {
  std::vector<float> rows;
  std::vector<tree_node> nodes;

  static constexpr int fields = 7;
  static constexpr point_fields points{{0, 1, 2, 3, 4, 5}, 6};

  std::uint32_t size() const { return static_cast<std::uint32_t>(rows.size() / fields); }
  const float *row(std::uint32_t i) const { return rows.data() + std::size_t{fields} * i; }
  tree_box box(std::uint32_t i) const {
    tree_box b;
    for (int k = 0; k < 3; ++k) {
      const float from = row(i)[k], to = row(i)[3 + k], radius = row(i)[6];
      b.low[k] = step_down(std::min(from, to) - radius), b.high[k] = step_up(std::max(from, to) + radius);
    }
    return b;
  }
  tree_view view() {
    const tree_shape shape(size());
    nodes.assign(shape.nodes(), {});
    for (int level = 0; level < shape.depth; ++level)
      for (std::uint32_t i = 0; i < shape.count[level] * tree_width; ++i) {
        tree_box b;
        if (level == 0 && i < size())
          b = box(i);
        for (std::uint32_t lane = 0; level > 0 && i < shape.count[level - 1] && lane < tree_width; ++lane)
          b.widen(box_of(nodes[shape.first[level - 1] + i], lane));
        put_box(nodes[shape.first[level] + i / tree_width], i % tree_width, b);
      }
    return {nodes.data(), size(), shape};
  }
};

// Along a line of length 1, so that neighbours in the order are neighbours in space; every eighth is up to `longest` long.
set random_set(std::mt19937_64 &random, std::uint32_t n, float length, float longest) {
  std::uniform_real_distribution<float> unit(-1, 1);
  set s;
  const bool mixed = random() % 4 == 0; // up, so that neighbours in the order are not near
  for (std::uint32_t i = 0; i < n; ++i) {
    const float at = static_cast<float>(mixed ? random() % n : i) / static_cast<float>(n),
                side = random() % 8 == 0 ? longest : length;
    const float centre[3] = {at, 0.1F * unit(random), 0.1F * unit(random)};
    for (const float c : centre)
      s.rows.push_back(c);
    for (const float c : centre)
      s.rows.push_back(random() % 4 == 0 ? c : c + side * unit(random));
    s.rows.push_back(random() % 2 ? 0 : 0.01F * length);
  }
  return s;
}

// Along a line like those, balls: sticks of no length.
set random_balls(std::mt19937_64 &random, std::uint32_t n, float radius) {
  set s = random_set(random, n, radius, radius);
  for (std::uint32_t i = 0; i < n; ++i) {
    float *const row = s.rows.data() + std::size_t{set::fields} * i;
    std::copy_n(row, 3, row + 3);
    row[6] = random() % 8 == 0 ? 0 : radius * static_cast<float>(random() % 64) / 32;
  }
  return s;
}

struct found {
  pairs list;
  unsigned long long count;
  pairs unsure{}; // of balls, and all
  unsigned long long unsure_count = 0, near = 0;
};
pairs sorted_pairs(const std::vector<index_pair> &list, std::size_t n) {
  pairs out;
  for (std::size_t i = 0; i < std::min(n, list.size()); ++i)
    out.emplace_back(list[i].a, list[i].b);
  std::sort(out.begin(), out.end());
  return out;
}
constexpr std::size_t no_list = ~std::size_t{0}; // hits are only counted
found walked(const tree_walk &from, std::size_t capacity, unsigned enough, std::uint32_t warps = 1,
             bool jointly = false, std::size_t unsure_capacity = 0) {
  constexpr index_pair untouched{0xffffffff, 0xffffffff};
  const bool counts = capacity == no_list;
  std::vector<index_pair> list(counts ? 64 : capacity + 64, untouched);
  unsigned long long count = 0, taken = 0;
  tree_walk w = from;
  w.out = {counts ? nullptr : list.data(), &count, capacity, from.out.both_ways};
  w.taken = &taken;
  std::vector<index_pair> unsure(unsure_capacity + 64, untouched);
  found f{};
  if (w.balls)
    w.unsure = {unsure.data(), &f.unsure_count, unsure_capacity}, w.near = &f.near;
  const walk_plan plan = plan_of(w, enough);
  static warp_room room;
  const auto go = [&](auto &&walk, std::uint32_t warp) {
    walk.run(warp, warps);
    if (!jointly) {
      walk.hits().flush();
      return;
    }
    const unsigned entries = walk.hits().entries();
    unsigned long long at = 0; // as a block does it for its warps
    if (threadIdx.x == 0)
      at = reserve(w, entries);
    walk.hits().flush(__shfl_sync(~0U, at, 0));
  };
  for (std::uint32_t warp = 0; warp < warps; ++warp)
    host_warp::the_blocks.run([&] {
      if (w.balls && w.out.both_ways)
        go(warp_walk<walk_by::balls, true>(w, plan, room), warp);
      else if (w.balls)
        go(warp_walk<walk_by::balls>(w, plan, room), warp);
      else if (w.out.both_ways)
        go(warp_walk<walk_by::boxes, true>(w, plan, room), warp);
      else if (w.rows)
        go(warp_walk<walk_by::points>(w, plan, room), warp);
      else
        go(warp_walk<walk_by::boxes>(w, plan, room), warp);
    });
  const auto is_untouched = [&](index_pair p) { return p.a == untouched.a && p.b == untouched.b; };
  CHECK(std::all_of(list.end() - 64, list.end(), is_untouched));
  CHECK(std::all_of(unsure.end() - 64, unsure.end(), is_untouched));
  list.resize(list.size() - 64), unsure.resize(unsure_capacity);
  f.count = count;
  f.list = sorted_pairs(list, count), f.unsure = sorted_pairs(unsure, f.unsure_count);
  return f;
}

// The pairs whose boxes touch, and of these the ones that are not apart by the walker's two points.
std::pair<pairs, pairs> looked_at(const set &walker, const set &tree, const part &of, bool swapped, bool half) {
  pairs touching, near;
  for (std::uint32_t i = of.first_a * tree_width; i < std::min(walker.size(), of.end_a * tree_width); ++i)
    for (std::uint32_t j = of.first_b * tree_width; j < std::min(tree.size(), of.end_b * tree_width); ++j) {
      const tree_box other = tree.box(j);
      if (!walker.box(i).touches(other) || (half && j < i))
        continue;
      const std::pair<std::uint32_t, std::uint32_t> p = swapped ? std::pair{j, i} : std::pair{i, j};
      touching.push_back(p);
      if (!apart_from_box(two_points_of(set::points, walker.row(i)), other.low, other.high))
        near.push_back(p);
    }
  std::sort(touching.begin(), touching.end());
  std::sort(near.begin(), near.end());
  return {touching, near};
}

} // namespace

TEST_CASE("walk: a warp finds every pair of boxes that touch, once") {
  std::mt19937_64 random(1);
  const std::uint32_t sizes[] = {1, 2, 31, 32, 33, 100, 1024, 1025, 2500};
  std::size_t seen = 0;
  for (int round = 0; round < 40; ++round) {
    set a = random_set(random, sizes[random() % 9], 0.003F, random() % 2 ? 0.02F : 0.5F);
    const bool half = round % 4 == 1; // of the pairs of a set with itself
    set b = half ? a : random_set(random, sizes[random() % 9], 0.003F, random() % 2 ? 0.003F : 0.5F);
    const tree_view x = a.view(), y = b.view();
    part of{0, x.shape.count[0], 0, y.shape.count[0]};
    if (round % 3 == 0) { // a part
      of.first_a = static_cast<std::uint32_t>(random() % of.end_a);
      of.first_b = static_cast<std::uint32_t>(random() % of.end_b);
      of.end_a = of.first_a + 1 + static_cast<std::uint32_t>(random() % (of.end_a - of.first_a));
      of.end_b = of.first_b + 1 + static_cast<std::uint32_t>(random() % (of.end_b - of.first_b));
    }
    const bool swapped = !half && random() % 2, by_points = random() % 2;
    const unsigned enough = 1U << random() % 14;
    const auto warps = static_cast<std::uint32_t>(1 + random() % 3);
    tree_walk w{x, y, of, swapped, half, by_points ? a.rows.data() : nullptr, set::fields, set::points, {}, nullptr};
    w.out.both_ways = half && !by_points && round % 8 == 1;
    auto [touching, near] = looked_at(a, b, of, swapped, half);
    if (w.out.both_ways) {
      for (std::size_t i = 0, n = touching.size(); i < n; ++i)
        if (const auto [first, second] = touching[i]; first != second)
          touching.emplace_back(second, first);
      std::sort(touching.begin(), touching.end());
    }
    const found f = walked(w, touching.size() + 1, enough, warps, random() % 2 == 0);
    INFO("round " << round << ": " << a.size() << " x " << b.size() << (by_points ? ", by points" : "") << ", cut into "
                  << enough);
    REQUIRE(f.count == f.list.size());
    if (!by_points) {
      REQUIRE(f.list == touching);
    } else {
      REQUIRE(std::adjacent_find(f.list.begin(), f.list.end()) == f.list.end());
      REQUIRE(std::includes(touching.begin(), touching.end(), f.list.begin(), f.list.end()));
      REQUIRE(std::includes(f.list.begin(), f.list.end(), near.begin(), near.end()));
    }
    seen += f.list.size();
  }
  CHECK(seen > 10000);
}

TEST_CASE("walk: elements that are long beside the tree's go down alone, by their points") {
  std::mt19937_64 random(9);
  std::size_t seen = 0, told_apart = 0, told_apart_of_half = 0;
  for (int round = 0; round < 6; ++round) {
    const bool half = round % 2 == 1, swapped = !half && random() % 2;
    const auto n = static_cast<std::uint32_t>(half ? 3000 + random() % 1500 : 300 + random() % 700);
    set a = random_set(random, n, 0.002F, 1);
    set b = half ? a : random_set(random, static_cast<std::uint32_t>(3000 + random() % 2000), 0.002F, 0.01F);
    const tree_view x = a.view(), y = b.view();
    part of{0, x.shape.count[0], 0, y.shape.count[0]};
    if (round % 3 == 1)
      of.first_a = of.end_a / 3, of.first_b = of.end_b / 4, of.end_b -= of.end_b / 5;
    const tree_walk w{x, y, of, swapped, half, a.rows.data(), set::fields, set::points, {}, nullptr};
    const auto [touching, near] = looked_at(a, b, of, swapped, half);
    const found f =
        walked(w, touching.size() + 1, 1U << random() % 14, static_cast<std::uint32_t>(1 + random() % 3), random() % 2);
    INFO("round " << round << ": " << a.size() << " x " << b.size());
    REQUIRE(f.count == f.list.size());
    REQUIRE(std::adjacent_find(f.list.begin(), f.list.end()) == f.list.end());
    REQUIRE(std::includes(touching.begin(), touching.end(), f.list.begin(), f.list.end()));
    REQUIRE(std::includes(f.list.begin(), f.list.end(), near.begin(), near.end()));
    seen += f.list.size();
    (half ? told_apart_of_half : told_apart) += touching.size() - f.list.size();
  }
  CHECK(seen > 10000);
  CHECK(told_apart > 1000);
  CHECK(told_apart_of_half > 1000);
}

TEST_CASE("walk: pairs of balls that their boxes prove are listed, and the others apart from them") {
  std::mt19937_64 random(5);
  const std::uint32_t sizes[] = {1, 31, 33, 100, 1025, 2500};
  std::size_t hits = 0, rest = 0;
  bool stopped_early = false, ended_with_one = false;
  for (int round = 0; round < 24; ++round) {
    const bool itself = round % 3 == 0, both_ways = itself && round % 2 == 0, swapped = !itself && random() % 2;
    const float far = round % 4 == 3 ? 64 : 0; // where many pairs are unsure
    set a = random_balls(random, sizes[random() % 6], 0.004F);
    for (std::size_t i = 0; i < a.rows.size(); ++i)
      a.rows[i] += i % 7 == 6 ? 0 : far;
    set b = itself ? a : random_balls(random, sizes[random() % 6], 0.02F);
    for (std::size_t i = 0; i < b.rows.size(); ++i)
      b.rows[i] += itself || i % 7 == 6 ? 0 : far;
    for (std::uint32_t i = 0; i < std::min(a.size(), b.size()); i += 5) // the same ball, of radius 0 perhaps
      std::copy_n(a.row(i), set::fields, b.rows.data() + std::size_t{set::fields} * i);
    if (itself)
      b = a;
    const tree_view x = a.view(), y = b.view();
    const part of{0, x.shape.count[0], 0, y.shape.count[0]};
    tree_walk w{x, y, of, swapped, itself, nullptr, set::fields, set::points, {}, nullptr};
    w.out.both_ways = both_ways, w.balls = true;
    pairs touch, unsure;
    unsigned long long not_apart = 0;
    for (std::uint32_t i = 0; i < a.size(); ++i)
      for (std::uint32_t j = itself ? i : 0; j < b.size(); ++j) {
        const tree_box p = a.box(i), q = b.box(j);
        const ball_verdict v = compare(ball_in_box(p.low, p.high), ball_in_box(q.low, q.high));
        if (v.apart || !p.touches(q))
          continue;
        const auto pair = swapped ? std::pair{j, i} : std::pair{i, j};
        (v.touch ? touch : unsure).push_back(pair);
        if (v.touch && both_ways && i != j)
          touch.emplace_back(j, i);
        not_apart += both_ways && i != j ? 2 : 1;
      }
    std::sort(touch.begin(), touch.end()), std::sort(unsure.begin(), unsure.end());
    const std::size_t room = std::size_t{a.size()} * b.size();
    const found f = walked(w, touch.size() + 1, 1U << random() % 14, 2, random() % 2 == 0, room);
    INFO("round " << round << ": " << a.size() << " x " << b.size());
    REQUIRE(f.list == touch);
    REQUIRE(f.count == touch.size());
    REQUIRE(f.unsure == unsure);
    REQUIRE(f.near == not_apart);
    hits += touch.size(), rest += unsure.size();

    const found counted = walked(w, no_list, 64, 1, false, room);
    REQUIRE(counted.count == touch.size());
    REQUIRE(counted.unsure == f.unsure);
    REQUIRE(counted.near == f.near);
    if (unsure.size() > 100) { // and a list of these that is too short
      const found some = walked(w, no_list, 64, 1, false, 10);
      REQUIRE(some.unsure_count > 10);
      stopped_early |= some.unsure_count < unsure.size();
    }
    if (touch.size() > 1000) { // where one is enough
      const found one = walked(w, 0, 64, 1, false, room);
      REQUIRE(one.count > 0);
      ended_with_one |= one.count < touch.size();
    }
  }
  CHECK(hits > 10000);
  CHECK(rest > 1000);
  CHECK(stopped_early);
  CHECK(ended_with_one);
}

TEST_CASE("walk: packets that go down together first lose no pair") {
  std::mt19937_64 random(3);
  const auto lift = [](set &s, std::uint32_t first, std::uint32_t end, float by) {
    for (std::uint32_t i = first; i < end; ++i)
      for (const std::size_t z : {2, 5})
        s.rows[std::size_t{set::fields} * i + z] += by;
  };
  for (int round = 0; round < 4; ++round) {
    set a = random_set(random, 1504, 0.03F, 0.05F), b = random_set(random, 33000, 0.02F, 0.02F);
    if (round < 3) { // of the tree the middle is above the rest, and of the walkers some are between these
      lift(b, 11000, 22000, 5);
      lift(a, 400, 1000, 2.5F), lift(a, 1300, 1500, 5);
    }
    const tree_view y = b.view();
    // Some reach as many nodes as a list has room for, which is all but the last, and others one more.
    REQUIRE(y.shape.count[1] == tree_width + 1);
    const float all_but_last = box_of(y.nodes[y.shape.first[2] + 1], 0).low[0] - 1e-5F;
    for (std::size_t i = 0; round == 3 && i < a.size(); i += 64) {
      float *const row = a.rows.data() + i * set::fields;
      row[0] = 0, row[3] = i < a.size() / 2 ? all_but_last : 1, row[6] = 0;
    }
    const tree_view x = a.view();
    REQUIRE(y.shape.depth - 1 > coarse_level);
    const part of{0, x.shape.count[0], round == 2 ? 300U : 0U, y.shape.count[0]};
    const tree_walk w{x, y, of, false, false, nullptr, set::fields, set::points, {}, nullptr};
    const walk_plan plan = plan_of(w, 1);
    REQUIRE((plan.whole && plan.batch >= least_together));
    const auto [touching, near] = looked_at(a, b, of, false, false);
    const found f = walked(w, touching.size() + 1, 1, 2);
    CHECK(touching.size() > 1000);
    CHECK(f.list == touching);
  }
}

// One packet reaches more nodes than are listed, and another one only the last, which comes later.
TEST_CASE("walk: packets that go down together lose none that comes after the list is full") {
  std::mt19937_64 random(3);
  set a = random_set(random, 1504, 0.001F, 0.001F), b = random_set(random, 67000, 0.0002F, 0.0002F);
  for (std::size_t i = 0; i < 2 * std::size_t{tree_width}; ++i) {
    float *const row = a.rows.data() + i * set::fields;
    row[0] = i < tree_width ? 0 : 0.998F, row[3] = i < tree_width ? 0.7F : 0.998F;
    row[6] = i < tree_width ? 0 : 0.015F;
  }
  const tree_view x = a.view(), y = b.view();
  REQUIRE(y.shape.count[coarse_level] == 3);
  const part of{0, x.shape.count[0], 0, y.shape.count[0]};
  const tree_walk w{x, y, of, false, false, nullptr, set::fields, set::points, {}, nullptr};
  const walk_plan plan = plan_of(w, 1);
  REQUIRE((plan.whole && plan.batch >= least_together));
  const auto [touching, near] = looked_at(a, b, of, false, false);
  REQUIRE(std::any_of(touching.begin(), touching.end(), [](const auto &p) { return p.first / tree_width == 1; }));
  CHECK(walked(w, touching.size() + 1, 1).list == touching);
}

TEST_CASE("walk: a list that is too short is never overrun, and its count says so") {
  std::mt19937_64 random(2);
  for (const bool by_points : {false, true})
    for (const std::size_t capacity : {0U, 1U, 100U, 1000U}) {
      set a = random_set(random, 1000, 0.1F, 1), b = random_set(random, 1000, 0.1F, 1);
      const tree_view x = a.view(), y = b.view();
      const part of{0, x.shape.count[0], 0, y.shape.count[0]};
      const tree_walk w{x,           y,           of, false,  false, by_points ? a.rows.data() : nullptr,
                        set::fields, set::points, {}, nullptr};
      const auto [touching, near] = looked_at(a, b, of, false, false);
      REQUIRE(near.size() > capacity);
      const found f = walked(w, capacity, 64);
      CHECK(f.count > capacity);
      CHECK(std::includes(touching.begin(), touching.end(), f.list.begin(), f.list.end()));
    }
}
