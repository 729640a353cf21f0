#include "meet/core/device/collide.hpp"

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/first_met.hpp"
#include "meet/core/device/hits.hpp"
#include "meet/core/device/parts.hpp"
#include "meet/core/device/query.hpp"
#include "meet/core/device/tallies.hpp"
#include "meet/core/device/tree_kernels.hpp"
#include "meetc/cuda/cascade.hpp"

#include <algorithm>
#include <chrono>

namespace meetc {
namespace {

constexpr std::size_t first_capacity = std::size_t{1} << 22;

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
}

// The rung that decides where tolerant is asked for: certified, if a set leaves the box that tolerant presumes.
rung tolerant_or_certified(const device_set &a, const device_set &b, const predicate_info &p, rung_report &report) {
  const tolerance_info &t = p.tolerance;
  require(t.fits(a.grid()) && t.fits(b.grid()), text(status::not_on_grid));
  const auto leaves = [&t](const device_set &s) {
    const auto [reach, longest] = s.reaches();
    return !t.holds(reach, longest);
  };
  report.left_box_a = leaves(a), report.left_box_b = leaves(b);
  if (!report.left_box_a && !report.left_box_b)
    return rung::tolerant;
  require(p.decide[static_cast<int>(rung::certified)] != nullptr, text(status::left_box));
  return rung::certified;
}

class device_query {
public:
  device_query(device &on, device_set &a, device_set &b, const predicate_info &p, rung precision,
               const device_options &options, std::span<std::uint64_t> of_instances, pairs_there *left_there,
               std::optional<std::size_t> cleared)
      : on_(on), buffers_(on.buffers()), a_(a), b_(b), predicate_(launchers_of(on.kernels(), p)), precision_(precision),
        symmetric_(p.symmetric), options_(options), of_instances_(of_instances),
        hits_(on, a, b, options.owner_a, options.owner_b),
        tallies_(!of_instances.empty() ||
                 (!hits_.owned() && (options.want == answer_kind::counts || options.want == answer_kind::flags))),
        keep_(tallies_ || options.want == answer_kind::pairs || (options.want != answer_kind::any && hits_.owned())),
        stores_(keep_ || options.first_met), left_there_(left_there), clock_runs_(cleared),
        cleared_(cleared.value_or(0)), first_(on.buffers()) {}

  device_result run() {
    // Half of the pairs of a set with itself are visited where the other half has the same answers.
    both_ways_ = &a_ == &b_ && symmetric_ && never_wrong(precision_) && !options_.first_met;
    require(!options_.first_met || predicate_.pairs.first_met, "no CUDA kernel was generated for the order of hits");
    hits_.upload_owners();
    if (!clock_runs_)
      check(cudaEventRecord(buffers_.events[0], on_.stream()), "starting a clock");
    if (options_.first_met)
      first_.start(a_, on_.stream());
    if (tallies_)
      tallied_.start(options_.want, a_.numbers(), b_.numbers(), of_instances_, on_.stream());
    if (a_.elements() > 0 && b_.elements() > 0) {
      take_trees();
      take_room();
      go_through({0, nodes(a_), 0, nodes(b_)});
      if (both_ways_ && !walk_decides() && !walks_balls() && options_.want != answer_kind::any)
        result_.candidates = 2 * result_.candidates - a_.elements(); // each element's box touches itself
    } else {
      mark_clock();
    }
    if (options_.first_met && a_.elements() > 0 && b_.elements() > 0) {
      first_.name(a_, b_, on_.stream());
      mark_clock();
    }
    if (options_.want == answer_kind::any)
      result_.count = result_.count > 0;
    if (tallies_)
      tallied_.finish(result_, of_instances_, on_.stream());
    else if (keep_)
      hits_.finish(
          options_.want, result_, [this] { mark_clock(); }, left_there_);
    if (options_.first_met)
      first_.finish(a_, b_, options_.owner_b, result_, on_.stream());
    result_.device_seconds = buffers_.between();
    return std::move(result_);
  }

private:
  // Those with the elements' boxes.
  static std::uint32_t nodes(const device_set &s) {
    return s.elements() / cuda::tree_width + (s.elements() % cuda::tree_width != 0);
  }

