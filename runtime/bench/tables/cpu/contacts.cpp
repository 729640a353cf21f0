// Where meshes meet, beside finding which pairs do; and where a mesh crosses itself.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/contacts/contacts.hpp"

#include <fmt/format.h>
#include <neighbours/neighbours_runtime.hpp>

namespace meetc::bench {

namespace {

// The bars are times on two threads.
constexpr int threads = 2;

struct row {
  std::string method;
  double milliseconds;
  std::uint64_t pairs, nodes;
};

template <class Real> std::vector<index_pair> pairs_with_corners(const contact_set<Real> &c) {
  std::vector<index_pair> out;
  for (std::size_t i = 0; i < c.pairs.size(); ++i)
    if (!c.corners[i].empty())
      out.push_back(c.pairs[i]);
  return out;
}

void measure_curves(const cpu_context &c, cpu_result &to) {
  const two_sets sets = c.sets.middle_in_large();
  const prepared a = app::prepare(sets.first), b = app::prepare(sets.second);
  const predicate_info &p = *app::choose(c.best(), a.kind(), b.kind(), {}, {}).predicate;
  collide_options options;
  options.threads = threads;
  const std::vector<index_pair> truth = collide(a, b, p, rung::exact, options).pairs;
  const view of_a = io::view_of(sets.first), of_b = io::view_of(sets.second);
  contact_options how;
  how.threads = threads;
  std::vector<index_pair> pairs;
  contact_set<float> single;
  contact_set<double> wide;
  host_clock clock(threads);
  const measured_methods m = measure("contacts", clock,
                                     {{"which pairs touch",
                                       true,
                                       {[&] { pairs = collide(a, b, p, rung::certified, options).pairs; }},
                                       [&] { return difference_of(pairs, truth); }},
                                      {"where, in float32",
                                       true,
                                       {[&] { single = contacts<float>(of_a, of_b, p, truth, how); }},
                                       [&] { return difference_of(pairs_with_corners(single), truth); }},
                                      {"where, in float64",
                                       true,
                                       {[&] { wide = contacts<double>(of_a, of_b, p, truth, how); }},
                                       [&] { return difference_of(pairs_with_corners(wide), truth); }}},
                                     c.for_seconds(c.quick ? 1 : 30));
  const auto ms = [&](std::size_t i) { return 1000 * m.of[i].seconds[0]; };
  to.tables.push_back(table_of<row>(
      "contacts",
      fmt::format("Where meshes meet, {}, {} threads: {} x {}", c.best_name(), threads, app::counted(sets.first),
                  app::counted(sets.second)),
      {{"method", "method", of_words, &row::method},
       {"ms", "ms", [](const row &r) { return of_milliseconds(r.milliseconds / 1000); }},
       {"pairs", "pairs", of_count, &row::pairs},
       {"nodes", "nodes", of_count, &row::nodes}},
      std::vector<row>{{"which pairs touch", ms(0), pairs.size(), 0},
                       {"where, in float32", ms(1), single.pairs.size(), single.nodes()},
                       {"where, in float64", ms(2), wide.pairs.size(), wide.nodes()}},
      {fmt::format("On prepared sets; where: from the pairs to polylines and patches. The median of {} interleaved "
                   "repetitions.",
                   m.repetitions)}));
  to.bars.push_back({fmt::format("{} x {}", c.sets.middle_name(), c.sets.large_name()),
                     "contacts in float32, 2 threads", bar::side::at_most, 15, "ms", ms(1)});
}

void measure_crossing(const cpu_context &c, cpu_result &to) {
  const io::element_set mesh = c.sets.large();
  const catalogue &near = neighbours::catalogue();
  const self_predicates by = app::of_one_mesh(c.best(), near);
  std::optional<prepared> set;
  self_result found;
  self_options how;
  how.threads = threads;
  host_clock clock(threads);
  const measured_methods m = measure(
      "crosses itself", clock,
      {{"crosses itself",
        false,
        {[&] { set = app::prepare(mesh, threads); }, [&] { found = self_pairs(*set, io::view_of(mesh), by, how); }},
        {}}},
      c.for_seconds(c.quick ? 1 : 30));
  struct line {
    double prepare, find;
    std::uint64_t neighbours, candidates, pairs;
  };
  to.tables.push_back(
      table_of<line>("crosses_itself",
                     fmt::format("Where the {} crosses itself, {}, {} threads: {}", c.sets.large_name(), c.best_name(),
                                 threads, app::counted(mesh)),
                     {{"prepare_ms", "prepare,|ms", of_milliseconds, &line::prepare},
                      {"find_ms", "find,|ms", of_milliseconds, &line::find},
                      {"neighbours", "neighbours", of_count, &line::neighbours},
                      {"candidates", "other|candidates", of_count, &line::candidates},
                      {"pairs", "pairs", of_count, &line::pairs}},
                     std::vector<line>{{m.of[0].seconds[0], m.of[0].seconds[1],
                                        found.neighbours[0] + found.neighbours[1] + found.neighbours[2],
                                        found.candidates, found.pairs.size()}},
                     {fmt::format("Every pair with a common corner is decided beyond it. The median of {} repetitions.",
                                  m.repetitions)}));
  to.bars.push_back({fmt::format("{} with itself", c.sets.large_name()), "prepare, and where it crosses, 2 threads",
                     bar::side::at_most, 150, "ms", 1000 * (m.of[0].seconds[0] + m.of[0].seconds[1])});
}

} // namespace

void measure_contacts(const cpu_context &c, cpu_result &to) {
  measure_curves(c, to);
  measure_crossing(c, to);
}

} // namespace meetc::bench
