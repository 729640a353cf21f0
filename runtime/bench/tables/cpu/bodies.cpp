// Many bodies that have all moved: preparing each in its pose, and posing the prepared ones.
#include "meet/bench/scenes/many_bodies.hpp"
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <list>

namespace meetc::bench {

void measure_moved_bodies(const cpu_context &c, cpu_result &to) {
  const catalogue &all = c.best();
  const many_bodies scene(all, c.quick ? 10 : 100, c.threads);
  const world &bodies = scene.bodies();
  const std::uint32_t count = scene.count();
  const predicate_info &p = *app::choose(all, scene.kind(), scene.kind(), {}, {}).predicate;

  std::list<prepared> in_place;
  std::vector<const prepared *> sets(count);
  world_answer by_sets, by_poses;
  std::vector<box> bounds(count);
  const auto prepare_all = [&] {
    in_place.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      sets[i] = &in_place.emplace_back(prepare(scene.faces(), scene.kind(), bodies.at(i), c.threads));
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
                  app::grouped(scene.faces().elements), c.best_name(), by_sets.touching.size()),
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
