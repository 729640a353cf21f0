// Kernels alone, and whole queries, on every pair and by the hierarchy.
#include "meet/bench/tables/gpu/measure.hpp"

#include "meet/app/text/words.hpp"
#include "meet/bench/tables/gpu/sets.hpp"

#include <cga/cga_cuda.hpp>
#include <cga/cga_every_pair.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace meetc::bench {

namespace {

constexpr int runs = 7;
// Pairs that a multiprocessor can filter in a clock cycle: the half-precision products of its matrix unit, over K = 16.
// Compute capability 9.0 has 2048, and 8.0 half of that.
double pairs_a_clock(const device_facts &f) {
  return f.major >= 9 ? 128 : 64;
}

const char *name_of(every_pair::filter f) {
  static const char *const names[] = {"float32", "mma.sync", "wgmma"};
  return names[static_cast<int>(f)];
}

std::vector<baseline> baselines_of(const std::string &predicate) {
  if (predicate == "ball_ball")
    return {baseline::balls_fp32, baseline::balls_fp64};
  if (predicate == "triangle_triangle")
    return {baseline::moller_0_fp32, baseline::moller_fp32, baseline::guigue_devillers_fp32};
  if (predicate == "box_box")
    return {baseline::boxes_fp32};
  return {baseline::moller_trumbore_0_fp32};
}

// A kernel or a query; limit: pairs a second that the matrix unit allows, with_transfers: seconds. 0: neither applies.
struct kernel_row {
  std::string name;
  std::optional<std::uint64_t> found;
  double seconds, limit = 0, with_transfers = 0;
};

struct tangent_row {
  std::string scene;
  std::uint64_t balls, found;
  double share, plain, certified;
};

} // namespace

gpu_bench::gpu_bench(const scene_source &from)
    : source_(from), all_(from.all), on_(cga::cuda::catalogue()), every_pair_(on_, cga::every_pair::catalogue()),
      timer_(on_) {}

std::string gpu_bench::device_in_words() {
  const device_facts &f = on_.facts();
  const every_pair::probe_result &p = every_pair_.probe();
  return fmt::format("{}, compute capability {}.{}, {} multiprocessors. The probe tried {} sums: mma.sync left "
                     "the model in {}, wgmma in {}{}. Times are medians of {} warm runs.",
                     f.name, f.major, f.minor, f.multiprocessors, app::grouped(p.cases), p.mma_faults, p.wgmma_faults,
                     p.has_wgmma ? "" : " (this device has none)", runs);
}

