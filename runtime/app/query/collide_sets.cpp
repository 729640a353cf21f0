#include "meet/app/query/collide_sets.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/core/answers/pair_list.hpp"
#include "meet/core/cascade/cascade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace meetc::app {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The predicate's first and second set, in whichever order the user gave them.
struct ordered {
  const io::element_set &first, &second;
  side_answer &first_answer, &second_answer;
};

result find_on_cpu(const ordered &o, const query &q, const collide_options &options, answers &out) {
  const auto start = std::chrono::steady_clock::now();
  if (&o.first == &o.second) {
    const prepared both = prepare(o.first, q.threads, nullptr, q.grid);
    both.bounds(o.first_answer.bounds.lo, o.first_answer.bounds.hi);
    o.second_answer.bounds = o.first_answer.bounds;
    out.prepare_seconds = seconds_since(start);
    return meetc::collide(both, both, *q.by.predicate, q.precision, options);
  }
  // The larger set is prepared for the smaller one alone.
  const bool first_smaller = o.first.elements <= o.second.elements;
  const prepared smaller = prepare(first_smaller ? o.first : o.second, q.threads, nullptr, q.grid);
  const prepared larger = prepare(first_smaller ? o.second : o.first, q.threads, &smaller, q.grid);
  const prepared &first = first_smaller ? smaller : larger, &second = first_smaller ? larger : smaller;
  first.bounds(o.first_answer.bounds.lo, o.first_answer.bounds.hi);
  second.bounds(o.second_answer.bounds.lo, o.second_answer.bounds.hi);
  out.prepare_seconds = seconds_since(start);
  return meetc::collide(first, second, *q.by.predicate, q.precision, options);
}

result find_on_device(const ordered &o, const query &q, const collide_options &options, answers &out) {
  device_pairs d = pairs_on_device(o.first, o.second, *q.by.predicate, q.precision, q.grid, q.devices, options);
  o.first_answer.bounds = d.around_a, o.second_answer.bounds = d.around_b;
  out.prepare_seconds = d.account.start_seconds + d.prepare_seconds;
  out.by_device = std::move(d.account);
  return std::move(d.found);
}

// Turns pairs of elements, and what elements meet first, into those of their items.
void take_items(const ordered &o, result &r) {
  if (o.first.owner.empty() && o.second.owner.empty())
    return;
  name_items(o.second.owner, r.first_met);
  for (index_pair &p : r.pairs)
    p = {static_cast<std::uint32_t>(o.first.owner_of(p.a)), static_cast<std::uint32_t>(o.second.owner_of(p.b))};
  sort_pairs(r.pairs);
  drop_repeats(r.pairs);
  r.count = r.pairs.size();
}

void find_on(processor on, const ordered &o, const query &q, answers &out) {
  out.on = on;
  collide_options options;
  options.want = q.any ? answer_kind::any : q.keep || q.elements ? answer_kind::pairs : answer_kind::flags;
  options.first_met = q.first;
  options.threads = q.threads;
  options.box = q.box;
  options.progress = q.progress;
  if (!q.elements) {
    options.owner_a = o.first.owner;
    options.owner_b = o.second.owner;
  }
  if (q.elements && q.first)
    require_first_met(*q.by.predicate, options.want, true, o.first.owner);
  result r = out.on == processor::cuda ? find_on_device(o, q, options, out) : find_on_cpu(o, q, options, out);
  if (q.elements) {
    out.element_pairs = r.pairs;
    take_items(o, r);
  }
  out.pairs = r.count;
  out.candidates = r.candidates;
  out.rungs = r.rungs;
  if (q.keep || q.elements)
    r.flags = flags_of(r.pairs, o.first.items, o.second.items);
  o.first_answer.hit = std::move(r.flags.a);
  o.second_answer.hit = std::move(r.flags.b);
  for (std::uint32_t i = 0; i < r.first_met.size(); ++i)
    if (r.first_met[i] != no_element)
      out.first.push_back({i, r.first_met[i]});
  if (q.by.swapped)
    out.first = transposed(std::move(out.first));
  out.list = q.by.swapped ? transposed(std::move(r.pairs)) : std::move(r.pairs);
}

void find_on_best(const ordered &o, const query &q, answers &out) {
  const std::size_t elements = o.first.elements + (&o.first == &o.second ? 0 : o.second.elements);
  if (device_expected(elements, q.threads)) {
    const expected_seconds expected = expected_on(elements, q.threads);
    try {
      find_on(processor::cuda, o, q, out);
      out.notes.push_back(fmt::format("--device auto took the CUDA device: {:.2g} s were expected of it, its start "
                                      "included, and {:.2g} s of the CPU",
                                      expected.cuda, expected.cpu));
      return;
    } catch (const failure &e) {
      if (e.code() != no_device)
        throw;
      out.notes.push_back(fmt::format("--device auto took the CPU: {}", e.what()));
    }
  }
  find_on(processor::cpu, o, q, out);
}

} // namespace

void set_tolerance(query &q, double tolerance) {
  const predicate_info &p = *q.by.predicate;
  q.tolerance = tolerance;
  if (tolerance == 0)
    return;
  if (q.precision != rung::certified)
    throw failure(fmt::format("--precision {}: with --tolerance the precision is certified", name_of(q.precision)));
  if (moved_by_grid(p, 1) == 0)
    throw failure(fmt::format("--tolerance: {} keeps none, since no short move is proved to mend its wrong answers; "
                              "without the option answers are exact",
                              p.name));
  q.grid = grid_within(p, tolerance);
  if (q.grid == 0)
    throw failure(fmt::format("--tolerance {}: beyond what float32 can be rounded to; without the option answers are "
                              "exact",
                              tolerance));
}

answers collide_sets(const io::element_set &a, const io::element_set &b, const query &q) {
  const predicate_info &predicate = *q.by.predicate;
  if (cascade(predicate, q.precision).count == 0)
    throw failure(fmt::format("--precision {}: {} was not generated for it", name_of(q.precision), predicate.name));
  if (q.first && !predicate.first_met)
    throw failure(
        fmt::format("--first needs segments and triangles (segment_triangle); {} has no order", predicate.name));
  answers out;
  const auto start = std::chrono::steady_clock::now();
  try {
    const ordered o = q.by.swapped ? ordered{b, a, out.b, out.a} : ordered{a, b, out.a, out.b};
    if (q.on == processor::best)
      find_on_best(o, q, out);
    else
      find_on(q.on, o, q, out);
  } catch (const input_error &e) { // sets from io::read are good, but for their rounding
    pose rounded;
    rounded.grid = q.grid;
    throw failure(fmt::format("--tolerance {}: {}, {}; without the option answers are exact", q.tolerance,
                              check(view_of(a), *a.kind, rounded) ? "A" : "B", e.what()));
  }
  if (q.by.swapped)
    std::swap(out.rungs.left_box_a, out.rungs.left_box_b);
  out.a.hit.resize(a.items); // for items after the last with an element, and for all items with `any`
  out.b.hit.resize(b.items);
  for (side_answer *const side : {&out.a, &out.b})
    side->touched = q.any ? out.pairs : static_cast<std::uint64_t>(std::count(side->hit.begin(), side->hit.end(), 1));
  out.collide_seconds = seconds_since(start) - out.prepare_seconds;
  return out;
}

} // namespace meetc::app
