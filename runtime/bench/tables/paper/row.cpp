#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/paint.hpp"
#include "meet/app/text/words.hpp"
#include "meet/bench/tables/paper/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace meetc::bench {

namespace {

pair_test test_by(const predicate_info &p, rung precision) {
  pair_decider by = decider_of(p, precision);
  if (!by)
    throw app::failure(fmt::format("{} was not generated for {}", p.name, app::name_of(precision)));
  return {std::move(by), precision == rung::fp32};
}

choice choice_for(const paper_context &c, const io::element_set &a, const io::element_set &b) {
  return app::choose(c.all, *a.kind, *b.kind, {}, {});
}

} // namespace

std::vector<pair_test> conformal_and(const paper_context &c, const io::element_set &a, const io::element_set &b,
                                     std::initializer_list<decide_function> classic) {
  const predicate_info &p = *choice_for(c, a, b).predicate;
  std::vector<pair_test> all{test_by(p, rung::certified), test_by(p, rung::fp32)};
  for (const decide_function one : classic)
    all.push_back({one});
  return all;
}

app::answers search_pairs(const paper_context &c, const io::element_set &a, const io::element_set &b, bool keep) {
  app::query h;
  h.by = choice_for(c, a, b);
  h.box = c.all.box;
  h.keep = keep;
  h.threads = c.threads;
  return app::collide_sets(a, b, h);
}

paper_row measure_row(const paper_context &c, const io::element_set &a, const io::element_set &b,
                      const std::vector<pair_test> &tests, app::answers &found) {
  const choice by = choice_for(c, a, b);
  found = search_pairs(c, a, b, &a == &b);
  paper_row row;
  row.a = a.elements, row.b = b.elements, row.pairs = found.pairs;
  row.hit_a = found.a.touched, row.hit_b = found.b.touched;

  std::optional<prepared> ready_a, ready_b;
  collide_options options;
  options.want = answer_kind::count;
  options.threads = 1;
  options.box = c.all.box;
  const auto find = [&](rung precision) {
    const prepared &first = by.swapped ? *ready_b : *ready_a, &second = by.swapped ? *ready_a : *ready_b;
    meetc::collide(first, second, *by.predicate, precision, options);
  };
  // The first query after preparing finds cold memory and computes what the sets store, for whichever rung comes first, so
  // one that nothing is made of stands before the two that are compared.
  const brute_force every(*by.predicate, a, b, c.budget);
  works all{reference_work(),
            [&] {
              ready_a.emplace(app::prepare(a, 1));
              ready_b.emplace(app::prepare(b, 1));
              find(rung::certified);
            },
            [&] { find(rung::fp32); }, [&] { find(rung::certified); }, [&] { find(rung::fp32); }};
  const std::size_t first_test = all.size();
  for (const pair_test &test : tests)
    all.emplace_back([&every, &test] { every.run(test); });
  host_clock clock(1);
  const times timed = take_turns(clock, all, {c.runs, 3600});
  const double reference = timed.seconds[0];
  row.search = timed.seconds[1] / reference;
  row.search_certified_over_fp32 = timed.seconds[3] / timed.seconds[4];
  row.compared = every.pairs();
  for (std::size_t t = 0; t < tests.size(); ++t) {
    row.tests.push_back(timed.seconds[first_test + t] / every.share() / reference);
    row.wrong.push_back(every.compared(tests[t], tests[0]));
  }
  const std::string scene = fmt::format("{} and {}", app::counted(a), app::counted(b));
  if (!every.is_sample())
    require_truth(scene, "every pair on one core, certified,", difference_of(row.wrong[0].found, found.pairs));
  if (c.device) {
    row.device = c.device->time_every_pair({a, b, by}, c.runs);
    require_truth(scene, c.device->name(), difference_of(row.device->pairs, found.pairs));
    row.device_search = row.device->seconds_with_transfers / reference;
    row.core_over_device = row.core() / row.device_search;
  }
  return row;
}

column<paper_row> core_column(const std::vector<paper_row> &rows) {
  return {"core", "one core,|x first row",
          [first = rows.front().core()](const paper_row &r) { return of_ratio(r.core() / first); }};
}

columns<paper_row> with_device(columns<paper_row> to) {
  const auto add = [&to](const char *key, const char *title, cell (*form)(double),
                         double (*figure)(const paper_row &)) {
    to.push_back(
        {key, title, [form, figure](const paper_row &r) { return r.device ? form(figure(r)) : missing("no device"); }});
  };
  add("gpu_ms", "GPU, every|pair, ms", of_milliseconds, [](const paper_row &r) { return r.device->seconds; });
  add("gpu_ms_with_transfers", "with|transfers", of_milliseconds,
      [](const paper_row &r) { return r.device->seconds_with_transfers; });
  add("core_over_gpu", "one core|/ GPU", of_ratio, [](const paper_row &r) { return r.core_over_device; });
  return to;
}

std::vector<std::string> claim_of(const paper_context &c, const std::vector<paper_row> &rows) {
  if (!c.device || rows.empty())
    return {};
  const auto [least, most] = std::minmax_element(rows.begin(), rows.end(), [](const paper_row &x, const paper_row &y) {
    return x.core_over_device < y.core_over_device;
  });
  return {
      fmt::format("one core / GPU: every pair on one core, conformal fp32, against every pair on {}, certified, with "
                  "transfers: {} to {}. The paper says three orders of magnitude; its own row is 42.0.",
                  c.device->name(), of_ratio(least->core_over_device).text, of_ratio(most->core_over_device).text)};
}

std::vector<std::pair<double, double>> points_of(const std::vector<paper_row> &rows, double over,
                                                 const std::function<double(const paper_row &)> &time) {
  std::vector<std::pair<double, double>> out;
  for (const paper_row &r : rows)
    out.emplace_back(static_cast<double>(r.b), time(r) / over);
  return out;
}

std::vector<curve> curves_of(const paper_context &c, const std::vector<paper_row> &rows) {
  const double first = rows.front().core();
  std::vector<curve> out{{"one core, every pair, conformal fp32", curve_colours::cpu,
                          points_of(rows, first, [](const paper_row &r) { return r.core(); })},
                         {"one core, meet's search, certified", curve_colours::search,
                          points_of(rows, first, [](const paper_row &r) { return r.search; })}};
  if (c.device)
    out.push_back({"GPU, every pair, certified, with transfers", curve_colours::gpu,
                   points_of(rows, first, [](const paper_row &r) { return r.device_search; })});
  return out;
}

paper_figure figure_of(const paper_context &c, int number, chart drawn) {
  std::string title = drawn.title;
  return {number, std::move(title), [drawn = std::move(drawn), quick = c.quick](const std::filesystem::path &to) {
            plot_of(drawn, quick ? 800 : 1000, quick ? 450 : 650).draw(to);
          }};
}

paper_figure figure_of(const paper_context &c, int number, std::string title, std::vector<painted_set> sides) {
  const auto kept = std::make_shared<std::vector<painted_set>>(std::move(sides));
  return {number, std::move(title), [kept, quick = c.quick](const std::filesystem::path &to) {
            std::vector<app::painted> painted;
            for (const painted_set &s : *kept)
              painted.push_back({s.set, s.hit, s.name, s.base, s.hit_colour});
            app::write_picture(to, painted, quick ? app::picture_view{{}, 800, 450} : app::picture_view{});
          }};
}

} // namespace meetc::bench
