#include "meet/core/device/query/decide.hpp"

#include "meet/core/device/query/lists.hpp"
#include "meet/core/device/query/parts.hpp"
#include "meet/core/device/walk/first_walk.hpp"
#include "meet/core/device/walk/walk.hpp"
#include "meet/core/threads/execution.hpp"
#include "meetc/cuda/cascade.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace meetc {
namespace {

bool needs_pairs(const decision_job &job) {
  return std::ranges::any_of(job.answers, [](const auto &a) { return a->needs_pairs(); });
}

// The pairs that a list may be expected to get: of balls that touch one other on average. Where there are more of one set,
// fewer of these do. Where the walk decides, half as many are listed; a list that only counts gets none. A mesh whose
// neighbours are sifted has six of them for each face, which is in a pair with itself as well.
std::uint64_t expected_pairs(const decision_job &job, walk_lists what) {
  if (what != walk_lists::candidates && !needs_pairs(job))
    return 0;
  const auto [few, many] = std::minmax({job.a.elements(), job.b.elements()});
  if (job.sieve)
    return std::uint64_t{8} * many;
  return (3 * std::uint64_t{few} + (many - few) / 2) / (what == walk_lists::balls ? 2 : 1);
}

// The pairs that a list may hold. Where a stop may be requested, parts are short: some ten milliseconds.
std::size_t most_listed(const decision_job &job) {
  constexpr std::size_t of_short_part = std::size_t{1} << 23;
  return job.stop.stop_possible() ? std::min(job.list_capacity, of_short_part) : job.list_capacity;
}

class decision {
public:
  explicit decision(const decision_job &job)
      : job_(job), buffers_(job.on.buffers()),
        first_(job.first_alone ? first_walk_of(job.on, job.a, job.b, job.by, job.precision) : std::nullopt),
        what_(first_ ? walk_lists::first : lists_of(job.by, job.precision)), expected_(expected_pairs(job, what_)),
        lists_(buffers_, expected_, most_listed(job), needs_pairs(job)),
        walk_(first_ ? tree_walk{} : walk_of(job.on, job.a, job.b, job.precision, what_, job.half)),
        cleared_(job.counts_cleared),
        stops_early_(!job.answers.empty() &&
                     std::ranges::all_of(job.answers, [](const auto &a) { return a->stops_early(); })) {}

  void run(device_result &r) {
    const cuda::part whole{0, lowest_nodes(job_.a), 0, lowest_nodes(job_.b)};
    std::vector<cuda::part> left{whole};
    std::uint64_t most = ~std::uint64_t{0},
                  looked_at = 0; // the largest part that is worth trying, and the pairs of finished ones
    if (expected_ > lists_.capacity())
      most = area(whole) / (expected_ / lists_.capacity() + 1);
    while (!left.empty() && !done()) {
      const cuda::part p = left.back();
      left.pop_back();
      if (area(p) > most && area(p) > always_fits()) {
        const auto [x, y] = halves(p, cuts_a(p, walk_.swapped), 1);
        left.push_back(y), left.push_back(x);
        continue;
      }
      if (job_.half && p.end_b <= p.first_a) { // the other half answers for it
        looked_at += area(p);
        continue;
      }
      const bool is_whole = area(p) == area(whole);
      find(p, is_whole);
      go_on(job_.stop); // no kernel runs now
      ++r.parts;
      if (!lists_.hold(1) && !answered()) {
        left.push_back(p);
        if (!lists_.take_more_room())
          most = area(p) / 4;
        continue;
      }
      if (most != ~std::uint64_t{0} && lists_.hold(8))
        most = most < ~std::uint64_t{0} / 2 ? most * 2 : ~std::uint64_t{0};
      take(is_whole, r);
      looked_at += area(p);
      if (job_.progress)
        job_.progress(static_cast<double>(looked_at) / static_cast<double>(area(whole)));
    }
    // Each element's box touches itself.
    if (job_.half && what_ == walk_lists::candidates && !stops_early_ && !job_.sieve)
      r.candidates = 2 * r.candidates - job_.a.elements();
  }

private:
  bool done() const {
    return stops_early_ && std::ranges::all_of(job_.answers, [](const auto &a) { return a->done(); });
  }
  // Whether the hits of the last part, however few are listed, are enough.
  bool answered() const { return stops_early_ && buffers_.seen_of(counter::hits) > 0; }
  // So many pairs of nodes never overflow a list.
  std::uint64_t always_fits() const {
    return lists_.capacity() / (std::uint64_t{cuda::tree_width} * cuda::tree_width * (job_.half ? 2 : 1));
  }

