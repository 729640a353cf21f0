#include "meet/core/device/group.hpp"

#include "meet/core/answers/answers.hpp"
#include "meet/core/answers/pair_list.hpp"
#include "meet/core/device/buffers.hpp"
#include "meet/core/device/given.hpp"
#include "meet/core/device/kernels.hpp"
#include "meet/core/device/query.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>

namespace meetc {
namespace {

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
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

// Frees what lies on each device while that is the current one.
template <class T> void release(std::span<const int> numbers, std::vector<std::unique_ptr<T>> &of) {
  int before = 0;
  cudaGetDevice(&before);
  for (std::size_t i = numbers.size(); i-- > 0;) {
    cudaSetDevice(numbers[i]); // an error here has been reported where it arose
    of[i].reset();
  }
  cudaSetDevice(before);
}

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

// What device i found of elements (or items) of A that no other device has seen.
void join(device_result &r, const device_result &more) {
  append(r.flags.a, more.flags.a);
  append(r.counts.a, more.counts.a);
  append(r.first_met, more.first_met);
  for (std::size_t k = 0; k < r.flags.b.size(); ++k)
    r.flags.b[k] |= more.flags.b[k];
  for (std::size_t k = 0; k < r.counts.b.size(); ++k)
    r.counts.b[k] += more.counts.b[k];
}

// All devices' lists of pairs, one after another, each where it belongs at once. first(i): what is added to the elements of A.
std::vector<index_pair> list_of(device_group &on, std::vector<device_result> &of, const std::vector<pairs_there> &left,
                                const std::function<std::size_t(std::size_t)> &first) {
  std::vector<std::size_t> begin{0};
  for (std::size_t i = 0; i < of.size(); ++i)
    begin.push_back(begin.back() + of[i].pairs.size() + left[i].n); // one of them
  std::vector<index_pair> out;
  if (begin.back() == 0)
    return out;
  make_room(out, begin.back());
  on.on_each([&](std::size_t i) {
    const auto by = static_cast<std::uint32_t>(first(i));
    index_pair *const to = out.data() + begin[i];
    for (std::size_t k = 0; k < of[i].pairs.size(); ++k)
      to[k] = {of[i].pairs[k].a + by, of[i].pairs[k].b};
    if (left[i].n == 0)
      return;
    check(renumber(left[i].pairs, left[i].n, by, on[i].stream()), "starting a kernel");
    on[i].buffers().moving.download(to, left[i].pairs, left[i].n * sizeof(index_pair), on[i].stream(),
                                    "downloading pairs");
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

// A thread for each device but the first. They cost a query less than threads that are started for it.
class device_group::waiting_threads {
public:
  explicit waiting_threads(std::size_t devices) {
    for (std::size_t i = 1; i < devices; ++i)
      threads_.emplace_back([this, i](const std::stop_token &stop) { take_turns(i, stop); });
  }

  // work(i) must not throw.
  void run(const std::function<void(std::size_t)> &work) {
    {
      const std::scoped_lock lock(mutex_);
      work_ = &work, left_ = threads_.size(), ++turn_;
    }
    begins_.notify_all();
    work(0);
    std::unique_lock lock(mutex_);
    ends_.wait(lock, [this] { return left_ == 0; });
  }

private:
  void take_turns(std::size_t i, const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    for (std::uint64_t seen = 0; begins_.wait(lock, stop, [&] { return turn_ != seen; });) {
      seen = turn_;
      lock.unlock();
      (*work_)(i);
      lock.lock();
      if (--left_ == 0)
        ends_.notify_one();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any begins_;
  std::condition_variable ends_;
  const std::function<void(std::size_t)> *work_ = nullptr; // that of this turn
  std::uint64_t turn_ = 0;
  std::size_t left_ = 0;              // threads that have not ended it
  std::vector<std::jthread> threads_; // the last member: stopped and joined first
};

device_group::device_group(const cuda::catalogue &kernels, std::span<const int> numbers)
    : numbers_(numbers.begin(), numbers.end()), devices_(numbers.size()) {
  const control_word_guard guard; // which the threads that it starts inherit
  require(!numbers_.empty() && *std::min_element(numbers_.begin(), numbers_.end()) >= 0,
          "a group of devices needs their numbers, from 0 on");
  int count = 0;
  const int last = *std::max_element(numbers_.begin(), numbers_.end());
  if (cudaGetDeviceCount(&count) != cudaSuccess || count == 0) {
    cudaGetLastError();
    const device says_why(kernels); // throws
  }
  if (last >= count)
    throw device_error("there is no CUDA device number " + std::to_string(last) + " here: the last one is number " +
                       std::to_string(count - 1));
  threads_ = std::make_unique<waiting_threads>(size());
  try {
    on_each([&](std::size_t i) { devices_[i] = std::make_unique<device>(kernels); });
  } catch (...) {
    release<device>(numbers_, devices_);
    throw;
  }
}

device_group::~device_group() {
  release<device>(numbers_, devices_);
}

void device_group::on_each(const std::function<void(std::size_t)> &work) {
  std::vector<std::exception_ptr> thrown(size());
  const auto run = [&](std::size_t i) {
    try {
      const current_device now(numbers_[i]);
      work(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  };
  threads_->run(run);
  for (const std::exception_ptr &e : thrown)
    if (e)
      std::rethrow_exception(e);
}

group_set::group_set(device_group &on, const view &elements, const kind_info &kind, spread how, const pose &at,
                     int threads)
    : on_(&on), how_(how), elements_(elements.elements), parts_(on.size()) {
  const view all = require_view(elements, kind);
  try {
    on.on_each([&](std::size_t i) {
      const std::size_t from = first(i), end = how_ == spread::cut ? elements_ * (i + 1) / parts_.size() : elements_;
      try {
        parts_[i] = std::make_unique<device_set>(on[i], slice_of(all, kind, from, end - from), kind, at, threads);
      } catch (const input_error &e) {
        fault f = e.where;
        f.element += from;
        throw input_error(f, kind);
      }
    });
  } catch (...) {
    release<device_set>(on.numbers(), parts_);
    throw;
  }
}

group_set::~group_set() {
  release<device_set>(on_->numbers(), parts_);
}

void group_set::move(const pose &at) {
  on_->on_each([&](std::size_t i) {
    try {
      parts_[i]->move(at);
    } catch (const input_error &e) {
      fault f = e.where;
      f.element += first(i);
      throw input_error(f, parts_[i]->kind());
    }
  });
}

void group_set::bounds(float lo[3], float hi[3]) {
  std::vector<float> of(6 * parts_.size());
  const control_word_guard guard;
  on_->on_each([&](std::size_t i) { parts_[i]->bounds(&of[6 * i], &of[6 * i + 3]); });
  std::copy_n(of.data(), 3, lo);
  std::copy_n(of.data() + 3, 3, hi);
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const float *const other = &of[6 * i];
    if (other[0] > other[3]) // nothing is there
      continue;
    const bool none = lo[0] > hi[0];
    for (int k = 0; k < 3; ++k) {
      lo[k] = none ? other[k] : std::min(lo[k], other[k]);
      hi[k] = none ? other[3 + k] : std::max(hi[k], other[3 + k]);
    }
  }
}

namespace {

device_result find_touching(device_group &on, group_set &a, group_set &b, const predicate_info &predicate,
                            rung precision, const device_options &options) {
  const auto start = std::chrono::steady_clock::now();
  require(a.is_on(on) && b.is_on(on), "a set is on another group of devices");
  require(a.how() == spread::cut && b.how() == spread::whole, "a group needs its first set cut and its second whole");
  const bool owned = !options.owner_a.empty();
  require(!owned || options.owner_a.size() == a.elements(), "an owner map needs one item for each element");
  std::vector<device_result> of(on.size());
  std::vector<pairs_there> left(on.size());
  on.on_each([&](std::size_t i) {
    device_options o = options;
    if (owned) {
      o.owner_a = options.owner_a.subspan(a.first(i), a.part(i).elements());
      if (o.want != answer_kind::any)
        o.want = answer_kind::pairs;
    }
    if (i > 0)
      o.progress = nullptr;
    require_query(on[i], a.part(i), b.part(i), predicate, precision, o);
    of[i] = query(on[i], a.part(i), b.part(i), predicate, precision, o, {}, &left[i]);
  });
  std::vector<index_pair> pairs = list_of(on, of, left, [&](std::size_t i) { return owned ? 0 : a.first(i); });
  device_result r = std::move(of[0]);
  for (std::size_t i = 1; i < of.size(); ++i) {
    add_up(r, of[i]);
    join(r, of[i]);
  }
  r.pairs = std::move(pairs);
  if (options.want == answer_kind::any)
    r.count = std::min<std::uint64_t>(r.count, 1);
  else if (owned) {
    sort_pairs(r.pairs);
    drop_repeats(r.pairs);
    answer_from_list(options.want, items(options.owner_a, a.elements()), items(options.owner_b, b.elements()), r);
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace

device_result collide(device_group &on, group_set &a, group_set &b, const predicate_info &predicate, rung precision,
                      const device_options &options) {
  return under_standard_word([&] { return find_touching(on, a, b, predicate, precision, options); });
}

} // namespace meetc
