// Queries with their preparation, beside other libraries: build, query and answers apart.
#include "meet/bench/tables/cpu/cpu.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/text/words.hpp"
#include "meet/bench/peers/peers.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace meetc::bench {

namespace {

struct contest {
  const cpu_context &c;
  std::string name, title;
  const io::element_set &a, &b; // the same one for a set against itself
  int threads;

  bool self() const { return &a == &b; }
};

// A method with what it finds. Its works take turns with those of the others: build, then query.
struct finder {
  std::string name;
  bool candidates, promises_truth;
  std::function<void()> build, query;
  std::function<const std::vector<index_pair> &()> found;
};

// Ours, by one rung. With `near` the larger set, b, is prepared for the smaller one alone.
finder ours(const contest &s, rung precision, bool near) {
  struct state {
    std::optional<prepared> a, b;
    result found;
  };
  const auto made = std::make_shared<state>();
  const predicate_info *p = app::choose(s.c.best(), *s.a.kind, *s.b.kind, {}, {}).predicate;
  return {fmt::format("{}{}", app::name_of(precision), near ? ", the larger set prepared for the smaller alone" : ""),
          false,
          never_wrong(precision),
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

std::vector<float> packed(const io::element_set &set) {
  const auto fields = static_cast<std::size_t>(set.kind->fields);
  std::vector<float> rows(set.elements * fields);
  for (std::size_t i = 0; i < set.elements; ++i)
    set.row(i, rows.data() + i * fields);
  return rows;
}

// The rows of both sets, which another library's finders share.
struct peer_rows {
  std::vector<float> a, b; // b is empty for a set against itself
  peers::packed_rows first, second;

  explicit peer_rows(const contest &s)
      : a(packed(s.a)),
        b(s.self() ? std::vector<float>{} : packed(s.b)), first{a.data(), s.a.elements}, second{s.self() ? a.data()
                                                                                                         : b.data(),
                                                                                                s.b.elements} {}
};

finder of_peer(const contest &s, const peers::offered_finder &offer, std::shared_ptr<peer_rows> rows) {
  struct state {
    std::shared_ptr<peer_rows> rows;
    std::unique_ptr<peers::pair_finder> finder;
    std::vector<index_pair> found;
  };
  const auto made = std::make_shared<state>();
  made->finder = offer.make(rows->first, rows->second, {s.threads, s.c.best().compiled_for});
  made->rows = std::move(rows);
  return {offer.name,
          offer.what == peers::finds::candidates,
          false,
          [made] { made->finder->build(); },
          [made] { made->finder->query(made->found); },
          [made]() -> const std::vector<index_pair> & { return made->found; }};
}

// Adds the methods of all libraries that are built in, and a note for each that is not.
void add_peers(const contest &s, const std::string &only, std::vector<finder> &to, std::vector<std::string> &notes) {
  std::shared_ptr<peer_rows> rows;
  for (const peers::library &l : peers::libraries()) {
    const auto &offers = app::is_mesh(s.a) ? l.triangles_triangles : l.segments_triangles;
    if (!only.empty() && l.name != only)
      continue;
    if (!l.built_in) {
      notes.push_back(fmt::format("{} was not built in (MEETC_BENCH_PEERS) and is left out.", l.name));
      continue;
    }
    for (const peers::offered_finder &offer : offers) {
      if (!rows)
        rows = std::make_shared<peer_rows>(s);
      to.push_back(of_peer(s, offer, rows));
    }
    if (!offers.empty())
      notes.push_back(fmt::format("{} {}: {}.", l.name, l.version, l.compiled));
  }
}

// Whether an element is paired with itself is a convention, so these pairs are not compared.
std::vector<index_pair> without_diagonal(std::vector<index_pair> list) {
  std::erase_if(list, [](const index_pair &p) { return p.a == p.b; });
  return list;
}

struct row {
  std::string method;
  bool candidates;
  double build, query;
  std::uint64_t found;
  difference differs;
};

// Measures all. Exact answers are the truth. Candidates cannot be false.
std::vector<row> measure_scene(const contest &s, const std::vector<finder> &finders, double most_seconds,
                               std::vector<std::string> notes, cpu_result &to) {
  finder exact = ours(s, rung::exact, false);
  exact.build();
  exact.query();
  const std::vector<index_pair> truth = exact.found(), compared = s.self() ? without_diagonal(truth) : truth;
  std::vector<method> methods;
  for (const finder &f : finders)
    methods.push_back({f.name, f.promises_truth, {f.build, f.query}, [&] {
                         return difference_of(s.self() ? without_diagonal(f.found()) : f.found(), compared);
                       }});
  host_clock clock(s.threads);
  const measured_methods m = measure(s.title, clock, methods, s.c.for_seconds(most_seconds));
  std::vector<row> rows;
  for (std::size_t i = 0; i < finders.size(); ++i)
    rows.push_back({finders[i].name, finders[i].candidates, m.of[i].seconds[0], m.of[i].seconds[1],
                    finders[i].found().size(), m.of[i].found});
  notes.insert(notes.begin(), fmt::format("{} pairs touch. The median of {} interleaved repetitions.",
                                          app::grouped(truth.size()), m.repetitions));
  to.tables.push_back(
      table_of<row>(s.name,
                    fmt::format("{}, {}, {} thread{}: {} x {}", s.title, s.c.best_name(), s.threads,
                                s.threads == 1 ? "" : "s", app::counted(s.a), app::counted(s.b)),
                    {{"method", "method", of_words, &row::method},
                     {"finds", "finds", [](const row &r) { return of_words(r.candidates ? "boxes" : "pairs"); }},
                     {"build_ms", "build,|ms", of_milliseconds, &row::build},
                     {"query_ms", "query,|ms", of_milliseconds, &row::query},
                     {"both_ms", "both,|ms", [](const row &r) { return of_milliseconds(r.build + r.query); }},
                     {"found", "found", of_count, &row::found},
                     {"false_hits", "false|hits",
                      [](const row &r) { return r.candidates ? missing("") : of_count(r.differs.extra); }},
                     {"missed", "missed|hits", [](const row &r) { return of_count(r.differs.missed); }}},
                    rows, std::move(notes)));
  return rows;
}

double query_of(const row &r) {
  return r.query;
}
double both_of(const row &r) {
  return r.build + r.query;
}

// A figure of ours, the first row, over the least of Embree's.
bar against_embree(std::string work, std::string what, double limit, const std::vector<row> &rows,
                   double (*figure)(const row &)) {
  bar b{std::move(work), std::move(what), bar::side::at_most, limit, "x"};
  std::optional<double> least;
  for (const row &r : rows)
    if (r.method.starts_with("Embree") && (!least || figure(r) < *least))
      least = figure(r);
  if (least)
    b.measured = figure(rows.front()) / *least;
  else
    b.why_not = "Embree was not built in";
  return b;
}

void measure_segments(const cpu_context &c, cpu_result &to) {
  const two_sets sets = c.sets.segments_in_large();
  const contest s{c, "segments", "Segments as long as the box x mesh", sets.first, sets.second, c.threads};
  std::vector<std::string> notes;
  std::vector<finder> finders{ours(s, rung::certified, true), ours(s, rung::certified, false)};
  add_peers(s, "Embree", finders, notes);
  const std::vector<row> rows = measure_scene(s, finders, c.quick ? 2 : 60, std::move(notes), to);
  const std::string work = "segments as long as the box x mesh";
  to.bars.push_back(against_embree(work, "query, certified / Embree", 2, rows, query_of));
  to.bars.push_back(against_embree(work, "build and query, certified / Embree", 1, rows, both_of));
}

void measure_self(const cpu_context &c, cpu_result &to) {
  const io::element_set mesh = c.sets.large();
  const contest s{c, "self", fmt::format("The {} against itself", c.sets.large_name()), mesh, mesh, c.threads};
  std::vector<std::string> notes;
  std::vector<finder> finders{ours(s, rung::certified, false), ours(s, rung::fp32, false), ours(s, rung::exact, false)};
  add_peers(s, "Embree", finders, notes);
  notes.emplace_back("A triangle with itself is not compared, since it is a convention whether such a pair is listed.");
  const std::vector<row> rows = measure_scene(s, finders, c.quick ? 2 : 120, std::move(notes), to);
  to.bars.push_back(against_embree(fmt::format("{} with itself", c.sets.large_name()),
                                   "query, certified / Embree's candidates", 1.3, rows, query_of));
}

void measure_bodies(const cpu_context &c, cpu_result &to) {
  const two_sets sets = c.sets.middle_in_large();
  const std::string work = fmt::format("{} x {}", c.sets.middle_name(), c.sets.large_name());
  {
    const contest s{c, "bodies", work, sets.first, sets.second, c.threads};
    std::vector<std::string> notes;
    std::vector<finder> finders{ours(s, rung::certified, true), ours(s, rung::certified, false),
                                ours(s, rung::fp32, false), ours(s, rung::exact, false)};
    add_peers(s, "", finders, notes);
    measure_scene(s, finders, c.quick ? 3 : 150, std::move(notes), to);
  }
  // The bars for this scene are times on two threads.
  const contest s{c, "bodies_2_threads", work, sets.first, sets.second, 2};
  const std::vector<row> rows =
      measure_scene(s, {ours(s, rung::certified, true), ours(s, rung::certified, false)}, c.quick ? 1 : 30, {}, to);
  to.bars.push_back({work, "prepare both, 2 threads", bar::side::at_most, 35, "ms", 1000 * rows[0].build});
  to.bars.push_back({work, "collide, certified, 2 threads", bar::side::at_most, 3, "ms", 1000 * rows[0].query});
}

} // namespace

void measure_candidates(const cpu_context &c, cpu_result &to) {
  measure_segments(c, to);
  measure_self(c, to);
  measure_bodies(c, to);
}

} // namespace meetc::bench
