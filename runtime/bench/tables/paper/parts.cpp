#include "bench/tables/paper/parts.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace meetc::bench {

search search_pairs(const paper_context &c, const io::element_set &a, const io::element_set &b, bool keep) {
  search s;
  app::query h;
  h.by = app::choose(c.all, *a.kind, *b.kind, {}, {});
  h.box = c.all.box;
  h.keep = keep;
  h.threads = c.threads;
  s.found = app::collide_sets(a, b, h);

  std::optional<prepared> ready_a, ready_b;
  const auto make_ready = [&] {
    ready_a.emplace(app::prepare(a, 1));
    ready_b.emplace(app::prepare(b, 1));
  };
  make_ready();
  collide_options options;
  options.want = answer_kind::count;
  options.threads = 1;
  options.box = c.all.box;
  const auto find = [&](rung precision) {
    const prepared &first = h.by.swapped ? *ready_b : *ready_a, &second = h.by.swapped ? *ready_a : *ready_b;
    meetc::collide(first, second, *h.by.predicate, precision, options);
  };
  const std::vector<double> whole = c.by.measure({[&] {
                                                   make_ready();
                                                   find(rung::certified);
                                                 }},
                                                 c.runs);
  // The ratio is that of sets which both rungs have used before: the first query after preparing finds cold memory and
  // computes what the sets store, for whichever rung comes first.
  find(rung::fp32);
  const std::vector<double> warm = c.by.measure({[&] { find(rung::certified); }, [&] { find(rung::fp32); }}, c.runs);
  s.time = whole[0];
  s.certified_over_fp32 = warm[0] / warm[1];
  return s;
}

std::vector<column> device_columns() {
  return {{"gpu_ms", "GPU, every|pair, ms"},
          {"gpu_ms_with_transfers", "with|transfers"},
          {"core_over_gpu", "one core|/ GPU"}};
}

device_cells ask_device(const paper_context &c, const io::element_set &a, const io::element_set &b, std::uint64_t pairs,
                        double one_core) {
  if (!c.device)
    return {{missing("no device"), missing("no device"), missing("no device")}};
  const device_time t = c.device->time({a, b, app::choose(c.all, *a.kind, *b.kind, {}, {})}, c.runs);
  if (t.pairs != pairs)
    throw app::failure(fmt::format("{}: {} pairs found on the device, {} on the CPU, of {} and {}", c.device->name(),
                                   app::grouped(t.pairs), app::grouped(pairs), app::counted(a), app::counted(b)),
                       app::no_device);
  const double ratio = c.by.seconds(one_core) / t.seconds_with_transfers;
  return {{of_milliseconds(t.seconds), of_milliseconds(t.seconds_with_transfers), of_ratio(ratio)},
          t.seconds_with_transfers / c.by.seconds(1),
          ratio};
}

void add_claim(const paper_context &c, const std::vector<double> &core_over_gpu, table &to) {
  if (!c.device || core_over_gpu.empty())
    return;
  const auto [least, most] = std::minmax_element(core_over_gpu.begin(), core_over_gpu.end());
  to.notes.push_back(fmt::format("one core / GPU: every pair on one core, conformal fp32, against every pair on {}, "
                                 "certified, with transfers: {} to {}. The paper says three orders of magnitude; its "
                                 "own row is 42.0.",
                                 c.device->name(), of_ratio(*least).text, of_ratio(*most).text));
}

decide_function decide_by(const app::choice &by, rung precision) {
  const decide_function f = by.predicate->decide[static_cast<int>(precision)];
  if (!f)
    throw app::failure(fmt::format("{} was not generated for {}", by.predicate->name, app::name_of(precision)));
  return f;
}

} // namespace meetc::bench