  // The elements of the larger set walk, but those with two points before others. A plain rung may say yes where nothing
  // touches, so that its candidates are all pairs whose boxes touch.
  void take_trees() {
    const bool points = never_wrong(precision_) && !walk_decides(), by_points_a = points && has_two_points(a_.kind()),
               by_points_b = points && has_two_points(b_.kind());
    walk_.half = both_ways_;
    walk_.swapped = by_points_a == by_points_b ? a_.elements() < b_.elements() : by_points_b;
    device_set &walker = walk_.swapped ? b_ : a_, &tree = walk_.swapped ? a_ : b_;
    const bool beside =
        &tree != &walker && !tree.has_tree() && !walker.has_tree(); // the two are made beside each other
    if (beside) {
      check(cudaEventRecord(buffers_.forked, on_.stream()), "starting a stream");
      check(cudaStreamWaitEvent(buffers_.beside, buffers_.forked, 0), "starting a stream");
    }
    walk_.tree = tree.tree(beside ? buffers_.beside : on_.stream());
    walk_.walker = walker.tree(on_.stream());
    walk_.found_walker = walker.findings(), walk_.found_tree = tree.findings();
    if (beside) {
      check(cudaEventRecord(buffers_.joined, buffers_.beside), "joining a stream");
      check(cudaStreamWaitEvent(on_.stream(), buffers_.joined, 0), "joining a stream");
    }
    walk_.rows = nullptr;
    if (by_points_a || by_points_b) {
      walk_.rows = walker.rows();
      walk_.fields = walker.kind().fields;
      walk_.points = point_fields_of(walker.kind());
    }
  }

  // The last mark counts.
  void mark_clock() { check(cudaEventRecord(buffers_.events[1], on_.stream()), "stopping a clock"); }

  // A walk that decides has no list but that of what it leaves unsure, unless its hits are stored.
  bool only_counts() const { return !stores_ && (walk_decides() || walks_balls()); }
  // Of a walk: a guess, of balls that touch one other on average. Where there are more of one set, fewer of these do. Where
  // it decides them, half as many are listed.
  std::uint64_t expected_in_list() const {
    if (only_counts())
      return 0;
    const auto [few, many] = std::minmax({a_.elements(), b_.elements()});
    return (3 * std::uint64_t{few} + (many - few) / 2) / (walks_balls() ? 2 : 1);
  }
  // Reserves room for the first lists, or keeps the existing lists.
  void take_room() {
    const std::size_t wanted = std::max<std::size_t>(expected_in_list(), first_capacity);
    const auto within_options = [this](std::size_t least) {
      return std::clamp(buffers_.first.capacity(), std::min(options_.list_capacity, least), options_.list_capacity);
    };
    capacity_ = within_options(wanted);
    if (!enlarge_lists(capacity_))
      capacity_ = within_options(first_capacity);
    buffers_.take_notes(keep_ && !tallies_ && !hits_.owned() ? hit_pairs::room_to_order : 0);
    buffers_.first.reserve(capacity_, "a list of candidates");
    buffers_.second.reserve(capacity_, "a list of candidates");
    if (stores_)
      buffers_.hits.reserve(capacity_, "a list of hits");
  }
  // Enlarges the lists if the options and the device's memory allow it.
  bool take_more_room() {
    const std::size_t more = std::min(capacity_ * 8, options_.list_capacity);
    if (more == capacity_ || !enlarge_lists(more))
      return false;
    capacity_ = more;
    return true;
  }
  // Returns false where there is too little memory.
  bool enlarge_lists(std::size_t capacity) {
    return buffers_.first.grow(capacity, 0, on_.stream()) && buffers_.second.grow(capacity, 0, on_.stream()) &&
           (!stores_ || buffers_.hits.grow(capacity, 0, on_.stream()));
  }

  cuda::pair_list list(const device_memory<index_pair> &pairs, counter c) const {
    return {pairs.data(), buffers_.counts() + static_cast<int>(c), std::min(pairs.capacity(), capacity_)};
  }
  cuda::pair_list count_only(counter c) const { return {nullptr, buffers_.counts() + static_cast<int>(c), 0}; }
  unsigned long long seen(counter c) const { return buffers_.seen->of_query.counts[static_cast<int>(c)]; }

