// The hierarchy of the usual kind beside ours.
#include "app/failure.hpp"
#include "app/sets.hpp"
#include "bench/baselines/gpu_lbvh.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "core/find.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::bench {

namespace {

constexpr int runs = 7;

std::optional<baseline> test_of(const std::string &predicate) {
  if (predicate == "ball_ball")
    return baseline::balls_fp32;
  if (predicate == "triangle_triangle")
    return baseline::moller_0_fp32;
  if (predicate == "segment_triangle")
    return baseline::moller_trumbore_0_fp32;
  if (predicate == "box_box")
    return baseline::boxes_fp32;
  return {};
}

} // namespace

table gpu_bench::measure_lbvh(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress) {
  table t;
  t.name = "lbvh";
  t.title = "A hierarchy of the usual kind beside ours";
  t.columns = {{"scene", "scene"},
               {"a", "elements of A"},
               {"b", "elements of B"},
               {"pairs", "pairs"},
               {"accepted", "LBVH:|accepted in fp32"},
               {"build", "LBVH:|build, ms"},
               {"query", "LBVH:|query, ms"},
               {"ordered", "ours: both|ordered, ms"},
               {"first", "ours: boxes|and query, ms"},
               {"given", "ours, given:|all of it, ms"},
               {"given_wall", "ours, given:|wall clock, ms"},
               {"ratio", "LBVH /|ours, given"}};
  t.notes.emplace_back(
      "LBVH: after Karras 2012, over the elements of B, with one thread for each element of A and the classic test in "
      "plain fp32 at the leaves: distance of balls, Möller with epsilon 0, Möller-Trumbore with epsilon 0, comparisons "
      "of boxes. Segments walk as rays do, through the boxes that they reach; all else walks with its box. Its pairs "
      "stay unsorted. It is given the extent of B, and A in our spatial order, without their time. Of a set with "
      "itself it looks at each pair of two elements once, and so counts less than half of the pairs. Ours: certified, "
      "and sorted; both sets are ordered on the device and enclosed. Given: the same of sets that lie on the device as "
      "they were uploaded, in one call, which leaves out what can touch nothing where that is expected to pay, orders "
      "the rest and leaves sorted pairs on the device; the device's time is from its first kernel to its last and "
      "contains what the host takes in between, and the wall clock is the call's.");
  for (const gpu_scene &scene : scenes) {
    const std::optional<baseline> by = test_of(scene.predicate);
    if (!by)
      throw app::failure(fmt::format("bench gpu: no classic test for {}", scene.predicate));
    const auto made_sets = scene.make();
    const io::element_set &first = made_sets.first, &second = scene.itself ? first : made_sets.second;
    const predicate_info &p = find_predicate(all_, scene.predicate);
    device_options o;
    std::vector<double> ordered, query;
    std::uint64_t found = 0;
    std::optional<device_set> a, its_own;
    for (int i = 0; i <= runs; ++i) {
      its_own.reset(), a.reset(); // before there are others: two copies of the largest sets need not fit
      a.emplace(on_, app::view_of(first), *first.kind);
      device_set &b = scene.itself ? *a : its_own.emplace(on_, app::view_of(second), *second.kind);
      const device_result r = meetc::collide(on_, *a, b, p, rung::certified, o);
      found = r.count;
      if (i > 0)
        ordered.push_back(a->ordered_seconds() + (scene.itself ? 0 : b.ordered_seconds())),
            query.push_back(r.device_seconds);
    }
    const given_times given = time_given(scene, first, second, p);
    if (given.found != found)
      throw app::failure("bench gpu: sets in order and as they are given differ", app::no_device);
    device_set &b = scene.itself ? *a : *its_own;
    baselines::lbvh_box within{};
    b.bounds(within.lo, within.hi);
    gpu_lbvh tree(b.elements(), static_cast<unsigned>(b.kind().fields));
    const double build = timer_.seconds(
        [&] { check(tree.build(b.rows(), within, on_.stream()), "building a baseline's hierarchy"); }, runs);
    counts_.reserve(1, "a counter");
    list_.reserve(2 * found + 1024, "a baseline's pairs");
    const double asked = timer_.seconds(
        [&] {
          check(cudaMemsetAsync(counts_.data(), 0, sizeof(unsigned long long), on_.stream()), "clearing a counter");
          const cudaError_t e =
              scene.itself ? tree.query_itself(*by, list_.data(), list_.capacity(), counts_.data(), on_.stream())
                           : tree.query(*by, a->rows(), a->elements(), list_.data(), list_.capacity(), counts_.data(),
                                        on_.stream());
          check(e, "starting a baseline's query");
        },
        runs);
    const std::uint64_t accepted = counted_on_device();
    t.rows.push_back({of_words(scene.name), of_count(a->elements()), of_count(b.elements()), of_count(found),
                      of_count(accepted), of_milliseconds(build), of_milliseconds(asked),
                      of_milliseconds(median(ordered)), of_milliseconds(median(query)), of_milliseconds(given.device),
                      of_milliseconds(given.wall), of_ratio((build + asked) / given.device)});
    progress();
  }
  return t;
}

} // namespace meetc::bench
