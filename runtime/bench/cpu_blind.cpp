// Every pair without boxes: our kernels beside the classic tests, for each instruction set.
#include "bench/cpu_parts.hpp"

#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/classic_set.hpp"
#include "bench/every_pair.hpp"
#include "bench/filtered_tiles.hpp"
#include "core/element_set.hpp"
#include "core/find.hpp"

#include <fmt/format.h>

#include <memory>

namespace meetc::bench {

namespace {

// Two sets for one predicate, in the order that preparing them gives, and the pairs of one element with a tile.
struct blind_scene {
  const char *predicate;
  classic_set a, b;
  std::vector<index_pair> pairs; // (0, j)

  blind_scene(const char *of, const cpu_sets::two_sets &sets)
      : predicate(of), a(sets.first, app::prepare(sets.first).set().order),
        b(sets.second, app::prepare(sets.second).set().order), pairs(most_tile_columns) {
    for (std::size_t j = 0; j < pairs.size(); ++j)
      pairs[j] = {0, static_cast<std::uint32_t>(j)};
  }
};

// The stored values that a rung reads.
stored_values read_by(rung precision, const stored_values &bounded, const stored_values &plain) {
  return precision == rung::certified ? bounded : precision == rung::fp32 ? plain : stored_values{};
}

// The tests of one instruction set.
struct tests_of_set {
  const blind_scene &scene;
  const catalogue &kernels;
  std::vector<named_test> &to;

  void add_classic(const char *name, baselines::classic_function f) const {
    const baselines::classic_rows a = scene.a.for_classic(), b = scene.b.for_classic();
    to.push_back({name, row_by_row([=](std::size_t i, std::size_t from, std::size_t n, answer *out) {
                    f(a, i, b, from, n, out);
                  })});
  }

  // Certified answers behind a filter of one element against tiles, whose numbers are made before the clock starts.
  void add_behind(const char *name, tile_filter (*filter)(const predicate_info &, const float *, std::size_t,
                                                          const float *, std::size_t)) const {
    const predicate_info &p = find_predicate(kernels, scene.predicate);
    to.push_back({name, behind(filter(p, scene.a.rows(), scene.a.count(), scene.b.rows(), scene.b.count()), p,
                               rung::certified, scene.a.rows(), scene.b.rows())});
  }

