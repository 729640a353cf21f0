// Queries with their preparation, beside other libraries: build, query and answers apart.
#include "bench/tables/cpu/parts.hpp"

#include "app/choose.hpp"
#include "app/sets.hpp"
#include "app/words.hpp"
#include "bench/harness/list_difference.hpp"
#include "bench/peers/peers.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>

namespace meetc::bench {

namespace {

// One method of a table. Its works take turns with those of the others: build, then query.
struct method {
  std::string name;
  bool candidates; // what it finds
  std::function<void()> build, query;
  std::function<const std::vector<index_pair> &()> found;
};

struct measured_method {
  double build = 0, query = 0;
};

struct candidate_scene {
  const cpu_context &c;
  const io::element_set &a, &b; // the same one for a set against itself
  int threads;

  bool self() const { return &a == &b; }
};

// Ours, by one rung. With `near` the larger set, b, is prepared for the smaller one alone.
method ours(const candidate_scene &s, rung precision, bool near) {
  struct state {
    std::optional<prepared> a, b;
    result found;
  };
  const auto made = std::make_shared<state>();
  const predicate_info *p = app::choose(s.c.best(), *s.a.kind, *s.b.kind, {}, {}).predicate;
  return {fmt::format("{}{}", app::name_of(precision), near ? ", the larger set prepared for the smaller alone" : ""),
          false,
          [made, s, near] {
            made->b.reset();
            made->a.emplace(app::prepare(s.a, s.threads));
            if (!s.self())
              made->b.emplace(app::prepare(s.b, s.threads, near ? &*made->a : nullptr));
          },
          [made, s, p, precision] {
            collide_options options;
            options.threads = s.threads;
            made->found = meetc::collide(*made->a, s.self() ? *made->a : *made->b, *p, precision, options);
          },
          [made]() -> const std::vector<index_pair> & { return made->found.pairs; }};
}

// Another library's, which keeps the rows.
struct rows_of_set {
  std::vector<float> rows;
  std::size_t count;

