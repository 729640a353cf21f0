#include "bench/tables/gpu/measure.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "core/find.hpp"

#include <cga/cga_cuda.hpp>
#include <cga/cga_every_pair.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

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

} // namespace

gpu_bench::gpu_bench(const catalogue &all, bool quick)
    : all_(all), quick_(quick), on_(cga::cuda::catalogue()), every_pair_(on_, cga::every_pair::catalogue()),
      timer_(on_) {}

std::string gpu_bench::device_in_words() {
  const device_facts &f = on_.facts();
  const every_pair::probe_result &p = every_pair_.probe();
  return fmt::format("{}, compute capability {}.{}, {} multiprocessors. The probe tried {} sums: mma.sync left "
                     "the model in {}, wgmma in {}{}. Times are medians of {} warm runs.",
                     f.name, f.major, f.minor, f.multiprocessors, app::grouped(p.cases), p.mma_faults, p.wgmma_faults,
                     p.has_wgmma ? "" : " (this device has none)", runs);
}

table gpu_bench::measure(const gpu_scene &scene) {
  const auto [first, second] = scene.make();
  const prepared a = app::prepare(first), b = app::prepare(second);
  device_set on_a(on_, a), on_b(on_, b);
  const predicate_info &p = find_predicate(all_, scene.predicate);
  const double pairs = static_cast<double>(a.elements()) * static_cast<double>(b.elements());
  table t;
  t.name = scene.predicate;
  t.title = fmt::format("{}: {} x {}", scene.name, app::counted(first), app::counted(second));
  t.columns = {{"kernel", "kernel"},
               {"found", "found"},
               {"ms", "ms"},
               {"tpairs", "Tpairs/s"},
               {"ratio", "x first row"},
               {"of_limit", "of the|limit"},
               {"ms_with_transfers", "ms with|transfers"},
               {"tpairs_with_transfers", "Tpairs/s with|transfers"}};
  double first_seconds = 0;
  const auto add = [&](const std::string &name, std::optional<std::uint64_t> found, double seconds, double limit,
                       double whole) {
    first_seconds = first_seconds > 0 ? first_seconds : seconds;
    t.rows.push_back(
        {of_words(name), found ? of_count(*found) : missing(""), of_milliseconds(seconds), of_rate(pairs / seconds),
         of_ratio(first_seconds / seconds), limit > 0 ? of_share(pairs / seconds / limit) : missing(""),
         whole > 0 ? of_milliseconds(whole) : missing(""), whole > 0 ? of_rate(pairs / whole) : missing("")});
  };
  for (const baseline by : baselines_of(scene.predicate)) {
    const counted_pairs r = count(by, on_a, on_b);
    add(fmt::format("{}{}", name_of(by), r.found ? "" : ", a part of B"), r.found, r.seconds, 0, 0);
    if (!r.found && t.notes.empty())
      t.notes.emplace_back(
          "A part of B: its first elements, which lie together in space; the time is scaled to all of it.");
  }
  using every_pair::filter;
  const auto by_every_pair = [&](filter f, rung precision) {
    const auto ask = [&](device_set &x, device_set &y) -> counted {
      const every_pair::outcome r = every_pair_.collide(x, y, p, precision, {.by = f, .balls = cover::element});
      return {r.count, r.device_seconds};
    };
    return query(ask, a, b, on_a, on_b);
  };
  for (const filter f : {filter::float32, filter::mma, filter::wgmma}) {
    if (!every_pair_.offers(f))
      continue;
    const filtered r = filter_alone(f, on_a, on_b);
    const double limit = pairs_a_clock(on_.facts()) * on_.facts().multiprocessors * r.hertz;
    add(fmt::format("filter alone, {}, every pair", name_of(f)), r.found, r.seconds, f == filter::float32 ? 0 : limit,
        0);
    if (f != filter::float32)
      t.notes.push_back(fmt::format("{}: clock {:.0f} MHz in the run, so the limit is {:.1f} Tpairs/s.", name_of(f),
                                    r.hertz / 1e6, limit / 1e12));
    if (f == every_pair_.best_filter()) {
      const whole_query plain = by_every_pair(f, rung::fp32);
      add("query, plain fp32, every pair", plain.found, plain.seconds, limit, plain.with_transfers);
    }
    const whole_query certified = by_every_pair(f, rung::certified);
    add(fmt::format("query, certified, {}, every pair", name_of(f)), certified.found, certified.seconds,
        f == filter::float32 ? 0 : limit, certified.with_transfers);
  }
  const auto by_hierarchy = [&](device_set &x, device_set &y) -> counted {
    const device_result r = meetc::collide(on_, x, y, p, rung::certified);
    return {r.count, r.device_seconds};
  };
  const whole_query tree = query(by_hierarchy, a, b, on_a, on_b);
  add("query, certified, hierarchy", tree.found, tree.seconds, 0, tree.with_transfers);
  return t;
}