  // One of our rungs on rows and, where the predicate stores values, on these. They are computed before the clock starts,
  // as the planes of the classic tests are.
  void add_ours(const char *name, rung precision) const {
    const predicate_info &p = find_predicate(kernels, scene.predicate);
    const decide_function decide = p.decide[static_cast<int>(precision)];
    const stored_values of_a = read_by(precision, p.stored_a, p.plain_stored_a),
                        of_b = read_by(precision, p.stored_b, p.plain_stored_b);
    const auto stored_a = std::make_shared<std::vector<float>>(stored_for(of_a, scene.a)),
               stored_b = std::make_shared<std::vector<float>>(stored_for(of_b, scene.b));
    const auto floats_a = static_cast<std::size_t>(of_a.floats), floats_b = static_cast<std::size_t>(of_b.floats);
    const blind_scene &s = scene;
    to.push_back(
        {name, row_by_row([=, &s](std::size_t i, std::size_t from, std::size_t n, answer *out) {
           const auto at = [](const classic_set &set, const std::vector<float> &stored, std::size_t floats,
                              std::size_t row) {
             return row_array{set.rows() + row * set.fields(), stored.empty() ? nullptr : stored.data() + row * floats};
           };
           decide(at(s.a, *stored_a, floats_a, i), at(s.b, *stored_b, floats_b, from), s.pairs.data(), n, out);
         })});
  }
};

struct certified_rate {
  instruction_set set;
  double rate = 0, filtered = 0; // in multiples of the reference's
};
constexpr const char *in_tiles = "certified";
constexpr const char *behind_filter = "certified behind the filter";

// The rows of a table: for each instruction set its tests, of which test `reference` has the rate 1. Returns those of `certified`.
std::vector<certified_rate>
measure_scene(const cpu_context &c, const blind_scene &scene, std::size_t reference,
              const std::function<void(const tests_of_set &, const baselines::classic_table &)> &add, table &t) {
  std::vector<named_test> tests, exact;
  std::vector<std::size_t> first;
  for (const catalogue *kernels : c.kernels) {
    first.push_back(tests.size());
    add({scene, *kernels, tests}, *baselines::classic_tests_for(kernels->compiled_for));
  }
  tests_of_set{scene, c.best(), exact}.add_ours("exact", rung::exact);
  const every_pair_result r = measure_every_pair(scene.a.count(), scene.b.count(), exact[0].test, tests,
                                                 c.quick ? 50'000 : 4'000'000, c.one_thread(c.quick ? 2 : 120));
  std::vector<certified_rate> out;
  for (std::size_t k = 0; k < c.kernels.size(); ++k) {
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : tests.size();
    const double one = r.of[first[k] + reference].seconds_a_pair;
    out.push_back({c.kernels[k]->compiled_for});
    for (std::size_t i = first[k]; i < end; ++i) {
      const every_pair_row &row = r.of[i];
      t.rows.push_back({of_words(name_of(c.kernels[k]->compiled_for)), of_words(tests[i].name),
                        of_nanoseconds(row.seconds_a_pair), of_ratio(one / row.seconds_a_pair), of_count(row.hits),
                        of_count(row.false_hits), of_count(row.missed)});
      if (tests[i].name == in_tiles)
        out.back().rate = one / row.seconds_a_pair;
      if (tests[i].name == behind_filter)
        out.back().filtered = one / row.seconds_a_pair;
    }
  }
  t.title += fmt::format(": {} pairs, of which {} touch", app::grouped(r.pairs), app::grouped(r.hits));
  t.notes.push_back(fmt::format(
      "All methods get the sets in the spatial order of prepared ones. The lower quartile of {} interleaved "
      "repetitions. False and missed: compared with `exact`, over all pairs.",
      r.repetitions));
  return out;
}

std::vector<column> columns(const char *reference) {
  return {{"instruction_set", "instruction|set"},
          {"method", "method"},
          {"ns", "ns a|pair"},
          {"rate", fmt::format("x {}", reference)},
          {"hits", "hits"},
          {"false_hits", "false|hits"},
          {"missed", "missed|hits"}};
}

void measure_triangles(const cpu_context &c, cpu_result &to) {
  const blind_scene scene("triangle_triangle", c.sets.small_on_large());
  table t{"blind_triangles",
          fmt::format("Every pair, no boxes: triangles, {} scaled onto {}", c.sets.small_name(), c.sets.large_name()),
          columns("scalar|Möller"),
          {},
          {"The planes of Möller's test are stored beside the triangles where that is said, as our predicates store "
           "what an object alone decides; rates are multiples of the scalar test's with stored planes, in the same "
           "instruction set."}};
  const auto add = [](const tests_of_set &of, const baselines::classic_table &classic) {
    of.add_classic("Möller, epsilon 0, scalar, planes stored", classic.moller_stored);
    of.add_classic("Möller, epsilon 0, scalar, as published", classic.moller);
    of.add_classic("Möller, epsilon 0, lanes, planes stored", classic.moller_lanes);
    of.add_classic("Guigue-Devillers, scalar", classic.guigue_devillers);
    of.add_ours("fp32", rung::fp32);
    of.add_ours("certified, pair by pair", rung::certified);
    of.add_behind(in_tiles, filter_by_signs);
    of.add_behind(behind_filter, filter_by_balls);
    of.add_ours("exact", rung::exact);
  };
  for (const certified_rate &r : measure_scene(c, scene, 0, add, t)) {
    const bool wide = r.set == instruction_set::avx512, narrow = r.set == instruction_set::baseline;
    const std::string work = fmt::format("every pair, triangles, {}", name_of(r.set));
    to.bars.push_back({work, "certified, rate / scalar Möller", bar::side::at_least,
                       narrow ? 2.0
                       : wide ? 8.0
                              : 5.0,
                       "x", r.rate});
    to.bars.push_back({work, "certified behind the filter, rate / scalar Möller", bar::side::at_least,
                       narrow ? 5.0
                       : wide ? 20.0
                              : 15.0,
                       "x", r.filtered});
  }
  to.tables.push_back(std::move(t));
}

void measure_every_ball(const cpu_context &c, cpu_result &to) {
  const blind_scene scene("ball_ball", c.sets.few_balls());
  table t{"blind_balls", "Every pair, no boxes: balls", columns("Euclid|in lanes"), {}, {}};
  const auto add = [](const tests_of_set &of, const baselines::classic_table &classic) {
    of.add_classic("Euclid, lanes", classic.balls_lanes);
    of.add_classic("Euclid, scalar", classic.balls);
    of.add_ours("fp32", rung::fp32);
    of.add_ours("certified", rung::certified);
    of.add_behind(behind_filter, filter_by_balls);
    of.add_ours("exact", rung::exact);
  };
  // The filter has the form of the predicate, but for the balls around the boxes. The bar is for the faster of the two
  // ways, and the table has both.
  for (const certified_rate &r : measure_scene(c, scene, 0, add, t))
    to.bars.push_back({fmt::format("every pair, balls, {}", name_of(r.set)),
                       "certified behind the filter, rate / Euclid in lanes", bar::side::at_least,
                       r.set == instruction_set::baseline ? 0.9 : 1.1, "x", r.filtered});
  to.tables.push_back(std::move(t));
}

} // namespace

void measure_blind(const cpu_context &c, cpu_result &to) {
  measure_triangles(c, to);
  measure_every_ball(c, to);
}

} // namespace meetc::bench