table gpu_bench::measure(const scene &of) {
  using every_pair::filter;
  const sets_here sets(of, all_);
  const prepared a = app::prepare(sets.a()), b = app::prepare(sets.b());
  device_set on_a(on_, a), on_b(on_, b);
  std::vector<kernel_row> rows;
  std::vector<std::string> notes;
  for (const baseline by : baselines_of(of.predicate)) {
    const counted_pairs r = count(by, on_a, on_b);
    rows.push_back({fmt::format("{}{}", name_of(by), r.found ? "" : ", a part of B"), r.found, r.seconds});
    if (!r.found && notes.empty())
      notes.emplace_back(
          "A part of B: its first elements, which lie together in space; the time is scaled to all of it.");
  }
  const auto add_query = [&](const std::string &name, double limit, const auto &ask) {
    const whole_query q = query(of.name + ": " + name, ask, a, b, on_a, on_b);
    rows.push_back({name, q.found, q.seconds, limit, q.with_transfers});
  };
  const auto by_every_pair = [&](filter f, rung precision) {
    return [this, &sets, f, precision](device_set &x, device_set &y) -> asked {
      const every_pair::outcome r =
          every_pair_.collide(x, y, sets.predicate, precision, {.by = f, .balls = cover::element});
      return {r.count, r.device_seconds};
    };
  };
  for (const filter f : {filter::float32, filter::mma, filter::wgmma}) {
    if (!every_pair_.offers(f))
      continue;
    const filtered r = filter_alone(f, on_a, on_b);
    const double limit = f == filter::float32 ? 0 : pairs_a_clock(on_.facts()) * on_.facts().multiprocessors * r.hertz;
    rows.push_back({fmt::format("filter alone, {}, every pair", name_of(f)), r.found, r.seconds, limit});
    if (limit > 0)
      notes.push_back(fmt::format("{}: clock {:.0f} MHz in the run, so the limit is {:.1f} Tpairs/s.", name_of(f),
                                  r.hertz / 1e6, limit / 1e12));
    if (f == every_pair_.best_filter())
      add_query("query, plain fp32, every pair", limit, by_every_pair(f, rung::fp32));
    add_query(fmt::format("query, certified, {}, every pair", name_of(f)), limit, by_every_pair(f, rung::certified));
  }
  add_query("query, certified, hierarchy", 0, [&](device_set &x, device_set &y) -> asked {
    const device_result r = meetc::collide(on_, x, y, sets.predicate, rung::certified);
    return {r.count, r.device_seconds};
  });
  for (const kernel_row &r : rows)
    if (r.name.starts_with("query, certified"))
      require_truth(of.name, r.name, difference_of(*r.found, *rows.back().found));
  const double pairs = static_cast<double>(a.elements()) * static_cast<double>(b.elements()),
               first = rows.front().seconds;
  const auto with_transfers = [](cell (*form)(double), double figure, bool there) {
    return there ? form(figure) : missing("");
  };
  return table_of<kernel_row>(
      of.predicate, fmt::format("{}: {} x {}", of.name, app::counted(sets.a()), app::counted(sets.b())),
      {{"kernel", "kernel", of_words, &kernel_row::name},
       {"found", "found", [](const kernel_row &r) { return r.found ? of_count(*r.found) : missing(""); }},
       {"ms", "ms", of_milliseconds, &kernel_row::seconds},
       {"tpairs", "Tpairs/s", of_rate, [pairs](const kernel_row &r) { return pairs / r.seconds; }},
       {"ratio", "x first row", of_ratio, [first](const kernel_row &r) { return first / r.seconds; }},
       {"of_limit", "of the|limit",
        [=](const kernel_row &r) { return with_transfers(of_share, pairs / r.seconds / r.limit, r.limit > 0); }},
       {"ms_with_transfers", "ms with|transfers",
        [=](const kernel_row &r) { return with_transfers(of_milliseconds, r.with_transfers, r.with_transfers > 0); }},
       {"tpairs_with_transfers", "Tpairs/s with|transfers",
        [=](const kernel_row &r) { return with_transfers(of_rate, pairs / r.with_transfers, r.with_transfers > 0); }}},
      rows, std::move(notes));
}

table gpu_bench::measure_tangent() {
  std::vector<tangent_row> rows;
  for (const scene &of : tangent_scenes(source_)) {
    const sets_here sets(of, all_);
    const prepared a = app::prepare(sets.a()), b = app::prepare(sets.b());
    device_set on_a(on_, a), on_b(on_, b);
    every_pair::outcome last;
    const auto time = [&](rung precision) {
      const every_pair::options how{.want = answer_kind::count, .balls = cover::element}; // the same filter for both
      return medians_of<1>(runs, [&] {
        last = every_pair_.collide(on_a, on_b, sets.predicate, precision, how);
        return std::array{last.device_seconds};
      })[0];
    };
    const double plain = time(rung::fp32), certified = time(rung::certified);
    const double pairs = static_cast<double>(a.elements()) * static_cast<double>(b.elements());
    rows.push_back(
        {of.name, a.elements(), last.count, static_cast<double>(last.rungs.unsure[0]) / pairs, plain, certified});
  }
  const auto share = [](const tangent_row &r) -> cell {
    return {fmt::format("{:.2g}", r.share), fmt::format("{:.6g}", r.share)};
  };
  return table_of<tangent_row>(
      "tangent", "Unsure pairs: certified against plain fp32, balls",
      {{"scene", "scene", of_words, &tangent_row::scene},
       {"balls", "balls|a side", of_count, &tangent_row::balls},
       {"share", "unsure in fp32,|of all pairs", share},
       {"pairs", "pairs|touch", of_count, &tangent_row::found},
       {"plain", "plain fp32,|ms", of_milliseconds, &tangent_row::plain},
       {"certified", "certified,|ms", of_milliseconds, &tangent_row::certified},
       {"ratio", "certified /|plain", of_ratio, [](const tangent_row &r) { return r.certified / r.plain; }}},
      rows, {"Both count; the filter is the same. Unsure pairs touch in exactly one point."});
}

