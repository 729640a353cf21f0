#include "meet/app/input/failure.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/text/progress.hpp"
#include "meet/bench/harness/machine.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/scenes/scene_sets.hpp"
#include "meet/bench/scenes/trade_families.hpp"
#include "meet/bench/tables/device.hpp"
#include "meet/bench/tables/tables.hpp"
#include "meet/bench/tables/trade/maps.hpp"
#include "meet/bench/tables/trade/tables.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace meetc::bench {

namespace {

namespace fs = std::filesystem;

struct sets_of_scene {
  std::string name;
  io::element_set a, b;
};

// A file's name, without what would break a table.
std::string name_in_table(const fs::path &file) {
  std::string name = file.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '|'; }, '?');
  return name;
}

// The user's own sets, if there are any, and built-in bodies of some size.
std::vector<sets_of_scene> scenes_of(const catalogue &all, const request &q) {
  std::vector<sets_of_scene> out;
  if (q.a) {
    const std::vector<const kind_info *> kinds = app::kinds_of(all);
    out.push_back({fmt::format("{} x {}", name_in_table(*q.a), name_in_table(*q.b)), io::read(*q.a, kinds),
                   io::read(*q.b, kinds)});
  }
  const int steps = q.quick ? 24 : 160;
  const auto ring = [&] { return app::of_mesh(all, bodies::torus(2 * steps, steps)); };
  io::transform aside;
  aside.translate = {0.31, 0.22, 0.13};
  out.push_back({"ring x ring, moved", ring(), app::of_mesh(all, bodies::torus(2 * steps, steps), aside)});
  out.push_back({"ring x itself", ring(), ring()});
  const io::element_set mesh = ring();
  out.push_back({"segments x ring", segments_in(all, mesh, q.quick ? 100 : 2000, 0.2), ring()});
  const std::size_t balls = q.quick ? 500 : 20'000;
  const double radius = q.quick ? 0.06 : 0.02;
  out.push_back({"spheres x spheres", ball_cloud(all, balls, 1, radius), ball_cloud(all, balls, 2, radius)});
  return out;
}

// The predicates for which pairs can be made and the truth is known.
bool is_measured(const predicate_info &p) {
  return can_make_pairs(p) && p.decide[static_cast<int>(rung::exact)];
}

// The tolerance to which the numbers of a family are rounded.
constexpr double tolerated = 0x1p-20; // sizes

// One predicate on a list of pairs, on the processor and on the device if there is one.
trade_result measure_cell(const element_pairs &pairs, const turns &how, double size, bench_device *device) {
  trade_result out = measure_trade(pairs, how, size * tolerated);
  if (device)
    for (trade_point &p : device->measure(pairs, std::min(how.repetitions, 9)))
      out.points.push_back(std::move(p));
  return out;
}

// The longest side of the box around a set; 1 where it has none.
double size_of(const io::element_set &set) {
  float lo[3], hi[3];
  app::prepare(set).bounds(lo, hi);
  double size = 0;
  for (int k = 0; k < 3; ++k)
    size = std::max(size, static_cast<double>(hi[k]) - static_cast<double>(lo[k]));
  return size > 0 ? size : 1;
}

