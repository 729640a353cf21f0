#include "app/collide_sets.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "core/pair_sort.hpp"

#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace meet::app {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void mark(side_answer &side, std::size_t items, const std::vector<index_pair> &pairs,
          std::uint32_t index_pair::*which) {
  side.hit.assign(items, 0);
  for (const index_pair &p : pairs) {
    std::uint8_t &hit = side.hit[p.*which];
    side.touched += hit == 0;
    hit = 1;
  }
}

} // namespace

answers collide_sets(const io::element_set &a, const io::element_set &b, const how &h) {
  const predicate_info &predicate = *h.by.predicate;
  if (!predicate.decide[static_cast<int>(h.precision)])
    throw failure(
        fmt::format("--precision {}: {} was not generated for it", name_of(h.precision), predicate.name));
  answers out;
  const auto start = std::chrono::steady_clock::now();
  const prepared ready_a = prepare(a, h.threads), ready_b = prepare(b, h.threads);
  ready_a.bounds(out.a.bounds.lo, out.a.bounds.hi);
  ready_b.bounds(out.b.bounds.lo, out.b.bounds.hi);
  out.prepare_seconds = seconds_since(start);

  const auto then = std::chrono::steady_clock::now();
  collide_options options;
  options.mode = h.any ? collide_mode::any : collide_mode::list;
  options.threads = h.threads;
  options.progress = h.progress;
  options.owner_a = h.by.swapped ? b.owner : a.owner;
  options.owner_b = h.by.swapped ? a.owner : b.owner;
  result r = h.by.swapped ? ::meet::collide(ready_b, ready_a, predicate, h.precision, options)
                          : ::meet::collide(ready_a, ready_b, predicate, h.precision, options);
  if (h.by.swapped) {
    for (index_pair &p : r.pairs)
      std::swap(p.a, p.b);
    std::vector<index_pair> scratch;
    sort_pairs(r.pairs.data(), r.pairs.size(), scratch);
  }
  out.pairs = r.count;
  out.candidates = r.candidates;
  out.list = std::move(r.pairs);
  mark(out.a, a.items, out.list, &index_pair::a);
  mark(out.b, b.items, out.list, &index_pair::b);
  if (h.any)
    out.a.touched = out.b.touched = out.pairs;
  out.collide_seconds = seconds_since(then);
  return out;
}

bool is_empty(const box &b) {
  return b.lo[0] > b.hi[0];
}

bool disjoint(const box &x, const box &y) {
  bool apart = false;
  for (int k = 0; k < 3; ++k)
    apart = apart || x.hi[k] < y.lo[k] || y.hi[k] < x.lo[k];
  return apart && !is_empty(x) && !is_empty(y);
}

bool inside(const box &inner, const box &outer) {
  bool in = !is_empty(inner) && !is_empty(outer);
  for (int k = 0; k < 3; ++k)
    in = in && outer.lo[k] <= inner.lo[k] && inner.hi[k] <= outer.hi[k];
  return in;
}

} // namespace meet::app
