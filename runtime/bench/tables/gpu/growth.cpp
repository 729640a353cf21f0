// The time of a query on a device as sets grow, and where they do not lie evenly, and every pair beside it.
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"

#include <memory>
#include <optional>

namespace meetc::bench {

namespace {

constexpr int growth_runs = 5;
constexpr double most_pairs = 3e12; // which every pair takes a quarter of a second for

// Sets on the device, as they were prepared on the host.
struct prepared_there {
  device_set a;
  std::optional<device_set> own_b;

  prepared_there(const device &on, const prepared &x, const prepared &y) : a(on, x) {
    if (&x != &y)
      own_b.emplace(on, y);
  }
  device_set &b() { return own_b ? *own_b : a; }
};

} // namespace

// Medians of seconds of certified queries that give sorted pairs on the device.
struct gpu_bench::query_times {
  std::string scene;
  std::uint64_t a = 0, b = 0, found = 0;
  std::optional<double> every_pair; // empty where it takes too long
  double first = 0, posed = 0, again = 0, wall = 0, ordered = 0, made = 0;
  given_times given{};
  double even = 0; // `first` of the last scene whose sets lie evenly
};

gpu_bench::query_times gpu_bench::time_query(const scene &of, bool beside_every_pair) {
  const sets_here sets(of, all_);
  const prepared a = app::prepare(sets.a());
  std::optional<prepared> other;
  const prepared &b = of.itself ? a : other.emplace(app::prepare(sets.b()));
  query_times out;
  out.scene = of.name, out.a = a.elements(), out.b = b.elements();
  const auto collide = [&](prepared_there &there) {
    return meetc::collide(on_, there.a, there.b(), sets.predicate, rung::certified);
  };
  const auto [first, again, posed, wall] = medians_of<4>(growth_runs, [&] {
    prepared_there there(on_, a, b);
    const device_result r = collide(there), r_again = collide(there);
    pose at;
    at.m[3] = 0x1p-20;
    there.b().move(at);
    const device_result r_posed = collide(there);
    require_truth(of.name, "a query that is asked again", difference_of(r_again.count, r.count));
    if (out.found > 0)
      require_truth(of.name, "a query of sets that are made again", difference_of(r.count, out.found));
    out.found = r.count;
    return std::array{r.device_seconds, r_again.device_seconds, r_posed.device_seconds, r.seconds};
  });
  out.first = first, out.again = again, out.posed = posed, out.wall = wall;
  if (beside_every_pair && static_cast<double>(out.a) * static_cast<double>(out.b) <= most_pairs)
    out.every_pair = medians_of<1>(growth_runs, [&] {
      prepared_there there(on_, a, b);
      const every_pair::outcome r = every_pair_.collide(there.a, there.b(), sets.predicate, rung::certified);
      require_truth(of.name, "every pair", difference_of(r.count, out.found));
      return std::array{r.device_seconds};
    })[0];
  host_clock clock(0);
  const auto [made, ordered] = medians_of<2>(growth_runs, [&] {
    clock.start();
    const auto there = std::make_unique<sets_there>(on_, sets);
    const double took = clock.stop();
    return std::array{took, there->ordered_seconds()};
  });
  out.made = made, out.ordered = ordered;
  out.given = time_given(sets);
  require_truth(of.name, "a query of sets as they are given", difference_of(out.given.found, out.found));
  return out;
}

namespace {

// First the scene, then every pair or nothing, then these.
template <class Row> columns<Row> query_columns(const columns<Row> &every_pair, const columns<Row> &last) {
  columns<Row> out{{"scene", "scene", of_words, &Row::scene},
                   {"a", "elements of A", of_count, &Row::a},
                   {"b", "elements of B", of_count, &Row::b},
                   {"pairs", "pairs", of_count, &Row::found}};
  out.insert(out.end(), every_pair.begin(), every_pair.end());
  const columns<Row> of_query{
      {"tree_first", "hierarchy: first,|ms", of_milliseconds, &Row::first},
      {"tree_posed", "hierarchy: after|a pose, ms", of_milliseconds, &Row::posed},
      {"tree_again", "hierarchy: again,|ms", of_milliseconds, &Row::again},
      {"tree_wall", "hierarchy: first,|wall clock, ms", of_milliseconds, &Row::wall},
      {"ordered", "both ordered|there, ms", of_milliseconds, &Row::ordered},
      {"made_wall", "both made there,|wall clock, ms", of_milliseconds, &Row::made},
      {"given", "given: all of it,|ms", of_milliseconds, [](const Row &r) { return r.given.device; }},
      {"given_wall", "given: all of it,|wall clock, ms", of_milliseconds, [](const Row &r) { return r.given.wall; }}};
  out.insert(out.end(), of_query.begin(), of_query.end());
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

constexpr const char *rules =
    "First: a query on sets that have only been uploaded, so that boxes, and columns of every pair, are made in it. "
    "After "
    "a pose: of B, whose boxes are made anew. Again: nothing is made. Ordered there: elements as they are given are "
    "moved, checked and ordered on the "
    "device; "
    "made there also has them uploaded from ordinary memory. Times are of the device until the pairs are sorted there, "
    "but "
    "for the wall clock, which in a query also has the pairs downloaded. Given: one call of sets that lie on the "
    "device as "
    "they were uploaded, from those to sorted pairs there; elements that can touch nothing are left out where that is "
    "expected to pay. Its device time contains what the host takes between kernels.";

} // namespace

table gpu_bench::measure_growth(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  std::vector<query_times> rows;
  for (const scene &of : scenes) {
    rows.push_back(time_query(of, true));
    progress();
  }
  const auto every = [](const query_times &r) {
    return r.every_pair ? of_milliseconds(*r.every_pair) : missing("too slow");
  };
  return table_of<query_times>("growth", "Growth with the sets",
                               query_columns<query_times>({{"every_first", "every pair: first,|ms", every}}, {}), rows,
                               {rules});
}

table gpu_bench::measure_hard(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  std::vector<query_times> rows;
  double even = 0;
  for (const scene &of : scenes) {
    rows.push_back(time_query(of, false));
    even = of.even ? rows.back().first : even;
    rows.back().even = even;
    progress();
  }
  const auto of_even = [](const query_times &r) { return r.first / r.even; };
  return table_of<query_times>(
      "hard", "Sets that do not lie evenly",
      query_columns<query_times>({}, {{"of_even", "hierarchy: first /|even above", of_ratio, of_even}}), rows, {rules});
}

} // namespace meetc::bench
