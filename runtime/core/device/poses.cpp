// One set against another in many poses.
//
// Problem: a query takes some 50 us even where nothing touches, and its kernels are too short to fill a device. Method: the
// elements of B in many poses at once are one set, whose hierarchy's lowest boxes each hold neighbours in one pose or two, and
// one query counts the pairs of each pose. A pose in which the box around B is proved apart from that around A is not looked
// at. As many poses are taken at once as memory allows, and as will probably not overflow the lists. Where it is only asked
// whether anything touches, a sixteenth of B's elements goes first, and all of them in the poses that are left.
#include "meet/core/device/collide.hpp"

#include "meet/core/device/answers/element_numbers.hpp"
#include "meet/core/device/query/query.hpp"
#include "meet/core/threads/execution.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/core/views/usage_error.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace meetc {
namespace {

constexpr std::size_t most_elements = std::size_t{1} << 23; // at once: more do not fill the device better
constexpr std::size_t bytes_of_element = 4096;              // with boxes and lists, and room to spare

constexpr double lists_filled = 0.8; // the share of a list that a part may be expected to need

// The share of the elements of B that is tested first.
constexpr std::uint32_t sample = 16, least_sampled = 16 * sample;

class poses_query {
public:
  poses_query(const device &on, device_rows &a, const predicate_info &p, rung precision, const device_options &options)
      : on_(on), a_(a), predicate_(p), precision_(precision), options_(options) {
    options_.want = answer_kind::count;
    options_.owner_a = options_.owner_b = {};
    options_.progress = {};
  }

