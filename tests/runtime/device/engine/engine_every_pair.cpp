// Every pair as a product of matrices, against the CPU's answer and against what the model of a matrix unit allows.
#include "engine.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>

namespace cuda_test {

using namespace meetc;

const char *name_of(every_pair::filter f) {
  static const char *const names[] = {"float32", "mma", "wgmma"};
  return names[static_cast<int>(f)];
}

namespace {

constexpr std::size_t least_lists = std::size_t{1} << 12;

std::string text(const range &r) {
  return std::to_string(r.least) + " to " + std::to_string(r.most);
}

} // namespace

void comparison::compare_every_pair(const std::string &scene, const predicate_info &p, const prepared &a,
                                    device_set &da, const prepared &b, device_set &db, std::span<const rung> rungs,
                                    const options &o) {
  if (!o.owner_a.empty() || !o.owner_b.empty())
    return; // elements are their own items
  for (const rung r : rungs) {
    const result want = collide(a, b, p, r);
    for (const every_pair::filter f : filters_) {
      if (!o.all_filters && f != every_pair_.best_filter())
        continue;
      const auto fails = [&](const std::string &what) {
        fail({scene, p.name}, std::to_string(a.elements()) + " by " + std::to_string(b.elements()) + ", " + name_of(r) +
                                  ", every pair by " + name_of(f) + ": " + what);
      };
      every_pair::options how;
      how.by = f;
      how.list_capacity = std::max(o.list_capacity, least_lists);
      const every_pair::outcome have = every_pair_.collide(da, db, p, r, how);
      add(scene, p, have);
      if (have.by != f)
        fails("another filter than was asked for");
      if (!same_list(want.pairs, have.pairs) || have.count != have.pairs.size())
        fails(std::to_string(have.count) + " pairs, and the CPU has " + std::to_string(want.count));
      // The CPU's candidates are touching boxes. For the plain rungs the device's are the same; for the others balls rule out
      // more, but know nothing of an element's two points.
      if ((have.candidates > want.candidates && !(never_wrong(r) && fewer_candidates_on_cpu(p))) ||
          (!never_wrong(r) && have.candidates != want.candidates))
        fails(std::to_string(have.candidates) + " candidates, and the CPU has " + std::to_string(want.candidates));
      if (have.near < have.candidates)
        fails("more candidates than near balls");
      if (have.rungs.unsure[0] > want.rungs.unsure[0] && !fewer_unsure_on_cpu(p, a, b))
        fails(std::to_string(have.rungs.unsure[0]) + " unsure, and on the CPU " + std::to_string(want.rungs.unsure[0]));
      if (o.expectations && r == rung::certified) {
        const expectation e = expect(p, a, b, f);
        const auto within = [&](const char *what, const range &may, std::uint64_t is) {
          if (!may.holds(is))
            fails(std::to_string(is) + " " + what + ", and the model allows " + text(may));
        };
        within("near balls", e.near, have.near);
        within("candidates", e.candidates, have.candidates);
        within("unsure", {0, e.most_unsure}, have.rungs.unsure[0]);
      }
      if (!o.all_modes)
        continue;
      how.want = answer_kind::count;
      const every_pair::outcome counted = every_pair_.collide(da, db, p, r, how);
      if (counted.count != have.count || !counted.pairs.empty())
        fails("counted " + std::to_string(counted.count) + ", listed " + std::to_string(have.count));
      if (counted.candidates != have.candidates || counted.near != have.near)
        fails("counting looks at other candidates than listing");
    }
  }
}

namespace {

prepared ready(const rows_of &r, const pose &at = {}) {
  return prepare(view_of(r), *r.kind, at);
}

// Columns stay with the engine. A move of either set, and sets that follow others in the same memory, make them anew.
void columns_follow_the_rows(comparison &with, const settings &s) {
  engine random(s.seed + 60);
  const std::size_t n = s.small ? 90 : 1500;
  constexpr rung certified[] = {rung::certified};
  options o;
  o.all_filters = false; // so that the columns of one query could serve the next
  each_predicate([&](const predicate_info &p) {
    const place at{1, 0.2, 1, 0};
    const rows_of x = random_rows(*p.a, n, at, random), y = random_rows(*p.b, n / 2, at, random);
    pose aside, far; // and out of the frame
    aside.m[7] = 0x1p-2, far.m[3] = 0x1p7;
    const prepared a = ready(x), b = ready(y), a_aside = ready(x, aside), b_aside = ready(y, aside);
    device_set da(with.on(), a), db(with.on(), b);
    with.same("columns, first", p, a, da, b, db, certified, o);
    db.move(aside);
    with.same("columns, B has moved", p, a, da, b_aside, db, certified, o);
    da.move(aside);
    with.same("columns, both have moved", p, a_aside, da, b_aside, db, certified, o);
    const prepared a_far = ready(x, far), b_far = ready(y, far);
    da.move(far), db.move(far);
    with.same("columns, both are far away", p, a_far, da, b_far, db, certified, o);
    da.move(aside), db.move({});
    with.same("columns, B is back", p, a_aside, da, b, db, certified, o);
    if (p.a == p.b)
      with.same("columns, exchanged", p, b, db, a_aside, da, certified, o);
    for (int again = 0; again < 3; ++again) { // likely in the memory of the one before
      const prepared c = ready(random_rows(*p.b, n / 2, at, random));
      device_set dc(with.on(), c);
      with.same("columns, another B", p, a_aside, da, c, dc, certified, o);
    }
  });
}

// Nothing is lost where lists are as short as they may be, whatever is cut.
void cut_parts(comparison &with, const settings &s) {
  engine random(s.seed + 61);
  options o;
  o.list_capacity = least_lists;
  o.all_modes = true;
  constexpr rung both[] = {rung::fp32, rung::certified};
  for (const char *name : {"ball_ball", "triangle_triangle"}) {
    const predicate_info &p = predicate_named(name);
    const std::pair<std::size_t, std::size_t> sizes[] = {{65, 700}, {700, 65}, {s.small ? 600 : 6000, 513}};
    for (const auto &[m, n] : sizes) {
      const rows_of x = random_rows(*p.a, m, {0.3, 0.6, 1, 0}, random),
                    y = random_rows(*p.b, n, {0.3, 0.6, 1, 0}, random);
      const prepared a = ready(x), b = ready(y);
      device_set da(with.on(), a), db(with.on(), b);
      with.same("every pair in parts", p, a, da, b, db, both, o);
      with.require("every pair in parts",
                   with.every_pair().collide(da, db, p, rung::certified, {.list_capacity = least_lists}).parts > 1,
                   "the product was not cut");
    }
  }
}

void refusals(comparison &with, const settings &s) {
  engine random(s.seed + 62);
  const predicate_info &p = predicate_named("ball_triangle");
  const prepared balls = ready(random_rows(*p.a, 40, {}, random)), triangles = ready(random_rows(*p.b, 30, {}, random));
  device_set a(with.on(), balls), b(with.on(), triangles);
  const auto refused = [&](const char *what, device_set &x, device_set &y, rung r, const every_pair::options &how) {
    bool thrown = false;
    try {
      with.every_pair().collide(x, y, p, r, how);
    } catch (const std::invalid_argument &) {
      thrown = true;
    }
    with.require("every pair, refused", thrown, what);
  };
  refused("kinds the wrong way round", b, a, rung::certified, {});
  refused("lists below 2^12", a, b, rung::certified, {.list_capacity = least_lists - 1});
  for (const answer_kind want : {answer_kind::any, answer_kind::flags, answer_kind::counts})
    refused("an answer that it does not give", a, b, rung::certified, {.want = want});
  refused("within a tolerance", a, b, rung::tolerant, {});
  for (const every_pair::filter f : {every_pair::filter::mma, every_pair::filter::wgmma})
    if (!with.every_pair().offers(f))
      refused("a filter that is not offered", a, b, rung::certified, {.by = f});
  device_set none(with.on(), ready({p.b, {}}));
  const every_pair::outcome r = with.every_pair().collide(a, none, p, rung::certified);
  with.require("every pair, refused", r.count == 0 && r.parts == 0, "an empty set");
}

} // namespace

void every_pair_scenes(comparison &with, const settings &s) {
  std::printf("every pair ...\n");
  columns_follow_the_rows(with, s);
  cut_parts(with, s);
  refusals(with, s);
  caller_scenes(with, s);
}

} // namespace cuda_test
