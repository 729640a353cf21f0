// The price of certainty in a query: certified and exact beside plain fp32, both sets prepared.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/query/choose.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

namespace meetc::bench {

namespace {

struct placed_scene {
  std::string name;
  bool has_bars;
  std::function<two_sets()> make;
};

std::vector<placed_scene> scenes(const cpu_context &c) {
  const cpu_sets &s = c.sets;
  const std::string bodies = fmt::format("{} x {}", s.middle_name(), s.large_name());
  const auto placed = [&s](double scale, double shift) {
    return [&s, scale, shift] { return s.middle_in_large(scale, shift); };
  };
  return {{bodies + ", as stored", false, placed(1, 0)},
          {bodies + ", x 1e-15", true, placed(1e-15, 0)},
          {bodies + ", x 1e12", true, placed(1e12, 0)},
          {bodies + ", moved by 1e6", true, placed(1, 1e6)},
          {"balls", true, [&s] { return s.balls(); }}};
}

struct row {
  std::string scene;
  std::uint64_t candidates, unsure;
  measured plain, certified, exact;
  int repetitions;

  double over_plain(const measured &m) const { return m.seconds[0] / plain.seconds[0]; }
};

row measure_scene(const cpu_context &c, const placed_scene &s) {
  constexpr std::array rungs{rung::fp32, rung::certified, rung::exact};
  const two_sets sets = s.make();
  const prepared a = app::prepare(sets.first), b = app::prepare(sets.second);
  const predicate_info &p = *app::choose(c.best(), *sets.first.kind, *sets.second.kind, {}, {}).predicate;
  collide_options options;
  options.threads = c.threads;
  std::array<result, rungs.size()> found;
  std::vector<method> methods;
  for (std::size_t r = 0; r < rungs.size(); ++r)
    methods.push_back({app::name_of(rungs[r]),
                       rungs[r] == rung::certified, // exact is the truth
                       {[&, r] { found[r] = meetc::collide(a, b, p, rungs[r], options); }},
                       [&, r] { return difference_of(found[r].pairs, found[2].pairs); }});
  host_clock clock(c.threads);
  const measured_methods m = measure(s.name, clock, methods, c.for_seconds(c.quick ? 1 : 30));
  return {s.name, found[2].candidates, found[1].rungs.unsure[0], m.of[0], m.of[1], m.of[2], m.repetitions};
}

} // namespace

void measure_precision(const cpu_context &c, cpu_result &to) {
  std::vector<row> rows;
  for (const placed_scene &s : scenes(c)) {
    rows.push_back(measure_scene(c, s));
    if (!s.has_bars)
      continue;
    const row &r = rows.back();
    const auto add = [&](const char *figure, double limit, const measured &m) {
      to.bars.push_back({s.name, figure, bar::side::at_most, limit, "x", r.over_plain(m)});
    };
    add("collide, certified / plain fp32", 1.15, r.certified);
    add("collide, exact / plain fp32", 1.5, r.exact);
  }
  to.tables.push_back(table_of<row>(
      "precision",
      fmt::format("The price of certainty: collide with both sets prepared, {}, {} thread{}", c.best_name(), c.threads,
                  c.threads == 1 ? "" : "s"),
      {{"scene", "scene", of_words, &row::scene},
       {"hits", "hits", [](const row &r) { return of_count(r.exact.found.found); }},
       {"candidates", "candidates", of_count, &row::candidates},
       {"fp32_ms", "fp32,|ms", [](const row &r) { return of_milliseconds(r.plain.seconds[0]); }},
       {"certified", "certified|/ fp32", [](const row &r) { return of_ratio(r.over_plain(r.certified)); }},
       {"exact", "exact|/ fp32", [](const row &r) { return of_ratio(r.over_plain(r.exact)); }},
       {"unsure", "unsure|in fp32", of_count, &row::unsure},
       {"fp32_false", "fp32: false|hits", [](const row &r) { return of_count(r.plain.found.extra); }},
       {"fp32_missed", "missed|hits", [](const row &r) { return of_count(r.plain.found.missed); }},
       {"certified_differs", "certified:|differs", [](const row &r) { return of_count(r.certified.found.wrong()); }},
       {"repetitions", "repetitions", of_count, &row::repetitions}},
      rows));
}

} // namespace meetc::bench
