// Sets that move: refitting beside preparing anew, and the query afterwards; and how soon a call ends that is cancelled.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/core/sets/moving_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>

namespace meetc::bench {

namespace {

// The box around the points of a mesh.
struct extent {
  double lo[3], size[3], longest = 0;

  explicit extent(const std::vector<float> &xyz) {
    for (std::size_t k = 0; k < 3; ++k) {
      double least = xyz[k], most = xyz[k];
      for (std::size_t i = k; i < xyz.size(); i += 3)
        least = std::min<double>(least, xyz[i]), most = std::max<double>(most, xyz[i]);
      lo[k] = least, size[k] = most - least;
      longest = std::max(longest, size[k]);
    }
  }
};

// Turns the points around the axis y by so many turns from one end of it to the other.
std::vector<float> twisted(std::vector<float> xyz, double turns) {
  const extent e(xyz);
  const double x = e.lo[0] + e.size[0] / 2, z = e.lo[2] + e.size[2] / 2;
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    const double at = 2 * std::numbers::pi * turns * (xyz[i + 1] - e.lo[1]) / e.size[1], c = std::cos(at),
                 s = std::sin(at);
    const double dx = xyz[i] - x, dz = xyz[i + 2] - z;
    xyz[i] = static_cast<float>(x + c * dx - s * dz), xyz[i + 2] = static_cast<float>(z + s * dx + c * dz);
  }
  return xyz;
}
// Waves along y, as high as this share of the longest side.
std::vector<float> waved(std::vector<float> xyz, double share) {
  const extent e(xyz);
  for (std::size_t i = 0; i < xyz.size(); i += 3)
    xyz[i] +=
        static_cast<float>(share * e.longest * std::sin(8 * std::numbers::pi * (xyz[i + 1] - e.lo[1]) / e.size[1]));
  return xyz;
}
// Each point moves by itself, by up to this share of the longest side.
std::vector<float> shaken(std::vector<float> xyz, double share) {
  std::mt19937 random(1);
  const double far = share * extent(xyz).longest;
  for (float &x : xyz)
    x += static_cast<float>(far * (static_cast<double>(random()) * 0x1p-31 - 1));
  return xyz;
}
// Each element moves by itself: its points get new places together. The mesh has no common vertices.
std::vector<float> scattered(std::vector<float> xyz, double share) {
  std::mt19937 random(1);
  const double far = share * extent(xyz).longest;
  for (std::size_t i = 0; i < xyz.size(); i += 9)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto by = static_cast<float>(far * (static_cast<double>(random()) * 0x1p-31 - 1));
      for (std::size_t p = 0; p < 9; p += 3)
        xyz[i + p + k] += by;
    }
  return xyz;
}

struct movement {
  std::string name;
  std::vector<float> (*move)(std::vector<float>, double);
  double by;
  bool apart = false; // elements have no common vertices
};
std::vector<float> kept(std::vector<float> xyz, double) {
  return xyz;
}
const std::vector<movement> movements = {{"none", kept, 0},
                                         {"waves, 5 %", waved, 0.05},
                                         {"twist, 1/4 turn", twisted, 0.25},
                                         {"twist, 2 turns", twisted, 2},
                                         {"points by 0.1 %", shaken, 0.001},
                                         {"points by 1 %", shaken, 0.01},
                                         {"triangles by 1 %", scattered, 0.01, true},
                                         {"triangles by 5 %", scattered, 0.05, true},
                                         {"triangles by 50 %", scattered, 0.5, true}};

struct row {
  std::string mesh, movement;
  double prepare, refit, looseness, anew, refitted;
  std::uint64_t pairs, wrong;
};

row measure_movement(const cpu_context &c, const std::string &name, const io::element_set &mesh,
                     const io::element_set &other, const movement &how) {
  const view first = io::view_of(mesh);
  std::vector<float> at_first = mesh.data;
  if (how.apart) {
    at_first.clear();
    for (std::size_t i = 0; i < 3 * first.elements; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        at_first.push_back(mesh.data[std::size_t{3} * mesh.index[i] + k]);
  }
  const std::vector<float> moved = how.move(at_first, how.by);
  const auto seen = [&](const std::vector<float> &numbers) {
    return how.apart ? view{numbers.data(), 0, 0, nullptr, first.elements}
                     : view{numbers.data(), first.vertices, 0, first.index, first.elements};
  };
  const predicate_info &p = *app::choose(c.best(), *mesh.kind, *other.kind, {}, {}).predicate;
  const prepared b = app::prepare(other);
  collide_options o;
  o.threads = c.threads;
  moving_set moving(seen(at_first), *p.a, {}, c.threads);
  std::optional<prepared> set;
  result by_refitted, by_anew;
  host_clock clock(c.threads);
  const measured_methods m =
      measure(name + ", " + how.name, clock,
              {{"prepared anew",
                true,
                {[&] { set.emplace(prepare(seen(moved), *p.a, {}, c.threads)); },
                 [&] { by_anew = collide(*set, b, p, rung::certified, o); }},
                [&] { return difference_of(by_anew.pairs, collide(*set, b, p, rung::exact, o).pairs); }},
               {"refitted",
                true,
                {[&] { moving.update(seen(moved), {}, c.threads); },
                 [&] { by_refitted = collide(moving, b, p, rung::certified, o); }},
                [&] { return difference_of(by_refitted.pairs, by_anew.pairs); }}},
              c.for_seconds(c.quick ? 1 : 10));
  return {name,
          how.name,
          m.of[0].seconds[0],
          m.of[1].seconds[0],
          moving.looseness(),
          m.of[0].seconds[1],
          m.of[1].seconds[1],
          by_anew.pairs.size(),
          m.of[1].found.wrong()};
}

struct ending {
  std::string call;
  double whole;        // seconds of the call
  double median, most; // from the request to the end
};

// Requests come at tenths of the call's time.
ending measure_cancel(const std::string &call, const std::function<void(const std::stop_token &)> &run) {
  using clock = std::chrono::steady_clock;
  const auto seconds = [](clock::duration d) { return std::chrono::duration<double>(d).count(); };
  const auto begin = clock::now();
  run({});
  const double whole = seconds(clock::now() - begin);
  std::vector<double> late;
  for (int tenth = 1; tenth < 10; ++tenth) {
    std::stop_source source;
    clock::time_point asked;
    const std::jthread asks([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(whole * tenth / 10));
      asked = clock::now();
      source.request_stop();
    });
    try {
      run(source.get_token());
    } catch (const cancelled &) {
      late.push_back(seconds(clock::now() - asked));
    }
  }
  return {call, whole, median(late), late.empty() ? 0 : *std::max_element(late.begin(), late.end())};
}

} // namespace