gpu_bench::given_times gpu_bench::time_given(const sets_here &sets) {
  device_set given_a = device_set::given(on_, io::view_of(sets.a()), *sets.a().kind);
  std::optional<device_set> its_own;
  device_set &given_b =
      sets.of.itself ? given_a : its_own.emplace(device_set::given(on_, io::view_of(sets.b()), *sets.b().kind));
  std::uint64_t found = 0;
  pairs_there pairs;
  const device_options leaves_pairs{.leave_there = &pairs};
  const auto [device, wall] = medians_of<2>(runs, [&] {
    const device_result r = meetc::collide(on_, given_a, given_b, sets.predicate, rung::certified, leaves_pairs);
    found = r.count;
    return std::array{r.device_seconds, r.seconds};
  });
  return {found, device, wall};
}

gpu_bench::counted_pairs gpu_bench::count(baseline by, const device_set &a, const device_set &b) {
  counts_.reserve(1, "a counter");
  const double pairs = static_cast<double>(a.elements()) * b.elements(), share = std::min(1.0, 1e11 / pairs);
  const auto m = static_cast<std::size_t>(share * b.elements());
  const auto once = [&] {
    check(cudaMemsetAsync(counts_.data(), 0, sizeof(unsigned long long), on_.stream()), "clearing a counter");
    check(count_pairs(by, a.rows().data(), a.elements(), b.rows().data(), m, counts_.data(), on_.stream()),
          "starting a baseline");
  };
  const double seconds = timer_.seconds(once, runs) / share;
  if (share < 1)
    return {{}, seconds};
  return {counted_on_device(), seconds};
}

std::uint64_t gpu_bench::counted_on_device() {
  unsigned long long n = 0;
  check(cudaMemcpy(&n, counts_.data(), sizeof n, cudaMemcpyDeviceToHost), "reading a counter");
  return n;
}

gpu_bench::filtered gpu_bench::filter_alone(every_pair::filter f, device_set &a, device_set &b) {
  list_.reserve(std::size_t{1} << 26, "a list of candidates");
  counts_.reserve(1, "a counter");
  const auto once = [&] {
    check(cudaMemsetAsync(counts_.data(), 0, sizeof(unsigned long long), on_.stream()), "clearing a counter");
    every_pair_.list_near(f, cover::element, a, b, {list_.data(), counts_.data(), list_.capacity()});
  };
  double seconds = timer_.seconds(once, runs);
  while (counted_on_device() > list_.capacity()) { // the filter stops early where the list is full
    list_.reserve(2 * list_.capacity(), "a list of candidates");
    seconds = timer_.seconds(once, runs);
  }
  const std::uint64_t found = counted_on_device();
  return {found, seconds, timer_.clock_during(once, seconds)};
}

gpu_bench::whole_query gpu_bench::query(const std::string &what,
                                        const std::function<asked(device_set &, device_set &)> &ask, const prepared &a,
                                        const prepared &b, device_set &on_a, device_set &on_b) {
  host_clock clock(0);
  std::uint64_t found = 0;
  const auto [seconds, with_transfers] = medians_of<2>(runs, [&] {
    const asked r = ask(on_a, on_b);
    clock.start();
    device_set fresh_a(on_, a), fresh_b(on_, b);
    const asked again = ask(fresh_a, fresh_b);
    const double whole = clock.stop();
    require_truth(what, "the same query on fresh sets", difference_of(again.found, r.found));
    found = r.found;
    return std::array{r.device_seconds, whole};
  });
  return {found, seconds, with_transfers};
}

} // namespace meetc::bench
