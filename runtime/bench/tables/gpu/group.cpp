// The gain of several devices of one host: one query cut between them, beside the same query on the first of them.
#include "meet/app/input/failure.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"
#include "meet/core/device/collide.hpp"

#include <cga/cga_cuda.hpp>
#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <vector>

namespace meetc::bench {

namespace {

constexpr int runs = 5;

// Sets on all devices of a group.
struct sets_on_all {
  group_set a, b;
  sets_on_all(device_group &on, const sets_here &from)
      : sets_on_all(on, from, spread_for(from.a().elements, from.b().elements, false)) {}

private:
  sets_on_all(device_group &on, const sets_here &from, std::pair<spread, spread> how)
      : a(on, io::view_of(from.a()), *from.a().kind, how.first),
        b(on, io::view_of(from.b()), *from.b().kind, how.second) {}
};

// Medians in seconds, on one device or on all of them.
struct side {
  double made = 0, pairs = 0, pairs_wall = 0, count_wall = 0;
};

// Makes the sets anew in each run, then asks for their pairs, which are to be those that are expected, and for their number.
// `ask` is a query of the sets.
template <class Sets, class On, class Ask>
side measure_side(const char *name, On &on, const sets_here &sets, const result &expected, const Ask &ask) {
  side out;
  std::unique_ptr<Sets> there;
  host_clock clock(0);
  out.made = medians_of<1>(runs, [&] {
    there.reset(); // before there are others
    clock.start();
    there = std::make_unique<Sets>(on, sets);
    return std::array{clock.stop()};
  })[0];
  const auto time = [&](answer_kind want) {
    device_options o;
    o.want = want;
    device_result last;
    const auto seconds = medians_of<2>(runs, [&] {
      last = {}; // its memory goes back before there is another list
      last = ask(*there, o);
      return std::array{last.device_seconds, last.seconds};
    });
    require_truth(sets.of.name, name,
                  want == answer_kind::pairs ? difference_of(std::move(last.pairs), expected.pairs)
                                             : difference_of(last.count, expected.count));
    return seconds;
  };
  const auto [device, wall] = time(answer_kind::pairs);
  out.pairs = device, out.pairs_wall = wall;
  out.count_wall = time(answer_kind::count)[1];
  return out;
}

struct row {
  std::string scene;
  std::uint64_t a, b, pairs;
  side one, all;
};

} // namespace

table gpu_bench::measure_group(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  int count = 0;
  check(cudaGetDeviceCount(&count), "counting devices");
  if (count < 2)
    throw app::failure("bench gpu --only group: there is one CUDA device here, and a group needs two", app::no_device);
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  device_group group(cga::cuda::catalogue(), numbers);
  const device &one = group[0];
  std::vector<row> rows;
  for (const scene &of : scenes) {
    const sets_here sets(of, all_);
    result expected;
    {
      const prepared a = app::prepare(sets.a());
      std::optional<prepared> other;
      expected = collide(a, of.itself ? a : other.emplace(app::prepare(sets.b())), sets.predicate, rung::certified);
    }
    const side of_one =
        measure_side<sets_there>("one device", one, sets, expected, [&](sets_there &s, const device_options &o) {
          return meetc::collide(one, s.a(), s.b(), sets.predicate, rung::certified, o);
        });
    const side of_all =
        measure_side<sets_on_all>("a group", group, sets, expected, [&](sets_on_all &s, const device_options &o) {
          return meetc::collide(group, s.a, s.b, sets.predicate, rung::certified, o);
        });
    rows.push_back({of.name, sets.a().elements, sets.b().elements, expected.count, of_one, of_all});
    progress();
  }
  return table_of<row>(
      "group", fmt::format("{} devices of one host beside one of them", count),
      {{"scene", "scene", of_words, &row::scene},
       {"a", "elements of A", of_count, &row::a},
       {"b", "elements of B", of_count, &row::b},
       {"pairs", "pairs", of_count, &row::pairs},
       {"made_one", "one: sets made|there, wall, ms", [](const row &r) { return of_milliseconds(r.one.made); }},
       {"made_group", "all: sets made|there, wall, ms", [](const row &r) { return of_milliseconds(r.all.made); }},
       {"one", "one: pairs,|ms", [](const row &r) { return of_milliseconds(r.one.pairs); }},
       {"group", "all: pairs,|ms", [](const row &r) { return of_milliseconds(r.all.pairs); }},
       {"one_wall", "one: pairs|here, wall, ms", [](const row &r) { return of_milliseconds(r.one.pairs_wall); }},
       {"group_wall", "all: pairs|here, wall, ms", [](const row &r) { return of_milliseconds(r.all.pairs_wall); }},
       {"gain", "one / all,|wall", [](const row &r) { return of_ratio(r.one.pairs_wall / r.all.pairs_wall); }},
       {"count_one", "one: counted,|wall, ms", [](const row &r) { return of_milliseconds(r.one.count_wall); }},
       {"count_group", "all: counted,|wall, ms", [](const row &r) { return of_milliseconds(r.all.count_wall); }},
       {"count_gain", "one / all,|wall", [](const row &r) { return of_ratio(r.one.count_wall / r.all.count_wall); }}},
      rows,
      {"Certified queries, on sets that were queried before. The larger set is cut between the devices, and each has "
       "all of the other one. Pairs, ms: "
       "of the device that takes longest, by its events, until its pairs are sorted there. Wall: of the call on the "
       "host, "
       "with the pairs in its memory, or only counted. Every list of pairs was compared with that of the CPU."});
}

} // namespace meetc::bench
