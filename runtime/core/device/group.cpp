#include "meet/core/device/collide.hpp"

#include "meet/core/answers/answers.hpp"
#include "meet/core/answers/pair_list.hpp"
#include "meet/core/device/answers/answers_for.hpp"
#include "meet/core/device/answers/hit_keys.hpp"
#include "meet/core/device/answers/kernels.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/query/query.hpp"
#include "meet/core/device/set/given.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/usage_error.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>

namespace meetc {
namespace {

void require(bool holds, const char *what) {
  if (!holds)
    throw usage_error(what);
}

// CUDA's current device belongs to a thread.
class current_device {
public:
  explicit current_device(int number) {
    check(cudaGetDevice(&before_), "choosing a CUDA device");
    check(cudaSetDevice(number), "choosing a CUDA device");
  }
  ~current_device() { cudaSetDevice(before_); }
  current_device(const current_device &) = delete;
  current_device &operator=(const current_device &) = delete;

private:
  int before_ = 0;
};

view slice_of(view elements, const kind_info &kind, std::size_t first, std::size_t n) {
  if (elements.index)
    elements.index += first * static_cast<std::size_t>(kind.points);
  else if (first > 0)
    elements.data = reinterpret_cast<const float *>(reinterpret_cast<const std::byte *>(elements.data) +
                                                    first * elements.stride_bytes);
  elements.elements = n;
  return elements;
}

template <class T> void append(std::vector<T> &to, const std::vector<T> &more) {
  to.insert(to.end(), more.begin(), more.end());
}

// Numbers of elements of the set that is cut follow one another; each device has some for all of the other one's.
template <class T, class Join> void join(per_element<T> &r, const per_element<T> &more, bool cut_a, const Join &one) {
  append(cut_a ? r.a : r.b, cut_a ? more.a : more.b);
  std::vector<T> &all = cut_a ? r.b : r.a;
  const std::vector<T> &others = cut_a ? more.b : more.a;
  for (std::size_t k = 0; k < all.size(); ++k)
    one(all[k], others[k]);
}
void join(device_result &r, const device_result &more, bool cut_a) {
  join(r.flags, more.flags, cut_a, [](std::uint8_t &flag, std::uint8_t other) { flag |= other; });
  join(r.counts, more.counts, cut_a, [](std::uint64_t &count, std::uint64_t other) { count += other; });
  append(r.first_met, more.first_met);
}

// All devices' lists of pairs, one after another, whose elements become the caller's by adding `first` of each device.
std::vector<index_pair> list_of(const device_group &on, std::vector<device_result> &of, std::vector<pairs_there> &left,
                                const std::vector<index_pair> &first) {
  std::vector<std::size_t> begin{0};
  for (std::size_t i = 0; i < of.size(); ++i)
    begin.push_back(begin.back() + of[i].pairs.size() + left[i].size()); // one of them
  std::vector<index_pair> out;
  if (begin.back() == 0)
    return out;
  on_device::make_room(out, begin.back());
  on.on_each([&](std::size_t i) {
    const index_pair by = first[i];
    index_pair *const to = out.data() + begin[i];
    for (std::size_t k = 0; k < of[i].pairs.size(); ++k)
      to[k] = {of[i].pairs[k].a + by.a, of[i].pairs[k].b + by.b};
    if (left[i].size() == 0)
      return;
    check(on_device::renumber(left[i].data(), left[i].size(), by, on[i].stream()), "starting a kernel");
    on[i].buffers().moving.download(to, left[i].data(), left[i].size() * sizeof(index_pair), on[i].stream(),
                                    "downloading pairs");
    left[i].exchange(on[i].buffers().more_keys, 0); // its memory goes back
  });
  return out;
}

void add_up(device_result &r, const device_result &more) {
  r.count += more.count;
  r.candidates += more.candidates;
  r.parts += more.parts;
  for (int k = 0; k < bounded_rungs; ++k)
    r.rungs.unsure[k] += more.rungs.unsure[k];
  r.rungs.left_box_a |= more.rungs.left_box_a;
  r.rungs.left_box_b |= more.rungs.left_box_b;
  r.device_seconds = std::max(r.device_seconds, more.device_seconds);
}

} // namespace

device_group::device_group(const cuda::catalogue &kernels, std::span<const int> numbers)
    : devices_(std::make_shared<std::vector<numbered>>()) {
  const control_word_guard guard; // which the threads that it starts inherit
  require(!numbers.empty() && *std::min_element(numbers.begin(), numbers.end()) >= 0,
          "a group of devices needs their numbers, from 0 on");
  int count = 0;
  const int last = *std::max_element(numbers.begin(), numbers.end());
  if (cudaGetDeviceCount(&count) != cudaSuccess || count == 0) {
    cudaGetLastError();
    const device says_why(kernels); // throws
  }
  if (last >= count)
    throw missing_device("there is no CUDA device number " + std::to_string(last) + " here: the last one is number " +
                         std::to_string(count - 1));
  for (const int number : numbers)
    devices_->push_back({number, {}});
  on_each([&](std::size_t i) { (*devices_)[i].on.emplace(kernels); });
}

void device_group::on_each(const std::function<void(std::size_t)> &work) const {
  std::vector<std::exception_ptr> thrown(size());
  const auto run = [&](std::size_t i) {
    try {
      const current_device now((*devices_)[i].number);
      work(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < size(); ++i)
      others.emplace_back(run, i);
    run(0);
  }
  for (const std::exception_ptr &e : thrown)
    if (e)
      std::rethrow_exception(e);
}

// Faults name the caller's elements.
void group_set::on_each_part(const std::function<void(std::size_t)> &work) const {
  on_.on_each([&](std::size_t i) {
    try {
      work(i);
    } catch (const input_error &e) {
      fault f = e.where;
      f.element += first(i);
      throw input_error(f, *kind_);
    }
  });
}

group_set::group_set(const device_group &on, const view &elements, const kind_info &kind, spread how, const pose &at,
                     int threads)
    : on_(on), kind_(&kind), how_(how), elements_(elements.elements), parts_(on.size()) {
  const view all = require_view(elements, kind);
  on_each_part([&](std::size_t i) {
    const view some = how_ == spread::cut ? slice_of(all, kind, begin(i), begin(i + 1) - begin(i)) : all;
    parts_[i].emplace(on_[i], some, kind, at, threads);
  });
}

void group_set::move(const pose &at) {
  on_each_part([&](std::size_t i) { parts_[i]->move(at); });
}

void group_set::bounds(float lo[3], float hi[3]) {
  std::vector<cuda::tree_box> boxes(parts_.size());
  on_each_part([&](std::size_t i) { parts_[i]->bounds(boxes[i].low, boxes[i].high); });
  cuda::tree_box all; // empty
  for (const cuda::tree_box &box : boxes)
    all.widen(box);
  std::copy_n(all.low, 3, lo);
  std::copy_n(all.high, 3, hi);
}

namespace {

device_result find_touching(const device_group &on, group_set &a, group_set &b, const predicate_info &predicate,
                            rung precision, const device_options &options) {
  const auto start = std::chrono::steady_clock::now();
  require(a.on() == on && b.on() == on, "a set is on another group of devices");
  require(a.how() != b.how(), "a group needs one set cut and the other whole");
  require(!options.leave_there, "a group leaves no list on a device");
  const bool cut_a = a.how() == spread::cut;
  require(cut_a || !options.first_met, "a group needs the set cut of which it is asked what it meets first");
  const group_set &cut = cut_a ? a : b;
  const std::span<const std::uint32_t> owners = cut_a ? options.owner_a : options.owner_b;
  const bool owned = !owners.empty();
  require(!owned || owners.size() == cut.elements(), "an owner map needs one item for each element");
  std::vector<device_result> of(on.size());
  std::vector<pairs_there> left(on.size());
  std::vector<index_pair> first(on.size());
  on.on_each([&](std::size_t i) {
    device_options o = options;
    const auto begin = static_cast<std::uint32_t>(cut.first(i));
    if (owned) {
      (cut_a ? o.owner_a : o.owner_b) = owners.subspan(begin, (cut_a ? a : b).part(i).elements());
      if (o.want != answer_kind::any)
        o.want = answer_kind::pairs;
    } else {
      first[i] = cut_a ? index_pair{begin, 0} : index_pair{0, begin};
    }
    if (i > 0)
      o.progress = nullptr;
    o.leave_there = &left[i];
    of[i] = collide(on[i], a.part(i), b.part(i), predicate, precision, o);
  });
  std::vector<index_pair> pairs = list_of(on, of, left, first);
  device_result r = std::move(of[0]);
  for (std::size_t i = 1; i < of.size(); ++i) {
    add_up(r, of[i]);
    join(r, of[i], cut_a);
  }
  r.pairs = std::move(pairs);
  if (!cut_a || owned) {
    const pair_span lists[] = {r.pairs};
    r.pairs = sorted(lists, thread_count(0));
  }
  if (options.want == answer_kind::any) {
    r.count = std::min<std::uint64_t>(r.count, 1);
  } else if (owned) {
    drop_repeats(r.pairs);
    answer_from_list(options.want, items(options.owner_a, a.elements()), items(options.owner_b, b.elements()), r);
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace

device_result collide(const device_group &on, group_set &a, group_set &b, const predicate_info &predicate,
                      rung precision, const device_options &options) {
  return under_standard_word([&] { return find_touching(on, a, b, predicate, precision, options); });
}

} // namespace meetc
