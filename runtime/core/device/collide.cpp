#include "core/device/collide.hpp"

#include "core/device/buffers.hpp"
#include "core/device/kernels.hpp"
#include "core/device/query.hpp"
#include "core/device/tallies.hpp"
#include "core/device/tree_kernels.hpp"
#include "core/pair_sort.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>

namespace meetc {
namespace {

// What a search takes as one object, by which its parts are counted.
constexpr std::uint32_t object_size(search by) {
  return by == search::tree ? cuda::tree_width : by == search::groups ? cuda::group_size : 1;
}
// Parts begin at multiples of this many objects.
constexpr std::uint32_t step_of(search by) {
  return by == search::tree ? 1 : cuda::part_step;
}
constexpr std::size_t least_part(search by) {
  const std::size_t elements = std::size_t{step_of(by)} * object_size(by);
  return elements * elements;
}
// Even if every pair of the smallest part's objects is taken apart, the lists can hold them.
constexpr std::size_t least_capacity = std::max(least_part(search::groups), least_part(search::tree));
// Beyond this many elements of A, hits are sorted faster by their keys than by counting.
constexpr std::uint32_t most_to_count = std::uint32_t{1} << 21;
constexpr std::size_t most_counted = 0xffffffff; // their ranks are 32 bits
constexpr std::size_t first_capacity = std::size_t{1} << 22;

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
}

const cuda::predicate_launchers &launchers_of(const cuda::catalogue &all, const predicate_info &p) {
  for (int i = 0; i < all.predicate_count; ++i)
    if (std::strcmp(all.predicates[i].name, p.name) == 0)
      return all.predicates[i];
  throw device_error(std::string("no CUDA kernels were generated for ") + p.name);
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
               const device_options &options, std::span<std::uint64_t> of_instances)
      : on_(on), buffers_(on.buffers()), a_(a), b_(b), predicate_(launchers_of(on.kernels(), p)), precision_(precision),
        symmetric_(p.symmetric), options_(options), of_instances_(of_instances),
        tallies_(!of_instances.empty() ||
                 (!owned() && (options.want == answer_kind::counts || options.want == answer_kind::flags))),
        keep_(tallies_ || options.want == answer_kind::pairs || (options.want != answer_kind::any && owned())) {}

  device_result run() {
    require(!options_.filter || on_.offers(*options_.filter),
            "this device does not offer the filter that was asked for");
    result_.expected = expected_costs(a_.for_search(b_));
    result_.by = options_.by.value_or(result_.expected.least());
    if (result_.by != search::tree)
      result_.filter = options_.filter ? *options_.filter : on_.best_filter();
    // A hierarchy visits half of the pairs of a set with itself where the other half has the same answers.
    both_ways_ = &a_ == &b_ && result_.by == search::tree && symmetric_ && never_wrong(precision_);
    if (owned())
      upload_owners();
    start_clock();
    if (tallies_)
      tallied_.start(options_.want, a_.elements(), b_.elements(), of_instances_, on_.stream());
    if (a_.elements() > 0 && b_.elements() > 0) {
      result_.by == search::tree ? take_trees() : take_columns();
      take_room();
      go_through({0, objects(a_), 0, objects(b_)});
      if (both_ways_ && options_.want != answer_kind::any) // each element's box touches itself
        for (std::uint64_t *const pairs : {&result_.near_balls, &result_.candidates})
          *pairs = 2 * *pairs - a_.elements();
    } else {
      mark_clock();
    }
    if (options_.want == answer_kind::any)
      result_.count = result_.count > 0;
    if (tallies_)
      tallied_.finish(result_, of_instances_, on_.stream());
    else if (keep_)
      finish();
    result_.device_seconds = buffers_.between();
    return std::move(result_);
  }

private:
  bool owned() const { return !options_.owner_a.empty() || !options_.owner_b.empty(); }

  std::uint32_t objects(const device_set &s) const {
    const std::uint32_t size = object_size(result_.by);
    return s.elements() / size + (s.elements() % size != 0);
  }

  void take_columns() {
    const device_set &frame = b_.elements() < a_.elements() ? a_ : b_;
    const cover c = options_.balls.value_or(cuda::balls_for(precision_));
    const cuda::grouping by = result_.by == search::groups ? cuda::grouping::group : cuda::grouping::single;
    x_ = a_.as(result_.filter, by, c, true, frame);
    y_ = b_.as(result_.filter, by, c, false, frame);
  }