// The candidates of the user's own sets.
std::vector<trade_cell> measure_candidates(const catalogue &all, const sets_of_scene &files, const turns &how,
                                           bench_device *device) {
  std::vector<trade_cell> out;
  for (const choice &c : fitting(all, *files.a.kind, *files.b.kind)) {
    if (!is_measured(*c.predicate))
      continue;
    const io::element_set &a = c.swapped ? files.b : files.a, &b = c.swapped ? files.a : files.b;
    const element_pairs pairs = candidates_of(*c.predicate, a, b, 100'000);
    if (const double size = size_of(a); pairs.count > 0)
      out.push_back({c.predicate, "files", fmt::format("candidates of {}", files.name), size, pairs.count,
                     measure_cell(pairs, how, size, device)});
  }
  return out;
}

std::vector<trade_cell> measure_pairs(const catalogue &all, const request &q, const std::vector<sets_of_scene> &scenes,
                                      bench_device *device, app::progress_line &progress) {
  const std::size_t n = q.quick ? 300 : 20'000;
  const turns how{q.repetitions, q.quick ? 0.2 : 8};
  std::vector<trade_cell> out; // what is asked about comes first
  if (q.a)
    out = measure_candidates(all, scenes[0], how, device);
  double done = 0;
  for (const trade_family &f : trade_families)
    for (int i = 0; i < all.predicate_count; ++i) {
      progress(done++ / static_cast<double>(trade_families.size() * static_cast<std::size_t>(all.predicate_count)));
      const predicate_info &p = all.predicates[i];
      const double size = std::ldexp(1.0, f.pairs.scale);
      if (is_measured(p))
        out.push_back({&p, f.name, f.words, size, n,
                       measure_cell(make_pairs(p, n, f.pairs, static_cast<std::uint64_t>(i) + 1), how, size, device)});
    }
  return out;
}

// A scene at every rung: timed by turns, then asked once more for its answer, since lists of all rungs may be long.
void measure_scene(const catalogue &all, const sets_of_scene &s, const request &q, bench_device *device, int threads,
                   std::vector<trade_query> &to) {
  const choice by = app::choose(all, *s.a.kind, *s.b.kind, {}, {});
  const predicate_info &p = *by.predicate;
  const prepared a = app::prepare(by.swapped ? s.b : s.a), b = app::prepare(by.swapped ? s.a : s.b);
  collide_options options;
  options.threads = threads;
  const result truth = collide(a, b, p, rung::exact, options);
  std::vector<rung> rungs;
  for (int r = 0; r < rung_count; ++r)
    if (decider_of(p, static_cast<rung>(r)))
      rungs.push_back(static_cast<rung>(r));
  result found;
  std::vector<trade_query> queries;
  const auto answer_of = [&](rung r, bool on_device) {
    const difference d = difference_of(std::move(found.pairs), truth.pairs);
    queries.push_back({s.name, r, on_device, found.seconds, 0, found.candidates, found.rungs.unsure[0], d});
    return d;
  };
  std::vector<method> methods;
  for (const rung r : rungs) {
    const auto run = [&, r] { found = collide(a, b, p, r, options); };
    methods.push_back({app::name_of(r), never_wrong(r), {run}, [&, r, run] {
                         run();
                         return answer_of(r, false);
                       }});
  }
  host_clock clock(threads);
  const measured_methods m = measure(s.name, clock, methods, {q.repetitions, q.quick ? 0.5 : 20});
  for (std::size_t i = 0; i < rungs.size(); ++i)
    queries[i].seconds = m.of[i].seconds[0];
  for (const rung r : {rung::fp32, rung::certified, rung::exact}) {
    if (!device || !decider_of(p, r))
      continue;
    found = device->query(a, b, p, r, std::min(q.repetitions, 9));
    const difference d = answer_of(r, true);
    if (never_wrong(r))
      require_truth(s.name, fmt::format("{} on the device", app::name_of(r)), d);
  }
  for (trade_query &query : queries)
    query.over_fp32 = rungs.front() == rung::fp32 ? query.seconds / queries.front().seconds : NAN;
  to.insert(to.end(), queries.begin(), queries.end());
}

const char *const rules =
    "A pair is wrong where its answer is not that of `exact`. *Farthest wrong by* is the length of the shortest "
    "translation of one element that would make the worst of the wrong answers right, in the pair's own unit, from its "
    "exact distance or depth; *in ulps* is the most of all wrong answers in units in the last place of a pair's "
    "largest "
    "number. *Proved* is what the error bound of the rung says that this length cannot exceed: 0 for the rungs that "
    "are "
    "never wrong, `none` where numbers overflow, and `-` where errors of several signs are not known to add up to one "
    "motion. *Unsure* is the share that the first rung of `certified` hands on. *paper, fp32* is the paper's own way: "
    "the orthonormal basis, without a local origin. *certified, rounded* is certified on numbers that were rounded to "
    "a "
    "power of two before, so that each wrong answer is right again after a move by 2^-20 of the size (`meet collide "
    "--tolerance`). On a device, times are by events on a list of four million pairs; *fp16 filter, device* calls a "
    "hit "
    "what the filter on the matrix unit does not rule out, of all pairs of 4,096 elements with 4,096.";

std::string map_file(const predicate_info &p) {
  return fmt::format("map_{}.png", p.name);
}

std::vector<table> tables_of(const std::vector<trade_cell> &cells, const std::vector<trade_query> &queries, int threads,
                             bool files_have_none) {
  std::vector<table> out;
  for (const std::string &family : families_of(cells))
    out.push_back(table_of_family(family, cells));
  out.push_back(table_of_losers(cells));
  if (files_have_none)
    out.back().notes.emplace_back("The two files have no candidates, so there are no pairs of theirs above.");
  out.push_back(table_of_queries(queries, threads));
  return out;
}

} // namespace

