// The engine's kernels that depend on no kind of element, but for those of orders and hierarchies, on the host: see stand_in.cpp.
#include "core/device/kernels.hpp"
#include "meetc/cuda_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace meetc {

cudaError_t to_keys(const index_pair *slots, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *owner_a,
                    const std::uint32_t *order_b, const std::uint32_t *owner_b, int bits_b, std::uint64_t *keys,
                    cudaStream_t) {
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t a = order_a[slots[i].a], b = order_b[slots[i].b];
    a = owner_a ? owner_a[a] : a, b = owner_b ? owner_b[b] : b;
    keys[i] = key_of({a, b}, bits_b);
  }
  return cudaSuccess;
}
cudaError_t to_pairs(std::uint64_t *keys, std::size_t n, int bits_b, cudaStream_t) {
  for (std::size_t i = 0; i < n; ++i) {
    const index_pair p = pair_of(keys[i], bits_b);
    std::memcpy(keys + i, &p, sizeof p);
  }
  return cudaSuccess;
}
cudaError_t reaches(const float *rows, std::size_t n, unsigned fields, std::uint64_t lengths, float *most,
                    cudaStream_t) {
  most[0] = most[1] = 0;
  for (std::size_t i = 0; i < n * fields; ++i) {
    float &of = most[i % fields < 64 ? lengths >> i % fields & 1 : 0];
    of = std::max(of, std::fabs(rows[i]));
  }
  return cudaSuccess;
}

cudaError_t sort_keys(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to, std::size_t n,
                      int bits, cudaStream_t) {
  bytes = 1;
  if (!space)
    return cudaSuccess;
  std::copy_n(keys, n, to);
  const std::uint64_t mask = bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0}; // too few bits must show
  std::stable_sort(to, to + n, [mask](std::uint64_t x, std::uint64_t y) { return (x & mask) < (y & mask); });
  return cudaSuccess;
}
// There is no order where an item has many hits; what stands there then means nothing, as on a device.
cudaError_t order_keys(const key_order &o, cudaStream_t) {
  constexpr std::uint32_t most_of_item = 1200;
  std::vector<std::uint64_t> sorted(o.keys, o.keys + o.n);
  std::copy_n(o.keys, o.n, o.by_cell);
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = most_of_item; i < o.n; ++i)
    if (sorted[i] >> o.bits_b == sorted[i - most_of_item] >> o.bits_b)
      *o.unordered = 1;
  for (std::uint32_t i = 0; i < o.n; ++i)
    reinterpret_cast<index_pair *>(o.keys)[i] = *o.unordered == 0 ? pair_of(sorted[i], o.bits_b) : index_pair{};
  return cudaSuccess;
}
cudaError_t drop_repeats(void *space, std::size_t &bytes, const std::uint64_t *keys, std::uint64_t *to,
                         unsigned long long *kept, std::size_t n, cudaStream_t) {
  bytes = 1;
  if (space)
    *kept = static_cast<unsigned long long>(std::unique_copy(keys, keys + n, to) - to);
  return cudaSuccess;
}

cudaError_t renumber(index_pair *pairs, std::size_t n, std::uint32_t by, cudaStream_t) {
  std::for_each_n(pairs, n, [by](index_pair &p) { p.a += by; });
  return cudaSuccess;
}

cudaError_t name_slots(const std::uint32_t *slots, std::uint32_t n, const std::uint32_t *order_a,
                       const std::uint32_t *order_b, std::uint32_t *named, cudaStream_t) {
  for (std::uint32_t i = 0; i < n; ++i)
    named[order_a[i]] = slots[i] == cuda::no_slot ? cuda::no_slot : order_b[slots[i]];
  return cudaSuccess;
}

cudaError_t tally(const hit_tally &t, cudaStream_t) {
  for (std::size_t i = 0; i < t.n; ++i) {
    const std::uint32_t a = t.hits[i].a, b = t.hits[i].b;
    if (t.counts_a)
      ++t.counts_a[t.order_a[a]];
    if (t.counts_b)
      ++t.counts_b[t.of_instance > 0 ? b / t.of_instance : t.order_b[b]];
    if (t.flags_a)
      t.flags_a[t.order_a[a]] = 1, t.flags_b[t.order_b[b]] = 1;
  }
  return cudaSuccess;
}

namespace {

void sort_hits(const hit_order &o) {
  for (std::size_t i = 0; i < *o.count; ++i)
    o.sorted[i] = {o.order_a[o.hits[i].a], o.order_b[o.hits[i].b]};
  std::sort(o.sorted, o.sorted + *o.count,
            [](index_pair x, index_pair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
}

} // namespace

cudaError_t order_hits(const hit_order &o, hit_amount expected, cudaStream_t) {
  if (expected == hit_amount::few) {
    if (*o.count > most_of_few || *o.count > o.capacity)
      *o.unordered = 1;
    else
      sort_hits(o);
    return cudaSuccess;
  }
  constexpr std::size_t most_of_one = 1024; // the device's has no such limit for all
  if (std::any_of(o.counted, o.counted + cuda::counted_to_distribute, [](std::uint32_t number) { return number != 0; }))
    return cudaErrorInvalidValue;
  std::fill_n(o.counted, cuda::counted_to_distribute, 1U); // they are used up
  if (*o.count > o.capacity)
    return cudaSuccess;
  const std::size_t n = *o.count;
  sort_hits(o);
  for (std::size_t i = 0, begin = 0; i < n; ++i) {
    begin = o.sorted[i].a == o.sorted[begin].a ? begin : i;
    if (i - begin >= most_of_one) {
      *o.unordered = 1;
      o.sorted[i] = {~0U, ~0U}; // is not looked at
    }
  }
  return cudaSuccess;
}

} // namespace meetc
