// Pairs of triangles by families, apart and never pooled: certified beside CGAL's exact predicates.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/bench/peers/peers.hpp"
#include "meet/bench/scenes/pair_families.hpp"
#include "meet/core/query/find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace meetc::bench {

namespace {

// By the order of pair_families(): how many times as fast as CGAL certified is to be.
constexpr std::array family_bars{3.0, 7.0, 15.0, 2.0, 1.0, 1.0};

struct row {
  std::string set, family;
  double certified, exact, cgal; // seconds a pair; cgal 0: not built in
  difference found;              // of certified, and of CGAL
  int repetitions;
};

row measure_family(const cpu_context &c, const catalogue &kernels, const pair_family &f) {
  const std::size_t n = f.pairs();
  std::vector<index_pair> pairs(n);
  for (std::size_t i = 0; i < n; ++i)
    pairs[i] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
  const predicate_info &p = find_predicate(kernels, "triangle_triangle");
  std::vector<answer> certified(n), exact(n), cgal(n);
  const auto by_rung = [&](rung precision, std::vector<answer> &to) -> method {
    return {app::name_of(precision),
            precision == rung::certified, // exact is the truth
            {[&, decide = decider_of(p, precision)] { decide(f.a.data(), f.b.data(), pairs.data(), n, to.data()); }},
            [&] { return difference_of(to, exact); }};
  };
  std::vector<method> methods{by_rung(rung::certified, certified), by_rung(rung::exact, exact)};
  const peers::exact_pairs *const peer = peers::cgal_pairs_for(kernels.compiled_for);
  std::unique_ptr<void, void (*)(void *)> made(nullptr, nullptr);
  if (peer) {
    made = {peer->make(f.a.data(), f.b.data(), n), peer->drop};
    methods.push_back({"CGAL EPICK", true, {[&] { peer->decide(made.get(), cgal.data()); }}, [&] {
                         return difference_of(cgal, exact);
                       }});
  }
  host_clock clock(1);
  const char *const set = name_of(kernels.compiled_for);
  const measured_methods m =
      measure(fmt::format("families: {}, {}", f.name, set), clock, methods, c.for_seconds(c.quick ? 1 : 30));
  const auto each = [&](std::size_t i) { return m.of[i].seconds[0] / static_cast<double>(n); };
  return {set, f.name, each(0), each(1), peer ? each(2) : 0, m.of[0].found, m.repetitions};
}

bar bar_of(const row &r, double limit) {
  bar b{fmt::format("{}, {}", r.family, r.set), "CGAL EPICK / certified, ns a pair", bar::side::at_least, limit, "x"};
  if (r.cgal > 0)
    b.measured = r.cgal / r.certified;
  else
    b.why_not = "CGAL was not built in";
  return b;
}

} // namespace

void measure_families(const cpu_context &c, cpu_result &to) {
  const std::size_t n = c.quick ? 200 : 20'000;
  const std::vector<pair_family> families = pair_families(n);
  std::vector<row> rows;
  int repetitions = c.repetitions;
  for (const catalogue *kernels : c.kernels)
    for (std::size_t f = 0; f < families.size(); ++f) {
      rows.push_back(measure_family(c, *kernels, families[f]));
      repetitions = std::min(repetitions, rows.back().repetitions);
      to.bars.push_back(bar_of(rows.back(), family_bars.at(f)));
    }
  std::vector<std::string> notes{fmt::format(
      "Each pair is decided once, so nothing is stored beforehand; CGAL's triangles are made in its own numbers before "
      "the clock starts. The median of at least {} interleaved repetitions.",
      repetitions)};
  for (const peers::library &l : peers::libraries())
    if (l.name == "CGAL")
      notes.push_back(
          l.built_in ? fmt::format("CGAL {}, with -frounding-math and the flags of each instruction set.", l.version)
                     : "CGAL was not built in (MEETC_BENCH_PEERS) and is left out.");
  to.tables.push_back(
      table_of<row>("families", fmt::format("Pairs of triangles by families, {} pairs each", app::grouped(n)),
                    {{"instruction_set", "instruction|set", of_words, &row::set},
                     {"family", "family", of_words, &row::family},
                     {"hits", "hits", [](const row &r) { return of_count(r.found.found); }},
                     {"certified_ns", "certified,|ns a pair", of_nanoseconds, &row::certified},
                     {"exact_ns", "exact,|ns a pair", of_nanoseconds, &row::exact},
                     {"cgal_ns", "CGAL EPICK,|ns a pair",
                      [](const row &r) { return r.cgal > 0 ? of_nanoseconds(r.cgal) : missing(); }},
                     {"cgal_over_certified", "CGAL /|certified",
                      [](const row &r) { return r.cgal > 0 ? of_ratio(r.cgal / r.certified) : missing(); }},
                     {"differ", "answers|that differ", [](const row &r) { return of_count(r.found.wrong()); }}},
                    rows, std::move(notes)));
}

} // namespace meetc::bench
