// Sets of every size, shape and scale, and all options of a query.
#include "engine.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>

namespace cuda_test {
namespace {

using namespace meetc;

constexpr rung certified[] = {rung::certified};
constexpr rung both[] = {rung::exact, rung::certified};
constexpr std::size_t least_lists = std::size_t{1} << 11;

prepared ready(const rows_of &r, const pose &at = {}) {
  return prepare(view_of(r), *r.kind, at);
}

// The size of an element at which it meets a few of the other set's elements.
double size_for(std::size_t n) {
  return std::max(0.02, 0.7 / std::cbrt(static_cast<double>(n) + 1));
}

template <class Error> bool throws(const std::function<void()> &f) {
  try {
    f();
  } catch (const Error &) {
    return true;
  }
  return false;
}

// Around every size of tile, block and part.
void sizes(comparison &with, const settings &s) {
  engine random(s.seed);
  const std::vector<std::size_t> all =
      s.small ? std::vector<std::size_t>{0, 1, 65, 130}
              : std::vector<std::size_t>{0, 1, 2, 15, 16, 17, 63, 64, 65, 511, 512, 513, 3000};
  each_predicate([&](const predicate_info &p) {
    for (const std::size_t m : all)
      for (const std::size_t n : all) {
        const place at{1, size_for(std::max(m, n)), 1, 0};
        options o;
        o.expectations = m * n <= 600'000;
        o.all_modes = s.small ? m == 65 && n == 65 : m * n <= 5000 || m == n;
        with.same("sizes", p, ready(random_rows(*p.a, m, at, random)), ready(random_rows(*p.b, n, at, random)),
                  certified, o);
      }
  });
}

void rungs(comparison &with, const settings &s) {
  engine random(s.seed + 1);
  const std::size_t m = s.small ? 70 : 700, n = s.small ? 130 : 1300;
  each_predicate([&](const predicate_info &p) {
    const place at{1, 0.2, 1, 0};
    options o;
    o.all_modes = !s.small;
    with.same("rungs", p, ready(random_rows(*p.a, m, at, random)), ready(random_rows(*p.b, n, at, random)), all_rungs,
              o);
  });
}

// Degenerate lattices, subnormals, 2^125, one-ulp shifts; alone and mixed.
void families(comparison &with, const settings &s) {
  engine random(s.seed + 2);
  const std::size_t n = s.small ? 60 : 500;
  each_predicate([&](const predicate_info &p) {
    for (int family = -1; family < 6; family += s.small ? 3 : 1) {
      options o;
      o.expectations = true;
      with.same("families", p, ready(family_rows(*p.a, n, family, random)),
                ready(family_rows(*p.b, n + 13, family, random)),
                s.small ? std::span<const rung>(certified) : all_rungs, o);
    }
  });
}

void scales(comparison &with, const settings &s) {
  engine random(s.seed + 3);
  const std::size_t n = s.small ? 50 : 450;
  struct two {
    const char *name;
    place a, b;
  };
  static const two all[] = {
      {"one 1e6 times larger", {1, 1e6, 1, 0}, {1, 0.1, 1, 0}},
      {"one 1e6 times smaller", {1e6, 1e5, 1, 0}, {1e6, 0.1, 1, 0}},
      {"sets of 1e6 and of 1", {1, 0.1, 1e6, 0}, {1, 0.1, 1, 0}},
      {"both at +1e7", {50, 5, 1, 1e7}, {50, 5, 1, 1e7}},
      {"one at +1e7", {1, 0.1, 1, 1e7}, {1, 0.1, 1, 0}},
      {"subnormal", {1, 0.2, 1e-43, 0}, {1, 0.2, 1e-43, 0}},
      {"about the least normal", {1, 0.2, 3e-38, 0}, {1, 0.2, 3e-38, 0}},
      {"near 1e38", {1, 0.2, 1.5e38, 0}, {1, 0.2, 1.5e38, 0}},
      {"1e38 beside 1e-38", {1, 0.2, 1.5e38, 0}, {1, 0.2, 1e-38, 0}},
      {"half beside each other", {1, 0.2, 1, 0}, {1, 0.2, 1, 1}},
      {"large elements", {1, 3, 1, 0}, {1, 0.1, 1, 0}},
      {"all in one plane's width", {1e-3, 1, 1, 0}, {1e-3, 1, 1, 0}},
  };
  each_predicate([&](const predicate_info &p) {
    for (const two &t : all) {
      options o;
      o.expectations = true;
      with.same(t.name, p, ready(random_rows(*p.a, n, t.a, random)), ready(random_rows(*p.b, n / 2, t.b, random)),
                s.small ? std::span<const rung>(certified) : all_rungs, o);
    }
  });
}

// Every pair is a hit, and more of them than a list holds.
void all_hits(comparison &with, const settings &s) {
  each_predicate([&](const predicate_info &p) {
    const prepared a = ready(same_rows(*p.a, 600)), b = ready(same_rows(*p.b, 600));
    options o;
    o.list_capacity = std::size_t{1} << (s.small ? 15 : 18);
    o.all_modes = !s.small || std::strcmp(p.name, "ball_ball") == 0; // tallies over several parts
    with.same("600 alike, small lists", p, a, b, s.small ? std::span<const rung>(certified) : both, o);
    if (!s.small)
      with.same("600 alike, room", p, a, b, certified);
  });
  // More hits of one element than are ordered by counting.
  each_predicate([&](const predicate_info &p) {
    with.same("2 by 1500 alike", p, ready(same_rows(*p.a, 2)), ready(same_rows(*p.b, 1500)), certified);
  });
  if (s.small)
    return;
  // The CPU decides one of the pairs; all others are the same. There are too many for the first lists; small lists are
  // never enlarged, and others are.
  each_predicate([&](const predicate_info &p) {
    constexpr std::uint32_t n = 3000;
    const bool enlarged = std::strcmp(p.name, "triangle_triangle") == 0;
    const std::string scene = enlarged ? "3000 alike, larger lists" : "3000 alike, small lists";
    const rows_of x = same_rows(*p.a, n), y = same_rows(*p.b, n);
    const index_pair first{0, 0};
    answer hit;
    p.decide[static_cast<int>(rung::exact)](x.rows.data(), y.rows.data(), &first, 1, &hit);
    device_set a(with.on(), ready(x)), b(with.on(), ready(y));
    const auto is_every_pair = [&](const result &r) {
      bool right = r.count == (hit == answer::yes ? std::uint64_t{n} * n : 0) && r.count == r.pairs.size();
      for (std::size_t i = 0; right && i < r.pairs.size(); ++i)
        right = r.pairs[i].a == i / n && r.pairs[i].b == i % n;
      return right;
    };
    device_options o;
    every_pair::options how;
    o.list_capacity = how.list_capacity = enlarged ? std::size_t{1} << 25 : std::size_t{1} << 18;
    const device_result r = collide(with.on(), a, b, p, rung::certified, o);
    with.add(scene, p, r);
    with.require(scene, is_every_pair(r), std::string(p.name) + ": not every pair once");
    // The first part may find the lists too small, and try again.
    with.require(scene, enlarged ? r.parts <= 2 : r.parts > 34, "the walk was not cut as it should be");
    for (const every_pair::filter f : with.filters()) {
      how.by = f;
      const every_pair::outcome brute = with.every_pair().collide(a, b, p, rung::certified, how);
      with.add(scene, p, brute);
      with.require(scene, is_every_pair(brute) && brute.near == std::uint64_t{n} * n,
                   std::string(p.name) + ", " + name_of(f) + ": not every pair once");
      with.require(scene, enlarged ? brute.parts <= 2 : brute.parts > 34, "the product was not cut as it should be");
    }
    // A walk that decides and only counts has no list that could be too short.
    if (std::strcmp(p.name, "ball_ball") == 0 || std::strcmp(p.name, "box_box") == 0)
      for (const answer_kind want : {answer_kind::count, answer_kind::any}) {
        o.want = want;
        o.list_capacity = least_lists;
        const device_result counted = collide(with.on(), a, b, p, rung::certified, o);
        with.add(scene, p, counted);
        with.require(scene,
                     counted.parts == 1 && counted.count == (want == answer_kind::any ? 1 : std::uint64_t{n} * n),
                     std::string(p.name) + ": another count, or in parts");
      }
  });
}

// Dense and sparse places alternate, so that parts are cut to different sizes. No set is a multiple of a block.
void cut_parts(comparison &with, const settings &s) {
  engine random(s.seed + 4);
  const std::size_t m = s.small ? 1301 : 5003, n = s.small ? 1601 : 7001;
  each_predicate([&](const predicate_info &p) {
    const auto clumps = [&](const kind_info &kind, std::size_t count) {
      rows_of out = random_rows(kind, count / 4, {10, 0.5, 1, 0}, random);
      for (const double at : {-8.0, -1.0, 8.0}) {
        const rows_of more =
            random_rows(kind, at == 8.0 ? count - 3 * (count / 4) : count / 4, {0.2, 0.4, 1, at}, random);
        out.rows.insert(out.rows.end(), more.rows.begin(), more.rows.end());
      }
      return out;
    };
    options o;
    o.list_capacity = least_lists;
    if (s.small && &p != &predicate_named("ball_ball") && &p != &predicate_named("triangle_triangle"))
      return;
    with.same("clumps, small lists", p, ready(clumps(*p.a, m)), ready(clumps(*p.b, n)), certified, o);
  });
}

void owners(comparison &with, const settings &s) {
  engine random(s.seed + 5);
  const std::size_t m = s.small ? 90 : 701, n = s.small ? 70 : 503;
  each_predicate([&](const predicate_info &p) {
    const place at{1, 0.3, 1, 0};
    const prepared a = ready(random_rows(*p.a, m, at, random)), b = ready(random_rows(*p.b, n, at, random));
    std::vector<std::uint32_t> fans(m), mixed(n), one(n, 0xfffffffe);
    for (std::uint32_t i = 0; i < m; ++i)
      fans[i] = i / 3;
    for (std::uint32_t i = 0; i < n; ++i)
      mixed[i] = i * 2654435761U % 61;
    options o;
    o.all_modes = true;
    const auto ask = [&](std::span<const std::uint32_t> of_a, std::span<const std::uint32_t> of_b) {
      o.owner_a = of_a, o.owner_b = of_b;
      with.same("owners", p, a, b, both, o);
    };
    ask(fans, mixed);
    if (!s.small)
      ask(fans, {}), ask({}, mixed), ask(fans, one);
  });
}

// Long grids: many X by few Y and the reverse, with sets whose sizes are multiples of nothing.
void long_sets(comparison &with, const settings &s) {
  engine random(s.seed + 7);
  const predicate_info &p = predicate_named("ball_ball");
  struct two {
    std::size_t m, n;
  };
  const std::vector<two> all =
      s.small ? std::vector<two>{{3, 9001}, {9001, 65}}
              : std::vector<two>{{1, 1'000'003}, {60, 1'000'003}, {65, 1'000'003},  {1'000'003, 60},
                                 {1'000'003, 1}, {129, 300'001},  {100'003, 70'001}};
  for (const two &t : all) {
    const place at{1, 1.2 / std::cbrt(static_cast<double>(std::max(t.m, t.n))), 1, 0};
    options o;
    o.all_modes = true;
    with.same(std::to_string(t.m) + " by " + std::to_string(t.n), p, ready(random_rows(*p.a, t.m, at, random)),
              ready(random_rows(*p.b, t.n, at, random)), certified, o);
  }
}

void refusals(comparison &with, const settings &s) {
  engine random(s.seed + 8);
  const predicate_info &p = predicate_named("ball_triangle");
  const prepared balls = ready(random_rows(*p.a, 40, {}, random)), triangles = ready(random_rows(*p.b, 30, {}, random));
  device_set a(with.on(), balls), b(with.on(), triangles);
  const auto refused = [&](const char *what, device_set &x, device_set &y, const predicate_info &by, rung r,
                           const device_options &o) {
    with.require("refused", throws<std::invalid_argument>([&] { collide(with.on(), x, y, by, r, o); }), what);
  };
  device_options o;
  o.list_capacity = least_lists - 1;
  refused("lists below 2^11", a, b, p, rung::certified, o);
  o.list_capacity = least_lists;
  refused("kinds the wrong way round", b, a, p, rung::certified, o);
  predicate_info without = p;
  without.decide[static_cast<int>(rung::fp64)] = nullptr;
  refused("a rung that the scene does not ask for", a, b, without, rung::fp64, o);
  const std::vector<std::uint32_t> few(39);
  o.owner_a = few;
  refused("an owner map that is too short", a, b, p, rung::certified, o);
  o.owner_a = {}, o.owner_b = few;
  refused("an owner map that is too long", a, b, p, rung::certified, o);
  o.owner_b = {};
  predicate_info stranger = p;
  stranger.name = "stranger";
  with.require("refused", throws<device_error>([&] { collide(with.on(), a, b, stranger, rung::certified); }),
               "a predicate that was not generated");
  with.require("refused",
               collide(with.on(), a, b, p, rung::certified).count ==
                   collide(balls, triangles, p, rung::certified).count,
               "a right question after the wrong ones");
}

} // namespace

void pair_scenes(comparison &with, const settings &s) {
  const auto scene = [&](const char *name, void (*run)(comparison &, const settings &)) {
    std::printf("%s ...\n", name);
    run(with, s);
  };
  scene("sizes", sizes);
  scene("rungs", rungs);
  scene("families", families);
  scene("scales", scales);
  scene("all hits", all_hits);
  scene("parts", cut_parts);
  scene("owners", owners);
  scene("long sets", long_sets);
  scene("refusals", refusals);
}

} // namespace cuda_test
