#include "meet/core/device/hits.hpp"

#include "meet/core/answers/answers.hpp"
#include "meet/core/answers/pair_list.hpp"
#include "meet/core/views/memory.hpp"

#include <algorithm>
#include <bit>

namespace meetc {
namespace {

constexpr std::size_t most_ordered = 0x7fffffff; // hits

int bits_of_items(std::span<const std::uint32_t> owners, std::uint32_t elements) {
  return std::bit_width(!owners.empty() ? *std::max_element(owners.begin(), owners.end())
                        : elements > 0  ? elements - 1
                                        : 0);
}

} // namespace

void make_room(std::vector<index_pair> &pairs, std::size_t n) {
  pairs.clear();
  pairs.reserve(n);
  wish_for_large_pages(pairs.data(), n * sizeof(index_pair));
  pairs.resize(n);
}

hit_pairs::hit_pairs(device &on, const device_set &a, const device_set &b, std::span<const std::uint32_t> owner_a,
                     std::span<const std::uint32_t> owner_b)
    : on_(on), buffers_(on.buffers()), a_(a), b_(b), owner_a_(owner_a), owner_b_(owner_b),
      bits_a_(bits_of_items(owner_a, a.numbers())), bits_b_(bits_of_items(owner_b, b.numbers())) {}

void hit_pairs::upload_owners() {
  const auto upload = [this](std::span<const std::uint32_t> from, const device_set &of,
                             device_memory<std::uint32_t> &to) {
    if (!from.empty() && from.size() != of.numbers())
      throw std::invalid_argument("an owner map needs one item for each element");
    if (from.empty())
      return;
    to.reserve(from.size(), "an owner map");
    check(cudaMemcpyAsync(to.data(), from.data(), from.size_bytes(), cudaMemcpyHostToDevice, on_.stream()),
          "uploading owners");
  };
  upload(owner_a_, a_, there_a_);
  upload(owner_b_, b_, there_b_);
}

bool hit_pairs::can_order(std::size_t hits) {
  return !owned() && hits <= most_ordered && buffers_.keys.grow(hits, 0, on_.stream()) &&
         buffers_.more_keys.grow(hits, 0, on_.stream());
}

void hit_pairs::order(const cuda::pair_list &hits, unsigned long long *counted, unsigned long long *unordered,
                      hit_amount expected) {
  const hit_order o{hits.pairs,
                    hits.count,
                    hits.capacity,
                    a_.order(),
                    b_.order(),
                    a_.numbers(),
                    b_.numbers(),
                    reinterpret_cast<std::uint32_t *>(counted),
                    buffers_.keys.data(),
                    reinterpret_cast<index_pair *>(buffers_.more_keys.data()),
                    unordered};
  check(order_hits(o, expected, on_.stream()), "sorting pairs");
}

void hit_pairs::add(const index_pair *hits, std::size_t n) {
  if (!buffers_.keys.grow(std::max(keys_ + n, std::min(2 * keys_, keys_ + (std::size_t{1} << 28))), keys_,
                          on_.stream()) &&
      !buffers_.keys.grow(keys_ + n, keys_, on_.stream())) {
    spill();
    buffers_.keys.reserve(n, "a list of hits");
  }
  check(to_keys(hits, n, a_.order(), there_a_.data(), b_.order(), there_b_.data(), bits_b_,
                buffers_.keys.data() + keys_, on_.stream()),
        "starting a kernel");
  keys_ += n;
}

// Moves the keys to the host, unsorted.
void hit_pairs::spill() {
  std::vector<std::uint64_t> keys(keys_);
  buffers_.moving.download(keys.data(), buffers_.keys.data(), keys_ * sizeof(std::uint64_t), on_.stream(),
                           "downloading pairs");
  for (const std::uint64_t k : keys)
    spilled_.push_back(pair_of(k, bits_b_));
  keys_ = 0;
}

unsigned long long hit_pairs::counted() {
  unsigned long long n = 0;
  check(cudaMemcpyAsync(&n, buffers_.counts(), sizeof n, cudaMemcpyDeviceToHost, on_.stream()), "sorting pairs");
  check(cudaStreamSynchronize(on_.stream()), "sorting pairs");
  return n;
}

// Brings all keys to their places at once, which become pairs. Returns false where too many are of items near each other.
bool hit_pairs::order_keys_there(int bits) {
  constexpr std::size_t bytes = cuda::counted_to_distribute * sizeof(std::uint32_t);
  buffers_.sort_space.reserve(bytes, "counters");
  for (void *const zeros : {static_cast<void *>(buffers_.sort_space.data()), static_cast<void *>(buffers_.counts())})
    check(cudaMemsetAsync(zeros, 0, zeros == buffers_.counts() ? sizeof(unsigned long long) : bytes, on_.stream()),
          "sorting pairs");
  check(order_keys({buffers_.keys.data(), static_cast<std::uint32_t>(keys_), bits, bits_b_, buffers_.more_keys.data(),
                    reinterpret_cast<std::uint32_t *>(buffers_.sort_space.data()), buffers_.counts()},
                   on_.stream()),
        "sorting pairs");
  if (counted() == 0)
    return true;
  std::swap(buffers_.keys, buffers_.more_keys);
  return false;
}

// Sorts the keys, drops repeats where there are owners, and makes pairs of them. Returns false where the device lacks the memory.
bool hit_pairs::sort_on_device() {
  if (owned() && keys_ > 0x7fffffff) // older versions of CUB take at most this many keys
    return false;
  if (!buffers_.more_keys.grow(keys_, 0, on_.stream()))
    return false;
  const int bits = std::max(1, bits_a_ + bits_b_);
  if (!owned() && !crowded_ && keys_ > 0 && keys_ <= most_keys_to_order && order_keys_there(bits))
    return true;
  std::size_t sort_bytes = 0, repeat_bytes = 0;
  check(sort_keys(nullptr, sort_bytes, nullptr, nullptr, keys_, bits, on_.stream()), "planning to sort");
  if (owned())
    check(drop_repeats(nullptr, repeat_bytes, nullptr, nullptr, nullptr, keys_, on_.stream()), "planning to sort");
  if (!buffers_.sort_space.grow(std::max(sort_bytes, repeat_bytes), 0, on_.stream()))
    return false;
  check(sort_keys(buffers_.sort_space.data(), sort_bytes, buffers_.keys.data(), buffers_.more_keys.data(), keys_, bits,
                  on_.stream()),
        "sorting pairs");
  std::swap(buffers_.keys, buffers_.more_keys);
  if (owned()) {
    check(drop_repeats(buffers_.sort_space.data(), repeat_bytes, buffers_.keys.data(), buffers_.more_keys.data(),
                       buffers_.counts(), keys_, on_.stream()),
          "dropping repeats");
    keys_ = counted();
    std::swap(buffers_.keys, buffers_.more_keys);
  }
  check(to_pairs(buffers_.keys.data(), keys_, bits_b_, on_.stream()), "starting a kernel");
  return true;
}

void hit_pairs::finish(answer_kind want, result &r, const std::function<void()> &sorted, pairs_there *left_there) {
  std::vector<index_pair> &pairs = r.pairs;
  if (spilled_.empty() && (keys_ == 0 || ordered_ || sort_on_device())) {
    std::uint64_t *const from = ordered_ ? buffers_.more_keys.data() : buffers_.keys.data();
    if (!ordered_)
      sorted();
    r.count = keys_;
    if (want == answer_kind::count)
      return;
    if (left_there && want == answer_kind::pairs) {
      *left_there = {reinterpret_cast<index_pair *>(from), keys_};
      return;
    }
    make_room(pairs, keys_);
    buffers_.moving.download(pairs.data(), from, keys_ * sizeof(index_pair), on_.stream(), "downloading pairs");
  } else {
    spill();
    pairs = std::move(spilled_);
    sort_pairs(pairs);
    if (owned())
      drop_repeats(pairs);
    sorted();
  }
  answer_from_list(want, items(owner_a_, a_.numbers()), items(owner_b_, b_.numbers()), r);
}

} // namespace meetc
