// CUB's sorts on the host, by those of the standard library.
#pragma once
#include "tests/runtime/device/host/host_launch.hpp"

#include <algorithm>
#include <cstdint>

namespace cub {

struct DeviceRadixSort {
  template <class Key, class Value>
  static cudaError_t SortPairs(void *space, std::size_t &bytes, const Key *keys, Key *sorted, const Value *values,
                               Value *to, std::int64_t n, int begin, int end, cudaStream_t) {
    bytes = 1;
    if (!space)
      return cudaSuccess;
    std::vector<std::pair<Key, Value>> all;
    for (std::int64_t i = 0; i < n; ++i)
      all.emplace_back(keys[i], values[i]);
    std::stable_sort(all.begin(), all.end(), [part = part_of<Key>(begin, end)](const auto &x, const auto &y) {
      return (x.first & part) < (y.first & part);
    });
    for (std::int64_t i = 0; i < n; ++i)
      sorted[i] = all[static_cast<std::size_t>(i)].first, to[i] = all[static_cast<std::size_t>(i)].second;
    return cudaSuccess;
  }
  template <class Key>
  static cudaError_t SortKeys(void *space, std::size_t &bytes, const Key *keys, Key *to, std::size_t n, int begin,
                              int end, cudaStream_t) {
    bytes = 1;
    if (!space)
      return cudaSuccess;
    std::copy_n(keys, n, to);
    std::stable_sort(to, to + n, [part = part_of<Key>(begin, end)](Key x, Key y) { return (x & part) < (y & part); });
    return cudaSuccess;
  }

private:
  template <class Key> static Key part_of(int begin, int end) { // too few bits must show
    const auto below = [](int bits) {
      return bits < static_cast<int>(8 * sizeof(Key)) ? (Key{1} << bits) - 1 : static_cast<Key>(~Key{0});
    };
    return static_cast<Key>(below(end) & ~below(begin));
  }
};

struct DeviceSelect {
  template <class T, class Count>
  static cudaError_t Unique(void *space, std::size_t &bytes, const T *from, T *to, Count *kept, std::int64_t n,
                            cudaStream_t) {
    bytes = 1;
    if (space)
      *kept = static_cast<Count>(std::unique_copy(from, from + n, to) - to);
    return cudaSuccess;
  }
};

} // namespace cub
