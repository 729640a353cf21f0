// The first triangles that segments meet, beside the nearest hits of a hierarchy of the usual kind.
#include "meet/bench/baselines/gpu_lbvh.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"

#include <algorithm>
#include <optional>

namespace meetc::bench {

namespace {

constexpr int runs = 7;

// Segments of which the baseline names another triangle than one that is met first, or none, or one where none is met.
std::uint64_t wrong(const sets_here &sets, const std::vector<std::uint32_t> &first,
                    const std::vector<std::uint32_t> &baseline) {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == baseline[i])
      continue;
    float s[6], t[9], u[9];
    answer touches = answer::no;
    if (first[i] != no_element && baseline[i] != no_element) {
      sets.a().row(i, s), sets.b().row(first[i], t), sets.b().row(baseline[i], u);
      const index_pair one{0, 0};
      sets.predicate.decide[static_cast<int>(rung::exact)](s, u, &one, 1, &touches);
    }
    n += touches != answer::yes || sets.predicate.first_met(s, t, u) != 0;
  }
  return n;
}

std::vector<std::uint32_t> downloaded(const std::uint32_t *from, std::size_t n) {
  std::vector<std::uint32_t> to(n);
  check(cudaMemcpy(to.data(), from, n * sizeof *from, cudaMemcpyDeviceToHost), "downloading nearest hits");
  return to;
}

struct row {
  std::string scene;
  std::uint64_t segments, pairs, meet, wrong;
  double counted, warps, threads, first, nearest;
};

} // namespace

table gpu_bench::measure_first(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  const auto measure_scene = [&](const scene &of) -> row {
    const sets_here sets(of, all_);
    sets_there there(on_, sets);
    device_set &a = there.a(), &b = there.b();
    device_result last;
    const auto time = [&](answer_kind want, bool first, std::optional<bool> alone) {
      device_options o;
      o.want = want, o.first_met = first, o.first_alone = alone;
      return medians_of<1>(runs, [&] {
        last = meetc::collide(on_, a, b, sets.predicate, rung::certified, o);
        return std::array{last.device_seconds};
      })[0];
    };
    const double counted = time(answer_kind::count, false, {});
    const std::uint64_t pairs = last.count;
    const double warps = time(answer_kind::none, true, false), threads = time(answer_kind::none, true, true),
                 ours = time(answer_kind::none, true, {});

    baselines::lbvh_box within{};
    b.bounds(within.lo, within.hi);
    gpu_lbvh tree(b.elements(), static_cast<unsigned>(b.kind().fields));
    check(tree.build(b.rows().data(), within, on_.stream()), "building a baseline's hierarchy");
    device_memory<std::uint32_t> nearest;
    nearest.reserve(a.elements(), "a baseline's nearest hits");
    const double lbvh = timer_.seconds(
        [&] {
          check(tree.first(a.rows().data(), a.elements(), nearest.data(), on_.stream()), "starting a baseline's query");
        },
        runs);
    const std::vector<std::uint32_t> of_slots = downloaded(nearest.data(), a.elements()),
                                     order_a = downloaded(a.rows().order(), a.elements()),
                                     order_b = downloaded(b.rows().order(), b.elements());
    std::vector<std::uint32_t> baseline(a.elements(), no_element);
    for (std::size_t i = 0; i < of_slots.size(); ++i)
      if (of_slots[i] != no_element)
        baseline[order_a[i]] = order_b[of_slots[i]];
    const auto none = std::count(last.first_met.begin(), last.first_met.end(), no_element);
    return {of.name,
            a.elements(),
            pairs,
            a.elements() - static_cast<std::uint64_t>(none),
            wrong(sets, last.first_met, baseline),
            counted,
            warps,
            threads,
            ours,
            lbvh};
  };
  std::vector<row> rows;
  for (const scene &of : scenes) {
    rows.push_back(measure_scene(of));
    progress();
  }
  return table_of<row>(
      "first", "The first triangles that segments meet",
      {{"scene", "scene", of_words, &row::scene},
       {"segments", "segments", of_count, &row::segments},
       {"pairs", "pairs", of_count, &row::pairs},
       {"meet", "segments|that meet some", of_count, &row::meet},
       {"counted", "ours:|pairs counted, ms", of_milliseconds, &row::counted},
       {"warps", "ours: a warp|each, ms", of_milliseconds, &row::warps},
       {"threads", "ours: a thread|each, ms", of_milliseconds, &row::threads},
       {"first", "ours: first|ones, ms", of_milliseconds, &row::first},
       {"lbvh", "LBVH:|nearest hits, ms", of_milliseconds, &row::nearest},
       {"wrong", "LBVH: wrong|segments", of_count, &row::wrong},
       {"ratio", "LBVH /|ours", [](const row &r) { return of_ratio(r.nearest / r.first); }}},
      rows,
      {"On prepared sets, without building hierarchies. Ours: certified, with the least triangle where several are met "
       "at "
       "one point; the device's time, with the naming of elements and without downloading. A warp each: over all "
       "pairs. A "
       "thread each: no farther than to a triangle that is proved to be met. First ones: by that of the two which the "
       "number of segments suggests. LBVH: that "
       "of `--only lbvh`, from the nearer child to the farther one and no farther than the nearest hit so far, with "
       "Möller-Trumbore in plain fp32, epsilon 0, without naming and downloading. It is wrong about a segment where it "
       "names a triangle that is not met, or not first, or none."});
}

} // namespace meetc::bench
