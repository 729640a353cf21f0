#include "app/collide_sets.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "core/pair_sort.hpp"

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
  const prepared &first, &second;
  const io::element_set &first_set, &second_set;
  side_answer &first_answer, &second_answer;
};

result found_on_device(const ordered &o, const query &q, const collide_options &options, answers &out) {
  device_pairs d = pairs_on_device(o.first, o.second, *q.by.predicate, q.precision, options);
  out.by_device = std::move(d.account);
  return std::move(d.found);
}

void find(const ordered &o, const query &q, answers &out) {
  collide_options options;
  options.want = q.any ? answer_kind::any : q.keep ? answer_kind::pairs : answer_kind::flags;
  options.threads = q.threads;
  options.box = q.box;
  options.progress = q.progress;
  options.owner_a = o.first_set.owner;
  options.owner_b = o.second_set.owner;
  result r = q.on == processor::cuda ? found_on_device(o, q, options, out)
                                     : meetc::collide(o.first, o.second, *q.by.predicate, q.precision, options);
  out.pairs = r.count;
  out.candidates = r.candidates;
  out.rungs = r.rungs;
  if (q.keep)
    r.flags = flags_of(r.pairs, o.first_set.items, o.second_set.items);
  o.first_answer.hit = std::move(r.flags.a);
  o.second_answer.hit = std::move(r.flags.b);
  out.list = q.by.swapped ? transposed(std::move(r.pairs)) : std::move(r.pairs);
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
  answers out;
  const auto start = std::chrono::steady_clock::now();
  // On the CPU the larger set is prepared for the smaller one alone. A device has a hierarchy over all elements.
  const bool a_first = a.elements <= b.elements;
  const auto ready = [&q](const io::element_set &set, const prepared *near) {
    try {
      return prepare(set, q.threads, near, q.grid);
    } catch (const input_error &e) {
      throw failure(
          fmt::format("--tolerance {}: rounded to multiples of 2^{}, {}", q.tolerance, std::ilogb(q.grid), e.what()));
    }
  };
  const prepared smaller = ready(a_first ? a : b, nullptr);
  const prepared larger = ready(a_first ? b : a, q.on == processor::cuda ? nullptr : &smaller);
  const prepared &ready_a = a_first ? smaller : larger, &ready_b = a_first ? larger : smaller;
  ready_a.bounds(out.a.bounds.lo, out.a.bounds.hi);
  ready_b.bounds(out.b.bounds.lo, out.b.bounds.hi);
  out.prepare_seconds = seconds_since(start);

  const auto then = std::chrono::steady_clock::now();
  const ordered o =
      q.by.swapped ? ordered{ready_b, ready_a, b, a, out.b, out.a} : ordered{ready_a, ready_b, a, b, out.a, out.b};
  find(o, q, out);
  if (q.by.swapped)
    std::swap(out.rungs.left_box_a, out.rungs.left_box_b);
  out.a.hit.resize(a.items); // for items after the last with an element, and for all items with `any`
  out.b.hit.resize(b.items);
  for (side_answer *const side : {&out.a, &out.b})
    side->touched = q.any ? out.pairs : static_cast<std::uint64_t>(std::count(side->hit.begin(), side->hit.end(), 1));
  out.collide_seconds = seconds_since(then);
  return out;
}

} // namespace meetc::app
