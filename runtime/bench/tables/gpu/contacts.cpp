// Where pairs meet, and where meshes cross themselves, on the device and on the CPU in the same run.
#include "meet/core/device/contacts.hpp"
#include "meet/bench/tables/gpu/measure.hpp"
#include "meet/bench/tables/gpu/sets.hpp"
#include "meet/core/device/self_pairs.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>
#include <neighbours/neighbours_cuda.hpp>
#include <neighbours/neighbours_runtime.hpp>

namespace meetc::bench {

namespace {

constexpr int runs = 7;

struct contacts_row {
  std::string scene;
  std::uint64_t pairs, nodes, pairs_left, nodes_left;
  double codes, places, places_in_float64, there, here;
};

struct self_row {
  std::string scene;
  std::uint64_t elements, pairs, candidates, neighbours;
  double device, there, here, prepared_here;
};

std::string with_threads(const char *note) {
  return fmt::format("{} The CPU has {} threads.", note, thread_count(0));
}

} // namespace

table gpu_bench::measure_contacts(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  std::vector<contacts_row> rows;
  for (const scene &of : scenes) {
    const sets_here sets(of, all_);
    std::vector<index_pair> pairs;
    {
      sets_there there(on_, sets);
      pairs = meetc::collide(on_, there.a(), there.b(), sets.predicate, rung::certified).pairs;
    }
    const view a = io::view_of(sets.a()), b = io::view_of(sets.b());
    contacts_row row{of.name, pairs.size(), 0, 0, 0, 0, 0, 0, 0, 0};
    const auto times = medians_of<5>(runs, [&] {
      device_contact_work work, in_float64;
      const contact_set<float> found = contacts<float>(on_, a, b, sets.predicate, pairs, {}, &work);
      contacts<double>(on_, a, b, sets.predicate, pairs, {}, &in_float64);
      row.nodes = found.nodes(), row.pairs_left = work.pairs_left, row.nodes_left = work.nodes_left;
      return std::array{work.codes_seconds, work.places_seconds, in_float64.places_seconds, found.seconds,
                        contacts<float>(a, b, sets.predicate, pairs).seconds};
    });
    row.codes = times[0], row.places = times[1], row.places_in_float64 = times[2];
    row.there = times[3], row.here = times[4];
    rows.push_back(row);
    progress();
  }
  return table_of<contacts_row>(
      "contacts", "Where pairs meet",
      {{"scene", "scene", of_words, &contacts_row::scene},
       {"pairs", "pairs", of_count, &contacts_row::pairs},
       {"nodes", "nodes", of_count, &contacts_row::nodes},
       {"codes", "codes,|ms", of_milliseconds, &contacts_row::codes},
       {"float32", "float32|coordinates, ms", of_milliseconds, &contacts_row::places},
       {"float64", "float64|coordinates, ms", of_milliseconds, &contacts_row::places_in_float64},
       {"pairs_left", "pairs left|to the host", of_count, &contacts_row::pairs_left},
       {"nodes_left", "nodes left|to the host", of_count, &contacts_row::nodes_left},
       {"there", "all, with the|device, ms", of_milliseconds, &contacts_row::there},
       {"here", "all, on the|CPU, ms", of_milliseconds, &contacts_row::here}},
      rows,
      {with_threads(
          "Medians. Codes and coordinates: the device's kernels alone, for sorted pairs in the host's memory. All: a "
          "call from these to polylines, in float32, with gathering, transfers, names and joining.")});
}

table gpu_bench::measure_self(const std::vector<scene> &scenes, const std::function<void()> &progress) {
  const catalogue &near = neighbours::catalogue();
  std::vector<self_row> rows;
  for (const scene &of : scenes) {
    const sets_here sets(of, all_);
    const self_predicates by{sets.predicate, find_predicate(near, "beyond_corner"),
                             find_predicate(near, "beyond_edge")};
    sets_there there(on_, sets);
    const view mesh = io::view_of(sets.a());
    device_self_result last;
    const auto times = medians_of<4>(runs, [&] {
      last = self_pairs(on_, there.a(), by, neighbours::cuda::catalogue());
      const auto start = std::chrono::steady_clock::now();
      const prepared here = app::prepare(sets.a());
      const double whole = self_pairs(here, mesh, by).seconds;
      return std::array{last.device_seconds, last.seconds, whole,
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
    });
    rows.push_back({of.name, sets.a().elements, last.pairs.size(), last.candidates,
                    last.neighbours[0] + last.neighbours[1] + last.neighbours[2], times[0], times[1], times[2],
                    times[3]});
    progress();
  }
  return table_of<self_row>(
      "self", "Where meshes cross themselves",
      {{"scene", "scene", of_words, &self_row::scene},
       {"elements", "faces", of_count, &self_row::elements},
       {"pairs", "pairs", of_count, &self_row::pairs},
       {"candidates", "candidates", of_count, &self_row::candidates},
       {"neighbours", "neighbours", of_count, &self_row::neighbours},
       {"device", "device,|ms", of_milliseconds, &self_row::device},
       {"there", "the call,|ms", of_milliseconds, &self_row::there},
       {"here", "CPU,|ms", of_milliseconds, &self_row::here},
       {"prepared", "CPU, with|preparing, ms", of_milliseconds, &self_row::prepared_here}},
      rows,
      {with_threads(
          "Medians. Device: of a set that lies there, with the numbers of its corners, its neighbours, and sorted "
          "pairs. The call: the host's clock, with the pairs in its memory. CPU: self_pairs() of a prepared set.")});
}

} // namespace meetc::bench
