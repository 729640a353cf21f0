// How long a query takes on a device as sets grow, and every pair beside it.
#include "app/failure.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/tables/gpu/measure.hpp"
#include "core/find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace meetc::bench {

namespace {

constexpr int growth_runs = 5;
constexpr int times_again = 4;      // the last of which is taken: then its kernels start as one
constexpr double most_pairs = 3e12; // which every pair takes a quarter of a second for

// Medians of seconds of certified queries that give sorted pairs on the device.
struct query_times {
  double first = 0, posed = 0, again = 0, wall = 0;
};

} // namespace

table gpu_bench::measure_searches(const std::string &name, const std::string &title,
                                  const std::vector<gpu_scene> &scenes, const std::function<void()> &progress) {
  table t;
  t.name = name;
  t.title = title;
  const bool compared = std::any_of(scenes.begin(), scenes.end(), [](const gpu_scene &scene) { return scene.even; });
  double even = 0;
  t.columns = {{"scene", "scene"},
               {"a", "elements of A"},
               {"b", "elements of B"},
               {"pairs", "pairs"},
               {"every_first", "every pair: first,|ms"},
               {"tree_first", "hierarchy: first,|ms"},
               {"tree_posed", "hierarchy: after|a pose, ms"},
               {"tree_again", "hierarchy: again,|ms"},
               {"tree_wall", "hierarchy: first,|wall clock, ms"},
               {"ordered", "both ordered|there, ms"},
               {"made_wall", "both made there,|wall clock, ms"},
               {"given", "given: all of it,|ms"},
               {"given_wall", "given: all of it,|wall clock, ms"}};
  if (compared)
    t.columns.push_back({"of_even", "hierarchy: first /|even above"});
  t.notes.emplace_back(
      "First: a query on sets that have only been uploaded, so that boxes, and columns of every pair, are made in it. "
      "After a pose: "
      "of "
      "B, whose boxes are made anew. Again: nothing is made, and all kernels start as one graph, since the same was "
      "asked some times before. Ordered there: "
      "elements as they are given are moved, "
      "checked "
      "and ordered on the device; made there also has them uploaded from ordinary memory. Times are of the device "
      "until "
      "the pairs are sorted there, but for the wall clock, which in a query also has the pairs downloaded. Given: one "
      "call of sets that lie on the device as they were uploaded, from those to sorted pairs there; elements that can "
      "touch nothing are left out where that is expected to pay. Its device time contains what the host takes "
      "between kernels.");
  for (const gpu_scene &scene : scenes) {
    const auto made_sets = scene.make();
    const io::element_set &first = made_sets.first, &second = scene.itself ? first : made_sets.second;
    const prepared a = app::prepare(first);
    std::optional<prepared> other;
    const prepared &b = scene.itself ? a : other.emplace(app::prepare(second));
    const predicate_info &p = find_predicate(all_, scene.predicate);
    std::optional<std::uint64_t> found;
    device_options o;
    const auto query = [&](device_set &on_a, device_set &on_b) {
      return meetc::collide(on_, on_a, on_b, p, rung::certified, o);
    };
    const auto time = [&] {
      std::vector<double> fresh, posed, again, wall;
      for (int i = 0; i <= growth_runs; ++i) {
        device_set on_a(on_, a);
        std::optional<device_set> its_own;
        device_set &on_b = scene.itself ? on_a : its_own.emplace(on_, b);
        const device_result r = query(on_a, on_b);
        device_result r_again;
        o.as_graph = true;
        for (int times = 0; times < times_again; ++times)
          r_again = query(on_a, on_b);
        o.as_graph = false;
        pose at;
        at.m[3] = 0x1p-20;
        on_b.move(at);
        const device_result r_posed = query(on_a, on_b);
        if (r_again.count != r.count || found.value_or(r.count) != r.count)
          throw app::failure("bench gpu: two queries differ", app::no_device);
        found = r.count;
        if (i > 0)
          fresh.push_back(r.device_seconds), again.push_back(r_again.device_seconds),
              posed.push_back(r_posed.device_seconds), wall.push_back(r.seconds);
      }
      return query_times{median(fresh), median(posed), median(again), median(wall)};
    };
    const query_times tree = time();
    const auto time_every_pair = [&] {
      std::vector<double> fresh;
      for (int i = 0; i <= growth_runs; ++i) {
        device_set on_a(on_, a);
        std::optional<device_set> its_own;
        const every_pair::outcome r =
            every_pair_.collide(on_a, scene.itself ? on_a : its_own.emplace(on_, b), p, rung::certified);
        if (r.count != *found)
          throw app::failure("bench gpu: a query and every pair differ", app::no_device);
        if (i > 0)
          fresh.push_back(r.device_seconds);
      }
      return median(fresh);
    };
    std::vector<double> ordered, made;
    for (int i = 0; i <= growth_runs; ++i) {
      const auto start = std::chrono::steady_clock::now();
      const device_set there_a(on_, app::view_of(first), *first.kind);
      std::optional<device_set> there_b;
      if (!scene.itself)
        there_b.emplace(on_, app::view_of(second), *second.kind);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      if (i > 0)
        made.push_back(took.count()),
            ordered.push_back(there_a.ordered_seconds() + (there_b ? there_b->ordered_seconds() : 0));
    }
    const given_times given = time_given(scene, first, second, p);
    if (given.found != *found)
      throw app::failure("bench gpu: sets in order and as they are given differ", app::no_device);
    const bool quick = static_cast<double>(a.elements()) * static_cast<double>(b.elements()) <= most_pairs;
    t.rows.push_back({of_words(scene.name), of_count(a.elements()), of_count(b.elements()), of_count(*found),
                      compared ? missing("")
                      : quick  ? of_milliseconds(time_every_pair())
                               : missing("too slow"),
                      of_milliseconds(tree.first), of_milliseconds(tree.posed), of_milliseconds(tree.again),
                      of_milliseconds(tree.wall), of_milliseconds(median(ordered)), of_milliseconds(median(made)),
                      of_milliseconds(given.device), of_milliseconds(given.wall)});
    if (scene.even)
      even = tree.first;
    if (compared)
      t.rows.back().push_back(of_ratio(tree.first / even));
    progress();
  }
  if (compared) { // by the hierarchy alone
    const auto drop = [](auto &cells) { cells.erase(cells.begin() + 4); };
    drop(t.columns);
    for (auto &row : t.rows)
      drop(row);
  }
  return t;
}

} // namespace meetc::bench