  // Whether the lists that the last part filled could take so many times as much.
  bool lists_hold(std::uint64_t times) const {
    const std::uint64_t most = capacity_ / times;
    return seen(counter::candidates) <= most && seen(counter::kept) <= most &&
           (!stores_ || seen(counter::hits) <= most);
  }
  bool overflowed() const { return !lists_hold(1); }
  // This number of pairs of nodes never overflows a list.
  std::uint64_t always_fits() const { return capacity_ / (cuda::tree_width * cuda::tree_width * (both_ways_ ? 2 : 1)); }

  void go_through(const cuda::part &whole) {
    std::vector<cuda::part> left{whole};
    std::uint64_t most = ~std::uint64_t{0}, done = 0; // the largest part that is worth trying, and the finished pairs
    if (expected_in_list() > capacity_)
      most = area(whole) / (expected_in_list() / capacity_ + 1);
    while (!left.empty()) {
      const cuda::part p = left.back();
      left.pop_back();
      if (area(p) > most && area(p) > always_fits()) {
        const auto [x, y] = halves(p, cuts_a(p, walk_.swapped), 1);
        left.push_back(y), left.push_back(x);
        continue;
      }
      if (both_ways_ && p.end_b <= p.first_a) { // a half that the other answers for
        done += area(p);
        continue;
      }
      try_part(p, area(p) == area(whole));
      const bool answered = options_.want == answer_kind::any && seen(counter::hits) > 0;
      if (overflowed() && !answered) {
        left.push_back(p);
        if (!take_more_room())
          most = area(p) / 4;
        continue;
      }
      if (most != ~std::uint64_t{0} && lists_hold(8))
        most = most < ~std::uint64_t{0} / 2 ? most * 2 : ~std::uint64_t{0};
      take_part();
      done += area(p);
      if (options_.progress)
        options_.progress(static_cast<double>(done) / static_cast<double>(area(whole)));
      if (answered)
        return;
    }
  }

  void try_part(const cuda::part &p, bool is_all) {
    const cudaStream_t stream = on_.stream();
    orders_ = is_all && keep_ && !tallies_ && hits_.can_order(capacity_);
    if (orders_) {
      const std::optional<std::uint64_t> before = buffers_.hits_before.of(&a_, &b_);
      // At first, that about as many elements of A touch one; but then they are not said to be few.
      expected_hits_ = before ? amount_of(*before) : std::max(amount_of(a_.numbers()), hit_amount::some);
    }
    enqueue(p);
    mark_clock();
    check(cudaMemcpyAsync(&buffers_.seen->of_query, buffers_.notes.data(), sizeof(query_notes), cudaMemcpyDeviceToHost,
                          stream),
          "reading counters");
    check(cudaStreamSynchronize(stream), "colliding");
    if (orders_)
      buffers_.hits_before.note(&a_, &b_, seen(counter::hits));
    ++result_.parts;
  }

  // The kernels from the candidates to the last decision and, if all hits are ordered at once, to sorted pairs.
  void enqueue(const cuda::part &p) {
    const cudaStream_t stream = on_.stream();
    const bool counted = orders_ && expected_hits_ != hit_amount::few;
    const std::size_t cleared = counters + (counted ? hit_pairs::room_to_order : 0);
    if (std::exchange(cleared_, 0) < cleared)
      check(cudaMemsetAsync(buffers_.counts(), 0, cleared * sizeof(unsigned long long), stream), "clearing counters");
    cuda::pair_list hits = stores_ ? list(buffers_.hits, counter::hits) : count_only(counter::hits);
    hits.both_ways = both_ways_;
    if (walk_decides()) {
      find_candidates(p, of_walk(hits));
    } else if (walks_balls()) {
      walk_.balls = true;
      walk_.unsure = list(buffers_.first, counter::candidates);
      walk_.near = count_only(counter::touching).count;
      find_candidates(p, of_walk(hits));
      decide_candidates(hits);
    } else {
      find_candidates(p, list(buffers_.first, counter::candidates));
      decide_candidates(hits);
    }
    if (orders_)
      hits_.order(hits, buffers_.to_order(), count_only(counter::unordered).count, expected_hits_);
  }