table gpu_bench::measure_tangent() {
  table t;
  t.name = "tangent";
  t.title = "Unsure pairs: certified against plain fp32, balls";
  t.columns = {{"scene", "scene"},
               {"balls", "balls|a side"},
               {"share", "unsure in fp32,|of all pairs"},
               {"pairs", "pairs|touch"},
               {"plain", "plain fp32,|ms"},
               {"certified", "certified,|ms"},
               {"ratio", "certified /|plain"}};
  t.notes.emplace_back("Both count; the filter is the same. Unsure pairs touch in exactly one point.");
  const predicate_info &p = find_predicate(all_, "ball_ball");
  for (const auto &make : tangent_scenes(all_, quick_)) {
    const tangent_scene s = make();
    const prepared a = app::prepare(s.a), b = app::prepare(s.b);
    device_set on_a(on_, a), on_b(on_, b);
    std::uint64_t unsure = 0, found = 0;
    const auto time = [&](rung precision) {
      const every_pair::options count{.want = answer_kind::count, .balls = cover::element}; // the same filter for both
      std::vector<double> seconds;
      for (int i = 0; i <= runs; ++i) {
        const every_pair::outcome r = every_pair_.collide(on_a, on_b, p, precision, count);
        if (i > 0)
          seconds.push_back(r.device_seconds);
        unsure = r.rungs.unsure[0];
        found = r.count;
      }
      return median(seconds);
    };
    const double plain = time(rung::fp32), certified = time(rung::certified);
    const double pairs = static_cast<double>(a.elements()) * static_cast<double>(b.elements());
    t.rows.push_back({of_words(s.name),
                      of_count(a.elements()),
                      {fmt::format("{:.2g}", static_cast<double>(unsure) / pairs),
                       fmt::format("{:.6g}", static_cast<double>(unsure) / pairs)},
                      of_count(found),
                      of_milliseconds(plain),
                      of_milliseconds(certified),
                      of_ratio(certified / plain)});
  }
  return t;
}

gpu_bench::given_times gpu_bench::time_given(const gpu_scene &scene, const io::element_set &a, const io::element_set &b,
                                             const predicate_info &p) {
  given_set given_a(on_, app::view_of(a), *a.kind);
  std::optional<given_set> its_own;
  given_set &given_b = scene.itself ? given_a : its_own.emplace(on_, app::view_of(b), *b.kind);
  std::vector<double> seconds, wall;
  std::uint64_t found = 0;
  for (int i = 0; i <= runs; ++i) {
    pairs_there pairs;
    const device_result r = meetc::collide(on_, given_a, given_b, p, rung::certified, {}, &pairs);
    found = r.count;
    if (i > 0)
      seconds.push_back(r.device_seconds), wall.push_back(r.seconds);
  }
  return {found, median(seconds), median(wall)};
}

gpu_bench::counted_pairs gpu_bench::count(baseline by, const device_set &a, const device_set &b) {
  counts_.reserve(1, "a counter");
  const double pairs = static_cast<double>(a.elements()) * b.elements(), share = std::min(1.0, 1e11 / pairs);
  const auto m = static_cast<std::size_t>(share * b.elements());
  const auto once = [&] {
    check(cudaMemsetAsync(counts_.data(), 0, sizeof(unsigned long long), on_.stream()), "clearing a counter");
    check(count_pairs(by, a.rows(), a.elements(), b.rows(), m, counts_.data(), on_.stream()), "starting a baseline");
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

gpu_bench::whole_query gpu_bench::query(const std::function<counted(device_set &, device_set &)> &ask,
                                        const prepared &a, const prepared &b, device_set &on_a, device_set &on_b) {
  std::vector<double> seconds, whole;
  std::uint64_t found = 0;
  for (int i = 0; i <= runs; ++i) {
    const counted r = ask(on_a, on_b);
    const auto start = std::chrono::steady_clock::now();
    device_set fresh_a(on_, a), fresh_b(on_, b);
    const counted again = ask(fresh_a, fresh_b);
    const std::chrono::duration<double> with = std::chrono::steady_clock::now() - start;
    if (again.found != r.found)
      throw app::failure("bench gpu: two runs of one query differ", app::no_device);
    found = r.found;
    if (i > 0)
      seconds.push_back(r.device_seconds), whole.push_back(with.count());
  }
  return {found, median(seconds), median(whole)};
}

} // namespace meetc::bench