  // The elements of the larger set walk, but those with two points before others. A plain rung may say yes where nothing
  // touches, so that its candidates are all pairs whose boxes touch.
  void take_trees() {
    x_ = {a_.rows(), a_.elements(), cuda::grouping::single, nullptr};
    y_ = {b_.rows(), b_.elements(), cuda::grouping::single, nullptr};
    const bool points = never_wrong(precision_), by_points_a = points && has_two_points(a_.kind()),
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

  void upload_owners() {
    const auto upload = [this](std::span<const std::uint32_t> from, const device_set &of,
                               device_memory<std::uint32_t> &to) {
      require(from.empty() || from.size() == of.elements(), "an owner map needs one item for each element");
      if (from.empty())
        return;
      to.reserve(from.size(), "an owner map");
      check(cudaMemcpyAsync(to.data(), from.data(), from.size_bytes(), cudaMemcpyHostToDevice, on_.stream()),
            "uploading owners");
    };
    upload(options_.owner_a, a_, owner_a_);
    upload(options_.owner_b, b_, owner_b_);
  }

  void start_clock() { check(cudaEventRecord(buffers_.events[0], on_.stream()), "starting a clock"); }
  // The last mark counts.
  void mark_clock() { check(cudaEventRecord(buffers_.events[1], on_.stream()), "stopping a clock"); }

  // Of a walk: a guess, of balls that touch one other on average.
  std::uint64_t expected_candidates() const { return 3 * std::uint64_t{std::max(a_.elements(), b_.elements())}; }
  // Reserves room for the first lists, or keeps the existing lists.
  void take_room() {
    const std::size_t wanted =
        result_.by == search::tree ? std::max<std::size_t>(expected_candidates(), first_capacity) : first_capacity;
    const auto within_options = [this](std::size_t least) {
      return std::clamp(buffers_.first.capacity(), std::min(options_.list_capacity, least), options_.list_capacity);
    };
    capacity_ = within_options(wanted);
    if (!enlarge_lists(capacity_))
      capacity_ = within_options(first_capacity);
    orders_all_ = keep_ && !tallies_ && !owned() && a_.elements() <= most_to_count;
    zeroed_ = counters + (orders_all_ ? a_.elements() / 2 + 1 : 0);
    buffers_.counts.reserve(zeroed_, "counters");
    buffers_.first.reserve(capacity_, "a list of candidates");
    buffers_.second.reserve(capacity_, "a list of candidates");
    if (keep_)
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
           (!keep_ || buffers_.hits.grow(capacity, 0, on_.stream()));
  }

  cuda::pair_list list(const device_memory<index_pair> &pairs, counter c) const {
    return {pairs.data(), buffers_.counts.data() + static_cast<int>(c), std::min(pairs.capacity(), capacity_)};
  }
  cuda::pair_list count_only(counter c) const { return {nullptr, buffers_.counts.data() + static_cast<int>(c), 0}; }
  unsigned long long seen(counter c) const { return buffers_.seen[static_cast<int>(c)]; }

  bool overflowed() const {
    return seen(counter::candidates) > capacity_ || seen(counter::kept) > capacity_ ||
           (keep_ && seen(counter::hits) > capacity_);
  }
  // This number of pairs of objects never overflows a list.
  std::uint64_t always_fits() const {
    const std::uint64_t size = object_size(result_.by);
    return capacity_ / (size * size * (both_ways_ ? 2 : 1));
  }

  static std::uint64_t area(const cuda::part &p) { return std::uint64_t{p.end_a - p.first_a} * (p.end_b - p.first_b); }
  // The halves of the longer side, cut between whole blocks where it has several.
  std::pair<cuda::part, cuda::part> halves(const cuda::part &p) const {
    const auto middle = [this](std::uint32_t from, std::uint32_t to) {
      const std::uint32_t unit =
          result_.by != search::tree && to - from > matrix_block ? matrix_block : step_of(result_.by);
      return from + (to - from + unit - 1) / unit / 2 * unit;
    };
    cuda::part x = p, y = p;
    if (p.end_a - p.first_a > p.end_b - p.first_b)
      x.end_a = y.first_a = middle(p.first_a, p.end_a);
    else
      x.end_b = y.first_b = middle(p.first_b, p.end_b);
    return {x, y};
  }

  void go_through(const cuda::part &whole) {
    std::vector<cuda::part> left{whole};
    std::uint64_t most = ~std::uint64_t{0}, done = 0; // the largest part that is worth trying, and the finished pairs
    if (result_.by == search::tree && expected_candidates() > capacity_)
      most = area(whole) / (expected_candidates() / capacity_ + 1);
    while (!left.empty()) {
      const cuda::part p = left.back();
      left.pop_back();
      if (area(p) > most && area(p) > always_fits()) {
        const auto [x, y] = halves(p);
        left.push_back(y), left.push_back(x);
        continue;
      }
      if (both_ways_ && p.end_b <= p.first_a) { // a half that the other answers for
        done += area(p);
        continue;
      }
      try_part(p, area(p) == area(whole));
      if (overflowed()) {
        ordered_ = false;
        left.push_back(p);
        if (!take_more_room())
          most = area(p) / 4;
        continue;
      }
      if (most != ~std::uint64_t{0} && seen(counter::candidates) < capacity_ / 8 && seen(counter::kept) < capacity_ / 8)
        most = most < ~std::uint64_t{0} / 2 ? most * 2 : ~std::uint64_t{0};
      take_part();
      done += area(p);
      if (options_.progress)
        options_.progress(static_cast<double>(done) / static_cast<double>(area(whole)));
      if (options_.want == answer_kind::any && result_.count > 0)
        return;
    }
  }

  void try_part(const cuda::part &p, bool is_all) {
    const cudaStream_t stream = on_.stream();
    check(
        cudaMemsetAsync(buffers_.counts.data(), 0, (is_all ? zeroed_ : counters) * sizeof(unsigned long long), stream),
        "clearing counters");
    find_candidates(p, list(buffers_.first, counter::candidates));
    cuda::pair_list hits = keep_ ? list(buffers_.hits, counter::hits) : count_only(counter::hits);
    hits.both_ways = both_ways_;
    cuda::pair_list in = list(buffers_.first, counter::candidates), out = list(buffers_.second, counter::kept);
    if (!boxes_suffice()) {
      check(predicate_.near(cuda::first_step(precision_), x_, y_, in, hits, out, count_only(counter::touching).count,
                            stream),
            "starting the step that tests boxes");
      std::swap(in, out);
    }
    const cuda::cascade_steps steps = cuda::steps_of(precision_);
    for (int s = 0; s < steps.count; ++s) {
      out.count = count_only(s == 0 ? counter::unsure_fp32 : counter::unsure_fp64).count;
      check(predicate_.run(steps.of[s], x_, y_, in, hits, out, stream), "starting a decision step");
      std::swap(in, out);
    }
    if (is_all && orders_all_ && capacity_ <= most_counted)
      order_hits_of_all(hits);
    mark_clock();
    check(cudaMemcpyAsync(buffers_.seen, buffers_.counts.data(), counters * sizeof(unsigned long long),
                          cudaMemcpyDeviceToHost, stream),
          "reading counters");
    check(cudaStreamSynchronize(stream), "colliding");
    ++result_.parts;
  }

  // A walk's candidates are the pairs whose boxes touch, so that the step that tests boxes has nothing to do but to reject.
  bool boxes_suffice() const {
    return result_.by == search::tree &&
           (cuda::first_step(precision_) == cuda::step::near_boxes || !predicate_.rejects);
  }

  // Enqueues what makes sorted pairs of these hits in buffers_.more_keys, if none has too many. Where there is too little
  // memory for that, their keys are sorted later.
  void order_hits_of_all(const cuda::pair_list &hits) {
    if (!buffers_.keys.grow(capacity_, 0, on_.stream()) || !buffers_.more_keys.grow(capacity_, 0, on_.stream()))
      return;
    auto *const numbers = reinterpret_cast<std::uint32_t *>(buffers_.keys.data());
    const hit_order o{hits.pairs,
                      hits.count,
                      hits.capacity,
                      a_.order(),
                      b_.order(),
                      a_.elements(),
                      reinterpret_cast<std::uint32_t *>(buffers_.counts.data() + counters),
                      numbers,
                      numbers + capacity_,
                      reinterpret_cast<index_pair *>(buffers_.more_keys.data()),
                      buffers_.counts.data() + static_cast<int>(counter::longest)};
    std::size_t bytes = 0;
    check(order_hits(nullptr, bytes, o, on_.stream()), "planning to sort");
    buffers_.sort_space.reserve(bytes, "sorted pairs");
    check(order_hits(buffers_.sort_space.data(), bytes, o, on_.stream()), "sorting pairs");
    ordered_ = true;
  }

  void find_candidates(const cuda::part &p, const cuda::pair_list &out) {
    if (result_.by != search::tree) {
      check(on_.kernels().candidates(result_.filter, x_, y_, p, out, on_.stream()), "starting the filter");
      return;
    }
    walk_.of = walk_.swapped ? cuda::part{p.first_b, p.end_b, p.first_a, p.end_a} : p;
    walk_.out = out;
    walk_.taken = buffers_.counts.data() + static_cast<int>(counter::taken);
    check(walk(walk_, on_.stream()), "starting the walk");
  }

  // Takes the results of a part whose lists did not overflow.
  void take_part() {
    result_.near_balls += seen(counter::candidates);
    result_.candidates += seen(boxes_suffice() ? counter::candidates : counter::touching);
    result_.count += seen(counter::hits);
    result_.rungs.unsure[0] += seen(counter::unsure_fp32);
    result_.rungs.unsure[1] += seen(counter::unsure_fp64);
    result_.rungs.unsure[2] += seen(counter::unsure_fp64x2);
    const std::size_t n = seen(counter::hits);
    ordered_ = ordered_ && seen(counter::longest) == 0;
    if (!keep_ || n == 0)
      return;
    if (tallies_) {
      tallied_.add(buffers_.hits.data(), n, a_.order(), b_.order(), on_.stream());
      mark_clock();
      return;
    }
    if (ordered_) {
      keys_ = n;
      return;
    }
    if (!buffers_.keys.grow(std::max(keys_ + n, std::min(2 * keys_, keys_ + (std::size_t{1} << 28))), keys_,
                            on_.stream()) &&
        !buffers_.keys.grow(keys_ + n, keys_, on_.stream())) {
      spill();
      buffers_.keys.reserve(n, "a list of hits");
    }
    check(to_keys(buffers_.hits.data(), n, a_.order(), owner_a_.data(), b_.order(), owner_b_.data(), bits_b_,
                  buffers_.keys.data() + keys_, on_.stream()),
          "starting a kernel");
    keys_ += n;
  }

  // Moves the keys to the host, unsorted.
  void spill() {
    std::vector<std::uint64_t> keys(keys_);
    check(cudaMemcpyAsync(keys.data(), buffers_.keys.data(), keys_ * sizeof(std::uint64_t), cudaMemcpyDeviceToHost,
                          on_.stream()),
          "downloading pairs");
    check(cudaStreamSynchronize(on_.stream()), "downloading pairs");
    for (const std::uint64_t k : keys)
      spilled_.push_back(pair_of(k, bits_b_));
    keys_ = 0;
  }

  // Sorts the keys on the device and drops repeats where there are owners. Returns false where the device lacks the
  // memory.
  bool sort_on_device() {
    if (owned() && keys_ > 0x7fffffff) // older versions of CUB take at most this many keys
      return false;
    const int bits = std::max(1, bits_of_items(options_.owner_a, a_) + bits_b_);
    std::size_t sort_bytes = 0, repeat_bytes = 0;
    check(sort_keys(nullptr, sort_bytes, nullptr, nullptr, keys_, bits, on_.stream()), "planning to sort");
    if (owned())
      check(drop_repeats(nullptr, repeat_bytes, nullptr, nullptr, nullptr, keys_, on_.stream()), "planning to sort");
    std::size_t bytes = std::max(sort_bytes, repeat_bytes);
    if (!buffers_.more_keys.grow(keys_, 0, on_.stream()) || !buffers_.sort_space.grow(bytes, 0, on_.stream()))
      return false;
    check(sort_keys(buffers_.sort_space.data(), sort_bytes, buffers_.keys.data(), buffers_.more_keys.data(), keys_,
                    bits, on_.stream()),
          "sorting pairs");
    std::swap(buffers_.keys, buffers_.more_keys);
    if (owned()) {
      check(drop_repeats(buffers_.sort_space.data(), repeat_bytes, buffers_.keys.data(), buffers_.more_keys.data(),
                         buffers_.counts.data(), keys_, on_.stream()),
            "dropping repeats");
      unsigned long long kept = 0;
      check(cudaMemcpyAsync(&kept, buffers_.counts.data(), sizeof kept, cudaMemcpyDeviceToHost, on_.stream()),
            "dropping repeats");
      check(cudaStreamSynchronize(on_.stream()), "dropping repeats");
      keys_ = kept;
      std::swap(buffers_.keys, buffers_.more_keys);
    }
    return true;
  }

  // Of the largest item's number.
  static int bits_of_items(std::span<const std::uint32_t> owners, const device_set &of) {
    const std::uint32_t elements = of.elements();
    return std::bit_width(!owners.empty() ? *std::max_element(owners.begin(), owners.end())
                          : elements > 0  ? elements - 1
                                          : 0);
  }

  void finish() {
    std::vector<index_pair> &pairs = result_.pairs;
    if (spilled_.empty() && (keys_ == 0 || ordered_ || sort_on_device())) {
      if (ordered_)
        std::swap(buffers_.keys, buffers_.more_keys);
      else
        check(to_pairs(buffers_.keys.data(), keys_, bits_b_, on_.stream()), "starting a kernel"), mark_clock();
      if (options_.want == answer_kind::count) {
        result_.count = keys_;
        return;
      }
      pairs.resize(keys_);
      check(cudaMemcpyAsync(pairs.data(), buffers_.keys.data(), keys_ * sizeof(index_pair), cudaMemcpyDeviceToHost,
                            on_.stream()),
            "downloading pairs");
      check(cudaStreamSynchronize(on_.stream()), "downloading pairs");
    } else {
      spill();
      pairs = std::move(spilled_);
      sort_scratch scratch;
      sort_pairs(pairs.data(), pairs.size(), scratch);
      if (owned())
        meetc::drop_repeats(pairs);
      mark_clock();
    }
    answer_from_list(options_.want, items(options_.owner_a, a_.elements()), items(options_.owner_b, b_.elements()),
                     result_);
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
  bool tallies_, keep_; // hits are counted by item; they are kept until then, or for their list
  tallies tallied_;
  int bits_b_ = bits_of_items(options_.owner_b, b_);
  cuda::operand x_{}, y_{};
  tree_walk walk_{};
  device_memory<std::uint32_t> owner_a_, owner_b_;
  std::size_t capacity_ = 0, keys_ = 0;
  bool orders_all_ = false, ordered_ = false; // the hits of all are to be sorted at once, and are already
  std::size_t zeroed_ = 0;                    // of the counters, in 64 bits
  std::vector<index_pair> spilled_;
  device_result result_;
};

} // namespace

void require_query(const device &on, const device_set &a, const device_set &b, const predicate_info &predicate,
                   rung precision, const device_options &options) {
  const auto same = [](const kind_info &x, const kind_info &y) {
    return x.fields == y.fields && std::strcmp(x.name, y.name) == 0;
  };
  require(same(a.kind(), *predicate.a) && same(b.kind(), *predicate.b), "the predicate is for other kinds of element");
  require(a.is_on(on) && b.is_on(on), "a set is on another device");
  require(predicate.decide[static_cast<int>(precision)] != nullptr, text(status::no_such_rung));
  require(options.list_capacity >= least_capacity, "a list holds at least 2^18 pairs");
}

device_result query(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                    const device_options &options, std::span<std::uint64_t> of_instances) {
  const auto start = std::chrono::steady_clock::now();
  rung_report report;
  if (precision == rung::tolerant)
    precision = tolerant_or_certified(a, b, predicate, report);
  device_result r = device_query(on, a, b, predicate, precision, options, of_instances).run();
  r.rungs.left_box_a = report.left_box_a, r.rungs.left_box_b = report.left_box_b;
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

device_result collide(device &on, device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options) {
  require_query(on, a, b, predicate, precision, options);
  for (const device_set *const s : {&a, &b})
    require(s->elements() == 0 || s->order(), "a set in several poses is for collide_poses() alone");
  return query(on, a, b, predicate, precision, options, {});
}

} // namespace meetc