  void decide_candidates(const cuda::pair_list &hits) {
    const cuda::cascade_lists lists{list(buffers_.first, counter::candidates), list(buffers_.second, counter::kept),
                                    count_only(counter::unsure_fp32).count};
    check(cuda::decide(predicate_, precision_, a_.rows(), b_.rows(), lists, hits, on_.stream()),
          "starting a decision step");
  }

  // Boxes that touch are hits of such a predicate, and a walk compares boxes.
  bool walk_decides() const { return predicate_.by_boxes && never_wrong(precision_); }

  // A walk compares balls by their boxes, which leaves few pairs to the rungs.
  bool walks_balls() const { return predicate_.by_balls && never_wrong(precision_); }
  // No list stops a walk that only counts, unless one hit is enough.
  cuda::pair_list of_walk(cuda::pair_list hits) const {
    if (only_counts())
      hits.capacity = options_.want == answer_kind::any ? 0 : ~0ULL;
    return hits;
  }

  void find_candidates(const cuda::part &p, const cuda::pair_list &out) {
    walk_.of = walk_.swapped ? cuda::part{p.first_b, p.end_b, p.first_a, p.end_a} : p;
    walk_.out = out;
    walk_.taken = buffers_.counts() + static_cast<int>(counter::taken);
    check(walk(walk_, on_.stream()), "starting the walk");
  }

  // Takes the results of a part whose lists did not overflow.
  void take_part() {
    result_.candidates += seen(walk_decides()  ? counter::hits
                               : walks_balls() ? counter::touching
                                               : counter::candidates);
    result_.count += seen(counter::hits);
    result_.rungs.unsure[0] += seen(counter::unsure_fp32);
    result_.rungs.unsure[1] += seen(counter::unsure_fp64);
    result_.rungs.unsure[2] += seen(counter::unsure_fp64x2);
    const std::size_t n = seen(counter::hits);
    if (n == 0)
      return;
    if (options_.first_met) {
      first_.add(predicate_, a_, b_, hits_.owners_there_b(), buffers_.hits.data(), n, on_.stream());
      mark_clock();
    }
    if (!keep_)
      return;
    if (tallies_) {
      tallied_.add(buffers_.hits.data(), n, a_.order(), b_.order(), on_.stream());
      mark_clock();
      return;
    }
    if (orders_ && seen(counter::unordered) == 0) {
      hits_.take_ordered(n);
      return;
    }
    if (orders_ && expected_hits_ != hit_amount::few)
      hits_.take_crowded();
    hits_.add(buffers_.hits.data(), n);
  }

  device &on_;
  device_buffers &buffers_;
  device_set &a_, &b_;
  const cuda::predicate_launchers &predicate_;
  rung precision_;
  bool symmetric_;
  const device_options &options_;
  std::span<std::uint64_t> of_instances_;
  bool both_ways_ = false;
  hit_pairs hits_;
  bool tallies_, keep_; // hits are counted by item; they are kept until then, or for their list
  bool stores_;         // they are written to a list of the device, for either of these or for the first ones
  pairs_there *left_there_;
  bool clock_runs_;     // the caller has started it
  std::size_t cleared_; // so many numbers the caller has cleared for the first part
  tallies tallied_;
  first_met_there first_;
  tree_walk walk_{};
  std::size_t capacity_ = 0;
  bool orders_ = false; // the hits of all are ordered with the kernels that find them
  hit_amount expected_hits_ = hit_amount::some;
  device_result result_;
};

} // namespace

device_result query(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                    const device_options &options, std::span<std::uint64_t> of_instances, pairs_there *left_there,
                    std::optional<std::size_t> cleared) {
  const auto start = std::chrono::steady_clock::now();
  rung_report report;
  if (precision == rung::tolerant)
    precision = tolerant_or_certified(a, b, predicate, report);
  device_result r = device_query(on, a, b, predicate, precision, options, of_instances, left_there, cleared).run();
  r.rungs.left_box_a = report.left_box_a, r.rungs.left_box_b = report.left_box_b;
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

device_result collide(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options) {
  return under_standard_word([&] {
    require_query(on, a, b, predicate, precision, options);
    for (const device_set *const s : {&a, &b})
      require(s->elements() == 0 || s->order(), "a set in several poses is for collide_poses() alone");
    return query(on, a, b, predicate, precision, options, {});
  });
}

} // namespace meetc
