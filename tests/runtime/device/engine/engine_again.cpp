// Queries that are asked again, with others and moves in between, and sets that are collided with themselves.
#include "engine.hpp"

#include <algorithm>
#include <cmath>

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

// The same query again, with other queries and every pair in between.
void again(comparison &with, const settings &s) {
  engine random(s.seed + 6);
  const predicate_info &p = predicate_named("triangle_triangle"), &q = predicate_named("ball_triangle");
  const std::size_t n = s.small ? 300 : 2000;
  const place at{1, 0.15, 1, 0};
  const prepared x = ready(random_rows(*p.a, n, at, random)), y = ready(random_rows(*p.b, n + 77, at, random)),
                 z = ready(random_rows(*q.a, n / 2, at, random));
  device_set a(with.on(), x), b(with.on(), y), c(with.on(), z);
  std::vector<index_pair> first, self, balls;
  for (int round = 0; round < (s.small ? 2 : 6); ++round) {
    const std::size_t capacity = round % 2 ? std::size_t{1} << 18 : std::size_t{1} << 23;
    const auto same_as = [&](std::vector<index_pair> &before, const result &r, const char *what) {
      if (before.empty())
        before = r.pairs;
      with.require("asked again", same_list(before, r.pairs) && r.count == r.pairs.size() && r.count > 0, what);
    };
    device_options o;
    o.list_capacity = capacity;
    same_as(first, collide(with.on(), a, b, p, rung::certified, o), "two sets");
    same_as(self, collide(with.on(), a, a, p, rung::certified, o), "a set against itself");
    same_as(balls, collide(with.on(), c, a, q, rung::certified, o), "another predicate");
    for (const every_pair::filter f : with.filters()) {
      const auto ask = [&](device_set &of_x, device_set &of_y, const predicate_info &by) {
        return with.every_pair().collide(of_x, of_y, by, rung::certified, {.by = f, .list_capacity = capacity});
      };
      same_as(first, ask(a, b, p), "every pair of two sets");
      same_as(self, ask(a, a, p), "every pair of a set against itself");
      same_as(balls, ask(c, a, q), "every pair by another predicate"); // frames change places
    }
  }
  const auto on_cpu = [&](const char *what, const prepared &u, const prepared &v, const predicate_info &by,
                          const std::vector<index_pair> &have) {
    with.require("asked again", same_list(collide(u, v, by, rung::certified).pairs, have), what);
  };
  on_cpu("two sets on the CPU", x, y, p, first);
  on_cpu("a set against itself on the CPU", x, x, p, self);
  on_cpu("another predicate on the CPU", z, x, q, balls);
}

// The same queries again and again, with others, moves and other wants in between.
void repeated(comparison &with, const settings &s) {
  engine random(s.seed + 8);
  const std::size_t n = s.small ? 120 : 3000;
  each_predicate([&](const predicate_info &p) {
    const place at{1, 0.15, 1, 0};
    const rows_of x = random_rows(*p.a, n, at, random), y = random_rows(*p.b, n / 2, at, random);
    const prepared a = ready(x), b = ready(y);
    device_set da(with.on(), a), db(with.on(), b), same_size(with.on(), ready(random_rows(*p.b, n / 2, at, random)));
    pose aside;
    aside.m[7] = 0x1p-3;
    const prepared b_aside = prepare(view_of(y), *p.b, aside);
    const std::vector<index_pair> want = collide(a, b, p, rung::certified).pairs,
                                  want_aside = collide(a, b_aside, p, rung::certified).pairs;
    device_options o, count;
    count.want = answer_kind::count;
    for (int round = 0; round < 8; ++round) {
      const bool is_aside = round % 3 == 2;
      db.move(is_aside ? aside : pose());
      const std::vector<index_pair> &wanted = is_aside ? want_aside : want;
      for (int i = 0; i < 3; ++i)
        with.require("repeated", same_list(collide(with.on(), da, db, p, rung::certified, o).pairs, wanted),
                     std::string(p.name) + ": other pairs");
      with.require("repeated", collide(with.on(), da, db, p, rung::certified, count).count == wanted.size(),
                   std::string(p.name) + ": another count");
      with.require("repeated", same_list(collide(with.on(), da, db, p, rung::exact, o).pairs, wanted),
                   std::string(p.name) + ": other pairs, exact");
      if (round % 4 == 1)
        collide(with.on(), da, same_size, p, rung::certified, o);
    }
  });
  // By turns nothing touches and all.
  each_predicate([&](const predicate_info &p) {
    device_set da(with.on(), ready(same_rows(*p.a, 60))), db(with.on(), ready(same_rows(*p.b, 60)));
    pose away;
    away.m[3] = 100;
    const device_options o;
    const std::size_t all = collide(with.on(), da, db, p, rung::certified, o).count;
    for (int round = 0; round < 6; ++round) {
      db.move(round % 2 ? away : pose());
      for (int i = 0; i < 3; ++i) {
        const device_result r = collide(with.on(), da, db, p, rung::certified, o);
        bool right = r.count == (round % 2 ? 0 : all) && r.pairs.size() == r.count;
        for (std::size_t k = 0; right && k < r.pairs.size(); ++k)
          right = r.pairs[k].a == k / 60 && r.pairs[k].b == k % 60;
        with.require("repeated", right && (all == 0 || all == 3600), std::string(p.name) + ": not every pair once");
      }
    }
  });
}

// The same set twice, also where its hits need several parts.
void with_itself(comparison &with, const settings &s) {
  engine random(s.seed + 20);
  const std::vector<std::size_t> all =
      s.small ? std::vector<std::size_t>{1, 33, 700} : std::vector<std::size_t>{1, 31, 32, 33, 1000, 5000, 70'000};
  each_predicate([&](const predicate_info &p) {
    if (p.a != p.b)
      return;
    for (const std::size_t n : all)
      for (const bool crowded : {false, true}) {
        if (crowded && n > 5000)
          continue;
        const rows_of x_rows = random_rows(*p.a, n, {1, crowded ? 0.6 : size_for(n), 1, 0}, random);
        const prepared x = ready(x_rows);
        device_set d(with.on(), x);
        options o;
        o.all_modes = true;
        o.list_capacity = least_lists;
        with.same("a set with itself", p, x, d, x, d, both, o);
        // Each third element, and each fifth, are one item; the set is then moved.
        std::vector<std::uint32_t> thirds(n), fifths(n);
        for (std::uint32_t i = 0; i < n; ++i)
          thirds[i] = i / 3, fifths[i] = i / 5;
        o.owner_a = thirds, o.owner_b = fifths;
        with.same("a set with itself, owned", p, x, d, x, d, certified, o);
        pose at;
        at.m[3] = 0x1p-3;
        d.move(at);
        const prepared moved = ready(x_rows, at);
        with.same("a set with itself, moved", p, moved, d, moved, d, certified, {.list_capacity = least_lists});
        if (crowded && n == 5000) {
          device_options cut;
          cut.list_capacity = least_lists;
          with.require("a set with itself", collide(with.on(), d, d, p, rung::certified, cut).parts > 1,
                       "no query was cut into parts");
        }
      }
  });
}

} // namespace

void again_scenes(comparison &with, const settings &s) {
  again(with, s);
  repeated(with, s);
  with_itself(with, s);
}

} // namespace cuda_test