  // Fills the counts of these poses, which are numbers in r.counts.
  void count(const device_rows &b, std::span<const pose> poses, std::span<const std::size_t> numbers, bool few_expected,
             poses_result &r, const std::function<void(double)> &progress) {
    const std::size_t room = std::min(most_elements, on_.facts().bytes / bytes_of_element);
    const std::size_t most = std::max<std::size_t>(1, room / std::max<std::size_t>(b.elements(), 1));
    std::vector<pose> some;
    std::vector<std::uint64_t> counts;
    // Until it is known how many candidates a pose has, fewer, but where a sample of B has left those that have few.
    std::size_t at_once = few_expected ? most : std::max<std::size_t>(1, most / 4);
    for (std::size_t first = 0, taken = 0; first < numbers.size(); first += taken) {
      go_on(options_.stop);
      const auto of = numbers.subspan(first, std::min(at_once, numbers.size() - first));
      taken = of.size();
      some.clear();
      for (const std::size_t i : of)
        some.push_back(poses[i]);
      counts.assign(of.size(), 0);
      device_rows instances(on_, b.kind());
      instances.take_instances(b, some, of);
      std::unique_ptr<on_device::query_answer> answers[] = {std::make_unique<on_device::instance_counts>(counts)};
      const device_result part = query(on_, a_, instances, predicate_, precision_, options_, answers);
      for (std::size_t i = 0; i < of.size(); ++i)
        r.counts[of[i]] = counts[i];
      for (int i = 0; i < bounded_rungs; ++i)
        r.rungs.unsure[i] += part.rungs.unsure[i];
      r.rungs.left_box_a |= part.rungs.left_box_a, r.rungs.left_box_b |= part.rungs.left_box_b;
      r.candidates += part.candidates;
      r.device_seconds += part.device_seconds;
      // As many as will probably not overflow the lists, by what these had.
      const double each = static_cast<double>(std::max(part.candidates, std::uint64_t{1})) / static_cast<double>(taken);
      at_once = static_cast<std::size_t>(std::clamp(lists_filled * static_cast<double>(options_.list_capacity) / each,
                                                    1.0, static_cast<double>(most)));
      if (progress)
        progress(static_cast<double>(first + of.size()) / static_cast<double>(numbers.size()));
    }
  }

private:
  const device &on_;
  device_rows &a_;
  const predicate_info &predicate_;
  rung precision_;
  device_options options_;
};

// A box around a body of B as it was uploaded.
struct enclosed {
  float lo[3], hi[3];
  double longest; // of its lengths
  enclosed(const device &on, const device_rows &b) {
    device_rows as_uploaded(on, b.kind());
    as_uploaded.take_part(b, 1);
    const cuda::tree_box around = as_uploaded.bounds();
    std::copy_n(around.low, 3, lo);
    std::copy_n(around.high, 3, hi);
    longest = static_cast<double>(as_uploaded.reaches().second);
  }
};
// Whether poses of this set may be proved apart without posing it.
bool can_be_enclosed(const device_rows &b) {
  const kind_info &kind = b.kind();
  return b.elements() > 0 && std::find(kind.roles, kind.roles + kind.fields, role::z) != kind.roles + kind.fields;
}

// Fills the counts of these poses of one pair of bodies, which are numbers in r.counts.
void count_poses(const device &on, poses_query &ask, device_rows &a, const device_rows &b,
                 const std::optional<enclosed> &around_b, std::span<const pose> poses, std::vector<std::size_t> left,
                 bool any, const std::function<void(double)> &progress, poses_result &r) {
  if (around_b && a.elements() > 0) {
    const cuda::tree_box around = a.bounds();
    std::erase_if(left, [&](std::size_t i) {
      return proved_apart(poses[i], around_b->lo, around_b->hi, around_b->longest, around.low, around.high);
    });
  }
  if (left.empty())
    return;
  const std::vector<std::size_t> asked = left;
  if (any && b.elements() >= least_sampled) {
    device_rows some(on, b.kind());
    some.take_part(b, sample);
    ask.count(some, poses, left, true, r, {});
    std::erase_if(left, [&r](std::size_t i) { return r.counts[i] > 0; });
  }
  ask.count(b, poses, left, any, r, progress);
  if (any)
    for (const std::size_t i : asked)
      r.counts[i] = r.counts[i] > 0;
}

poses_result count_configurations(const device &on, std::span<device_set *const> a,
                                  std::span<const device_set *const> b, std::span<const pose> poses,
                                  const predicate_info &predicate, rung precision, const device_options &options) {
  const auto start = std::chrono::steady_clock::now();
  const bool any = options.want == answer_kind::any;
  if (!any && options.want != answer_kind::count)
    throw usage_error("many poses are answered by counts, or by whether anything touches");
  if (options.first_met)
    throw usage_error("many poses do not say what is met first");
  if (poses.size() % std::max<std::size_t>(b.size(), 1) != 0 || (b.empty() && !poses.empty()))
    throw usage_error("a configuration has a pose for each body");
  for (std::size_t i = 0; i < poses.size(); ++i)
    try {
      require_movable(b[i % b.size()]->kind(), poses[i]);
    } catch (const std::invalid_argument &e) {
      throw usage_error("pose " + std::to_string(i) + ": " + e.what());
    }
  for (device_set *const body : a)
    for (const device_set *const other : b) {
      if (body->as_given() || other->as_given())
        throw usage_error("many poses are asked of sets that are in order");
      require_query(on, *body, *other, predicate, precision, options);
    }
  // A plain rung may say that what is far apart touches.
  std::vector<std::optional<enclosed>> around(b.size());
  for (std::size_t j = 0; j < b.size(); ++j)
    if (never_wrong(precision) && a.size() * poses.size() > b.size() && can_be_enclosed(b[j]->rows()))
      around[j].emplace(on, b[j]->rows());
  poses_result all;
  all.counts.reserve(a.size() * poses.size());
  double done = 0;
  std::function<void(double)> progress;
  if (options.progress)
    progress = [&](double fraction) { options.progress((done + fraction) / static_cast<double>(a.size() * b.size())); };
  for (device_set *const body : a) {
    poses_result r; // of all poses
    r.counts.resize(poses.size());
    poses_query ask(on, body->rows(), predicate, precision, options);
    for (std::size_t j = 0; j < b.size(); ++j, ++done) {
      std::vector<std::size_t> numbers;
      for (std::size_t i = j; i < poses.size(); i += b.size())
        numbers.push_back(i);
      count_poses(on, ask, body->rows(), b[j]->rows(), around[j], poses, std::move(numbers), any, progress, r);
    }
    all.counts.insert(all.counts.end(), r.counts.begin(), r.counts.end());
    for (int i = 0; i < bounded_rungs; ++i)
      all.rungs.unsure[i] += r.rungs.unsure[i];
    all.rungs.left_box_a |= r.rungs.left_box_a, all.rungs.left_box_b |= r.rungs.left_box_b;
    all.candidates += r.candidates;
    all.device_seconds += r.device_seconds;
  }
  if (options.progress)
    options.progress(1);
  all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return all;
}

} // namespace

poses_result collide(const device &on, device_set &a, const device_set &b, std::span<const pose> poses,
                     const predicate_info &predicate, rung precision, const device_options &options) {
  device_set *const bodies_a[] = {&a};
  const device_set *const bodies_b[] = {&b};
  return collide(on, bodies_a, bodies_b, poses, predicate, precision, options);
}

poses_result collide(const device &on, std::span<device_set *const> a, std::span<const device_set *const> b,
                     std::span<const pose> poses, const predicate_info &predicate, rung precision,
                     const device_options &options) {
  return under_standard_word([&] {
    const auto lock = on.use();
    return count_configurations(on, a, b, poses, predicate, precision, options);
  });
}

} // namespace meetc
