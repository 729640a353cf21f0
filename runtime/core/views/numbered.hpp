// core/views/numbered.hpp: numbers keys in the order in which they first appear.
#ifndef MEETC_CORE_VIEWS_NUMBERED_HPP
#define MEETC_CORE_VIEWS_NUMBERED_HPP

#include "meet/core/threads/threads.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace meetc {

// A key is N words. The numbers depend on the keys and their order alone.
template <class Word, std::size_t N> class numbered {
public:
  using key = std::array<Word, N>;

  // `on` may stop what takes long, and outlives this.
  numbered(std::size_t expected, const execution &on) : on_(on) {
    std::size_t n = 16;
    while (n < 2 * expected)
      n *= 2;
    empty(n);
    keys_.reserve(expected);
  }
  std::uint32_t number(const key &k) {
    if (2 * keys_.size() >= slots_.size())
      grow();
    std::uint32_t &slot = find(k);
    if (slot == none) {
      if (keys_.size() >= most)
        throw std::length_error("2^31 different points or parts, or more");
      slot = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(k);
    }
    return slot;
  }
  const std::vector<key> &keys() const { return keys_; }

private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::size_t most = std::size_t{1} << 31;
  const execution &on_;
  std::vector<std::uint32_t> slots_;
  std::vector<key> keys_;

  std::uint32_t &find(const key &k) {
    std::uint64_t hash = 0;
    for (const Word word : k) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29;
    }
    hash = (hash ^ hash >> 32) * 0xbf58476d1ce4e5b9U;
    const std::size_t last = slots_.size() - 1;
    std::size_t i = (hash ^ hash >> 31) & last;
    while (slots_[i] != none && keys_[slots_[i]] != k)
      i = (i + 1) & last;
    return slots_[i];
  }
  void empty(std::size_t n) {
    std::vector<std::uint32_t>().swap(slots_);
    slots_.reserve(n);
    for_strips(on_, n, [&](std::size_t, std::size_t end) { slots_.resize(end, none); });
  }
  void grow() {
    empty(2 * slots_.size());
    for_strips(on_, keys_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        find(keys_[i]) = static_cast<std::uint32_t>(i);
    });
  }
};

// The key of a point x, y, z: equal where its coordinates are, 0 and -0 too.
inline std::array<std::uint32_t, 3> key_of_point(const float *point) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x == 0 ? 0.0F : x); };
  return {bits(point[0]), bits(point[1]), bits(point[2])};
}

} // namespace meetc

#endif
