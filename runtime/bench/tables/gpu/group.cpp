// What several devices of one host gain: one query cut between them, beside the same query on the first of them.
#include "core/device/group.hpp"
#include "app/failure.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "core/find.hpp"

#include <cga/cga_cuda.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

namespace meetc::bench {

namespace {

constexpr int runs = 5;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool same(const result &x, const result &y) {
  return x.count == y.count && std::equal(x.pairs.begin(), x.pairs.end(), y.pairs.begin(), y.pairs.end(),
                                          [](index_pair p, index_pair q) { return p.a == q.a && p.b == q.b; });
}

// Medians in seconds.
struct query_times {
  double device = 0, wall = 0;
};
template <class Query> query_times time(device_result &last, const Query &query) {
  std::vector<double> device, wall;
  for (int i = 0; i <= runs; ++i) {
    last = {}; // its memory goes back before there is another list
    last = query();
    if (i > 0)
      device.push_back(last.device_seconds), wall.push_back(last.seconds);
  }
  return {median(device), median(wall)};
}

} // namespace

table gpu_bench::measure_group(const std::vector<gpu_scene> &scenes, const std::function<void()> &progress) {
  int count = 0;
  check(cudaGetDeviceCount(&count), "counting devices");
  if (count < 2)
    throw app::failure("bench gpu --only group: there is one CUDA device here, and a group needs two", app::no_device);
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  device_group group(cga::cuda::catalogue(), numbers);
  device &one = group[0];
  table t;
  t.name = "group";
  t.title = fmt::format("{} devices of one host beside one of them", count);
  t.columns = {{"scene", "scene"},
               {"a", "elements of A"},
               {"b", "elements of B"},
               {"pairs", "pairs"},
               {"made_one", "one: sets made|there, wall, ms"},
               {"made_group", "all: sets made|there, wall, ms"},
               {"one", "one: pairs,|ms"},
               {"group", "all: pairs,|ms"},
               {"one_wall", "one: pairs|here, wall, ms"},
               {"group_wall", "all: pairs|here, wall, ms"},
               {"gain", "one / all,|wall"},
               {"count_one", "one: counted,|wall, ms"},
               {"count_group", "all: counted,|wall, ms"},
               {"count_gain", "one / all,|wall"}};
  t.notes.emplace_back(
      "Of queries, certified and by a hierarchy, on sets that were queried before. A is cut between the devices and "
      "each has all of B; a set with itself is cut likewise, and looked at whole where one device looks at half. "
      "Pairs, "
      "ms: of the device that takes longest, by its events, until its pairs are sorted there. Wall: of the call on the "
      "host, with the pairs in its memory, or only counted. Every list of pairs was compared with that of one device, "
      "and with the CPU's.");
  for (const gpu_scene &scene : scenes) {
    const auto made_sets = scene.make();
    const io::element_set &first = made_sets.first, &second = scene.itself ? first : made_sets.second;
    const predicate_info &p = find_predicate(all_, scene.predicate);
    device_options o;
    result expected;
    {
      const prepared a = app::prepare(first);
      std::optional<prepared> other;
      expected = collide(a, scene.itself ? a : other.emplace(app::prepare(second)), p, rung::certified);
    }
    const auto require = [&](const device_result &r) {
      if (!same(r, expected))
        throw app::failure(fmt::format("bench gpu: {}: a device and the CPU differ", scene.name), app::no_device);
    };
    device_result last;
    std::vector<double> made_one, made_group;
    query_times pairs_one, pairs_group, count_one, count_group;
    std::uint64_t elements_a = 0, elements_b = 0;
    {
      std::optional<device_set> a, its_own;
      for (int i = 0; i <= runs; ++i) {
        its_own.reset(), a.reset();
        const auto start = std::chrono::steady_clock::now();
        a.emplace(one, app::view_of(first), *first.kind);
        if (!scene.itself)
          its_own.emplace(one, app::view_of(second), *second.kind);
        if (i > 0)
          made_one.push_back(seconds_since(start));
      }
      device_set &b = scene.itself ? *a : *its_own;
      elements_a = a->elements(), elements_b = b.elements();
      const auto query = [&] { return meetc::collide(one, *a, b, p, rung::certified, o); };
      pairs_one = time(last, query);
      require(last);
      o.want = answer_kind::count;
      count_one = time(last, query);
    }
    {
      std::optional<group_set> a, b;
      for (int i = 0; i <= runs; ++i) {
        b.reset(), a.reset();
        const auto start = std::chrono::steady_clock::now();
        a.emplace(group, app::view_of(first), *first.kind, spread::cut);
        b.emplace(group, app::view_of(second), *second.kind, spread::whole);
        if (i > 0)
          made_group.push_back(seconds_since(start));
      }
      const auto query = [&] { return meetc::collide(group, *a, *b, p, rung::certified, o); };
      count_group = time(last, query);
      if (last.count != expected.count)
        throw app::failure(fmt::format("bench gpu: {}: a group counts otherwise", scene.name), app::no_device);
      o.want = answer_kind::pairs;
      pairs_group = time(last, query);
      require(last);
    }
    t.rows.push_back({of_words(scene.name), of_count(elements_a), of_count(elements_b), of_count(expected.count),
                      of_milliseconds(median(made_one)), of_milliseconds(median(made_group)),
                      of_milliseconds(pairs_one.device), of_milliseconds(pairs_group.device),
                      of_milliseconds(pairs_one.wall), of_milliseconds(pairs_group.wall),
                      of_ratio(pairs_one.wall / pairs_group.wall), of_milliseconds(count_one.wall),
                      of_milliseconds(count_group.wall), of_ratio(count_one.wall / count_group.wall)});
    progress();
  }
  return t;
}

} // namespace meetc::bench