  explicit rows_of_set(const io::element_set &set)
      : rows(set.elements * static_cast<std::size_t>(set.kind->fields)), count(set.elements) {
    for (std::size_t i = 0; i < count; ++i)
      set.row(i, rows.data() + i * static_cast<std::size_t>(set.kind->fields));
  }
  peers::packed_rows packed() const { return {rows.data(), count}; }
};
struct peer_rows {
  rows_of_set a;
  std::optional<rows_of_set> b; // empty: the same as a
  peers::packed_rows first() const { return a.packed(); }
  peers::packed_rows second() const { return b ? b->packed() : first(); }
};
method of_peer(const candidate_scene &s, const peers::offered_finder &offer, const std::shared_ptr<peer_rows> &rows) {
  struct state {
    std::shared_ptr<peer_rows> rows;
    std::unique_ptr<peers::pair_finder> finder;
    std::vector<index_pair> found;
  };
  const auto made = std::make_shared<state>();
  made->rows = rows;
  made->finder = offer.make(rows->first(), rows->second(), {s.threads, s.c.best().compiled_for});
  return {offer.name, offer.what == peers::finds::candidates, [made] { made->finder->build(); },
          [made] { made->finder->query(made->found); },
          [made]() -> const std::vector<index_pair> & { return made->found; }};
}

// Adds the methods of all libraries that are built in, and a note for each that is not.
void add_peers(const candidate_scene &s, const std::string &only, std::vector<method> &to, table &t) {
  const bool meshes = app::is_mesh(s.a);
  std::shared_ptr<peer_rows> rows;
  for (const peers::library &l : peers::libraries()) {
    const auto &offers = meshes ? l.triangles_triangles : l.segments_triangles;
    if (!only.empty() && l.name != only)
      continue;
    if (!l.built_in) {
      t.notes.push_back(fmt::format("{} was not built in (MEETC_BENCH_PEERS) and is left out.", l.name));
      continue;
    }
    for (const peers::offered_finder &offer : offers) {
      if (!rows)
        rows = s.self() ? std::make_shared<peer_rows>(peer_rows{rows_of_set(s.a), {}})
                        : std::make_shared<peer_rows>(peer_rows{rows_of_set(s.a), rows_of_set(s.b)});
      to.push_back(of_peer(s, offer, rows));
    }
    if (!offers.empty())
      t.notes.push_back(fmt::format("{} {}: {}.", l.name, l.version, l.compiled));
  }
}

// Measures all, and adds a row for each. Exact answers are the truth. Candidates cannot be false.
std::vector<measured_method> measure(const candidate_scene &s, const std::vector<method> &methods, double most_seconds,
                                     table &t) {
  method exact = ours(s, rung::exact, false);
  exact.build();
  exact.query();
  std::vector<index_pair> truth = exact.found();
  std::vector<std::function<void()>> works;
  for (const method &m : methods) {
    works.push_back(m.build);
    works.push_back(m.query);
  }
  interleaved_options timing = s.c.all_threads(most_seconds);
  timing.threads = s.threads;
  const interleaved_times times = measure_interleaved(works, timing);
  t.columns = {{"method", "method"},    {"finds", "finds"}, {"build_ms", "build,|ms"},    {"query_ms", "query,|ms"},
               {"both_ms", "both,|ms"}, {"found", "found"}, {"false_hits", "false|hits"}, {"missed", "missed|hits"}};
  const auto without_diagonal = [](std::vector<index_pair> list) {
    std::erase_if(list, [](const index_pair &p) { return p.a == p.b; });
    return list;
  };
  std::vector<measured_method> out;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    out.push_back({times.seconds[2 * m], times.seconds[2 * m + 1]});
    std::vector<index_pair> found = methods[m].found();
    const std::size_t count = found.size();
    // Whether an element is paired with itself is a convention, so these pairs are not compared.
    const list_difference d = s.self() ? difference_of(without_diagonal(std::move(found)), without_diagonal(truth))
                                       : difference_of(std::move(found), truth);
    t.rows.push_back({of_words(methods[m].name), of_words(methods[m].candidates ? "boxes" : "pairs"),
                      of_milliseconds(out[m].build), of_milliseconds(out[m].query),
                      of_milliseconds(out[m].build + out[m].query), of_count(count),
                      methods[m].candidates ? missing("") : of_count(d.extra), of_count(d.missed)});
  }
  t.title += fmt::format(", {}, {} thread{}: {} x {}", name_of(s.c.best().compiled_for), s.threads,
                         s.threads == 1 ? "" : "s", app::counted(s.a), app::counted(s.b));
  t.notes.insert(t.notes.begin(), fmt::format("{} pairs touch. The lower quartile of {} interleaved repetitions.",
                                              app::grouped(truth.size()), times.repetitions));
  return out;
}

// The least of a figure over the methods whose name starts with `name`; empty where there is none.
template <class Figure>
std::optional<double> least(const std::vector<method> &methods, const std::vector<measured_method> &times,
                            std::string_view name, const Figure &figure) {
  std::optional<double> out;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (methods[m].name.rfind(name, 0) == 0 && (!out || figure(times[m]) < *out))
      out = figure(times[m]);
  return out;
}

double query_of(const measured_method &m) {
  return m.query;
}
double both_of(const measured_method &m) {
  return m.build + m.query;
}

bar against_embree(std::string work, std::string figure, double limit, double ours,
                   const std::optional<double> &theirs) {
  bar b{std::move(work), std::move(figure), bar::side::at_most, limit, "x"};
  if (theirs)
    b.measured = ours / *theirs;
  else
    b.why_not = "Embree was not built in";
  return b;
}

void measure_segments(const cpu_context &c, cpu_result &to) {
  const cpu_sets::two_sets sets = c.sets.segments_in_large();
  const candidate_scene s{c, sets.first, sets.second, c.threads};
  table t{"segments", "Segments as long as the box x mesh", {}, {}, {}};
  std::vector<method> methods{ours(s, rung::certified, true), ours(s, rung::certified, false)};
  add_peers(s, "Embree", methods, t);
  const std::vector<measured_method> times = measure(s, methods, c.quick ? 2 : 60, t);
  const std::string work = "segments as long as the box x mesh";
  to.bars.push_back(
      against_embree(work, "query, certified / Embree", 2, times[0].query, least(methods, times, "Embree", query_of)));
  to.bars.push_back(against_embree(work, "build and query, certified / Embree", 1, both_of(times[0]),
                                   least(methods, times, "Embree", both_of)));
  to.tables.push_back(std::move(t));
}

void measure_self(const cpu_context &c, cpu_result &to) {
  const io::element_set mesh = c.sets.large();
  const candidate_scene s{c, mesh, mesh, c.threads};
  table t{"self", fmt::format("The {} against itself", c.sets.large_name()), {}, {}, {}};
  std::vector<method> methods{ours(s, rung::certified, false), ours(s, rung::fp32, false), ours(s, rung::exact, false)};
  add_peers(s, "Embree", methods, t);
  const std::vector<measured_method> times = measure(s, methods, c.quick ? 2 : 120, t);
  t.notes.emplace_back(
      "A triangle with itself is not compared, since it is a convention whether such a pair is listed.");
  const std::string work = fmt::format("{} with itself", c.sets.large_name());
  to.bars.push_back(against_embree(work, "query, certified / Embree's candidates", 1.3, times[0].query,
                                   least(methods, times, "Embree", query_of)));
  to.tables.push_back(std::move(t));
}

void measure_bodies(const cpu_context &c, cpu_result &to) {
  const cpu_sets::two_sets sets = c.sets.middle_in_large();
  const std::string work = fmt::format("{} x {}", c.sets.middle_name(), c.sets.large_name());
  {
    const candidate_scene s{c, sets.first, sets.second, c.threads};
    table t{"bodies", work, {}, {}, {}};
    std::vector<method> methods{ours(s, rung::certified, true), ours(s, rung::certified, false),
                                ours(s, rung::fp32, false), ours(s, rung::exact, false)};
    add_peers(s, "", methods, t);
    measure(s, methods, c.quick ? 3 : 150, t);
    to.tables.push_back(std::move(t));
  }
  // The bars for this scene are times on two threads.
  const candidate_scene s{c, sets.first, sets.second, 2};
  table t{"bodies_2_threads", work, {}, {}, {}};
  const std::vector<method> methods{ours(s, rung::certified, true), ours(s, rung::certified, false)};
  const std::vector<measured_method> times = measure(s, methods, c.quick ? 1 : 30, t);
  to.bars.push_back({work, "prepare both, 2 threads", bar::side::at_most, 35, "ms", 1000 * times[0].build});
  to.bars.push_back({work, "collide, certified, 2 threads", bar::side::at_most, 3, "ms", 1000 * times[0].query});
  to.tables.push_back(std::move(t));
}

} // namespace

void measure_candidates(const cpu_context &c, cpu_result &to) {
  measure_segments(c, to);
  measure_self(c, to);
  measure_bodies(c, to);
}

} // namespace meetc::bench
