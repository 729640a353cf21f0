// What certainty costs in a query: certified and exact beside plain fp32, both sets prepared.
#include "bench/tables/cpu/parts.hpp"

#include "app/choose.hpp"
#include "app/sets.hpp"
#include "bench/harness/list_difference.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

namespace meetc::bench {

namespace {

struct precision_scene {
  std::string name;
  bool has_bars;
  std::function<cpu_sets::two_sets()> make;
};

std::vector<precision_scene> scenes(const cpu_context &c) {
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

} // namespace

void measure_precision(const cpu_context &c, cpu_result &to) {
  constexpr std::array rungs{rung::fp32, rung::certified, rung::exact};
  table t{"precision",
          fmt::format("The price of certainty: collide with both sets prepared, {}, {} thread{}",
                      name_of(c.best().compiled_for), c.threads, c.threads == 1 ? "" : "s"),
          {{"scene", "scene"},
           {"hits", "hits"},
           {"candidates", "candidates"},
           {"fp32_ms", "fp32,|ms"},
           {"certified", "certified|/ fp32"},
           {"exact", "exact|/ fp32"},
           {"unsure", "unsure|in fp32"},
           {"fp32_false", "fp32: false|hits"},
           {"fp32_missed", "missed|hits"},
           {"certified_differs", "certified:|differs"},
           {"repetitions", "repetitions"}},
          {},
          {}};
  for (const precision_scene &scene : scenes(c)) {
    const cpu_sets::two_sets sets = scene.make();
    const prepared a = app::prepare(sets.first), b = app::prepare(sets.second);
    const predicate_info &p = *app::choose(c.best(), *sets.first.kind, *sets.second.kind, {}, {}).predicate;
    collide_options options;
    options.threads = c.threads;
    std::array<result, rungs.size()> found;
    std::vector<std::function<void()>> works;
    for (std::size_t r = 0; r < rungs.size(); ++r)
      works.emplace_back([&, r] { found[r] = meetc::collide(a, b, p, rungs[r], options); });
    const interleaved_times times = measure_interleaved(works, c.all_threads(c.quick ? 1 : 30));
    const list_difference plain = difference_of(found[0].pairs, found[2].pairs),
                          certified = difference_of(found[1].pairs, found[2].pairs);
    const double over_plain[] = {times.seconds[1] / times.seconds[0], times.seconds[2] / times.seconds[0]};
    t.rows.push_back({of_words(scene.name), of_count(found[2].count), of_count(found[2].candidates),
                      of_milliseconds(times.seconds[0]), of_ratio(over_plain[0]), of_ratio(over_plain[1]),
                      of_count(found[1].rungs.unsure[0]), of_count(plain.extra), of_count(plain.missed),
                      of_count(certified.extra + certified.missed),
                      of_count(static_cast<std::uint64_t>(times.repetitions))});
    if (!scene.has_bars)
      continue;
    to.bars.push_back({scene.name, "collide, certified / plain fp32", bar::side::at_most, 1.15, "x", over_plain[0]});
    to.bars.push_back({scene.name, "collide, exact / plain fp32", bar::side::at_most, 1.5, "x", over_plain[1]});
  }
  to.tables.push_back(std::move(t));
}

} // namespace meetc::bench
