// Many balls: preparing and colliding, on one thread and on twice as many up to the number that is asked for.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <list>
#include <optional>

namespace meetc::bench {

namespace {

// The numbers of threads that are measured: 1, 2, 4 and so on, and `most`.
std::vector<int> thread_counts(int most) {
  std::vector<int> out;
  for (int n = 1; n < most; n *= 2)
    out.push_back(n);
  out.push_back(most);
  return out;
}

// The sets on one number of threads, and what is found there.
struct state {
  int threads;
  std::optional<prepared> a, b;
  result certified, plain;
};

struct row {
  int threads;
  double prepare, certified, plain;
  difference of_certified, of_plain;
};

} // namespace

void measure_balls(const cpu_context &c, cpu_result &to) {
  constexpr int threads_of_bar = 16;
  const two_sets sets = c.sets.many_balls();
  const predicate_info &p = *app::choose(c.best(), *sets.first.kind, *sets.second.kind, {}, {}).predicate;
  const auto collide_by = [&p](const state &s, rung precision) {
    collide_options options;
    options.threads = s.threads;
    return meetc::collide(*s.a, *s.b, p, precision, options);
  };
  std::list<state> states; // whose places the methods keep
  std::optional<result> exact;
  const auto compared = [&](const result &r) {
    if (!exact)
      exact = collide_by(states.back(), rung::exact);
    return difference_of(r.pairs, exact->pairs);
  };
  std::vector<method> methods;
  for (const int n : thread_counts(c.threads)) {
    state &s = states.emplace_back(state{n, {}, {}, {}, {}});
    const auto prepare = [&] {
      s.a.emplace(app::prepare(sets.first, s.threads));
      s.b.emplace(app::prepare(sets.second, s.threads));
    };
    methods.push_back({fmt::format("certified on {} threads", n),
                       true,
                       {prepare, [&] { s.certified = collide_by(s, rung::certified); }},
                       [&] { return compared(s.certified); }});
    methods.push_back(
        {"plain fp32", false, {[&] { s.plain = collide_by(s, rung::fp32); }}, [&] { return compared(s.plain); }});
  }
  host_clock clock(c.threads);
  const measured_methods m = measure("many balls", clock, methods, c.for_seconds(c.quick ? 1 : 120));
  std::vector<row> rows;
  for (const state &s : states) {
    const measured &certified = m.of[2 * rows.size()], &plain = m.of[2 * rows.size() + 1];
    rows.push_back(
        {s.threads, certified.seconds[0], certified.seconds[1], plain.seconds[0], certified.found, plain.found});
  }
  const row first = rows.front();
  to.tables.push_back(table_of<row>(
      "many_balls",
      fmt::format("Many balls: {} x {}, {}: {} pairs touch", app::counted(sets.first), app::counted(sets.second),
                  c.best_name(), app::grouped(exact->count)),
      {{"threads", "threads", of_count, &row::threads},
       {"prepare_ms", "prepare both,|ms", of_milliseconds, &row::prepare},
       {"certified_ms", "collide, certified,|ms", of_milliseconds, &row::certified},
       {"fp32_ms", "collide, fp32,|ms", of_milliseconds, &row::plain},
       {"prepare_speedup", "prepare,|x first row", [&](const row &r) { return of_ratio(first.prepare / r.prepare); }},
       {"certified_speedup", "certified,|x first row",
        [&](const row &r) { return of_ratio(first.certified / r.certified); }},
       {"certified_differs", "certified:|differs", [](const row &r) { return of_count(r.of_certified.wrong()); }},
       {"fp32_differs", "fp32:|differs", [](const row &r) { return of_count(r.of_plain.wrong()); }}},
      rows,
      {fmt::format("The median of {} interleaved repetitions. Differs: pairs that are not those of `exact`.",
                   m.repetitions)}));

  const auto add_bar = [&](const char *figure, double limit, double row::*seconds) {
    bar b{"many balls", figure, bar::side::at_most, limit, "ms"};
    for (const row &r : rows)
      if (r.threads == threads_of_bar)
        b.measured = 1000 * r.*seconds;
    if (!b.measured)
      b.why_not = fmt::format("this run used {} thread{}", c.threads, c.threads == 1 ? "" : "s");
    to.bars.push_back(std::move(b));
  };
  add_bar("prepare both, 16 threads", 150, &row::prepare);
  add_bar("collide, certified, 16 threads", 40, &row::certified);
}

} // namespace meetc::bench