void measure_refit(const cpu_context &c, cpu_result &to) {
  const two_sets sets = c.sets.middle_in_large();
  std::vector<row> rows;
  for (const movement &how : movements) {
    rows.push_back(measure_movement(c, c.sets.large_name(), sets.second, sets.first, how));
    rows.push_back(measure_movement(c, c.sets.middle_name(), sets.first, sets.second, how));
  }
  const auto ratio = [](double row::*of, double row::*to_it) {
    return [of, to_it](const row &r) { return of_ratio(r.*of / r.*to_it); };
  };
  to.tables.push_back(table_of<row>(
      "refit",
      fmt::format("Sets that move: refitted and prepared anew, {}, and the query with the other mesh after "
                  "each",
                  c.best_name()),
      {{"mesh", "mesh", of_words, &row::mesh},
       {"movement", "movement", of_words, &row::movement},
       {"prepare_ms", "prepare,|ms", of_milliseconds, &row::prepare},
       {"refit_ms", "refit,|ms", of_milliseconds, &row::refit},
       {"ratio", "prepare /|refit", ratio(&row::prepare, &row::refit)},
       {"looseness", "looseness", of_ratio, &row::looseness},
       {"anew_ms", "query of|anew, ms", of_milliseconds, &row::anew},
       {"slower", "query, refitted|/ anew", ratio(&row::refitted, &row::anew)},
       {"pairs", "pairs", of_count, &row::pairs},
       {"differs", "differs", of_count, &row::wrong}},
      rows,
      {"Movements are of the first place of the mesh, in shares of its longest side. Triangles that move by "
       "themselves have no common vertices, and no index."}));
  to.bars.push_back(
      {c.sets.large_name(), "prepare / refit", bar::side::at_least, 5, "x", rows[0].prepare / rows[0].refit});
  to.bars.push_back(
      {c.sets.middle_name(), "prepare / refit", bar::side::at_least, 5, "x", rows[1].prepare / rows[1].refit});
}

void measure_cancelling(const cpu_context &c, cpu_result &to) {
  const two_sets sets = c.sets.middle_in_large();
  const predicate_info &p = *app::choose(c.best(), *sets.first.kind, *sets.second.kind, {}, {}).predicate;
  const prepared a = app::prepare(sets.first), b = app::prepare(sets.second);
  const view of_b = io::view_of(sets.second);
  collide_options o;
  o.threads = c.threads;
  const std::vector<index_pair> pairs = collide(b, b, p, rung::certified, o).pairs;
  const auto query = [&](const prepared &x, const prepared &y, rung precision) {
    return [&, precision](const std::stop_token &stop) {
      collide_options with = o;
      with.stop = stop;
      collide(x, y, p, precision, with);
    };
  };
  const std::vector<ending> rows{
      measure_cancel("prepare",
                     [&](const std::stop_token &stop) { prepare(of_b, *p.b, {}, c.threads, nullptr, stop); }),
      measure_cancel("collide, certified", query(a, b, rung::certified)),
      measure_cancel("collide with itself, exact", query(b, b, rung::exact)),
      measure_cancel("contacts of all neighbours", [&](const std::stop_token &stop) {
        contact_options with;
        with.threads = c.threads, with.stop = stop;
        contacts(of_b, of_b, p, pairs, with);
      })};
  to.tables.push_back(
      table_of<ending>("cancel", "Calls that are cancelled at tenths of their time",
                       {{"call", "call", of_words, &ending::call},
                        {"whole_ms", "to its end,|ms", of_milliseconds, &ending::whole},
                        {"median_ms", "after the request,|median, ms", of_milliseconds, &ending::median},
                        {"most_ms", "longest,|ms", of_milliseconds, &ending::most}},
                       rows, {"Wall-clock times, also with one thread."}));
  for (const ending &e : rows)
    to.bars.push_back({e.call, "from the request to the end", bar::side::at_most, 50, "ms", 1000 * e.most});
}

} // namespace meetc::bench
