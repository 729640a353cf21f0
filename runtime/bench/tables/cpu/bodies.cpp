// Many bodies that have all moved: preparing each in its pose, and posing the prepared ones.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/bodies/meshes.hpp"
#include "meet/core/sets/posed_blocks.hpp"
#include "meet/core/world/world.hpp"

#include <fmt/format.h>

#include <cmath>
#include <list>
#include <random>

namespace meetc::bench {

namespace {

// Rotates about y by a quarter turn at most, and moves the body within a cube of this half side.
pose drawn(std::mt19937 &g, double range) {
  const auto uniform = [&g](double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(g()) * 0x1p-32); };
  const double t = uniform(-1, 1), c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  pose p;
  const double m[12] = {c,  0, s, uniform(-range, range), 0, 1, 0, uniform(-range, range),
                        -s, 0, c, uniform(-range, range)};
  std::copy_n(m, 12, p.m);
  return p;
}

std::vector<index_pair> touching_pairs(const world_answer &found) {
  std::vector<index_pair> out;
  for (const touching_bodies &t : found.touching)
    for (std::uint64_t i = 0; i < t.found.count; ++i) // a pair of bodies for each pair of their faces
      out.push_back({t.a, t.b});
  return out;
}

} // namespace

void measure_moved_bodies(const cpu_context &c, cpu_result &to) {
  const std::size_t bodies_wanted = c.quick ? 10 : 100;
  const catalogue &all = c.best();
  const bodies::mesh shape = bodies::torus(50, 50);
  const view faces{shape.xyz.data(), shape.vertices(), 0, shape.index.data(), shape.triangles()};
  const kind_info *triangle = nullptr;
  for (int i = 0; i < all.kind_count; ++i)
    if (all.kinds[i].points == 3)
      triangle = &all.kinds[i];
  const predicate_info &p = *app::choose(all, *triangle, *triangle, {}, {}).predicate;

  world bodies(all);
  const auto own = std::make_shared<prepared>(prepare(faces, *triangle, {}, c.threads));
  std::mt19937 g(1);
  for (std::size_t i = 0; i < bodies_wanted; ++i)
    bodies.add(fmt::format("body {}", i), own, drawn(g, 1.5 * std::cbrt(static_cast<double>(bodies_wanted))));
  const auto count = static_cast<std::uint32_t>(bodies.size());

  std::list<prepared> in_place;
  std::vector<const prepared *> sets(count);
  world_answer by_sets, by_poses;
  std::vector<box> bounds(count);
  const auto prepare_all = [&] {
    in_place.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      sets[i] = &in_place.emplace_back(prepare(faces, *triangle, bodies.at(i), c.threads));
      sets[i]->bounds(bounds[i].lo, bounds[i].hi);
    }
  };
  const auto collide_all = [&](rung precision) {
    world_answer found;
    collide_options o;
    o.want = answer_kind::count;
    o.threads = c.threads;
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b) {
        bool apart = false;
        for (int k = 0; k < 3; ++k)
          apart |= bounds[a].hi[k] < bounds[b].lo[k] || bounds[b].hi[k] < bounds[a].lo[k];
        if (apart)
          continue;
        result r = collide(*sets[a], *sets[b], p, precision, o);
        found.candidates += r.candidates;
        if (r.count > 0)
          found.touching.push_back({a, b, std::move(r)});
      }
    return found;
  };
  std::optional<std::vector<index_pair>> exact;
  const auto compared = [&](const world_answer &found) {
    if (!exact)
      exact = touching_pairs(collide_all(rung::exact));
    return difference_of(touching_pairs(found), *exact);
  };
  const auto pose_all = [&] {
    world_options o;
    o.threads = c.threads;
    by_poses = bodies.touching(o);
  };
  host_clock clock(c.threads);
  const measured_methods m = measure("many bodies", clock,
                                     {{"prepared in their poses",
                                       true,
                                       {prepare_all, [&] { by_sets = collide_all(rung::certified); }},
                                       [&] { return compared(by_sets); }},
                                      {"posed", true, {pose_all}, [&] { return compared(by_poses); }}},
                                     c.for_seconds(c.quick ? 1 : 60));
  const std::vector<double> &prepared_seconds = m.of[0].seconds;
  const double posed_seconds = m.of[1].seconds[0];
  struct row {
    std::string method;
    std::optional<double> move, collide; // where they are steps of their own
    double total;
    std::uint64_t candidates;
    difference of;
  };
  const std::vector<row> rows{{"prepared in their poses", prepared_seconds[0], prepared_seconds[1],
                               prepared_seconds[0] + prepared_seconds[1], by_sets.candidates, m.of[0].found},
                              {"posed", {}, {}, posed_seconds, by_poses.candidates, m.of[1].found}};
  const auto step = [](std::optional<double> row::*seconds) {
    return [seconds](const row &r) { return r.*seconds ? of_milliseconds(*(r.*seconds)) : missing(); };
  };
  to.tables.push_back(table_of<row>(
      "many_bodies",
      fmt::format("Many bodies: {} of {} triangles each, all moved, {}: {} pairs of bodies touch", count,
                  app::grouped(shape.triangles()), c.best_name(), by_sets.touching.size()),
      {{"method", "method", of_words, &row::method},
       {"move_ms", "move,|ms", step(&row::move)},
       {"collide_ms", "collide,|ms", step(&row::collide)},
       {"total_ms", "both,|ms", of_milliseconds, &row::total},
       {"candidates", "candidates", of_count, &row::candidates},
       {"differs", "differs", [](const row &r) { return of_count(r.of.wrong()); }}},
      rows,
      {fmt::format("The median of {} interleaved repetitions. Differs: pairs of faces that are not those of `exact`.",
                   m.repetitions)}));
  to.bars.push_back({"many bodies", "move and collide / narrow phase alone", bar::side::at_most, 4, "x",
                     posed_seconds / prepared_seconds[1]});
  to.bars.push_back(
      {"many bodies", "prepare / move and collide", bar::side::at_least, 10, "x", prepared_seconds[0] / posed_seconds});
}

} // namespace meetc::bench