  // Runs the kernels from the walk to the last decision, and waits for their counts.
  void find(const cuda::part &p, bool is_whole) {
    if (!std::exchange(cleared_, false))
      buffers_.clear_counts();
    cuda::pair_list hits = lists_.hits();
    hits.both_ways = job_.half && !job_.sieve;
    if (first_)
      walk_first(p, hits);
    else
      walk(p, hits);
    if (what_ != walk_lists::hits)
      certify(hits);
    if (is_whole)
      for (const auto &answer : job_.answers)
        answer->take_early(hits);
    buffers_.mark_clock();
    buffers_.read_notes("colliding");
  }

  void walk(const cuda::part &p, const cuda::pair_list &hits) {
    walk_.of = walk_.swapped ? cuda::part{p.first_b, p.end_b, p.first_a, p.end_a} : p;
    walk_.out = what_ == walk_lists::candidates ? lists_.candidates() : hits;
    // No list stops a walk that only counts, unless one hit is enough.
    if (what_ != walk_lists::candidates && !walk_.out.pairs)
      walk_.out.capacity = stops_early_ ? 0 : ~0ULL;
    if (what_ == walk_lists::balls) {
      walk_.unsure = lists_.candidates();
      walk_.near = buffers_.count_of(counter::touching);
    }
    check(meetc::walk(walk_, job_.on.stream()), "starting the walk");
  }

  void walk_first(const cuda::part &p, const cuda::pair_list &hits) {
    first_->of = slots_of(p, job_.a.elements(), job_.b.elements());
    first_->hits = hits, first_->unsure = lists_.candidates();
    check(job_.by.pairs.walk_first(*first_, job_.on.stream()), "starting the walk");
  }

  void certify(const cuda::pair_list &hits) {
    cuda::pair_list in = lists_.candidates(), out = lists_.kept();
    if (job_.sieve) {
      const cuda::pair_list all = in;
      in = out, in.count = buffers_.count_of(counter::apart);
      job_.sieve->sift(all, in, hits);
      out = all, out.count = buffers_.count_of(counter::kept);
    }
    check(cuda::decide(job_.by, job_.precision, job_.a.data(), job_.b.data(),
                       {in, out, buffers_.count_of(counter::unsure_fp32)}, hits, job_.on.stream()),
          "starting a decision step");
  }

  // Takes the counts and the hits of a part whose lists did not overflow.
  void take(bool is_whole, device_result &r) {
    const auto seen = [this](counter c) { return buffers_.seen_of(c); };
    r.candidates += seen(job_.sieve                        ? counter::apart
                         : what_ == walk_lists::hits       ? counter::hits
                         : what_ == walk_lists::candidates ? counter::candidates
                                                           : counter::touching);
    r.count += seen(counter::hits);
    r.rungs.unsure[0] += seen(counter::unsure_fp32);
    r.rungs.unsure[1] += seen(counter::unsure_fp64);
    r.rungs.unsure[2] += seen(counter::unsure_fp64x2);
    if (job_.sieve)
      job_.sieve->take();
    for (const auto &answer : job_.answers)
      answer->take({buffers_.hits.data(), static_cast<std::size_t>(seen(counter::hits)), is_whole});
  }

  const decision_job &job_;
  device_buffers &buffers_;
  std::optional<cuda::first_walk_job> first_;
  walk_lists what_;
  std::uint64_t expected_;
  query_lists lists_;
  tree_walk walk_;
  bool cleared_, stops_early_;
};

} // namespace

void decide_all(const decision_job &job, device_result &r) {
  decision(job).run(r);
}

} // namespace meetc
