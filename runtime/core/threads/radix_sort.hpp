// core/threads/radix_sort.hpp: a stable sort by an unsigned key, on one thread or several.
//
// Method: radix_sort() sorts on one thread, digit by digit, the lowest first. radix_sort_parts() distributes the items to 256
// buckets by the highest bits of their keys, in parts: each part counts its items of each bucket, and then knows its places
// there. One thread then sorts each bucket by the other bits. The order depends on the items alone. Limits: a bucket that has
// most items keeps one thread busy, and the caller's stack holds 64 KiB of counts.
// Source: Satish, Harris and Garland, "Designing Efficient Sorting Algorithms for Manycore GPUs", 2009 (counts by parts).
#ifndef MEETC_CORE_THREADS_RADIX_SORT_HPP
#define MEETC_CORE_THREADS_RADIX_SORT_HPP

#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace meetc {

// Sorts by the low `bits` bits of key(item), on this thread. The result lies in `data`; scratch has room for n. `on` may stop
// it, and the items are then lost.
template <class T, class Key>
void radix_sort(T *data, T *scratch, std::size_t n, int bits, const Key &key, const execution &on = 1) {
  const auto low = [&](const T &item, int shift, int width) {
    return width == 0 ? 0 : key(item) << (64 - shift - width) >> (64 - width);
  };
  constexpr std::size_t few = 32;
  if (n <= few) { // by insertion
    for (std::size_t i = 1; i < n; ++i) {
      const T item = data[i];
      std::size_t at = i;
      for (; at > 0 && low(item, 0, bits) < low(data[at - 1], 0, bits); --at)
        data[at] = data[at - 1];
      data[at] = item;
    }
    return;
  }
  constexpr int widest = 11;
  const int most = std::min(static_cast<int>(std::bit_width(n)), widest), passes = (bits + most - 1) / most,
            width = passes ? (bits + passes - 1) / passes : 0;
  std::array<std::size_t, std::size_t{1} << widest> start;
  T *from = data, *to = scratch;
  for (int shift = 0; shift < bits; shift += width) {
    const int here = std::min(width, bits - shift);
    std::fill_n(start.begin(), std::size_t{1} << here, 0);
    for_strips(on, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        ++start[low(from[i], shift, here)];
    });
    if (start[low(from[0], shift, here)] == n)
      continue; // all have the same digit
    std::size_t sum = 0;
    for (std::size_t digit = 0; digit < std::size_t{1} << here; ++digit)
      sum += std::exchange(start[digit], sum);
    for_strips(on, n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        to[start[low(from[i], shift, here)]++] = from[i];
    });
    std::swap(from, to);
  }
  if (from != data)
    std::copy(from, from + n, data);
}

// Items come in up to most_sort_parts parts: each(part, visit) calls visit(items, count) for the pieces of a part, one after
// another, and does so again when it is called again. With every part the items end as many as all are.
inline constexpr std::size_t sort_buckets = 256, most_sort_parts = 32;

// Sorts them into `to`, which does not overlap them, by the low `bits` bits of key(item). Items with one key stand in the order
// of the parts. room(worker, begin, n) is room for n items while a bucket is sorted whose first place is `begin`.
// then(begin, n, room) is called once for each bucket when it is sorted; equal keys share a bucket.
template <class T, class Each, class Key, class Room, class Then>
void radix_sort_parts(std::size_t parts, const Each &each, T *to, int bits, const execution &on, const Key &key,
                      const Room &room, const Then &then) {
  constexpr int bucket_bits = std::countr_zero(sort_buckets);
  const int shift = std::max(bits - bucket_bits, 0);
  const auto bucket = [&](const T &item) {
    return bits == 0 ? 0 : static_cast<std::size_t>(key(item) << (64 - bits) >> (64 - bits + shift));
  };
  std::array<std::array<std::size_t, sort_buckets>, most_sort_parts> at; // counts, and then places
  for_chunks(on, parts, 1, [&](int, std::size_t p, std::size_t) {
    at[p] = {};
    each(p, [&](const T *items, std::size_t n) {
      for_strips(on, n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          ++at[p][bucket(items[i])];
      });
    });
  });
  std::array<std::size_t, sort_buckets + 1> ends{};
  for (std::size_t b = 0; b < sort_buckets; ++b) {
    std::size_t sum = ends[b];
    for (std::size_t p = 0; p < parts; ++p)
      sum += std::exchange(at[p][b], sum);
    ends[b + 1] = sum;
  }
  for_chunks(on, parts, 1, [&](int, std::size_t p, std::size_t) {
    each(p, [&](const T *items, std::size_t n) {
      for_strips(on, n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          to[at[p][bucket(items[i])]++] = items[i];
      });
    });
  });
  for_chunks(parts > 1 ? on : execution(1, on.stop), sort_buckets, 1, [&](int worker, std::size_t b, std::size_t) {
    const std::size_t begin = ends[b], n = ends[b + 1] - begin;
    if (n == 0)
      return;
    T *const scratch = room(worker, begin, n);
    radix_sort(to + begin, scratch, n, shift, key, on);
    then(begin, n, scratch);
  });
}

} // namespace meetc

#endif
