#include "app/collide_sets.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "core/decide.hpp"
#include "core/pair_sort.hpp"
#include "core/threads.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace meetc::app {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Marks items instead of keeping pairs, on all threads at once.
class mark_items final : public hit_taker {
public:
  mark_items(std::vector<std::uint8_t> &a, std::vector<std::uint8_t> &b) : a_(a), b_(b) {}
  void take(int, const index_pair *hits, std::size_t n) override {
    for (std::size_t i = 0; i < n; ++i) {
      mark(a_[hits[i].a]);
      mark(b_[hits[i].b]);
    }
  }

private:
  static void mark(std::uint8_t &flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); }
  std::vector<std::uint8_t> &a_, &b_;
};

// The predicate's first and second set, whichever of the user's they are.
struct ordered {
  const prepared &first, &second;
  const io::element_set &first_set, &second_set;
  side_answer &first_answer, &second_answer;
};

void count_only(const ordered &o, const how &h, answers &out) {
  mark_items taker(o.first_answer.hit, o.second_answer.hit);
  const tree_pairs source(o.first.set(), o.second.set());
  const int threads = thread_count(h.threads);
  const std::unique_ptr<std::byte[]> batches(new std::byte[batch_bytes(threads)]);
  std::function<void(double)> progress = h.progress;
  const auto report = [](void *context, double fraction) {
    (*static_cast<std::function<void(double)> *>(context))(fraction);
  };
  ladder by(*h.by.predicate, h.precision);
  by.enter_box(h.box, o.first.set(), o.second.set());
  const tally total = decide_all({o.first.set(), o.second.set(), by, source, threads, h.any,
                                  progress ? +report : nullptr, &progress, h.any ? nullptr : &taker},
                                 {batches.get(), batch_bytes(threads)});
  out.pairs = total.hits;
  out.candidates = total.candidates;
  out.rungs = total.rungs;
}

result on_device(const ordered &o, const how &h, const collide_options &options, answers &out) {
  device_pairs d = pairs_on_device(o.first, o.second, *h.by.predicate, h.precision, options);
  out.device = std::move(d.device);
  out.model = std::move(d.model);
  out.device_seconds = d.device_seconds;
  out.start_seconds = d.start_seconds;
  return std::move(d.found);
}

void list_pairs(const ordered &o, const how &h, answers &out) {
  collide_options options;
  options.mode = h.any ? collide_mode::any : collide_mode::list;
  options.threads = h.threads;
  options.box = h.box;
  options.progress = h.progress;
  options.owner_a = o.first_set.owner;
  options.owner_b = o.second_set.owner;
  result r = h.where == place::cuda ? on_device(o, h, options, out)
                                    : ::meetc::collide(o.first, o.second, *h.by.predicate, h.precision, options);
  out.pairs = r.count;
  out.candidates = r.candidates;
  out.rungs = r.rungs;
  out.list = std::move(r.pairs);
  for (const index_pair &p : out.list) {
    o.first_answer.hit[p.a] = 1;
    o.second_answer.hit[p.b] = 1;
  }
  if (h.by.swapped) {
    for (index_pair &p : out.list)
      std::swap(p.a, p.b);
    std::vector<index_pair> scratch;
    sort_pairs(out.list.data(), out.list.size(), scratch);
  }
}

} // namespace

answers collide_sets(const io::element_set &a, const io::element_set &b, const how &h) {
  const predicate_info &predicate = *h.by.predicate;
  if (ladder(predicate, h.precision).count == 0)
    throw failure(fmt::format("--precision {}: {} was not generated for it", name_of(h.precision), predicate.name));
  answers out;
  const auto start = std::chrono::steady_clock::now();
  const prepared ready_a = prepare(a, h.threads), ready_b = prepare(b, h.threads);
  ready_a.bounds(out.a.bounds.lo, out.a.bounds.hi);
  ready_b.bounds(out.b.bounds.lo, out.b.bounds.hi);
  out.prepare_seconds = seconds_since(start);

  const auto then = std::chrono::steady_clock::now();
  out.a.hit.assign(a.items, 0);
  out.b.hit.assign(b.items, 0);
  const ordered o =
      h.by.swapped ? ordered{ready_b, ready_a, b, a, out.b, out.a} : ordered{ready_a, ready_b, a, b, out.a, out.b};
  if (h.where == place::cpu && (h.any || (!h.keep && a.owner.empty() && b.owner.empty())))
    count_only(o, h, out);
  else
    list_pairs(o, h, out);
  if (h.by.swapped)
    std::swap(out.rungs.left_box_a, out.rungs.left_box_b);
  for (side_answer *const side : {&out.a, &out.b})
    side->touched = h.any ? out.pairs : static_cast<std::uint64_t>(std::count(side->hit.begin(), side->hit.end(), 1));
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

} // namespace meetc::app
