// Pairs of triangles by families, apart and never pooled: certified beside CGAL's exact predicates.
#include "bench/tables/cpu/parts.hpp"

#include "app/words.hpp"
#include "bench/peers/peers.hpp"
#include "bench/scenes/pair_families.hpp"
#include "core/find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace meetc::bench {

namespace {

// By the order of pair_families(): how many times as fast as CGAL certified is to be.
constexpr std::array family_bars{3.0, 7.0, 15.0, 2.0, 1.0, 1.0};

struct family_times {
  double certified = 0, exact = 0, cgal = 0; // seconds a pair; cgal 0: not built in
  std::uint64_t hits = 0, differ = 0;        // certified and exact, and where there is CGAL, certified and CGAL
  int repetitions = 0;
};

family_times measure(const cpu_context &c, const catalogue &kernels, const pair_family &f) {
  const std::size_t n = f.pairs();
  std::vector<index_pair> pairs(n);
  for (std::size_t i = 0; i < n; ++i)
    pairs[i] = {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
  const predicate_info &p = find_predicate(kernels, "triangle_triangle");
  std::vector<answer> certified(n), exact(n), cgal(n);
  const auto decide = [&](rung precision, std::vector<answer> &to) {
    p.decide[static_cast<int>(precision)](f.a.data(), f.b.data(), pairs.data(), n, to.data());
  };
  std::vector<std::function<void()>> works{[&] { decide(rung::certified, certified); },
                                           [&] { decide(rung::exact, exact); }};
  const peers::exact_pairs *const peer = peers::cgal_pairs_for(kernels.compiled_for);
  std::unique_ptr<void, void (*)(void *)> made(nullptr, nullptr);
  if (peer) {
    made = {peer->make(f.a.data(), f.b.data(), n), peer->drop};
    works.emplace_back([&] { peer->decide(made.get(), cgal.data()); });
  }
  const interleaved_times times = measure_interleaved(works, c.one_thread(c.quick ? 1 : 30));
  family_times r;
  const auto each = static_cast<double>(n);
  r.certified = times.seconds[0] / each;
  r.exact = times.seconds[1] / each;
  r.cgal = peer ? times.seconds[2] / each : 0;
  r.hits = static_cast<std::uint64_t>(std::count(exact.begin(), exact.end(), answer::yes));
  for (std::size_t i = 0; i < n; ++i)
    r.differ += certified[i] != exact[i] || (peer && cgal[i] != exact[i]);
  r.repetitions = times.repetitions;
  return r;
}

} // namespace

void measure_families(const cpu_context &c, cpu_result &to) {
  const std::size_t n = c.quick ? 200 : 20'000;
  table t{"families",
          fmt::format("Pairs of triangles by families, {} pairs each", app::grouped(n)),
          {{"instruction_set", "instruction|set"},
           {"family", "family"},
           {"hits", "hits"},
           {"certified_ns", "certified,|ns a pair"},
           {"exact_ns", "exact,|ns a pair"},
           {"cgal_ns", "CGAL EPICK,|ns a pair"},
           {"cgal_over_certified", "CGAL /|certified"},
           {"differ", "answers|that differ"}},
          {},
          {}};
  const std::vector<pair_family> families = pair_families(n);
  int repetitions = c.repetitions;
  for (const catalogue *kernels : c.kernels)
    for (std::size_t f = 0; f < families.size(); ++f) {
      const family_times r = measure(c, *kernels, families[f]);
      repetitions = std::min(repetitions, r.repetitions);
      const char *const set = name_of(kernels->compiled_for);
      bar b{fmt::format("{}, {}", families[f].name, set), "CGAL EPICK / certified, ns a pair", bar::side::at_least,
            family_bars.at(f), "x"};
      if (r.cgal > 0)
        b.measured = r.cgal / r.certified;
      else
        b.why_not = "CGAL was not built in";
      t.rows.push_back({of_words(set), of_words(families[f].name), of_count(r.hits), of_nanoseconds(r.certified),
                        of_nanoseconds(r.exact), r.cgal > 0 ? of_nanoseconds(r.cgal) : missing("-"),
                        b.measured ? of_ratio(*b.measured) : missing("-"), of_count(r.differ)});
      to.bars.push_back(std::move(b));
    }
  t.notes.push_back(fmt::format("Each pair is decided once, so nothing is stored beforehand; CGAL's triangles are made "
                                "in its own numbers before the "
                                "clock starts. The lower quartile of at least {} interleaved repetitions.",
                                repetitions));
  for (const peers::library &l : peers::libraries())
    if (l.name == "CGAL")
      t.notes.push_back(
          l.built_in ? fmt::format("CGAL {}, with -frounding-math and the flags of each instruction set.", l.version)
                     : "CGAL was not built in (MEETC_BENCH_PEERS) and is left out.");
  to.tables.push_back(std::move(t));
}

} // namespace meetc::bench
