#include "meet/core/query/pairs.hpp"

#include "meet/core/answers/any_pair.hpp"
#include "meet/core/answers/element_numbers.hpp"
#include "meet/core/answers/lent_pairs.hpp"
#include "meet/core/cascade/cascade.hpp"
#include "meet/core/query/decide.hpp"
#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <initializer_list>
#include <span>

namespace meetc {
namespace {

struct layout {
  element_set a, b;
  float *stored_a, *stored_b;
  set_scratch scratch_a, scratch_b;
  memory batches;
};

// Both sets are kept. The memory that was needed to build them then holds the batches.
layout take_layout(bump_allocator &from, const predicate_info &p, std::size_t a, std::size_t b, int threads) {
  layout l;
  l.a = take_set(from, *p.a, a);
  l.b = take_set(from, *p.b, b);
  l.stored_a = from.take<float>(a * static_cast<std::size_t>(p.stored_a.floats));
  l.stored_b = from.take<float>(b * static_cast<std::size_t>(p.stored_b.floats));
  bump_allocator for_a, for_b;
  take_scratch(for_a, *p.a, a);
  take_scratch(for_b, *p.b, b);
  l.batches.bytes = std::max({for_a.bytes(), for_b.bytes(), batch_bytes(threads)});
  l.batches.data = from.take<std::byte>(l.batches.bytes);
  if (l.batches.data) {
    bump_allocator again_a(l.batches), again_b(l.batches);
    l.scratch_a = take_scratch(again_a, *p.a, a);
    l.scratch_b = take_scratch(again_b, *p.b, b);
  }
  return l;
}

// By a, then b. A comparison looks for a request now and then, since no memory is there for a sort in pieces.
void sort_pairs(std::span<index_pair> list, const execution &on) {
  std::uint32_t comparisons = 0;
  std::sort(list.begin(), list.end(), [&](index_pair x, index_pair y) {
    if ((++comparisons & 0xffff) == 0)
      on.go_on();
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
}

} // namespace

std::size_t workspace(const predicate_info &predicate, std::size_t elements_a, std::size_t elements_b, int threads) {
  bump_allocator need;
  take_layout(need, predicate, elements_a, elements_b, thread_count(threads));
  return need.bytes();
}

namespace {

status find_pairs(const predicate_info &predicate, rung precision, const view &a, const pose &at_a, const view &b,
                  const pose &at_b, const pairs_out &out, memory work, const pairs_options &options) {
  if (!out.count)
    return status::bad_argument;
  *out.count = 0;
  if (out.rungs)
    *out.rungs = {};
  if ((out.capacity > 0 && !out.data) || !(options.box >= 0))
    return status::bad_argument;
  cascade by(predicate, precision);
  if (by.count == 0)
    return status::no_such_rung;
  if (a.elements > 0xffffffff || b.elements > 0xffffffff)
    return status::too_many_elements;
  const int threads = thread_count(options.threads);
  if (!work.data || work.bytes < workspace(predicate, a.elements, b.elements, threads))
    return status::workspace_too_small;

  bump_allocator from(work);
  layout l = take_layout(from, predicate, a.elements, b.elements, threads);
  // The smaller set is filled whole, and the other with what is near it.
  const bool a_first = a.elements <= b.elements;
  const execution on(threads, options.stop);
  status s = a_first ? fill(l.a, a, at_a, l.scratch_a, on) : fill(l.b, b, at_b, l.scratch_b, on);
  if (s == status::ok)
    s = a_first ? fill(l.b, b, at_b, l.scratch_b, on, &l.a) : fill(l.a, a, at_a, l.scratch_a, on, &l.b);
  if (s == status::ok)
    s = by.check(l.a, l.b);
  if (s != status::ok)
    return s;

  stored_rows stored_a, stored_b;
  const tree_pairs source(l.a, l.b, what_rules_out(precision));
  // The answers write to the caller's arrays, and stop_at_first takes the place of all others.
  any_pair any;
  lent_pairs list(out.data, out.capacity);
  element_flags flags(out.flags_a, out.flags_b);
  element_counts counts(out.counts_a, out.counts_b);
  const queried_sets sets{l.a, l.b, a.elements, b.elements, threads};
  for (query_answer *const each : std::initializer_list<query_answer *>{&any, &list, &flags, &counts})
    each->start(sets);
  query_answer *answers[3];
  std::size_t wanted = 0;
  if (options.stop_at_first)
    answers[wanted++] = &any;
  else if (out.capacity > 0)
    answers[wanted++] = &list;
  if (!options.stop_at_first && (out.flags_a || out.flags_b))
    answers[wanted++] = &flags;
  if (!options.stop_at_first && (out.counts_a || out.counts_b))
    answers[wanted++] = &counts;
  by.enter_box(options.box, l.a, l.b);
  const tally total = decide_all({l.a,
                                  l.b,
                                  {by.stored_a.floats > 0 ? &stored_a : nullptr, by.stored_a, l.stored_a},
                                  {by.stored_b.floats > 0 ? &stored_b : nullptr, by.stored_b, l.stored_b},
                                  by,
                                  source,
                                  on,
                                  options.progress,
                                  options.progress_context,
                                  {answers, wanted}},
                                 l.batches);
  *out.count = options.stop_at_first ? std::min<std::uint64_t>(total.hits, 1) : total.hits;
  if (out.rungs)
    *out.rungs = total.rungs;
  if (!options.stop_at_first && *out.count <= out.capacity)
    sort_pairs({out.data, *out.count}, on);
  return status::ok;
}

} // namespace

status pairs(const predicate_info &predicate, rung precision, const view &a, const pose &at_a, const view &b,
             const pose &at_b, pairs_out out, memory work, const pairs_options &options) noexcept {
  try {
    return under_standard_word([&] { return find_pairs(predicate, precision, a, at_a, b, at_b, out, work, options); });
  } catch (const cancelled &) {
    *out.count = 0;
    return status::cancelled;
  }
}

} // namespace meetc
