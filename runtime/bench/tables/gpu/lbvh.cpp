// The hierarchy of the usual kind beside ours.
#include "meet/app/input/failure.hpp"
#include "meet/bench/baselines/gpu_lbvh.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"

#include <fmt/format.h>

#include <memory>

namespace meetc::bench {

namespace {

constexpr int runs = 7;

baseline test_of(const std::string &predicate) {
  if (predicate == "ball_ball")
    return baseline::balls_fp32;
  if (predicate == "triangle_triangle")
    return baseline::moller_0_fp32;
  if (predicate == "segment_triangle")
    return baseline::moller_trumbore_0_fp32;
  if (predicate == "box_box")
    return baseline::boxes_fp32;
  throw app::failure(fmt::format("bench gpu: no classic test for {}", predicate));
}

struct row {
  std::string scene;
  std::uint64_t a = 0, b = 0, found = 0, accepted = 0;
  double build = 0, query = 0, ordered = 0, first = 0, given = 0, given_wall = 0;
};

} // namespace

table gpu_bench::measure_lbvh(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  const auto measure_scene = [&](const scene &of) {
    const baseline by = test_of(of.predicate);
    const sets_here sets(of, all_);
    row r{of.name};
    std::unique_ptr<sets_there> there;
    const auto [ordered, first] = medians_of<2>(runs, [&] {
      there.reset(); // before there are others: two copies of the largest sets need not fit
      there = std::make_unique<sets_there>(on_, sets);
      const device_result d = meetc::collide(on_, there->a(), there->b(), sets.predicate, rung::certified);
      r.found = d.count;
      return std::array{there->ordered_seconds(), d.device_seconds};
    });
    const given_times given = time_given(sets);
    require_truth(of.name, "a query of sets as they are given", difference_of(given.found, r.found));
    device_set &a = there->a(), &b = there->b();
    baselines::lbvh_box within{};
    b.bounds(within.lo, within.hi);
    gpu_lbvh tree(b.elements(), static_cast<unsigned>(b.kind().fields));
    r.build = timer_.seconds(
        [&] { check(tree.build(b.rows().data(), within, on_.stream()), "building a baseline's hierarchy"); }, runs);
    counts_.reserve(1, "a counter");
    list_.reserve(2 * r.found + 1024, "a baseline's pairs");
    r.query = timer_.seconds(
        [&] {
          check(cudaMemsetAsync(counts_.data(), 0, sizeof(unsigned long long), on_.stream()), "clearing a counter");
          const cudaError_t e =
              of.itself ? tree.query_itself(by, list_.data(), list_.capacity(), counts_.data(), on_.stream())
                        : tree.query(by, a.rows().data(), a.elements(), list_.data(), list_.capacity(), counts_.data(),
                                     on_.stream());
          check(e, "starting a baseline's query");
        },
        runs);
    r.accepted = counted_on_device();
    r.a = a.elements(), r.b = b.elements();
    r.ordered = ordered, r.first = first, r.given = given.device, r.given_wall = given.wall;
    return r;
  };
  std::vector<row> rows;
  for (const scene &of : scenes) {
    rows.push_back(measure_scene(of));
    progress();
  }
  return table_of<row>(
      "lbvh", "A hierarchy of the usual kind beside ours",
      {{"scene", "scene", of_words, &row::scene},
       {"a", "elements of A", of_count, &row::a},
       {"b", "elements of B", of_count, &row::b},
       {"pairs", "pairs", of_count, &row::found},
       {"accepted", "LBVH:|accepted in fp32", of_count, &row::accepted},
       {"build", "LBVH:|build, ms", of_milliseconds, &row::build},
       {"query", "LBVH:|query, ms", of_milliseconds, &row::query},
       {"ordered", "ours: both|ordered, ms", of_milliseconds, &row::ordered},
       {"first", "ours: boxes|and query, ms", of_milliseconds, &row::first},
       {"given", "ours, given:|all of it, ms", of_milliseconds, &row::given},
       {"given_wall", "ours, given:|wall clock, ms", of_milliseconds, &row::given_wall},
       {"ratio", "LBVH /|ours, given", [](const row &r) { return of_ratio((r.build + r.query) / r.given); }}},
      rows,
      {"LBVH: after Karras 2012, over the elements of B, with one thread for each element of A and the classic test in "
       "plain fp32 at the leaves: distance of balls, Möller with epsilon 0, Möller-Trumbore with epsilon 0, "
       "comparisons "
       "of boxes. Segments walk as rays do, through the boxes that they reach; all else walks with its box. Its pairs "
       "stay unsorted. It is given the extent of B, and A in our spatial order, without their time. In a set with "
       "itself it looks at each pair of two elements once, and so counts less than half of the pairs. Ours: certified, "
       "and sorted; both sets are ordered on the device and enclosed. Given: the same of sets that lie on the device "
       "as "
       "they were uploaded, in one call, which leaves out what can touch nothing where that is expected to pay, orders "
       "the rest and leaves sorted pairs on the device; the device's time is from its first kernel to its last and "
       "contains what the host takes in between, and the wall clock is the call's."});
}

} // namespace meetc::bench
