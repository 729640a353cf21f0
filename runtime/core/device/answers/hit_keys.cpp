#include "meet/core/device/answers/hit_keys.hpp"

#include "meet/core/answers/pair_list.hpp"
#include "meet/core/device/answers/kernels.hpp"
#include "meet/core/device/answers/owners.hpp"
#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/views/memory.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace meetc::on_device {

void make_room(std::vector<index_pair> &pairs, std::size_t n) {
  pairs.clear();
  pairs.reserve(n);
  wish_for_large_pages(pairs.data(), n * sizeof(index_pair));
  pairs.resize(n);
}

std::vector<index_pair> download_pairs(const device &on, const index_pair *from, std::size_t n) {
  std::vector<index_pair> out;
  make_room(out, n);
  on.buffers().moving.download(out.data(), from, n * sizeof(index_pair), on.stream(), "downloading pairs");
  return out;
}

hit_keys::side::side(const device_rows &of, std::span<const std::uint32_t> from, cudaStream_t stream)
    : set(of), bits(std::bit_width(!from.empty()      ? *std::max_element(from.begin(), from.end())
                                   : of.numbers() > 0 ? of.numbers() - 1
                                                      : 0)) {
  upload_owners(from, owners, stream);
}

hit_keys::hit_keys(const queried_sets &sets, std::span<const std::uint32_t> owner_a,
                   std::span<const std::uint32_t> owner_b)
    : on_(sets.on), owned_(!owner_a.empty() || !owner_b.empty()), a_(sets.a, owner_a, sets.on.stream()),
      b_(sets.b, owner_b, sets.on.stream()) {}

void hit_keys::add(const index_pair *hits, std::size_t n) {
  device_memory<std::uint64_t> &keys = on_.buffers().keys;
  const std::size_t roomy = std::max(keys_ + n, std::min(2 * keys_, keys_ + (std::size_t{1} << 28)));
  if (!keys.grow(roomy, keys_, on_.stream()) && !keys.grow(keys_ + n, keys_, on_.stream())) {
    spill();
    keys.reserve(n, "a list of hits");
  }
  check(to_keys(hits, n, a_.set.order(), a_.owners.data(), b_.set.order(), b_.owners.data(), b_.bits,
                keys.data() + keys_, on_.stream()),
        "starting a kernel");
  keys_ += n;
}

// Moves the keys to the host, unsorted.
void hit_keys::spill() {
  std::vector<std::uint64_t> keys(keys_);
  on_.buffers().moving.download(keys.data(), on_.buffers().keys.data(), keys_ * sizeof(std::uint64_t), on_.stream(),
                                "downloading pairs");
  for (const std::uint64_t k : keys)
    here_.push_back(pair_of(k, b_.bits));
  keys_ = 0;
}

// Returns false where the device lacks the memory.
bool hit_keys::sort_there() {
  device_buffers &buffers = on_.buffers();
  if (owned_ && keys_ > 0x7fffffff) // older versions of CUB take at most this many keys
    return false;
  if (!buffers.more_keys.grow(keys_, 0, on_.stream()))
    return false;
  const int bits = std::max(1, a_.bits + b_.bits);
  std::size_t sort_bytes = 0, repeat_bytes = 0;
  check(sort_keys(nullptr, sort_bytes, nullptr, nullptr, keys_, bits, on_.stream()), "planning to sort");
  if (owned_)
    check(drop_repeats(nullptr, repeat_bytes, nullptr, nullptr, nullptr, keys_, on_.stream()), "planning to sort");
  if (!buffers.sort_space.grow(std::max(sort_bytes, repeat_bytes), 0, on_.stream()))
    return false;
  check(sort_keys(buffers.sort_space.data(), sort_bytes, buffers.keys.data(), buffers.more_keys.data(), keys_, bits,
                  on_.stream()),
        "sorting pairs");
  std::swap(buffers.keys, buffers.more_keys);
  if (owned_) {
    check(drop_repeats(buffers.sort_space.data(), repeat_bytes, buffers.keys.data(), buffers.more_keys.data(),
                       buffers.counts().data(), keys_, on_.stream()),
          "dropping repeats");
    unsigned long long kept = 0;
    check(cudaMemcpyAsync(&kept, buffers.counts().data(), sizeof kept, cudaMemcpyDeviceToHost, on_.stream()),
          "dropping repeats");
    check(cudaStreamSynchronize(on_.stream()), "dropping repeats");
    keys_ = kept;
    std::swap(buffers.keys, buffers.more_keys);
  }
  check(to_pairs(buffers.keys.data(), keys_, b_.bits, on_.stream()), "starting a kernel");
  buffers.mark_clock();
  return true;
}

void hit_keys::sort() {
  if (here_.empty() && (keys_ == 0 || sort_there()))
    return;
  spill();
  sort_pairs(here_);
  if (owned_)
    meetc::drop_repeats(here_);
}

const index_pair *hit_keys::there() const {
  return here_.empty() ? reinterpret_cast<const index_pair *>(on_.buffers().keys.data()) : nullptr;
}
std::vector<index_pair> hit_keys::take_list() {
  return here_.empty() ? download_pairs(on_, there(), keys_) : std::move(here_);
}

} // namespace meetc::on_device