std::string trade(const app::kernel_library &kernels, const request &q) {
  const catalogue &all = app::kernels_named(kernels, q.instruction_set);
  std::vector<std::string> names{"trade.md", "trade.csv", "trade.png"};
  std::vector<const predicate_info *> mapped;
  for (int i = 0; i < all.predicate_count; ++i)
    if (is_measured(all.predicates[i])) {
      mapped.push_back(&all.predicates[i]);
      names.push_back(map_file(all.predicates[i]));
    }
  report_folder folder(q.folder, names, q.a ? std::vector<fs::path>{*q.a, *q.b} : std::vector<fs::path>{});
  const int threads = thread_count(q.threads);
  const std::vector<sets_of_scene> scenes = scenes_of(all, q);
  const std::unique_ptr<bench_device> device = bench_device_named(q.device);
  std::vector<trade_cell> cells;
  std::vector<trade_query> queries;
  {
    app::progress_line progress("trade");
    cells = measure_pairs(all, q, scenes, device.get(), progress);
    for (const sets_of_scene &s : scenes)
      measure_scene(all, s, q, device.get(), threads, queries);
  }
  const std::string set = name_of(all.compiled_for);
  const std::string on = device ? fmt::format(" Device: {}.", device->name()) : "";
  report r{"The trade of speed for accuracy",
           in_words(q.a ? "meet trade A B" : "meet trade", q,
                    fmt::format(" --threads {} --repetitions {}", threads, q.repetitions)),
           {machine_in_words(),
            fmt::format("Measured with {}. Compiled by {}.{}", set, compiler_in_words(),
                        device ? on : " No device took part."),
            rules},
           {{"machine", machine_in_words()},
            {"compiler", compiler_in_words()},
            {"instruction_set", set},
            {"device", device ? app::json(device->name()) : app::json(nullptr)},
            {"threads", threads},
            {"repetitions", q.repetitions},
            {"quick", q.quick}},
           tables_of(cells, queries, threads, q.a && cells.back().family != "files"),
           {}};
  r.files.push_back({"trade.csv", [&cells](const fs::path &to) { io::write_file(to, as_csv(cells)); }});
  r.files.push_back(
      {"trade.png", [&](const fs::path &to) {
         plot_of_trade(fmt::format("{} Measured with {}.{}", machine_in_words(), set, on), cells).draw(to);
       }});
  for (const predicate_info *p : mapped)
    r.files.push_back({map_file(*p), [&set, p, n = std::size_t{q.quick ? 20U : 500U}](const fs::path &to) {
                         plot_of_maps(
                             fmt::format("{}, {}: {} pairs in each cell", p->name, set, n),
                             {map_trade(*p, trade_maps::axis::scale, n), map_trade(*p, trade_maps::axis::offset, n)})
                             .draw(to);
                       }});
  return folder.write(r, q.json);
}

} // namespace meetc::bench
