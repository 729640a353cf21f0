// core/radix_sort.hpp: a stable sort by an unsigned key, digit by digit, lowest first.
#ifndef MEETC_CORE_RADIX_SORT_HPP
#define MEETC_CORE_RADIX_SORT_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace meetc {

// Sorts by the low `bits` bits of key(item). The result lies in `data`; scratch has room for n > 0. Below some hundred
// items a comparison sort is faster.
template <class T, class Key> void radix_sort(T *data, T *scratch, std::size_t n, int bits, const Key &key) {
  constexpr int widest = 11;
  const int passes = (bits + widest - 1) / widest;
  const int width = passes ? (bits + passes - 1) / passes : 0;
  T *from = data, *to = scratch;
  for (int shift = 0; shift < bits; shift += width) {
    const std::uint64_t mask = (std::uint64_t{1} << std::min(width, bits - shift)) - 1;
    std::array<std::size_t, std::size_t{1} << widest> start{};
    for (std::size_t i = 0; i < n; ++i)
      ++start[key(from[i]) >> shift & mask];
    if (start[key(from[0]) >> shift & mask] == n)
      continue; // all have the same digit
    std::size_t sum = 0;
    for (std::size_t &s : start) {
      const std::size_t count = s;
      s = sum;
      sum += count;
    }
    for (std::size_t i = 0; i < n; ++i)
      to[start[key(from[i]) >> shift & mask]++] = from[i];
    std::swap(from, to);
  }
  if (from != data)
    std::copy(from, from + n, data);
}

} // namespace meetc

#endif
