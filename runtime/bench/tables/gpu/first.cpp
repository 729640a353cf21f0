// What segments meet first, beside the nearest hits of a hierarchy of the usual kind.
#include "app/sets.hpp"
#include "bench/baselines/gpu_lbvh.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "core/find.hpp"

#include <algorithm>

namespace meetc::bench {

namespace {

constexpr int runs = 7;

// Segments of which the baseline names another triangle than one that is met first, or none, or one where none is met.
std::uint64_t wrong(const predicate_info &p, const io::element_set &segments, const io::element_set &mesh,
                    const std::vector<std::uint32_t> &first, const std::vector<std::uint32_t> &baseline) {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == baseline[i])
      continue;
    float s[6], t[9], u[9];
    answer touches = answer::no;
    if (first[i] != no_element && baseline[i] != no_element) {
      segments.row(i, s), mesh.row(first[i], t), mesh.row(baseline[i], u);
      const index_pair one{0, 0};
      p.decide[static_cast<int>(rung::certified)](s, u, &one, 1, &touches);
    }
    n += touches != answer::yes || p.first_met(s, t, u) != 0;
  }
  return n;
}

} // namespace

table gpu_bench::measure_first(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress) {
  table t;
  t.name = "first";
  t.title = "What segments meet first";
  t.columns = {{"scene", "scene"},
               {"segments", "segments"},
               {"pairs", "pairs"},
               {"meet", "segments|that meet some"},
               {"counted", "ours:|pairs counted, ms"},
               {"first", "ours: and the|first ones, ms"},
               {"lbvh", "LBVH:|nearest hits, ms"},
               {"wrong", "LBVH: wrong|segments"},
               {"ratio", "LBVH /|ours"}};
  t.notes.emplace_back(
      "On prepared sets, without building hierarchies. Ours: certified, over all pairs, with the least triangle where "
      "several are met at one point; the device's time, with the naming of elements and without downloading. LBVH: "
      "that "
      "of `--only lbvh`, from the nearer child to the farther one and no farther than the nearest hit so far, with "
      "Möller-Trumbore in plain fp32, epsilon 0, without naming and downloading. It is wrong about a segment where it "
      "names a triangle that is not met, or not first, or none.");
  for (const gpu_scene &scene : scenes) {
    const auto [segments, mesh] = scene.make();
    const predicate_info &p = find_predicate(all_, scene.predicate);
    device_set a(on_, app::view_of(segments), *segments.kind), b(on_, app::view_of(mesh), *mesh.kind);
    device_options o;
    o.want = answer_kind::count;
    device_result last;
    const auto time = [&](bool first) {
      o.first_met = first;
      std::vector<double> seconds;
      for (int i = 0; i <= runs; ++i) {
        last = meetc::collide(on_, a, b, p, rung::certified, o);
        if (i > 0)
          seconds.push_back(last.device_seconds);
      }
      return median(seconds);
    };
    const double counted = time(false), ours = time(true);

    baselines::lbvh_box within{};
    b.bounds(within.lo, within.hi);
    gpu_lbvh tree(b.elements(), static_cast<unsigned>(b.kind().fields));
    check(tree.build(b.rows(), within, on_.stream()), "building a baseline's hierarchy");
    device_memory<std::uint32_t> nearest;
    nearest.reserve(a.elements(), "a baseline's nearest hits");
    const double usual = timer_.seconds(
        [&] { check(tree.first(a.rows(), a.elements(), nearest.data(), on_.stream()), "starting a baseline's query"); },
        runs);
    const auto download = [&](const std::uint32_t *from, std::size_t n) {
      std::vector<std::uint32_t> to(n);
      check(cudaMemcpy(to.data(), from, n * sizeof *from, cudaMemcpyDeviceToHost), "downloading nearest hits");
      return to;
    };
    const std::vector<std::uint32_t> of_slots = download(nearest.data(), a.elements()),
                                     order_a = download(a.order(), a.elements()),
                                     order_b = download(b.order(), b.elements());
    std::vector<std::uint32_t> baseline(a.elements(), no_element);
    for (std::size_t i = 0; i < of_slots.size(); ++i)
      if (of_slots[i] != no_element)
        baseline[order_a[i]] = order_b[of_slots[i]];
    const auto none = std::count(last.first_met.begin(), last.first_met.end(), no_element);
    t.rows.push_back({of_words(scene.name), of_count(a.elements()), of_count(last.count),
                      of_count(a.elements() - static_cast<std::uint64_t>(none)), of_milliseconds(counted),
                      of_milliseconds(ours), of_milliseconds(usual),
                      of_count(wrong(p, segments, mesh, last.first_met, baseline)), of_ratio(usual / ours)});
    progress();
  }
  return t;
}

} // namespace meetc::bench
