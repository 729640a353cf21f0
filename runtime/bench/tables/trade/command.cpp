#include "bench/tables/trade/command.hpp"

#include "app/failure.hpp"
#include "app/kinds.hpp"
#include "app/made_sets.hpp"
#include "app/option_values.hpp"
#include "app/output_files.hpp"
#include "app/progress.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/harness/gnuplot.hpp"
#include "bench/harness/list_difference.hpp"
#include "bench/harness/machine.hpp"
#include "bench/harness/option_values.hpp"
#include "bench/scenes/scene_sets.hpp"
#include "bench/scenes/trade_families.hpp"
#include "bench/tables/trade/device.hpp"
#include "bench/tables/trade/maps.hpp"
#include "bench/tables/trade/report.hpp"
#include "core/threads.hpp"
#include "io/atomic_file.hpp"
#include "io/read.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace meetc::bench {

namespace {

namespace fs = std::filesystem;

struct scene {
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
std::vector<scene> scenes_of(const catalogue &all, const trade_request &q) {
  std::vector<scene> out;
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

// What the numbers of a family are rounded to for its tolerance.
constexpr double tolerated = 0x1p-20; // sizes

// One predicate on a list of pairs, on the processor and on the device if there is one.
trade_result measure_cell(const element_pairs &pairs, const interleaved_options &by, double size,
                          trade_device *device) {
  trade_result out = measure_trade(pairs, by, size * tolerated);
  if (device)
    for (trade_point &p : device->measure(pairs, std::min(by.repetitions, 9)))
      out.points.push_back(std::move(p));
  return out;
}

void measure_pairs(const catalogue &all, const trade_request &q, const std::vector<scene> &scenes, trade_device *device,
                   const std::function<void(double)> &progress, std::vector<trade_cell> &to) {
  const std::size_t n = q.quick ? 300 : 20'000;
  const interleaved_options by{q.repetitions, 1, q.quick ? 0.2 : 8};
  double done = 0;
  for (const trade_family &f : trade_families)
    for (int i = 0; i < all.predicate_count; ++i) {
      progress(done++ / static_cast<double>(trade_families.size() * static_cast<std::size_t>(all.predicate_count)));
      const predicate_info &p = all.predicates[i];
      if (is_measured(p))
        to.push_back({&p, f.name, f.words, std::ldexp(1.0, f.pairs.scale), n,
                      measure_cell(make_pairs(p, n, f.pairs, static_cast<std::uint64_t>(i) + 1), by,
                                   std::ldexp(1.0, f.pairs.scale), device)});
    }
  if (!q.a)
    return;
  for (const app::choice &c : app::fitting(all, *scenes[0].a.kind, *scenes[0].b.kind)) {
    if (!is_measured(*c.predicate))
      continue;
    const io::element_set &a = c.swapped ? scenes[0].b : scenes[0].a, &b = c.swapped ? scenes[0].a : scenes[0].b;
    const element_pairs pairs = candidates_of(*c.predicate, a, b, 100'000);
    const prepared whole = app::prepare(a);
    float lo[3], hi[3];
    whole.bounds(lo, hi);
    double size = 0;
    for (int k = 0; k < 3; ++k)
      size = std::max(size, static_cast<double>(hi[k]) - static_cast<double>(lo[k]));
    if (pairs.count > 0)
      to.push_back({c.predicate, "files", fmt::format("candidates of {}", scenes[0].name), size > 0 ? size : 1,
                    pairs.count, measure_cell(pairs, by, size > 0 ? size : 1, device)});
  }
}

std::vector<trade_query> measure_queries(const catalogue &all, const std::vector<scene> &scenes, const trade_request &q,
                                         trade_device *device, int threads) {
  std::vector<trade_query> out;
  for (const scene &s : scenes) {
    const app::choice by = app::choose(all, *s.a.kind, *s.b.kind, {}, {});
    const predicate_info &p = *by.predicate;
    const prepared a = app::prepare(by.swapped ? s.b : s.a), b = app::prepare(by.swapped ? s.a : s.b);
    collide_options options;
    options.threads = threads;
    std::vector<rung> rungs;
    for (int r = 0; r < rung_count; ++r)
      if (p.decide[r])
        rungs.push_back(static_cast<rung>(r));
    result found; // of one rung at a time, since lists may be long
    std::vector<std::function<void()>> works;
    for (std::size_t r = 0; r < rungs.size(); ++r)
      works.emplace_back([&, r] { found = collide(a, b, p, rungs[r], options); });
    const interleaved_times times = measure_interleaved(works, {q.repetitions, threads, q.quick ? 0.5 : 20});
    const result truth = collide(a, b, p, rung::exact, options);
    for (std::size_t r = 0; r < rungs.size(); ++r) {
      found = collide(a, b, p, rungs[r], options);
      const list_difference d = difference_of(std::move(found.pairs), truth.pairs);
      out.push_back({s.name, rungs[r], times.seconds[r], found.count, found.candidates, d.extra, d.missed,
                     found.rungs.unsure[0], false});
    }
    for (const rung r : {rung::fp32, rung::certified, rung::exact}) {
      if (!device || !p.decide[static_cast<int>(r)])
        continue;
      found = device->query(a, b, p, r, std::min(q.repetitions, 9));
      const double seconds = found.seconds;
      const list_difference d = difference_of(std::move(found.pairs), truth.pairs);
      out.push_back(
          {s.name, r, seconds, found.count, found.candidates, d.extra, d.missed, found.rungs.unsure[0], true});
    }
  }
  return out;
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
    "a power of "
    "two before, so that each wrong answer is right again after a move by 2^-20 of the size (`meet collide "
    "--tolerance`). On a "
    "device, times are by events on a list of four million pairs; *fp16 filter, device* calls a hit what the filter on "
    "the "
    "matrix unit does not rule out, of all pairs of 4,096 elements with 4,096.";

} // namespace

std::string trade(const app::kernel_library &kernels, const trade_request &q) {
  app::output_files outputs(q.a ? std::vector<fs::path>{*q.a, *q.b} : std::vector<fs::path>{});
  const catalogue &all = app::kernels_named(kernels, q.instruction_set);
  std::vector<const predicate_info *> mapped;
  for (int i = 0; i < all.predicate_count; ++i)
    if (is_measured(all.predicates[i]))
      mapped.push_back(&all.predicates[i]);
  const auto map_file = [](const predicate_info &p) { return fmt::format("map_{}.png", p.name); };
  if (q.folder && q.folder->empty())
    throw app::failure("-o: the folder's name is empty");
  if (q.folder) {
    for (const char *const name : {"trade.md", "trade.csv", "trade.png"})
      outputs.expect(*q.folder / name, true);
    for (const predicate_info *p : mapped)
      outputs.expect(*q.folder / map_file(*p), true);
    need_gnuplot();
  }
  const int threads = thread_count(q.threads);
  const std::vector<scene> scenes = scenes_of(all, q);
  auto progress = std::make_unique<app::progress_line>("trade");
  std::vector<trade_cell> cells;
  const std::unique_ptr<trade_device> device = trade_device_named(q.device);
  measure_pairs(
      all, q, scenes, device.get(), [&progress](double fraction) { (*progress)(fraction); }, cells);
  const std::vector<trade_query> queries = measure_queries(all, scenes, q, device.get(), threads);
  progress.reset();

  std::vector<table> tables;
  std::vector<std::string> families;
  for (const trade_cell &c : cells)
    if (families.empty() || families.back() != c.family)
      families.push_back(c.family);
  tables.reserve(families.size() + 2);
  for (const std::string &family : families)
    tables.push_back(table_of(family, cells));
  tables.push_back(losers_of(cells));
  if (q.a && families.back() != "files")
    tables.back().notes.emplace_back("The two files have no candidates, so there are no pairs of theirs above.");
  tables.push_back(table_of(queries, threads));

  const std::string set = name_of(all.compiled_for);
  const std::string about =
      fmt::format("{}\n\nMeasured with {}. Compiled by {}. {}\n\n{}\n", machine_in_words(), set, compiler_in_words(),
                  device ? fmt::format("Device: {}.", device->name()) : "No device took part.", rules);
  std::string text = about;
  std::string markdown = fmt::format(
      "# The trade of speed for accuracy\n\nWritten by `meet trade{}{} --threads {} --repetitions {} -o DIR`.\n\n{}",
      q.a ? " A B" : "", q.quick ? " --quick" : "", threads, q.repetitions, about);
  app::json json_tables = app::json::array();
  for (const table &t : tables) {
    text += fmt::format("\n{}", as_text(t));
    markdown += fmt::format("\n{}", as_markdown(t));
    json_tables.push_back(as_json(t));
  }
  if (q.folder) {
    outputs.make_folder(*q.folder);
    outputs.write(*q.folder / "trade.md", [&](const fs::path &to) { io::write_file(to, markdown); });
    outputs.write(*q.folder / "trade.csv", [&](const fs::path &to) { io::write_file(to, as_csv(cells)); });
    outputs.write(*q.folder / "trade.png", [&](const fs::path &to) {
      draw_trade(to,
                 fmt::format("{} Measured with {}.{}", machine_in_words(), set,
                             device ? fmt::format(" Device: {}.", device->name()) : ""),
                 cells);
    });
    for (const predicate_info *p : mapped)
      outputs.write(*q.folder / map_file(*p), [&](const fs::path &to) {
        const std::size_t n = q.quick ? 20 : 500;
        draw_maps(to, fmt::format("{}, {}: {} pairs in each cell", p->name, set, n),
                  {map_trade(*p, trade_maps::axis::scale, n), map_trade(*p, trade_maps::axis::offset, n)});
      });
    outputs.commit();
    text +=
        fmt::format("\nwrote trade.md, trade.csv, trade.png and {} maps into {}\n", mapped.size(), q.folder->string());
  }
  if (!q.json)
    return text;
  const app::json out = {{"machine", machine_in_words()},
                         {"compiler", compiler_in_words()},
                         {"instruction_set", set},
                         {"device", device ? app::json(device->name()) : app::json(nullptr)},
                         {"threads", threads},
                         {"repetitions", q.repetitions},
                         {"quick", q.quick},
                         {"tables", std::move(json_tables)}};
  return app::in_one_line(out) + '\n';
}

app::command add_trade(CLI::App &program, const app::kernel_library &kernels) {
  CLI::App &c =
      *program.add_subcommand("trade", "Measure what each precision costs, how often it is wrong, and how far");
  const auto q = std::make_shared<trade_request>();
  const auto threads = std::make_shared<std::optional<std::string>>(),
             repetitions = std::make_shared<std::optional<std::string>>();
  c.add_option("a", q->a, app::files_help)->type_name("A");
  c.add_option("b", q->b, "The same. The pairs and the query of the two files are measured beside the built-in ones")
      ->type_name("B");
  c.add_option("-o", q->folder,
               "Also write trade.md, trade.csv, trade.png and a map for each predicate into this folder")
      ->type_name("DIR");
  c.add_option("--instruction-set", q->instruction_set, "Measure this one; auto, the default: the best that runs here")
      ->type_name("auto|baseline|avx2|avx512");
  c.add_option("--device", q->device, "Also measure there; auto, the default: if there is one that this build can use")
      ->type_name("auto|cpu|cuda");
  c.add_option("--threads", *threads, "Threads of whole queries; 0 is all cores, 1 the default")->type_name("N");
  c.add_option("--repetitions", *repetitions,
               "How often the rungs take turns, by default 21; fewer where they take long")
      ->type_name("N");
  c.add_flag("--quick", q->quick, "Few pairs, to see that it runs")->disable_flag_override();
  c.add_flag("--json", q->json, "Print one JSON object instead of the tables")->disable_flag_override();
  return {&c, [kernels, q, threads, repetitions] {
            if (q->a.has_value() != q->b.has_value())
              throw app::failure("trade: a second set is needed beside the first");
            if (*threads)
              q->threads = app::threads_named(**threads);
            if (*repetitions)
              q->repetitions = repetitions_named(**repetitions);
            return trade(kernels, *q);
          }};
}

} // namespace meetc::bench
