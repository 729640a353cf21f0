// Many balls: preparing and colliding, on one thread and on twice as many up to the number that is asked for.
#include "bench/tables/cpu/parts.hpp"

#include "app/choose.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/harness/list_difference.hpp"

#include <fmt/format.h>

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

// Works on one number of threads, and what they found.
struct balls_on_threads {
  int threads;
  std::optional<prepared> a, b;
  result certified, plain;
};

} // namespace

void measure_balls(const cpu_context &c, cpu_result &to) {
  constexpr int threads_of_bar = 16;
  const cpu_sets::two_sets sets = c.sets.many_balls();
  const predicate_info &p = *app::choose(c.best(), *sets.first.kind, *sets.second.kind, {}, {}).predicate;
  const auto collide_by = [&p](const balls_on_threads &s, rung precision) {
    collide_options options;
    options.threads = s.threads;
    return meetc::collide(*s.a, *s.b, p, precision, options);
  };
  std::vector<balls_on_threads> states;
  for (const int n : thread_counts(c.threads))
    states.push_back({n, {}, {}, {}, {}});
  std::vector<std::function<void()>> works;
  for (balls_on_threads &s : states) {
    works.emplace_back([&] {
      s.a.emplace(app::prepare(sets.first, s.threads));
      s.b.emplace(app::prepare(sets.second, s.threads));
    });
    works.emplace_back([&] { s.certified = collide_by(s, rung::certified); });
    works.emplace_back([&] { s.plain = collide_by(s, rung::fp32); });
  }
  const interleaved_times times = measure_interleaved(works, c.all_threads(c.quick ? 1 : 120));

  const result exact = collide_by(states.back(), rung::exact);
  const auto differs = [&exact](const result &r) {
    const list_difference d = difference_of(r.pairs, exact.pairs);
    return of_count(d.extra + d.missed);
  };
  table t{
      "many_balls",
      fmt::format("Many balls: {} x {}, {}: {} pairs touch", app::counted(sets.first), app::counted(sets.second),
                  name_of(c.best().compiled_for), app::grouped(exact.count)),
      {{"threads", "threads"},
       {"prepare_ms", "prepare both,|ms"},
       {"certified_ms", "collide, certified,|ms"},
       {"fp32_ms", "collide, fp32,|ms"},
       {"prepare_speedup", "prepare,|x first row"},
       {"certified_speedup", "certified,|x first row"},
       {"certified_differs", "certified:|differs"},
       {"fp32_differs", "fp32:|differs"}},
      {},
      {fmt::format("The lower quartile of {} interleaved repetitions. Differs: pairs that are not those of `exact`.",
                   times.repetitions)}};
  for (std::size_t s = 0; s < states.size(); ++s) {
    const double *const seconds = times.seconds.data() + 3 * s;
    t.rows.push_back({of_count(static_cast<std::uint64_t>(states[s].threads)), of_milliseconds(seconds[0]),
                      of_milliseconds(seconds[1]), of_milliseconds(seconds[2]), of_ratio(times.seconds[0] / seconds[0]),
                      of_ratio(times.seconds[1] / seconds[1]), differs(states[s].certified), differs(states[s].plain)});
  }
  to.tables.push_back(std::move(t));

  const auto add_bar = [&](const char *figure, double limit, std::size_t work) {
    bar r{"many balls", figure, bar::side::at_most, limit, "ms"};
    for (std::size_t s = 0; s < states.size(); ++s)
      if (states[s].threads == threads_of_bar)
        r.measured = 1000 * times.seconds[3 * s + work];
    if (!r.measured)
      r.why_not = fmt::format("this run used {} thread{}", c.threads, c.threads == 1 ? "" : "s");
    to.bars.push_back(std::move(r));
  };
  add_bar("prepare both, 16 threads", 150, 0);
  add_bar("collide, certified, 16 threads", 40, 1);
}

} // namespace meetc::bench
